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

// The parts of a sample's box in the two columns (rows) that it touches, base + low and base + low + 1 with
// low = floor(displacement), where the window reaches them, else 0.
struct BoxShare {
    real low;
    real high;
};

KERNEL BoxShare box_share(real displacement, real low, real half_window) {
    real part = displacement - low;
    BoxShare share;
    share.low = abs(low) <= half_window ? real(1) - part : real(0);
    share.high = abs(low + real(1)) <= half_window ? part : real(0);
    return share;
}

// How much of the box the window sees and, of that, how much lies on a map of `size` columns.
struct AxisShare {
    real in_window;
    real on_map;
};

KERNEL AxisShare share_on_axis(real displacement, real base, real half_window, real size) {
    real low = floor(displacement);
    BoxShare box = box_share(displacement, low, half_window);
    real column = base + low;
    AxisShare share;
    share.in_window = box.low + box.high;
    share.on_map = (column >= real(0) && column < size ? box.low : real(0)) +
                   (column >= real(-1) && column < size - real(1) ? box.high : real(0));
    return share;
}
