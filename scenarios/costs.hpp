// What the parts of a run cost in time: the one table, measured (docs/auto.md says with what command). Another machine
// is faster or slower by much the same factor in all of them, so that choices between models hold where seconds do not.
#pragma once

namespace waterlight::costs {

// One thread of an Intel Xeon (Sapphire Rapids), CPU back-end, 50 to 500 cells along a side; seconds.
constexpr double linear_frame = 6e-6;
constexpr double linear_step = 4e-6;
constexpr double linear_cell_step = 0.6e-9;
constexpr double shallow_step = 2e-6;
constexpr double shallow_cell_step = 24e-9;
constexpr double airy_frame = 8e-6;
constexpr double airy_cell_frame = 12e-9;
constexpr double surface_cell_frame = 1e-9;  // of linear and shallow-water: elevation and slopes for the light
constexpr double prescribed_cell_wave_frame = 2e-9;

constexpr double floor_pixel_frame = 5e-9;           // two-pass, a sample, footprint "pixel"
constexpr double floor_parallelogram_frame = 10e-9;  // footprint "adaptive"
constexpr double truth_pixel_frame = 2e-6;           // converged to 1e-3
// Of methods that look from the light, as multiples of the plain map's 10 ns in the same minute (pool, 512 x 384
// pixels):
constexpr double quad_frame = 17e-9;                                      // each of them
constexpr double splat_vertex_frame = 200e-9, splat_pixel_frame = 60e-9;  // in water
constexpr double splat_object_vertex_frame = 950e-9;                      // where there are objects
constexpr double photon_frame = 33e-9;                                    // from the water's surface
constexpr double photon_object_frame = 150e-9,
                 photon_cell_frame = 230e-9;  // among objects; of the water as they see it
constexpr double traced_sample_frame = 1e-6;  // of a picture with objects
constexpr double beam_frame = 0.1e-6;         // each of two a cell, made anew
constexpr double beam_slice_frame = 75e-9;    // each beam in each layer of volume_cells (beams_volume)
// A pixel that beams fill, for each column of their grid: 0.75 rays through cells of 5 ns each (beams_image).
constexpr double picture_pixel_column_frame = 3.7e-9;
// As multiples of the plain map in the same minute (light/*, docs/light.md):
constexpr double disc_factor = 1.25, disc_factor_a_pixel = 0.16;  // of the map, and for each pixel of the disc's radius
constexpr double relief_pixel_frame = 150 * floor_parallelogram_frame;  // light/ground
constexpr double wall_cell_frame = 18 * floor_parallelogram_frame;      // light/walls, four pixels of the map a cell
// A picture of the scene on a Vulkan device that is the CPU (pool, 480 x 270 and 960 x 540 pixels, 1 and 4 samples).
constexpr double scene_frame = 40e-3, scene_pixel_frame = 150e-9, scene_sample_frame = 100e-9;
constexpr double file_cell_frame =
    10e-9;  // a cell or a pixel of a field and its picture, written by a thread of its own

}  // namespace waterlight::costs
