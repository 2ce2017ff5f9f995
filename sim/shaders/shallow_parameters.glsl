// What the host tells the passes of the shallow-water model. C++ and GLSL include the same text after
// sim/kernels/shallow_sides.glsl: scalars of four bytes only, so that both lay it out alike.

struct ShallowParameters {
    int nx, ny;
    // Of ShallowStage.
    float dt;
    float per_dx, per_dy;
    float gravity;
    float film;
    float friction;
    float wet;    // ShallowWaterSettings::wet_m
    float datum;  // of the surface, m above level 0
    float time;   // s since the start
    int stage;    // 1 and 2: the stages of a step; 3: the friction before it; 0: a look at what is there
    SideDemand sides[4];  // west, east, south, north; levels are above the datum
};
