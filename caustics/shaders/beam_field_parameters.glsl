// What the host tells the pass that fills fields with light. C++ and GLSL include the same text: scalars of four bytes
// only, so that both lay it out alike.
struct BeamFieldParameters {
    int nx, ny;                      // cells of the grid of beams
    int columns, rows, slices;       // of the fields
    int first_slice, slice_count;    // that this run fills
    int periodic_x, periodic_y;      // 1 or 0
    float x0, y0;                    // corner of the domain, m
    float per_metre_x, per_metre_y;  // cells
    float depth;
    float extinction;
    float per_quantum;               // one over the flux, W, that a sum counts as 1
};
