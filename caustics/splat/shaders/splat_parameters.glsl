// What the host tells the passes of caustics mapping. C++ and GLSL include the same text: scalars of four bytes only, so
// that both lay it out alike. Lengths in metres where they do not say pixels.

// One workgroup a chunk of so many vertices. Small: devices that play a GPU end loops after 65535 steps an invocation.
const int splat_chunk = 1024;

struct SplatParameters {
    // The light: SplatLight.
    float source_x, source_y, source_z, parallel, level;
    float strength;
    float axis_x, axis_y, axis_z, cosine;
    // The water.
    float index, fresnel, extinction;
    int nx, ny;
    int sides;  // side_x + 4 side_y
    float climb_x, climb_y;
    float half_width_x, half_width_y;
    // The vertices: a lattice, or a list.
    int list;  // 1: flights
    int count;
    int columns, rows;
    int first_x, first_y;
    int domain_x, domain_y;
    int rim;
    int ends;  // 1: along x, + 2: along y
    float area;
    float step_x_x, step_x_y, step_y_x, step_y_y;  // pixels from vertex to vertex
    // The landing.
    int iterations, by_height;
    float pixel_m;
    int texels_x, texels_y;  // 0: level
    int texel_sides;
    float texel_at_x, texel_at_y;  // centre of the first
    float texel_width, texel_height;
    // The map.
    float pixel_x_x, pixel_x_y, pixel_y_x, pixel_y_y;  // a metre's pixels: (dot(pixel_x, metres), dot(pixel_y, metres))
    int map_width, map_height;
    int fixed_size;
    float radius;  // pixels
    // What lands repeats: periods in pixels, and in periods the place of a pixel's displacement and of pixel (0, 0).
    int wraps;  // 1: along x, + 2: along y
    float period_x_x, period_x_y, period_y_x, period_y_y;
    float per_x_x, per_x_y, per_y_x, per_y_y;
    float origin_x, origin_y;
    int copy_low_x, copy_high_x, copy_low_y, copy_high_y;
};

// A column or a row of the lattice.
struct SplatPlace {
    int cell;         // of the surface where its water is read, and the part of the way to the next
    float cell_part;
    float at;         // m
    int pixel_x;      // its part of the vertex's place on the map
    float part_x;
    int pixel_y;
    float part_y;
};

// Light that leaves an object, or water among objects.
struct SplatFlight {
    float x, y, z;
    float way_x, way_y, way_z;
    float power, extinction;
    int own;
    int pixel_x;  // where it starts, on the map
    float part_x;
    int pixel_y;
    float part_y;
    int vertex_x, vertex_y;
    int west, east, south, north;
};

// Where a vertex lands: a pixel and the place in it.
struct SplatLanding {
    int pixel_x, pixel_y;
    float part_x, part_y;
    float power;
    int state;  // 1: landed, + 2: of the domain
};

// A splat as it is drawn: SplatShape, and SplatEdge along both axes.
struct SplatRecord {
    int pixel_x, pixel_y;
    float part_x, part_y;
    float power;
    float along, across, lean, transposed;
    float reach_x, reach_y;
    float west_x, west_y, west_normal_x, west_normal_y, west_inside;
    float south_x, south_y, south_normal_x, south_normal_y, south_inside;
};

// What some vertices of one row add to the ledger, W, and to the report.
struct SplatAccount {
    float incident, reflected, extinguished, outside, lost, entered;
    int vertices, not_converged, missed;
    float step2;
};

// Of one copy of all splats: pixels.
struct SplatShift {
    float x, y;
    float width, height;  // of the map
};
