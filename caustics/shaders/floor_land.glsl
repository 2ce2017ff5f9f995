// Pass 0: lands the light of every sample of a band of lattice rows. One workgroup a row; each of its invocations also
// sums the ledger of the samples it landed. With SHADOWS defined objects stop light. A shader of one line includes this.
#include "sim/kernels/real.glsl"

#include "caustics/kernels/optics.glsl"
#include "caustics/kernels/floor.glsl"
#include "caustics/kernels/footprint.glsl"
#include "caustics/kernels/shadow.glsl"
#include "caustics/kernels/surface_lookup.glsl"
#include "caustics/shaders/floor_parameters.glsl"

layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;

layout(push_constant) uniform Push { FloorParameters f; };
layout(std430, binding = 0) readonly buffer Places { FloorPlace places[]; };  // of the columns, then of the rows
// Displacement along x of the whole band, then along y, then power; with the adaptive footprint also the width, height,
// slant and slide of the parallelograms.
layout(std430, binding = 1) writeonly buffer Landed { float landed[]; };
layout(std430, binding = 2) writeonly buffer Ledger { FloorRowLedger ledger[]; };
#ifdef SHADOWS
layout(std430, binding = 3) readonly buffer Shadows { float shadows[]; };  // of each sample: above, below, stopped
const int first_texels = 4;
#else
const int first_texels = 3;
#endif
// The surface, as texels: a device that is a CPU takes numbers of buffers one by one.
layout(binding = first_texels) uniform samplerBuffer elevations;
layout(binding = first_texels + 1) uniform samplerBuffer slopes_x;
layout(binding = first_texels + 2) uniform samplerBuffer slopes_y;

struct SurfaceSample {
    real elevation;
    real2 slope;
    real lit;      // part that light reaches
    real counted;  // part that the ledger counts
};

AxisPlace place(int whole, real part, int n, int side, real half_width) {
    return part >= 1 ? place_on_axis(whole + 1, part - 1, n, side, half_width)
                     : place_on_axis(whole, part, n, side, half_width);
}

real blend(vec4 around, AxisPlace x, AxisPlace y) {
    return x.water * y.water * bilinear(around[0], around[1], around[2], around[3], x.weight, y.weight);
}

SurfaceSample read_surface(int i, int j) {
    FloorPlace c = places[i];
    FloorPlace r = places[f.column_count + j];
    AxisPlace x = place(c.whole_x + r.whole_x, c.part_x + r.part_x, f.nx, f.sides & 3, f.half_width_x);
    AxisPlace y = place(c.whole_y + r.whole_y, c.part_y + r.part_y, f.ny, f.sides >> 2, f.half_width_y);
    ivec4 cells = ivec4(x.low, x.high, x.low, x.high) + f.nx * ivec4(y.low, y.low, y.high, y.high);
    vec4 mirror_x = vec4(x.mirror_low, x.mirror_high, x.mirror_low, x.mirror_high);
    vec4 mirror_y = vec4(y.mirror_low, y.mirror_low, y.mirror_high, y.mirror_high);
#define AT(field, n) texelFetch(field, cells[n]).x
#define AROUND(field) vec4(AT(field, 0), AT(field, 1), AT(field, 2), AT(field, 3))
    SurfaceSample s;
    s.elevation = blend(AROUND(elevations), x, y) + f.climb_x * wraps_between(x) + f.climb_y * wraps_between(y);
    s.slope = real2(blend(mirror_x * AROUND(slopes_x), x, y), blend(mirror_y * AROUND(slopes_y), x, y));
    s.lit = lit_part(x, f.sides & 3) * lit_part(y, f.sides >> 2);
    s.counted = counted_part(x, f.sides & 3, (f.options & 1) != 0, f.first_column + i, f.map_width) *
                counted_part(y, f.sides >> 2, (f.options & 2) != 0, f.first_row + j, f.map_height);
    return s;
}

FloorLight light() {
    return FloorLight(real3(f.direction_x, f.direction_y, f.direction_z), f.irradiance, f.index, f.fresnel, f.depth,
                      real2(f.rest_travel_x, f.rest_travel_y), real2(f.pixel_x_x, f.pixel_x_y),
                      real2(f.pixel_y_x, f.pixel_y_y));
}

real2 displacement(int i, int j) {
    SurfaceSample s = read_surface(i, j);
    return land_on_floor(light(), s.elevation, s.slope).displacement;
}

