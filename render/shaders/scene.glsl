// What every pass of a picture sees: the scene's buffers, the variant, the ray of a pixel. After the kernels.

layout(constant_id = 0) const bool in_water = false;      // the camera
layout(constant_id = 1) const bool wall_x = false;        // sides
layout(constant_id = 2) const bool wall_y = false;
layout(constant_id = 3) const bool wraps_x = false;
layout(constant_id = 4) const bool wraps_y = false;
layout(constant_id = 5) const bool uneven = false;        // ground
layout(constant_id = 6) const int map_colours = 0;        // of the floor map; 0: there is none
layout(constant_id = 7) const bool wall_maps = false;
layout(constant_id = 8) const int scatter = SCATTER_NONE; // what is known of light scattered in the water
layout(constant_id = 9) const int floor_pattern = 0;
layout(constant_id = 10) const int wall_pattern = 0;
layout(constant_id = 11) const int deck_pattern = 0;
layout(constant_id = 12) const int overlay = OVERLAY_NONE;
layout(constant_id = 13) const bool uniform_sky = false;
layout(constant_id = 14) const bool coarse = false;       // a level of the surface's fields above the first
layout(constant_id = 15) const bool outside = false;      // a camera in the water, but beside the pool

layout(constant_id = 16) const int kind = 0;              // what of several things is drawn

layout(push_constant) uniform Push { PassParameters p; };
layout(std140, binding = 0) uniform SceneBlock { SceneParameters s; };
layout(std430, binding = 1) readonly buffer Copies { vec4 copies[]; };   // shift of each copy
layout(std430, binding = 2) readonly buffer Palette { vec4 palette[]; };
// What pixels look up, as texels: a device that is a CPU takes numbers of buffers one by one.
layout(binding = 3) uniform samplerBuffer surface_texels;  // slopes, variance, elevation
layout(binding = 4) uniform samplerBuffer light_texels;    // maps
layout(binding = 5) uniform samplerBuffer medium_texels;   // phase function, then the volume
layout(binding = 6) uniform samplerBuffer ground_texels;   // heights, with a margin of one cell

vec4 surface_cell(int k) { return texelFetch(surface_texels, k); }
float light_value(int k) { return texelFetch(light_texels, k).x; }
float medium_value(int k) { return texelFetch(medium_texels, k).x; }
float ground_value(int k) { return texelFetch(ground_texels, k).x; }

// What the next pixel to the right, and the next up, differ by. Derivatives of the device would not do: at the edge of a
// triangle the pixels beyond it need not read buffers.
struct PerPixel {
    vec3 right, up;
};
