#include "tests/bench/methods/methods.hpp"

#include <algorithm>
#include <memory>

#include "caustics/beam_volume.hpp"
#include "caustics/photons/photons.hpp"
#include "caustics/quads.hpp"
#include "caustics/splat/splat.hpp"

namespace waterlight::methods {

namespace {

Mapper held(std::shared_ptr<FloorMapper> mapper) {
    return [mapper = std::move(mapper)](const Surface& surface, FloorMap& map) { mapper->compute(surface, map); };
}

Mapper two_pass(FloorSettings settings, int finer, Footprint footprint) {
    settings.footprint = footprint;
    settings.samples_per_pixel = finer;
    return held(make_floor_cpu(settings));
}

Mapper quads(FloorSettings settings, int finer) {
    settings.samples_per_pixel = finer;
    return held(make_floor_quads(settings));
}

int longer(const FloorSettings& settings) { return std::max(settings.plan.width, settings.plan.height); }

Mapper splats(const FloorSettings& settings, int finer, SplatOptions::Size size) {
    SplatSettings s{.floor = settings};
    s.options.grid = finer * longer(settings);
    s.options.size = size;
    // As wide as the pixels between two vertices: narrower ones leave gaps.
    s.options.radius_pixels = 0.6;
    return held(make_splat_floor_cpu(s));
}

/// One slice of the fields, in the middle of water twice as deep: it lies at the floor.
Mapper beams(const FloorSettings& settings, int finer) {
    struct Buffers {
        Beams beams;
        BeamVolume volume;
    };
    BeamSettings b;
    b.grid = {finer * settings.plan.width, finer * settings.plan.height};
    b.depth_m = 2 * settings.depth_m;
    b.sun = settings.sun;
    b.optics = settings.optics;
    const glm::ivec3 cells{settings.plan.width, settings.plan.height, 1};
    return [b, cells, buffers = std::make_shared<Buffers>()](const Surface& surface, FloorMap& map) {
        make_beams(b, surface, buffers->beams);
        fill_volume(buffers->beams, cells, buffers->volume);
        std::swap(map.irradiance, buffers->volume.plane_irradiance);
    };
}

}  // namespace

Mapper photons(const FloorSettings& settings, int along, double blur_pixels) {
    PhotonSettings s{.floor = settings};
    s.options.map = along * longer(settings);
    s.options.blur_pixels = blur_pixels;
    return held(make_photon_floor(s));
}

std::vector<Method> all_methods() {
    using Settings = const FloorSettings&;
    using Size = SplatOptions::Size;
    return {
        {"two-pass, pixel", false, 1e-3, [](Settings s, int n) { return two_pass(s, n, Footprint::pixel); }},
        {"two-pass, adaptive", true, 1e-3, [](Settings s, int n) { return two_pass(s, n, Footprint::adaptive); }},
        {"quads", true, 1e-3, quads},
        {"splat, fixed", false, 1e-3, [](Settings s, int n) { return splats(s, n, Size::fixed); }},
        {"splat, jacobian", true, 1e-3, [](Settings s, int n) { return splats(s, n, Size::jacobian); }},
        {"photons", true, 1e-2, [](Settings s, int n) { return photons(s, photons_along_pixel * n, 0); }},
        {"photons, blurred", true, 1e-2,
         [](Settings s, int n) { return photons(s, photons_along_pixel * n, photon_blur); }},
        {"beams", true, 1e-3, beams},
    };
}

}  // namespace waterlight::methods
