// The splat of each vertex by its neighbours' landing, and what of it does not lie on the map.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "sim/kernels/real.glsl"

#include "caustics/kernels/optics.glsl"
#include "caustics/kernels/splat.glsl"
#include "caustics/splat/shaders/splat_parameters.glsl"

layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;

layout(std430, binding = 0) readonly buffer Parameters { SplatParameters p; };
layout(std430, binding = 1) readonly buffer Flights { SplatFlight flights[]; };
layout(std430, binding = 2) readonly buffer Landings { SplatLanding landings[]; };
layout(std430, binding = 3) buffer Records { SplatRecord records[]; };
layout(std430, binding = 4) writeonly buffer Accounts { SplatAccount accounts[]; };

#include "caustics/splat/shaders/splat_share.glsl"

bool landed(int k) {
    return k >= 0 && (landings[k].state & 1) != 0;
}

// From where vertex k lands to where n does, pixels.
vec2 between(int k, int n) {
    SplatLanding from = landings[k];
    SplatLanding to = landings[n];
    return vec2(to.pixel_x - from.pixel_x, to.pixel_y - from.pixel_y) +
           vec2(to.part_x - from.part_x, to.part_y - from.part_y);
}

struct Difference {
    vec2 first;
    vec2 second;
};

Difference difference(int k, int before, int after, vec2 step) {
    if (landed(before) && landed(after)) {
        vec2 low = -between(k, before);
        vec2 high = between(k, after);
        float l = length(low);
        float h = length(high);
        bool jumps = p.list != 0 && max(l, h) > 3 * (min(l, h) + length(step));
        if (jumps) return Difference(l < h ? low : high, vec2(0));
        return Difference(0.5 * (low + high), high - low);
    }
    if (landed(before)) return Difference(-between(k, before), vec2(0));
    return Difference(landed(after) ? between(k, after) : step, vec2(0));
}

float away_from_end(bool ends, int vertex, int count) {
    float behind = vertex + 0.5;
    float before = count - vertex - 0.5;
    float nearest = behind <= before ? behind : -before;
    return ends && abs(nearest) < splat_reach * splat_deviation ? nearest : 0;
}

// `away` vertices from the lattice's end, along the axis with the differences a; `step` is from vertex to vertex along it,
// `across` along the other.
SplatEdge edge_of(int k, float away, int step, int across, vec2 a, vec2 b, vec2 shift) {
    if (away == 0) return SplatEdge(vec2(0), vec2(0), 0);
    vec2 to_edge = -away * a - shift;
    vec2 mirrored = -2 * away * a;
    if (p.list == 0) {
        int outwards = away > 0 ? -step : step;
        int last = k + int(abs(away)) * outwards;
        to_edge = (9 * (between(k, last) + between(k, last + outwards)) -
                   (between(k, last - outwards) + between(k, last + 2 * outwards))) / 16 - shift;
        int image = last + (last - k) + outwards;
        vec2 bend = between(image, image - step) + between(image, image + step) + between(image, image - across) +
                    between(image, image + across);
        mirrored = between(k, image) + 0.5 * splat_deviation * splat_deviation * bend - shift;
    }
    return splat_edge(away > 0 ? a : -a, b, to_edge, mirrored);
}

SplatRecord with_edges(SplatRecord r, int k, Difference x, Difference y, vec2 shift) {
    ivec2 vertex = p.list != 0 ? ivec2(flights[k].vertex_x, flights[k].vertex_y)
                               : ivec2(p.first_x + k % p.columns, p.first_y + k / p.columns);
    float away_x = away_from_end((p.ends & 1) != 0, vertex.x, p.domain_x);
    float away_y = away_from_end((p.ends & 2) != 0, vertex.y, p.domain_y);
    if (away_x == 0 && away_y == 0) return r;
    SplatEdge west = edge_of(k, away_x, 1, p.columns, x.first, y.first, shift);
    SplatEdge south = edge_of(k, away_y, p.columns, 1, y.first, x.first, shift);
    ivec2 low = ivec2(floor(vec2(r.part_x - r.reach_x, r.part_y - r.reach_y)));
    ivec2 high = ivec2(floor(vec2(r.part_x + r.reach_x, r.part_y + r.reach_y)));
    if ((!is_edge(west) && !is_edge(south)) || high.x - low.x >= widest_edged || high.y - low.y >= widest_edged) return r;
    SplatRecord e = r;
    e.west_x = west.mirrored.x;
    e.west_y = west.mirrored.y;
    e.west_normal_x = west.normal.x;
    e.west_normal_y = west.normal.y;
    e.west_inside = west.inside;
    e.south_x = south.mirrored.x;
    e.south_y = south.mirrored.y;
    e.south_normal_x = south.normal.x;
    e.south_normal_y = south.normal.y;
    e.south_inside = south.inside;
    float sum = 0;
    for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i) sum += splat_share(e, vec2(i - r.part_x, j - r.part_y));
    if (!(sum > 0)) return r;
    e.power /= sum;
    return e;
}

