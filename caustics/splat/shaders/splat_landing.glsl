// Landing in the light's image, for the passes that land vertices. They have the parameters `p` and the heights of the
// positions texture.

SplatLight light() {
    return SplatLight(LightImage(real3(p.source_x, p.source_y, p.source_z), p.parallel, p.level), p.strength,
                      real3(p.axis_x, p.axis_y, p.axis_z), p.cosine);
}

AxisPlace texel_place(float at, float first, float pitch, int n, int side) {
    float cell = (at - first) / pitch;
    float whole = floor(cell);
    return place_on_axis(int(whole), cell - whole, n, side, 0.5);
}

float receiver_height(vec2 at) {
    if (p.texels_x == 0) return p.level;
    AxisPlace x = texel_place(at.x, p.texel_at_x, p.texel_width, p.texels_x, p.texel_sides & 3);
    AxisPlace y = texel_place(at.y, p.texel_at_y, p.texel_height, p.texels_y, p.texel_sides >> 2);
    int low = p.texels_x * y.low;
    int high = p.texels_x * y.high;
    return bilinear(heights[low + x.low], heights[low + x.high], heights[high + x.low], heights[high + x.high], x.weight,
                    y.weight);
}

bool within(float at, float first, float pitch, int n, int side) {
    float cell = (at - first) / pitch + 0.5;
    return side == SIDE_PERIODIC || (cell >= 0 && cell <= n);
}

bool is_seen(vec2 at) {
    return p.texels_x == 0 ||
           (within(at.x, p.texel_at_x, p.texel_width, p.texels_x, p.texel_sides & 3) &&
            within(at.y, p.texel_at_y, p.texel_height, p.texels_y, p.texel_sides >> 2));
}

struct Landed {
    float distance;
    float last_step;
    bool seen;
};

Landed land_in_image(vec3 start, vec3 direction) {
    LightImage image = light().image;
    bool by_height = p.by_height != 0;
    float above = max(0, start.z - image.level);
    Landed l = Landed(by_height ? above / -direction.z : above, 0, true);
    for (int k = 0; k < p.iterations; ++k) {
        vec2 place = in_image(image, start + l.distance * direction);
        vec3 found = of_image(image, place, receiver_height(place));
        float next = next_distance(start, direction, found, by_height);
        l.last_step = abs(next - l.distance);
        l.distance = next;
        if (l.last_step == 0) break;
    }
    l.seen = is_seen(in_image(image, start + l.distance * direction));
    return l;
}

// Lands light from a place that is pixel + part on the map, and accounts for it.
SplatLanding land_from(vec3 start, vec3 direction, float power, float extinction, bool own, ivec2 pixel, vec2 part,
                       inout SplatAccount account) {
    Landed l = land_in_image(start, direction);
    vec2 way = l.distance * direction.xy;
    vec2 at = part + vec2(p.pixel_x_x * way.x + p.pixel_x_y * way.y, p.pixel_y_x * way.x + p.pixel_y_y * way.y);
    bool finite = abs(at.x) < 1e9 && abs(at.y) < 1e9;
    vec2 whole = finite ? floor(at) : vec2(0);
    SplatLanding landing = SplatLanding(pixel.x + int(whole.x), pixel.y + int(whole.y), at.x - whole.x, at.y - whole.y, 0,
                                        (finite ? 1 : 0) + (own ? 2 : 0));
    if (!(power > 0)) return landing;
    float counted = own ? 1 : 0;
    float left = finite && extinction > 0 ? power * beer_lambert(extinction, l.distance) : power;
    account.vertices += 1;
    account.extinguished += counted * (power - left);
    if (!finite || !l.seen) {
        account.missed += 1;
        account.outside += finite ? counted * left : 0;
        account.lost += finite ? 0 : counted * left;
        return landing;
    }
    if (l.last_step > p.pixel_m) account.not_converged += 1;
    account.step2 += l.last_step * l.last_step;
    landing.power = left;
    return landing;
}
