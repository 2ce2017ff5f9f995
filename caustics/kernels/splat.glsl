// Caustics mapping: Shah, Konttinen & Pattanaik, "Caustics Mapping: An Image-space Technique for Real-time Caustics", IEEE
// TVCG 13 (2007). The light's image, landing in it, and splats. Include after optics.glsl.

// The light's image: where its rays meet the plane z = level. Parallel rays (parallel = 1) run along `source`, those of a
// lamp (0) come from there. Of parallel light the image of a flat floor at that level is the floor itself.
struct LightImage {
    real3 source;
    real parallel;
    real level;
};

// The way of the ray through a place, towards the image; not a unit vector.
KERNEL real3 light_ray(LightImage image, real3 at) {
    return image.parallel * image.source + (real(1) - image.parallel) * (at - image.source);
}

// Where the ray through a place comes to a height.
KERNEL real3 ray_at_height(LightImage image, real3 at, real height) {
    real3 ray = light_ray(image, at);
    real t = (height - at.z) / ray.z;
    return real3(at.x + t * ray.x, at.y + t * ray.y, height);
}

// The place in the image of a place in the world.
KERNEL real2 in_image(LightImage image, real3 at) {
    real3 there = ray_at_height(image, at, image.level);
    return real2(there.x, there.y);
}

// The place of a height on the ray of a place in the image.
KERNEL real3 of_image(LightImage image, real2 place, real height) {
    return ray_at_height(image, real3(place.x, place.y, image.level), height);
}

// A light: irradiance (W/m2) on a plane that faces parallel rays, or a lamp's intensity (W/sr) within its cone.
struct SplatLight {
    LightImage image;
    real strength;
    real3 axis;   // of a lamp's cone
    real cosine;  // of its half-angle; below -1: to all sides
};

struct LightThere {
    real3 direction;  // unit
    real irradiance;  // W/m2 on a plane that faces it
};

KERNEL LightThere light_at(SplatLight light, real3 at) {
    real3 ray = light_ray(light.image, at);
    real length2 = dot(ray, ray);
    real lamp = real(1) - light.image.parallel;
    LightThere there;
    there.direction = ray * (real(1) / sqrt(length2));
    real lit = dot(there.direction, light.axis) >= light.cosine ? real(1) : real(0);
    there.irradiance = light.strength * (light.image.parallel + lamp * lit / length2);
    return there;
}

// A vertex on the water: light goes on from there. W per m2 of horizontal area.
struct WaterVertex {
    real3 direction;  // unit
    real incident;
    real transmitted;
};

KERNEL WaterVertex enter_water(SplatLight light, real3 at, real2 slope, real index, real fresnel) {
    LightThere there = light_at(light, at);
    Refraction r = refract_sun(there.direction, slope, index, fresnel);
    real descent = real(1) / r.path;
    WaterVertex v;
    v.direction = real3(r.travel.x * descent, r.travel.y * descent, -descent);
    v.incident = there.irradiance * r.incident;
    v.transmitted = v.incident * r.transmittance;
    return v;
}

// One step of the landing: `found` is the receiver that the light sees behind start + d direction. The paper takes its
// distance for the next d. By height, that d is taken at which the ray is as high: exact where receivers are level.
KERNEL real next_distance(real3 start, real3 direction, real3 found, bool by_height) {
    real3 away = found - start;
    return by_height ? max(real(0), away.z / direction.z) : sqrt(dot(away, away));
}

// A splat, lengths in pixels: a Gaussian along the one of the map's axes on which it is longer, and of each line across
// it another, about a middle that leans.
struct SplatShape {
    real2 shift;      // of its centre from where its vertex lands
    real along;       // standard deviations
    real across;
    real lean;
    real transposed;  // 1 where the longer axis is y
};

// Standard deviation of a footprint, in spacings of vertices: splats on an even lattice add up to an even field but for
// 4 exp(-2 pi^2 deviation^2) = 6e-5, of which pixels average out more.
const real splat_deviation = real(0.75);
// Where a splat ends, in standard deviations.
const real splat_reach = real(3.6);

// The Gaussian in the lattice's own measure, landed: a and b are by how much the landing moves from vertex to vertex along
// the lattice's axes, bend_a and bend_b the second differences. To first order the covariance is that of a and b alone.
// To second order the centre moves by half the bend times the variance, without which the map would be blurred by as
// much: with it the error falls with the fourth power of the spacing. The bends also give the width that is left at folds.
KERNEL SplatShape landed_splat(real2 a, real2 b, real2 bend_a, real2 bend_b) {
    real variance = splat_deviation * splat_deviation;
    real least = real(1e-2);
    real bent = real(0.5) * variance * variance;
    real xx = variance * (a.x * a.x + b.x * b.x) + bent * (bend_a.x * bend_a.x + bend_b.x * bend_b.x) + least * least;
    real yy = variance * (a.y * a.y + b.y * b.y) + bent * (bend_a.y * bend_a.y + bend_b.y * bend_b.y) + least * least;
    real xy = variance * (a.x * a.y + b.x * b.y) + bent * (bend_a.x * bend_a.y + bend_b.x * bend_b.y);
    SplatShape s;
    s.shift = real(0.5) * variance * (bend_a + bend_b);
    s.transposed = yy > xx ? real(1) : real(0);
    real longer = max(xx, yy);
    s.along = sqrt(longer);
    s.lean = xy / longer;
    s.across = sqrt(max(least * least, min(xx, yy) - xy * s.lean));
    return s;
}

