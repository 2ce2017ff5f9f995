// What objects in the way leave of the light of one sample of the surface, and where the rest goes.

// Parts of a sample whose light objects stop: before it comes to the surface, and in the water; and what is left of the
// latter's light, after the water's extinction, where it is stopped.
struct SampleShadow {
    real above;
    real below;
    real stopped;
};

struct ShadedLight {
    real reflected;
    real extinguished;
    real objects;
    real arrived;
};

// incident = reflected + extinguished + objects + arrived, as without objects incident = (incident - transmitted) +
// (transmitted - arrived) + arrived.
KERNEL ShadedLight shade(SampleShadow shadow, real incident, real transmitted, real arrived) {
    real lit = max(real(0), real(1) - shadow.above - shadow.below);
    ShadedLight light;
    light.reflected = (real(1) - shadow.above) * (incident - transmitted);
    light.extinguished = lit * (transmitted - arrived) + (shadow.below - shadow.stopped) * transmitted;
    light.objects = shadow.above * incident + shadow.stopped * transmitted;
    light.arrived = lit * arrived;
    return light;
}
