// What goes together in the pictures of the scene.
#include <fmt/format.h>

#include "scenarios/combinations.hpp"
#include "scenarios/resolve.hpp"

namespace waterlight {

namespace {

void check_overlay(const Scenario& s) {
    const std::string key = "picture.overlay";
    const Overlay overlay = s.picture.look.overlay;
    const bool has_map = s.floor.has_value();
    if (overlay == Overlay::irradiance && !has_map)
        s.origin.reject(key, "irradiance without [caustics.floor]", "a floor map to show");
    if (overlay != Overlay::error) return;
    if (!has_map) s.origin.reject(key, "error without [caustics.floor]", "a floor map whose error is shown");
    if (!s.accuracy.estimate)
        s.origin.reject(key, "error without accuracy.estimate", "accuracy.estimate = true in the scenario");
    if (s.floor->method == FloorMethod::truth)
        s.origin.reject(key, "error beside caustics.floor.method = \"truth\"", "another method");
}

void check_range(const Scenario& s) {
    const PictureSection& p = s.picture;
    if (p.range_low && p.range_high && *p.range_low >= *p.range_high)
        s.origin.reject("picture.range_high", fmt::format("{}", *p.range_high),
                        fmt::format("> picture.range_low = {}", *p.range_low));
}

}  // namespace

void check_picture(const Scenario& s) {
    if (s.output.image && !s.camera)
        s.origin.reject("output.image", "true without [camera]", "[camera] in the scenario");
    if (traces_pictures(s) && s.picture.look.overlay != Overlay::none)
        s.origin.reject("picture.overlay", "it beside objects or a lamp",
                        "none; pictures of these are traced, without");
    const int samples = s.picture.look.samples;
    if ((samples & (samples - 1)) != 0) s.origin.reject("picture.samples", fmt::format("{}", samples), "1, 2, 4 or 8");
    check_overlay(s);
    check_range(s);
}

}  // namespace waterlight
