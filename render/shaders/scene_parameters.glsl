// What the host tells the passes of a picture. C++ and GLSL include the same text: scalars of four bytes only, so that
// both lay it out alike. Lengths in metres, light in W/m2, suffixes r, g, b for the colours.

// The scene, a uniform block at binding 0 of every pass.
struct SceneParameters {
    float sun_x, sun_y, sun_z;  // to the sun, unit
    float sun_irradiance;       // E0; 0 with the sun below the horizon
    float sun_radius;           // half-angle of its disc, radians
    // Its light below flat water: metres per metre of descent, the way's part of it, what enters on the horizontal plane.
    float travel_x, travel_y, path, entering;
    float index, fresnel;
    float extinction;                                // of light on its way as the fields know it, 1/m
    float colour_r, colour_g, colour_b;              // absorption beyond, 1/m
    float left_r, left_g, left_b;                    // of the sun's light on the flat floor, by that absorption
    float sight_r, sight_g, sight_b;                 // extinction on the camera's way
    float absorption_r, absorption_g, absorption_b;  // of diffuse light
    float scattering;
    float depth;  // of the flat floor
    float x0, y0, x1, y1;  // the domain's sides
    float cell_x, cell_y;
    float freeboard;
    float floor_r, floor_g, floor_b, floor_side;  // albedos, and sizes of patterns
    float wall_r, wall_g, wall_b, wall_side;
    float deck_r, deck_g, deck_b, deck_side;
    float mean_r, mean_g, mean_b;                 // albedo of the floor with its pattern
    float sky_scale;                              // radiance where the sky's pattern is 1
    float sky_r, sky_g, sky_b;                    // irradiance of the sky
    float earth_r, earth_g, earth_b;              // radiance of what lies below the horizon
    float ambient_r, ambient_g, ambient_b;        // diffuse light on the flat floor
    float up_r, up_g, up_b;                       // and what comes up from it to the surface
    float r_ext, r_int;
    // Pixels of the floor map: origin + x along_x + y along_y, of its outer corner.
    float map_x, map_y, map_xx, map_xy, map_yx, map_yy;
    int map_width, map_height, map_levels;
    int map_offset_0, map_offset_1, map_offset_2, map_offset_3, map_offset_4, map_offset_5;  // of its levels
    float map_pitch;
    // Where the maps of walls 0 to 3 begin; columns, rows and pixels of those of the x sides and of the y sides.
    int wall_offset_0, wall_offset_1, wall_offset_2, wall_offset_3;
    int wall_columns_x, wall_columns_y, wall_rows;
    float wall_pitch_x, wall_pitch_y, wall_pitch_up;
    int ground_nx, ground_ny;
    float ground_low, ground_high;
    int volume_nx, volume_ny, volume_nz, volume_offset;
    float volume_depth;
    float mean_variance;  // of all slopes, per axis
    float per_exposure;   // 1 / exposure
    float overlay_low, overlay_scale;
};

// Push constants of every pass: the camera in the words of camera.hpp, and what this draw takes of the scene.
struct PassParameters {
    float eye_x, eye_y, eye_z;
    float corner_x, corner_y, corner_z;
    float right_x, right_y, right_z;
    float up_x, up_y, up_z;
    float forward_x, forward_y, forward_z;
    float near;
    float scale_x, scale_y;  // of the picture's plane to [-1, 1]
    // A mesh of columns by rows over a rectangle in cells of the surface, of one level of its fields.
    float u0, v0, u1, v1;
    int columns, rows;
    int level_offset, level_nx, level_ny;
    float level_scale;  // cells along one of its own
    int first_copy;     // of the list of copies
};