SplatRecord splat_of(int k) {
    SplatLanding l = landings[k];
    SplatRecord r = SplatRecord(l.pixel_x, l.pixel_y, l.part_x, l.part_y, l.power, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                                0, 0);
    SplatShape s = round_splat(p.radius);
    Difference x;
    Difference y;
    if (p.fixed_size == 0) {
        ivec4 n = p.list != 0 ? ivec4(flights[k].west, flights[k].east, flights[k].south, flights[k].north)
                              : ivec4(k - 1, k + 1, k - p.columns, k + p.columns);
        x = difference(k, n[0], n[1], vec2(p.step_x_x, p.step_x_y));
        y = difference(k, n[2], n[3], vec2(p.step_y_x, p.step_y_y));
        s = landed_splat(x.first, y.first, x.second, y.second);
    }
    vec2 at = vec2(l.part_x, l.part_y) + s.shift;
    // Into the first period; copies are drawn around it.
    if (p.wraps != 0) {
        vec2 pixel = vec2(l.pixel_x, l.pixel_y) + at;
        vec2 periods = floor(vec2(p.per_x_x * pixel.x + p.per_x_y * pixel.y + p.origin_x,
                                  p.per_y_x * pixel.x + p.per_y_y * pixel.y + p.origin_y));
        periods *= vec2((p.wraps & 1) != 0 ? 1 : 0, (p.wraps & 2) != 0 ? 1 : 0);
        at -= periods.x * vec2(p.period_x_x, p.period_x_y) + periods.y * vec2(p.period_y_x, p.period_y_y);
    }
    vec2 whole = floor(at);
    r.pixel_x += int(whole.x);
    r.pixel_y += int(whole.y);
    r.part_x = at.x - whole.x;
    r.part_y = at.y - whole.y;
    r.along = s.along;
    r.across = s.across;
    r.lean = s.lean;
    r.transposed = s.transposed;
    vec2 deviation = vec2(s.along, s.across + abs(s.lean) * s.along);
    vec2 reach = splat_reach * (s.transposed > 0.5 ? deviation.yx : deviation);
    r.reach_x = reach.x;
    r.reach_y = reach.y;
    return p.fixed_size == 0 ? with_edges(r, k, x, y, s.shift) : r;
}

// The part of a splat's light that lies between two corners, from its centre: line by line, or strip by strip where it
// is wide.
float part_between(SplatShape s, vec2 low, vec2 high) {
    bool upright = s.transposed > 0.5;
    float from = max(upright ? low.y : low.x, -splat_reach * s.along);
    float to = min(upright ? high.y : high.x, splat_reach * s.along);
    float bottom = upright ? low.x : low.y;
    float top = upright ? high.x : high.y;
    // Lines begin at whole pixels from `low`.
    float first = upright ? low.y : low.x;
    from = first + floor(from - first);
    int lines = max(0, int(ceil(to - from)));
    int strips = min(lines, 512);
    float width = strips == lines ? 1 : (to - from) / strips;
    float sum = 0;
    for (int k = 0; k < strips; ++k) {
        float l = clamp((from + k * width) / s.along, -splat_reach, splat_reach);
        float h = clamp((from + (k + 1) * width) / s.along, -splat_reach, splat_reach);
        SplatLine line = splat_line(s, l, normal_at(l), h, normal_at(h));
        sum += line.share * (splat_below((top - line.middle) / line.deviation) -
                             splat_below((bottom - line.middle) / line.deviation));
    }
    return sum;
}

// The part of one copy's light that lies on the map.
float part_on_map(SplatRecord r, float power, vec2 shift) {
    vec2 centre = vec2(r.part_x, r.part_y) + shift;
    vec2 at = vec2(r.pixel_x, r.pixel_y) + centre;
    vec2 reach = vec2(r.reach_x, r.reach_y);
    vec2 size = vec2(p.map_width, p.map_height);
    if (any(lessThan(at + reach, vec2(0))) || any(greaterThan(at - reach, size))) return 0;
    if (all(greaterThanEqual(at - reach, vec2(0))) && all(lessThan(at + reach, size))) return 1;
    if (!is_edge(west_of(r)) && !is_edge(south_of(r))) {
        vec2 corner = vec2(-r.pixel_x, -r.pixel_y) - centre;
        return part_between(shape_of(r), corner, corner + size);
    }
    ivec2 low = ivec2(max(floor(at - reach), vec2(0)));
    ivec2 high = ivec2(min(floor(at + reach), size - 1));
    float sum = 0;
    for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i) sum += splat_share(r, vec2(i - r.pixel_x, j - r.pixel_y) - centre);
    return sum * r.power / power;
}

void account_for(SplatRecord r, SplatLanding l, inout SplatAccount account) {
    if (!(l.power > 0)) return;
    float part = 0;
    for (int b = p.copy_low_y; b <= p.copy_high_y; ++b)
        for (int a = p.copy_low_x; a <= p.copy_high_x; ++a)
            part += part_on_map(r, l.power, a * vec2(p.period_x_x, p.period_x_y) + b * vec2(p.period_y_x, p.period_y_y));
    if ((l.state & 2) == 0)
        account.entered += l.power * part;
    else if (part < 1)
        account.outside += l.power * (1 - part);
    else
        account.entered += l.power * (part - 1);
}

void main() {
    int chunk = int(gl_WorkGroupID.y);
    int me = int(gl_LocalInvocationID.x);
    int workers = int(gl_WorkGroupSize.x);
    int end = min(p.count, (chunk + 1) * splat_chunk);
    SplatAccount account = SplatAccount(0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    for (int k = chunk * splat_chunk + me; k < end; k += workers) {
        // Vertices without light, at the lattice's rim among them, have no neighbours to go by.
        if (landings[k].power > 0)
            records[k] = splat_of(k);
        else
            records[k] = SplatRecord(0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    }
    for (int k = chunk * splat_chunk + me; k < end; k += workers) account_for(records[k], landings[k], account);
    accounts[chunk * workers + me] = account;
}
