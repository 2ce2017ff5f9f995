// What the host tells the passes of a picture of beams. C++ and GLSL include the same text: scalars of four bytes only, so
// that both lay it out alike.

// Push constants of the pass that views cells: the camera in the words of beam_view.hpp, z upwards.
struct BeamCellParameters {
    float eye_x, eye_y, eye_z;
    float corner_x, corner_y, corner_z;
    float right_x, right_y, right_z;
    float up_x, up_y, up_z;
    float forward_x, forward_y, forward_z;
    float shift_x, shift_y;  // of this copy of the beams
    float range;
    float scattering;
    int nx, ny;  // cells
    int width, height;
};

// Push constants of the pass that draws them: rays as (r_x, r_y, down), corners of the water's box relative to the eye.
struct BeamPixelParameters {
    float corner_x, corner_y, corner_z;
    float right_x, right_y, right_z;
    float up_x, up_y, up_z;
    float low_x, low_y, low_z;
    float high_x, high_y, high_z;
    float range;
    float extinction;
    float mean_cosine;  // g of Henyey & Greenstein
    int samples;
    int width, height;
};