KERNEL SplatShape round_splat(real radius) {
    SplatShape s;
    s.shift = real2(real(0), real(0));
    s.transposed = real(0);
    s.along = radius;
    s.lean = real(0);
    s.across = radius;
    return s;
}

// The standard normal distribution at x: its density, and what lies below. Abramowitz & Stegun 7.1.26, to 1e-7.
struct NormalAt {
    real density;
    real below;
};

KERNEL NormalAt normal_at(real x) {
    real t = real(1) / (real(1) + real(0.231641888) * abs(x));
    real series = t * (real(0.254829592) +
                       t * (real(-0.284496736) +
                            t * (real(1.421413741) + t * (real(-1.453152027) + t * real(1.061405429)))));
    real bell = exp(real(-0.5) * x * x);
    real tail = real(0.5) * series * bell;
    NormalAt n;
    n.density = real(0.398942280401433) * bell;
    n.below = x < real(0) ? tail : real(1) - tail;
    return n;
}

// Of a standard normal distribution that is cut off at the splats' reach.
KERNEL real within_reach(real below) {
    const real cut = real(1.5910859e-4);  // what lies below -3.6
    return clamp((below - cut) * (real(1) / (real(1) - real(2) * cut)), real(0), real(1));
}

KERNEL real splat_below(real x) {
    return within_reach(normal_at(x).below);
}

// Of a splat's light what lies between two places on its longer axis, in standard deviations from its centre, and the
// Gaussian that this is across it, about a middle.
struct SplatLine {
    real share;
    real middle;     // pixels from the splat's centre
    real deviation;  // pixels
};

// The places are within the splat's reach.
KERNEL SplatLine splat_line(SplatShape s, real low, NormalAt at_low, real high, NormalAt at_high) {
    real part = at_high.below - at_low.below;
    SplatLine line;
    line.share = max(real(0), within_reach(at_high.below) - within_reach(at_low.below));
    // Mean and variance between the two; where hardly anything is, of the middle.
    bool thin = part < real(1e-5);
    real over = real(1) / (thin ? real(1) : part);
    real mean = thin ? real(0.5) * (low + high) : clamp((at_low.density - at_high.density) * over, low, high);
    real spread = real(1) + (low * at_low.density - high * at_high.density) * over - mean * mean;
    real leaning = s.lean * s.along;
    line.middle = leaning * mean;
    line.deviation = sqrt(s.across * s.across + leaning * leaning * (thin ? real(0) : clamp(spread, real(0), real(1))));
    return line;
}

// The share of a splat's light in the pixel whose lower corner is so far from its centre.
KERNEL real splat_in_pixel(SplatShape s, real2 corner) {
    real along = s.transposed > real(0.5) ? corner.y : corner.x;
    real across = s.transposed > real(0.5) ? corner.x : corner.y;
    real low = clamp(along / s.along, -splat_reach, splat_reach);
    real high = clamp((along + real(1)) / s.along, -splat_reach, splat_reach);
    SplatLine line = splat_line(s, low, normal_at(low), high, normal_at(high));
    real from = (across - line.middle) / line.deviation;
    return line.share * (splat_below(from + real(1) / line.deviation) - splat_below(from));
}

// Where the lattice ends, at a wall, its light ends along a line. What a splat near it has beyond is laid on this side, as
// a mirror would: else there would be a dark seam. Only of splats up to so many pixels wide and high.
const int widest_edged = 48;

struct SplatEdge {
    real2 mirrored;  // from the splat's centre to that of its mirror image
    real2 normal;    // unit, towards the light; 0: no edge
    real inside;     // how far the splat's centre is from the edge
};

// `to_edge` leads from the splat's centre to a place on the edge, `mirrored` to its mirror image; `b` is by how much the
// landing moves from vertex to vertex along the edge, `a` across it, times -1 where the lattice ends at its high side.
KERNEL SplatEdge splat_edge(real2 a, real2 b, real2 to_edge, real2 mirrored) {
    SplatEdge e;
    real across = a.x * b.y - a.y * b.x;
    real square = dot(b, b);
    // Where light lands on a line there is no saying which side is which.
    bool none = across * across <= real(1e-6) * square * dot(a, a);
    real scale = (none ? real(0) : (across < real(0) ? real(-1) : real(1))) / sqrt(max(square, real(1e-12)));
    e.normal = real2(b.y * scale, -b.x * scale);
    e.inside = -dot(e.normal, to_edge);
    e.mirrored = mirrored;
    return e;
}

// The part of a pixel on this side of the edge; `middle` is its middle from the splat's centre.
KERNEL real inside_edge(SplatEdge e, real2 middle) {
    real width = abs(e.normal.x) + abs(e.normal.y);
    return width > real(0) ? clamp(real(0.5) + (dot(e.normal, middle) + e.inside) / width, real(0), real(1)) : real(1);
}
