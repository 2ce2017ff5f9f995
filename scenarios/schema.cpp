// Every key of a scenario, once: name, unit, range, meaning. Types and defaults are those of the settings they fill.
#include "scenarios/schema.hpp"

#include "scenarios/scenario.hpp"
#include "scenarios/schema_accuracy.hpp"
#include "scenarios/schema_beams.hpp"
#include "scenarios/schema_check.hpp"
#include "scenarios/schema_light.hpp"
#include "scenarios/schema_objects.hpp"
#include "scenarios/schema_parts.hpp"
#include "scenarios/schema_picture.hpp"
#include "scenarios/schema_shallow.hpp"

namespace waterlight {

using namespace schema;

namespace {

constexpr Range cell_counts{.low = 1, .high = 1 << 20};
constexpr Range pixel_counts{.low = 1, .high = 1 << 20};
constexpr Range window_sizes{.low = 1, .high = 9999};

void describe_domain(Visitor& v, DomainSection& s) {
    v.value({"size_m", "m", "Width and height of the patch of water.", positive, true}, &s.size_m);
    v.value({"cells", "", "Cells of the wave model along x and y.", cell_counts, false, "auto"}, &s.cells);
    v.value(
        {"depth_m", "m", "Depth of the still water above the flat floor, where the map of light lies.", positive, true},
        &s.depth_m);
    describe_ground(v, s);
}

void describe_water(Visitor& v, Water& w, WaterOptics& o, WaterColourSection& c) {
    v.value({"gravity_m_s2", "m/s2", "Acceleration of gravity.", positive}, &w.gravity_m_s2);
    v.value({"density_kg_m3", "kg/m3", "Density.", positive}, &w.density_kg_m3);
    v.value({"surface_tension_n_m", "N/m", "Surface tension; felt by ripples shorter than some 5 cm.", not_negative},
            &w.surface_tension_n_m);
    v.value({"refractive_index", "", "Of the water; that of air is 1.", {.low = 1, .high = 3}}, &o.refractive_index);
    v.value({"fresnel", "", "Whether the surface reflects its share; false lets all light in."}, &o.fresnel);
    describe_optics(v, o);
    describe_water_colour(v, c);
}

void describe_sine(Visitor& v, Sine& s) {
    v.value({"amplitude_m", "m", "Amplitude a.", {}, true}, &s.amplitude_m);
    v.value({"wavelength_m", "m", "Wavelength.", positive, true}, &s.wavelength_m);
    v.value({"direction_deg", "deg", "Direction of travel, counter-clockwise from +x.", circle}, &s.direction_deg);
    v.value({"phase_deg", "deg", "Phase at the origin at time 0.", circle}, &s.phase_deg);
    v.value({"frozen", "", "Whether it stands still; model prescribed only."}, &s.frozen);
}

void describe_standing(Visitor& v, StandingWave& s) {
    v.value({"amplitude_m", "m", "Amplitude.", {}, true}, &s.amplitude_m);
    v.value({"half_waves_x", "", "Half waves along x.", {.low = 0, .high = 1 << 20}}, &s.half_waves_x);
    v.value({"half_waves_y", "", "Half waves along y.", {.low = 0, .high = 1 << 20}}, &s.half_waves_y);
}

void describe_spectrum(Visitor& v, SpectrumSettings& s) {
    v.value({"type", "", "Model of the sea."}, choice(s.type, {"pierson-moskowitz", "jonswap", "tma"}));
    v.value({"significant_height_m", "m", "Hs = 4 sqrt(m0) of the whole spectrum.", positive}, &s.significant_height_m);
    v.value({"peak_period_s", "s", "Period of the most energetic waves.", positive}, &s.peak_period_s);
    v.value({"peak_enhancement", "", "gamma of JONSWAP and TMA.", {.low = 1, .high = 20}}, &s.peak_enhancement);
    v.value({"direction_deg", "deg", "Direction towards which the sea runs, counter-clockwise from +x.", circle},
            &s.direction_deg);
    v.value({"spreading", "", "s of the spreading cos^2s(angle / 2).", {.low = 0, .high = 1000}}, &s.spreading);
    v.value({"seed", "", "Seed of the random phases."}, &s.seed);
}

void describe_buoy(Visitor& v, std::string& stem, BuoySettings& s) {
    v.value(
        {"stem",
         "",
         "Path of a buoy's five NDBC files without .data_spec, .swdir, .swdir2, .swr1, .swr2; beside the scenario or "
         "below $WATERLIGHT_DATA.",
         {},
         true},
        &stem);
    v.value({.name = "time", .meaning = "Record to take, \"YYYY-MM-DD hh:mm\".", .otherwise = "the newest complete"},
            &s.time);
    v.value({"tail", "", "Whether to continue the spectrum beyond the buoy's highest frequency."}, &s.tail);
    v.value({"seed", "", "Seed of the random phases."}, &s.seed);
}

void describe_gerstner(Visitor& v, GerstnerSettings& s) {
    v.value({"waves", "", "Number of trochoidal waves.", {.low = 1, .high = 10000}}, &s.waves);
    v.value({"wavelength_m", "m", "Shortest and longest wavelength.", positive}, &s.wavelength_m);
    v.value({"steepness", "", "Sum of k a over the waves.", {.low = 0, .high = 1, .excludes_high = true}},
            &s.steepness);
    v.value({"direction_deg", "deg", "Mean direction of travel, counter-clockwise from +x.", circle}, &s.direction_deg);
    v.value({"spread_deg", "deg", "Directions are drawn within this of the mean.", {.low = 0, .high = 180}},
            &s.spread_deg);
    v.value({"seed", "", "Seed of lengths, directions and phases."}, &s.seed);
}

void describe_drop(Visitor& v, Drop& s) {
    v.value({"at_m", "m", "Place.", {}, true}, &s.at_m);
    v.value({"radius_m", "m", "Radius R of height (1 - r2/R2) exp(-r2/R2).", positive}, &s.radius_m);
    v.value({"height_m", "m", "Height at the centre; negative digs."}, &s.height_m);
    v.value({"time_s", "s", "When it falls.", not_negative}, &s.time_s);
}

void describe_rain(Visitor& v, Rain& s) {
    v.value({"drops_per_m2_s", "1/(m2 s)", "Mean number of drops.", positive}, &s.drops_per_m2_s);
    v.value({"radius_m", "m", "Least and greatest radius.", positive}, &s.radius_m);
    v.value({"height_m", "m", "Least and greatest height at the centre; negative digs."}, &s.height_m);
    v.value({"start_s", "s", "When it begins.", not_negative}, &s.start_s);
    v.value({.name = "end_s", .unit = "s", .meaning = "When it ends.", .range = not_negative, .otherwise = "never"},
            &s.end_s);
    v.value({"seed", "", "Seed of places, times and sizes."}, &s.seed);
}

void describe_wavemaker(Visitor& v, Wavemaker& s) {
    v.value({"from_m", "m", "One end of its line.", {}, true}, &s.from_m);
    v.value({"to_m", "m", "The other end.", {}, true}, &s.to_m);
    v.value({"amplitude_m", "m", "Amplitude of the waves it sends to both sides.", not_negative}, &s.amplitude_m);
    v.value({"period_s", "s", "Period.", positive}, &s.period_s);
    v.value({"phase_deg", "deg", "Phase at its start.", circle}, &s.phase_deg);
    v.value({"start_s", "s", "When it starts.", not_negative}, &s.start_s);
    v.value({"ramp_periods", "", "Periods over which it swells to its amplitude.", not_negative}, &s.ramp_periods);
}

void describe_waves(Visitor& v, WavesSection& s) {
    v.value({"model", "",
             "Wave model; auto takes prescribed where slope, file, gerstner or a frozen sine is stated, else the "
             "cheapest that "
             "meets accuracy.tolerance (`waterlight explain` says why)."},
            choice(s.model, {"auto", "linear", "airy", "shallow-water", "prescribed"}));
    v.section(sides_key, [&s](Visitor& in) { describe_sides(in, s); });
    v.value({"duration_s", "s", "Time to simulate; 0 gives one frame.", not_negative}, &s.duration_s);
    v.value(
        {"cfl",
         "",
         "Courant number: c dt sqrt(1/dx2 + 1/dy2) of linear, dt max((|u| + c)/dx + (|v| + c)/dy) of shallow-water.",
         {.low = 0, .high = 1, .excludes_low = true},
         false,
         "0.9 of linear, 0.8 of shallow-water"},
        &s.cfl);
    v.value({"margin_m", "m", "Width of the hidden margin that swallows waves beyond an absorbing side.", positive,
             false, "chosen by the model"},
            &s.margin_m);
    v.value({"slope",
             "",
             "A tilt of the surface along x and y; model prescribed only.",
             {.low = -1, .high = 1},
             false,
             "none"},
            &s.slope);
    v.value({"file",
             "",
             "Surface to take instead of formulas: .vti, or .pvd for a series, with an array \"elevation\"; beside the "
             "scenario or below $WATERLIGHT_DATA; model prescribed only.",
             {},
             false,
             "none"},
            &s.file);
    v.list({"sine", "", "A plane wave to start from."}, {{"", "", append<Sine>(s.sines, describe_sine)}});
    v.list({"standing", "", "A standing wave to start from."},
           {{"", "", append<StandingWave>(s.standing, describe_standing)}});
    v.optional_section({"spectrum", "", "A random sea to start from; model airy, periodic sides."},
                       into(s.spectrum, describe_spectrum));
    v.optional_section({"buoy", "", "A measured sea to start from; model airy, periodic sides."},
                       into(s.buoy, [](Visitor& in, BuoySettings& buoy) {
                           std::string stem = buoy.stem.string();
                           describe_buoy(in, stem, buoy);
                           buoy.stem = stem;
                       }));
    v.optional_section({"gerstner", "", "A sea of trochoidal waves; model prescribed."},
                       into(s.gerstner, describe_gerstner));
    describe_shallow(v, s);
    v.list({"source", "", "What disturbs the water; models linear, airy and shallow-water."},
           {{"drop", "A crater or a bump with its rim, of no volume.", append<Drop>(s.sources, describe_drop)},
            {"rain", "Drops at random places and times.", append<Rain>(s.sources, describe_rain)},
            {"wavemaker", "A line that sends plane waves to both sides.",
             append<Wavemaker>(s.sources, describe_wavemaker)}});
}

void describe_light(Visitor& v, Sun& s) {
    v.value({"elevation_deg", "deg", "Of the sun above the horizon.", {.low = 0, .high = 90, .excludes_low = true}},
            &s.elevation_deg);
    v.value({"azimuth_deg", "deg", "Towards the sun, counter-clockwise from +x.", circle}, &s.azimuth_deg);
    v.value({"irradiance_w_m2", "W/m2", "Of the sun on a plane that faces it.", not_negative}, &s.irradiance_w_m2);
}

void describe_window(Visitor& v, FloorWindow& s) {
    v.value({"samples", "", "Samples N along the map's x; odd.", window_sizes}, &s.samples);
    v.value({"channels", "", "Neighbouring rows M along the map's y, even: M + 1 channels; odd counts the channels.",
             window_sizes},
            &s.channels);
}

void describe_floor(Visitor& v, FloorSection& s) {
    v.value({"method", "",
             "two-pass: fast, float; truth: converged, double precision, slow; quads: forward, exact at folds; splat: "
             "caustics mapping; photons: followed through everything, noisy. What each can is in docs/methods.md."},
            choice(s.method, {floor_method_names.begin(), floor_method_names.end()}));
    v.value({"pixels", "", "Pixels of the map along its x and y.", pixel_counts, false, "auto"}, &s.pixels);
    v.optional_section(
        {.name = "window",
         .meaning = "How far light is followed from its rest position; auto is the least that loses none.",
         .otherwise = "auto"},
        into(s.window, describe_window));
    v.value(
        {"footprint", "",
         "What of the floor a landed sample lights: adaptive, the parallelogram where its light falls; pixel, a pixel "
         "as in Yuksel & Keyser."},
        choice(s.footprint, {"adaptive", "pixel"}));
    v.value({"samples_per_pixel",
             "",
             "Samples along each axis of a pixel; methods two-pass and quads.",
             {.low = 1, .high = 16}},
            &s.samples_per_pixel);
    describe_receiver(v, s.on);
    v.value({"angle_deg", "deg", "Of the map's x axis, counter-clockwise from the domain's.", circle}, &s.angle_deg);
    v.value({"centre_m", "m", "Centre of the map on the floor.", {}, false, "the domain's"}, &s.centre_m);
    v.value({"size_m", "m", "Size of the map.", positive, false, "the domain's"}, &s.size_m);
    v.value({"tolerance",
             "",
             "Relative error that the truth's own estimate must reach; method truth only.",
             {.low = 1e-7, .high = 0.1}},
            &s.tolerance);
    describe_methods(v, s);
}

void describe_output(Visitor& v, OutputSection& s) {
    v.value({"every_s", "s", "Time between frames.", positive}, &s.every_s);
    v.value({"probe_every_s", "s",
             "Time between the rows of probes.csv, frames or not; for each row beams and the two-pass map are made "
             "anew where "
             "a probe reads them.",
             positive, false, "every_s"},
            &s.probe_every_s);
    v.value({"checkpoint_every_s", "s",
             "Time on the clock between checkpoints, from which run --resume goes on; 0 writes none but where the run "
             "is interrupted.",
             not_negative},
            &s.checkpoint_every_s);
    v.value({"formats", "", "What to write; png16 is 16-bit grey with its scale in the file."},
            Words{{"vti", "png", "png16", "exr"}, &s.formats});
    v.value({"image", "",
             "Whether to draw each frame as a picture of the scene too, images/scene_*.png, as [camera] sees it; by "
             "Vulkan, on a GPU or on the CPU."},
            &s.image);
    v.value(
        {"fields", "",
         "Arrays of surface/*.vti beside elevation; velocity where the model has it. max_elevation, max_speed and "
         "arrival_time are those of extremes.vti, over all steps; model shallow-water only."},
        Words{{"elevation", "slope", "velocity", "depth", "max_elevation", "max_speed", "arrival_time"}, &s.fields});
    v.value({"compression", "", "Of the .vti arrays."}, choice(s.compression, {"none", "lz4", "zlib"}));
    v.value({"elevation_max_m", "m", "Elevation at the ends of the pictures' colours.", positive, false,
             "the largest so far"},
            &s.elevation_max_m);
    v.value({"irradiance_max_w_m2", "W/m2", "Irradiance at the bright end of the pictures' colours.", positive, false,
             "three times that below flat water"},
            &s.irradiance_max_w_m2);
}

void describe_probe(Visitor& v, Probe& s) {
    v.value({"name", "", "Column in probes.csv; letters, digits, _ and -.", {}, true}, &s.name);
    v.value({"at_m", "m", "Place in the domain.", {}, true}, &s.at_m);
    v.value({"depth_m", "m", "Depth below still water at which it reads the irradiance; needs caustics.beams.",
             positive, false, "that of the floor"},
            &s.depth_m);
}

}  // namespace

void describe(Visitor& v, Scenario& s) {
    v.value({"title", "", "What the scenario shows, in a few words."}, &s.title);
    v.section({"domain", "", "The patch of water."}, [&s](Visitor& in) { describe_domain(in, s.domain); });
    v.section({"water", "", "The water as waves and light feel it."},
              [&s](Visitor& in) { describe_water(in, s.water, s.optics, s.water_colour); });
    v.section({"waves", "", "How the surface moves."}, [&s](Visitor& in) { describe_waves(in, s.waves); });
    v.section({"light", "", "The sun, or a lamp in its place."}, [&s](Visitor& in) {
        describe_lamp(in, s.lamp);
        describe_light(in, s.light);
        describe_sun(in, s.sun);
    });
    describe_objects(v, s.objects);
    v.section({"caustics", "", "The light that the water focuses."}, [&s](Visitor& in) {
        in.optional_section({"floor", "", "The map of irradiance on the floor."}, into(s.floor, describe_floor));
        in.optional_section({"beams", "", "Beams of light in the water, for fields, places and pictures of it."},
                            into(s.beams, describe_beams));
        in.optional_section({"walls", "", "Maps of irradiance on the walls, of sides with boundary \"wall\"."},
                            into(s.walls, describe_walls));
    });
    v.optional_section(
        {"camera", "",
         "What sees the scene (output.image) and, with caustics.beams, the light that the water scatters "
         "alone."},
        into(s.camera, describe_camera));
    v.section(
        {"picture", "", "What pictures of the scene show beside the fields of the run. None of it changes a field."},
        [&s](Visitor& in) { describe_picture(in, s.picture); });
    v.section({"accuracy", "", "How wrong the run may be."}, [&s](Visitor& in) { describe_accuracy(in, s.accuracy); });
    v.section({"output", "", "What is written."}, [&s](Visitor& in) { describe_output(in, s.output); });
    v.list({"probe", "", "A gauge: elevation, and irradiance below it."},
           {{"", "", append<Probe>(s.probes, describe_probe)}});
    v.list({"check", "", "An expectation; the run fails with exit 1 where it is not met."},
           {{"", "", append<Check>(s.checks, describe_check)}});
    v.section({"check_run", "", "What the command `check` does differently from `run`."},
              [&s](Visitor& in) { describe_check_run(in, s.check_run); });
}

}  // namespace waterlight
