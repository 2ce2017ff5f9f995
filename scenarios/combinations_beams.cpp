// What goes together in the light of the water.
#include <fmt/format.h>

#include "scenarios/combinations.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

namespace {

/// Waves that are prescribed do not feel the ground: it is there for light alone, and of that for beams.
void check_ground(const Scenario& s) {
    if (!has_ground(s) || resolve_model(s).model != ModelChoice::prescribed) return;
    const std::string ground = s.domain.bathymetry ? "domain.bathymetry" : "domain.ground";
    const std::string beside = fmt::format("it beside {} and waves.model = \"prescribed\"", ground);
    if (s.floor)
        s.origin.reject("caustics.floor", beside + ", whose floor map is of a flat floor",
                        "[caustics.beams] alone, which know the ground, or model shallow-water");
    if (!s.beams)
        s.origin.reject(ground, "it beside waves.model = \"prescribed\" without [caustics.beams]",
                        "[caustics.beams] in the scenario, or model shallow-water");
    for (std::size_t i = 0; i < s.probes.size(); ++i)
        if (!s.probes[i].depth_m)
            s.origin.reject(fmt::format("probe[{}]", i), beside + " without depth_m",
                            "depth_m of the probe, or model shallow-water");
}

/// Whether pictures of the scene are spoken of, be it that there are none for now.
bool states_image(const Scenario& s) { return s.origin.places.contains("output.image"); }

/// Above the water a camera sees reflected light, or the scene.
void check_camera_in_air(const Scenario& s) {
    const double height = s.camera->camera.position_m.z;
    const bool reflects = s.beams && s.beams->reflected;
    if (!reflects && states_image(s)) return;
    if (!reflects)
        s.origin.reject("camera.position_m", fmt::format("a height of {} m", height),
                        fmt::format("a height in the water, in (-{}, 0), or output.image = true or "
                                    "caustics.beams.reflected beside it",
                                    s.domain.depth_m));
    const ReflectedSection& reflected = *s.beams->reflected;
    if (height >= reflected.height_m)
        s.origin.reject("camera.position_m", fmt::format("a height of {} m", height),
                        fmt::format("one below caustics.beams.reflected.height_m = {}", reflected.height_m));
    if (s.beams->refine_below)
        s.origin.reject("caustics.beams.refine_below", "it beside a camera above the water", "a camera in the water");
}

void check_camera(const Scenario& s) {
    const Camera& c = s.camera->camera;
    if (!s.beams && !states_image(s))
        s.origin.reject("camera", "it without [caustics.beams]",
                        "[caustics.beams] or output.image = true in the scenario");
    if (looks_from_air(s))
        check_camera_in_air(s);
    else if (!(c.position_m.z < 0 && (has_ground(s) || c.position_m.z > -s.domain.depth_m)))
        s.origin.reject("camera.position_m", fmt::format("a height of {} m", c.position_m.z),
                        fmt::format("a height in the water, in (-{}, 0)", s.domain.depth_m));
    if (c.position_m == c.target_m) s.origin.reject("camera.target_m", "the place of position_m", "another place");
    const double pixels = c.size.x * static_cast<double>(c.size.y);
    constexpr double most = 1e8;
    if (pixels > most)
        s.origin.reject("camera.pixels", fmt::format("[{}, {}]", c.size.x, c.size.y), "at most 1e8 pixels");
}

}  // namespace

void check_beams(const Scenario& s) {
    check_ground(s);
    if (s.camera) check_camera(s);
    for (std::size_t i = 0; i < s.probes.size(); ++i) {
        if (!s.probes[i].depth_m) continue;
        const std::string key = fmt::format("probe[{}].depth_m", i);
        if (!s.beams) s.origin.reject(key, "it without [caustics.beams]", "[caustics.beams] in the scenario");
        if (!has_ground(s) && *s.probes[i].depth_m > s.domain.depth_m)
            s.origin.reject(key, fmt::format("{}", *s.probes[i].depth_m),
                            fmt::format("at most domain.depth_m = {}", s.domain.depth_m));
    }
    if (s.beams && s.beams->centre_m && !s.beams->size_m)
        s.origin.reject("caustics.beams.centre_m", "it without size_m", "both or none");
}

}  // namespace waterlight
