// The floor map of Yuksel & Keyser (2009). Include after optics.glsl.
// Base pixel of a sample: the pixel that the sample's light would hit if the water were at rest. Displacements are in
// pixels, from the base pixel's centre to where the light lands.

struct FloorLight {
    real3 direction;    // s
    real irradiance;    // E0, W/m2
    real index;         // n
    real fresnel;       // 1 or 0
    real depth;         // m
    real2 rest_travel;  // travel through water at rest
    real2 pixel_x;      // displacement in pixels = (dot(pixel_x, metres), dot(pixel_y, metres))
    real2 pixel_y;
};

struct FloorSample {
    real2 displacement;  // pixels
    real path;           // m under water
    real incident;       // W per m2 of horizontal area, as are the next
    real transmitted;
};

// Pass 0: lands the light that enters at a point of the real surface (paper eq. 1, from the elevation, not the mean plane).
KERNEL FloorSample land_on_floor(FloorLight light, real elevation, real2 slope) {
    Refraction r = refract_sun(light.direction, slope, light.index, light.fresnel);
    real descent = max(real(0), elevation + light.depth);
    real2 shift = real2(descent * r.travel.x - light.depth * light.rest_travel.x,
                        descent * r.travel.y - light.depth * light.rest_travel.y);
    FloorSample landed;
    landed.displacement = real2(light.pixel_x.x * shift.x + light.pixel_x.y * shift.y,
                                light.pixel_y.x * shift.x + light.pixel_y.y * shift.y);
    landed.path = descent * r.path;
    landed.incident = light.irradiance * r.incident;
    landed.transmitted = landed.incident * r.transmittance;
    return landed;
}

// Overlap of a sample's one-pixel box with a pixel at this distance along one axis (paper, figure 5).
KERNEL real pixel_overlap(real distance) {
    return max(real(0), real(1) - abs(distance));
}

// How much of a sample's box lies in columns (rows) that the window reaches and, of that, on the map. The box of a
// sample with base column `base` covers columns base + floor(displacement) and the next.
struct AxisShare {
    real in_window;
    real on_map;
};

KERNEL AxisShare share_on_axis(real displacement, real base, real half_window, real size) {
    real low = floor(displacement);
    real high_weight = displacement - low;
    real low_weight = real(1) - high_weight;
    real high = low + real(1);
    real low_seen = abs(low) <= half_window ? low_weight : real(0);
    real high_seen = abs(high) <= half_window ? high_weight : real(0);
    real low_column = base + low;
    real high_column = base + high;
    AxisShare share;
    share.in_window = low_seen + high_seen;
    share.on_map = (low_column >= real(0) && low_column < size ? low_seen : real(0)) +
                   (high_column >= real(0) && high_column < size ? high_seen : real(0));
    return share;
}