// Half of the next sample's displacement less half of the last one's; at the lattice's edges one-sided.
Parallelogram parallelogram(int i, int j) {
    int left = max(i - 1, 0);
    int right = min(i + 1, f.column_count - 1);
    int below = max(j - 1, 0);
    int above = min(j + 1, f.row_count - 1);
    real2 along_x = (displacement(right, j) - displacement(left, j)) / real(max(right - left, 1));
    real2 along_y = (displacement(i, above) - displacement(i, below)) / real(max(above - below, 1));
    return landed_parallelogram(real2(1 + along_x.x, along_x.y), real2(along_y.x, 1 + along_y.y));
}

SampleShare share_of_box(real2 displacement, real2 base) {
    AxisShare x = share_on_axis(displacement.x, base.x, real(f.half_samples), real(f.map_width));
    AxisShare y = share_on_axis(displacement.y, base.y, real(f.half_channels), real(f.map_height));
    return SampleShare(x.in_window * y.in_window, x.on_map * y.on_map);
}

SampleShare share_of_parallelogram(Parallelogram shape, real2 displacement, real2 base) {
    real strips = real(f.options >> 3);
    FloorReach reach = FloorReach(real2(f.half_samples, f.half_channels), real2(f.map_width, f.map_height), strips);
    SampleShare sum = SampleShare(0, 0);
    for (real k = 0; k < strips; ++k) {
        SampleShare share = share_of(reach, strip_of(shape, displacement, k, strips), base);
        sum.in_window += share.in_window;
        sum.on_map += share.on_map;
    }
    return sum;
}

ShadedLight shaded(int i, int j, real incident, real transmitted, real arrived) {
#ifdef SHADOWS
    int at = 3 * (j * f.column_count + i);
    return shade(SampleShadow(shadows[at], shadows[at + 1], shadows[at + 2]), incident, transmitted, arrived);
#else
    return ShadedLight(incident - transmitted, transmitted - arrived, 0, arrived);
#endif
}

// Lands sample (i, j), stores it, and returns what it adds to the ledger.
FloorRowLedger land(int i, int j) {
    SurfaceSample s = read_surface(i, j);
    FloorSample l = land_on_floor(light(), s.elevation, s.slope);
    real incident = s.lit * l.incident;
    real transmitted = s.lit * l.transmitted;
    real unshaded = f.extinction > 0 ? transmitted * beer_lambert(f.extinction, l.path) : transmitted;
    ShadedLight light = shaded(i, j, incident, transmitted, unshaded);
    real power = light.arrived;

    int band_size = f.band_count * f.column_count;
    int at = (j - f.band_begin) * f.column_count + i;
    landed[at] = l.displacement.x;
    landed[at + band_size] = l.displacement.y;
    landed[at + 2 * band_size] = power;

    real2 base = real2(f.first_column + i, f.first_row + j);
    SampleShare share;
    if ((f.options & 4) != 0) {
        Parallelogram shape = parallelogram(i, j);
        landed[at + 3 * band_size] = shape.width;
        landed[at + 4 * band_size] = shape.height;
        landed[at + 5 * band_size] = shape.slant;
        landed[at + 6 * band_size] = shape.slide;
        share = share_of_parallelogram(shape, l.displacement, base);
    } else {
        share = share_of_box(l.displacement, base);
    }
    return FloorRowLedger(s.counted * incident, s.counted * light.reflected, s.counted * light.extinguished,
                          s.counted * power * (share.in_window - share.on_map),
                          s.counted * power * (1 - share.in_window), (1 - s.counted) * power * share.on_map,
                          s.counted * light.objects);
}

FloorRowLedger sum(FloorRowLedger a, FloorRowLedger b) {
    return FloorRowLedger(a.incident + b.incident, a.reflected + b.reflected, a.extinguished + b.extinguished,
                          a.outside + b.outside, a.lost + b.lost, a.entered + b.entered, a.objects + b.objects);
}

void main() {
    int j = f.band_begin + int(gl_WorkGroupID.y);
    int me = int(gl_LocalInvocationID.x);
    int workers = int(gl_WorkGroupSize.x);
    FloorRowLedger mine = FloorRowLedger(0, 0, 0, 0, 0, 0, 0);
    for (int i = me; i < f.column_count; i += workers) mine = sum(mine, land(i, j));
    ledger[j * workers + me] = mine;
}
