// Pictures of a scene with objects in it, ray traced on the processor. No Vulkan.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "caustics/camera.hpp"
#include "caustics/objects/lamp.hpp"
#include "caustics/objects/object_set.hpp"
#include "export/png.hpp"
#include "render/look.hpp"
#include "render/radiance.hpp"
#include "render/scene.hpp"

namespace waterlight {

/// A scene and what is in it. `scene` is that of the Vulkan picture; its floor map is where the caustics and shadows on
/// the floor come from, of objects and lamp as well.
struct TracedScene {
    Scene scene;
    std::shared_ptr<const ObjectSet> objects{};  ///< at the surface's time; none: nothing
    std::optional<Lamp> lamp{};                  ///< beside the sun; without a sun, set that one's irradiance to 0
    double wavelength_nm = 587.6;                ///< for the index of glass
};

struct TraceOptions {
    int samples = 16;           ///< of a pixel, >= 1; taken as the square number not above
    int bounces = 16;           ///< surfaces that a way of sight meets at most, >= 1
    double least_share = 2e-3;  ///< ways that carry less of the picture's light end, in [0, 1)
    /// Called with the part that is done, now and then, from one thread at a time.
    std::function<void(double)> progress{};
};

struct TracedPicture {
    Radiance radiance;
    double exposure_w_m2_sr = 1;  ///< as Look has it
};

/// Follows each sample's sight backwards: through water and glass both ways by Fresnel's formula, off mirrors, to the
/// sky, floor, walls and ground, whose light is that of the Vulkan picture, from the same texts. The same bytes
/// whatever the number of threads. Look::samples is not used.
///
/// Diffuse objects have the light of sun, lamp and sky. In the water the sun comes along its way through still water,
/// as strong as the waves focus it there; a lamp comes straight, not refracted. Shadows are of objects alone, and glass
/// in the way lets through what goes straight. Sides that are periodic repeat the objects. A way that ends for want of
/// bounces sees the sky's mean. Throws InputError where a setting is out of its range, or the look has an overlay.
TracedPicture trace_picture(const TracedScene& scene, const Look& look, const Camera& camera,
                            const TraceOptions& options);

/// What a screen shows of it: the tone curve and sRGB of the Vulkan pictures, the top row first.
ColourImage developed(const TracedPicture& picture);

}  // namespace waterlight
