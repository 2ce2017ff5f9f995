// What a frame looks like: the pictures of Outputs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/outputs.hpp"
#include "export/atomic_file.hpp"
#include "export/colour_picture.hpp"
#include "export/exr.hpp"
#include "export/framed_picture.hpp"
#include "export/frames.hpp"
#include "export/grey16.hpp"
#include "export/picture.hpp"
#include "render/overlay_map.hpp"

namespace waterlight {

namespace {

std::string name_of(Overlay overlay) {
    if (overlay == Overlay::elevation) return "Elevation of the surface";
    return overlay == Overlay::irradiance ? "Irradiance on the floor" : "Estimated error of the irradiance";
}

}  // namespace

void Outputs::write_pictures(const FrameFiles& frame) {
    const Grid& grid = frame.surface.grid;
    const double time_s = frame.surface.time_s;
    const PictureSettings elevation{.map = ColourMap::cool_warm,
                                    .range = elevation_range(frame),
                                    .quantity = "Elevation of the surface",
                                    .unit = "m",
                                    .time_s = time_s,
                                    .pitch_m = {grid.dx_m, grid.dy_m},
                                    .missing = ground_colour};
    write_picture(image("elevation", "png"), frame.shown.empty() ? frame.surface.elevation : frame.shown, elevation);
    if (has_picture_) write_radiance(frame);
    if (walls_) write_wall_pictures(frame);
    if (!plan_) return;
    const PictureSettings irradiance{.map = ColourMap::viridis,
                                     .range = {0, irradiance_max_},
                                     .quantity = "Irradiance on the floor",
                                     .unit = "W/m\u00b2",
                                     .time_s = time_s,
                                     .pitch_m = plan_->pitch_m};
    write_picture(image("irradiance", "png"), frame.irradiance, irradiance);
    if (frame.bands.size() == 3) write_colour(frame);
}

void Outputs::write_wall_pictures(const FrameFiles& frame) {
    for (int wall = 0; wall < 4; ++wall) {
        const auto w = static_cast<std::size_t>(wall);
        if (frame.walls[w].empty()) continue;
        write_picture(image(fmt::format("wall_{}", wall_names[w]), "png"), frame.walls[w],
                      {.map = ColourMap::viridis,
                       .range = {0, irradiance_max_},
                       .quantity = fmt::format("Irradiance on the {} wall", wall_names[w]),
                       .unit = "W/m\u00b2",
                       .time_s = frame.surface.time_s,
                       .pitch_m = wall_plan(*walls_, frame.surface.grid, wall).pitch_m});
    }
}

/// The longest wavelength is red; sunlight of the brightness at the end of the pictures' colours is white.
void Outputs::write_colour(const FrameFiles& frame) {
    std::vector<const BandFiles*> bands;
    for (const BandFiles& band : frame.bands) bands.push_back(&band);
    std::ranges::sort(bands, std::greater{}, &BandFiles::wavelength_nm);
    ColourFields fields;
    for (std::size_t c = 0; c < 3; ++c) {
        fields.field[c] = &bands[c]->irradiance;
        fields.full[c] = irradiance_max_ * bands[c]->share;
    }
    write_colour_picture(image("colour", "png"), fields);
}

void Outputs::write_radiance(const FrameFiles& frame) {
    for (const float r : frame.radiance.values()) radiance_so_far_ = std::max<double>(radiance_so_far_, r);
    const double most = radiance_max_.value_or(radiance_so_far_ > 0 ? radiance_so_far_ : 1);
    const ValueRange range =
        radiance_decades_ ? ValueRange{most * std::pow(10.0, -*radiance_decades_), most, true} : ValueRange{0, most};
    write_picture(image("radiance", "png"), frame.radiance,
                  {.map = ColourMap::deep_water,
                   .range = range,
                   .quantity = "Scattered light",
                   .unit = "W/(m\u00b2 sr)",
                   .time_s = frame.surface.time_s,
                   .length_bar = false});
}

/// As large as the camera's, unless there is a legend around it.
void Outputs::write_scene(const FrameFiles& frame) {
    const ColourImage& picture = frame.scene.image;
    if (look_->overlay == Overlay::none) return write_file(image("scene", "png"), encode_png(picture));
    const PictureSettings legend{.map = overlay_map(look_->overlay),
                                 .range = {look_->range.low, look_->range.high},
                                 .quantity = name_of(look_->overlay),
                                 .unit = look_->overlay == Overlay::elevation ? "m" : "W/m\u00b2",
                                 .time_s = frame.surface.time_s,
                                 .length_bar = false};
    write_file(image("scene", "png"), encode_png(framed_picture(picture, legend, frame.scene.clipped)));
}

ValueRange Outputs::elevation_range(const FrameFiles& frame) {
    const Field<float>& elevation = frame.shown.empty() ? frame.surface.elevation : frame.shown;
    if (settings_.elevation_max_m) return {-*settings_.elevation_max_m, *settings_.elevation_max_m};
    const bool flat = std::ranges::all_of(elevation.values(), [](float e) { return e == 0 || std::isnan(e); });
    const ValueRange now = symmetric_range(elevation);
    if (flat && !elevation_range_) return now;
    if (!elevation_range_ || now.high > elevation_range_->high) elevation_range_ = now;
    return *elevation_range_;
}

void Outputs::write_greys(const FrameFiles& frame) {
    write_grey16(image("elevation16", "png"), frame.surface.elevation, elevation_range(frame), "elevation", "m");
    if (plan_) write_grey16(image("irradiance16", "png"), frame.irradiance, {0, irradiance_max_}, "irradiance", "W/m2");
}

void Outputs::write_exrs(const FrameFiles& frame) {
    const Grid& grid = frame.surface.grid;
    const double time_s = frame.surface.time_s;
    write_exr(image("elevation", "exr"), frame.surface.elevation, {"elevation", "m", time_s, {grid.dx_m, grid.dy_m}});
    if (has_picture_) write_exr(image("radiance", "exr"), frame.radiance, {"radiance", "W/(m2 sr)", time_s, {1, 1}});
    if (plan_) write_exr(image("irradiance", "exr"), frame.irradiance, {"irradiance", "W/m2", time_s, plan_->pitch_m});
}

}  // namespace waterlight
