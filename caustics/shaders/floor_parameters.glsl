// What the host tells the passes of the floor map. C++ and GLSL include the same text: scalars of four bytes only, so
// that both lay it out alike. Names as in caustics/floor_frame.hpp.

// The push constants of all three passes: 128 bytes, as many as every device takes.
struct FloorParameters {
    // The light: FloorLight.
    float direction_x, direction_y, direction_z;
    float irradiance;
    float index;
    float fresnel;
    float depth;
    float extinction;
    float rest_travel_x, rest_travel_y;
    float pixel_x_x, pixel_x_y;
    float pixel_y_x, pixel_y_y;
    // The surface.
    int nx, ny;
    int sides;  // side_x + 4 side_y
    float climb_x, climb_y;  // of the surface over one period
    // The lattice of samples and the map.
    float half_width_x, half_width_y;
    int first_column, column_count;
    int first_row, row_count;
    int half_samples, half_channels;
    int map_width, map_height;
    int options;  // 1: count_base_x, + 2: count_base_y, + 4: adaptive, + 8 strips
    // The rows of the lattice that this run of the passes handles, counted from the lattice's first.
    int band_begin, band_count;
};

// Coordinates in cells: SplitPlace along the domain's x and y.
struct FloorPlace {
    int whole_x;
    float part_x;
    int whole_y;
    float part_y;
};

// What some samples of one row add to the ledger, W/m2 of surface.
struct FloorRowLedger {
    float incident;
    float reflected;
    float extinguished;
    float outside;
    float lost;
    float entered;
    float objects;
};
