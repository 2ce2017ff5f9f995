// The kernels and words of all passes of a picture.
#include "sim/kernels/real.glsl"

#include "caustics/kernels/optics.glsl"
#include "caustics/kernels/phase_table.glsl"
#include "caustics/kernels/surface_lookup.glsl"
#include "render/kernels/ambient.glsl"
#include "render/kernels/finish.glsl"
#include "render/kernels/sky.glsl"
#include "render/kernels/view_ray.glsl"
#include "render/shaders/variant_words.glsl"
#include "render/shaders/scene_parameters.glsl"
#include "render/shaders/scene.glsl"
#include "render/shaders/ground_cells.glsl"
