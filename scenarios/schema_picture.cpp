#include "scenarios/schema_picture.hpp"

#include "scenarios/schema_parts.hpp"

namespace waterlight {

using namespace schema;

namespace {

void describe_finish(Visitor& v, Finish& f) {
    v.value({"pattern", "", "What is drawn on it: nothing, square tiles with joints, or sand with ripples."},
            choice(f.pattern, {"plain", "tiles", "sand"}));
    v.value({"albedo", "", "Part of red, green and blue light that it reflects, to all sides alike.", fractions},
            &f.albedo);
    v.value({"tile_m", "m", "Side of a tile; of sand, the distance of its ripples.", positive}, &f.tile_m);
}

void describe_sky(Visitor& v, Sky& s) {
    v.value({"type", "", "Where its light comes from: clear, brighter towards sun and horizon; uniform, all over."},
            choice(s.type, {"clear", "uniform"}));
    v.value({"irradiance_w_m2", "W/m2", "Of the sky alone on the horizontal plane.", not_negative, false,
             "a sixth of light.irradiance_w_m2"},
            &s.irradiance_w_m2);
}

}  // namespace

void describe_picture(Visitor& v, PictureSection& s) {
    Look& look = s.look;
    v.value({"freeboard_m", "m", "How far walls and deck rise above still water.", not_negative}, &look.freeboard_m);
    v.value({"exposure_w_m2_sr", "W/(m2 sr)", "Radiance that the tone curve takes for white.", positive, false,
             "that of a white plane in sun and sky"},
            &look.exposure_w_m2_sr);
    v.value({"samples",
             "",
             "Samples of a pixel along edges: 1, 2, 4 or 8, or the most that the device has.",
             {.low = 1, .high = 8}},
            &look.samples);
    v.value({"colour_per_m", "1/m",
             "Absorption of red, green and blue light beyond the scenario's own; by default that of pure water at 650, "
             "550 and 450 nm.",
             not_negative},
            &look.colour_per_m);
    v.value(
        {"overlay", "",
         "Field to show in colours, with a legend: elevation on the water, irradiance or its estimated error on the "
         "floor."},
        choice(look.overlay, {"none", "elevation", "irradiance", "error"}));
    v.value({.name = "range_low",
             .meaning = "Value at the lower end of the overlay's colours, in m or W/m2.",
             .otherwise = "of irradiance 0, else -range_high"},
            &s.range_low);
    v.value({.name = "range_high",
             .meaning = "Value at the upper end.",
             .otherwise = "output.elevation_max_m, else twice the amplitude of the waves that are stated; "
                          "output.irradiance_max_w_m2, of errors a tenth of it"},
            &s.range_high);
    v.section({"floor", "", "How the floor, or the ground in its place, looks."},
              [&look](Visitor& in) { describe_finish(in, look.floor); });
    v.section({"walls", "", "How the walls of sides with boundary \"wall\" look."},
              [&look](Visitor& in) { describe_finish(in, look.walls); });
    v.section({"deck", "", "How the deck around a pool looks."},
              [&look](Visitor& in) { describe_finish(in, look.deck); });
    v.section({"sky", "", "The light of the sky."}, [&look](Visitor& in) { describe_sky(in, look.sky); });
}

}  // namespace waterlight
