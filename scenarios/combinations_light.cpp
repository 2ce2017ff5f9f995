// What goes together in the light that a scenario asks for.
#include <fmt/format.h>

#include <numeric>
#include <set>

#include "scenarios/combinations.hpp"
#include "scenarios/resolve.hpp"
#include "scenarios/resolve_light.hpp"

namespace waterlight {

namespace {

constexpr std::size_t most_wavelengths = 16;

/// How many wavelengths the light has; 0 for light of one colour.
std::size_t wavelengths_in(const Scenario& s) { return s.sun.colour == Colour::rgb ? 3 : s.sun.wavelengths_nm.size(); }

std::string_view colour_key(const Scenario& s) {
    return s.sun.colour == Colour::rgb ? "light.colour" : "light.wavelengths_nm";
}

/// A list with one value a wavelength.
void check_list(const Scenario& s, std::string_view key, const std::vector<double>& values) {
    const std::size_t wanted = wavelengths_in(s);
    if (values.empty() || values.size() == wanted) return;
    if (wanted == 0)
        s.origin.reject(key, "it beside light of one colour", "light.wavelengths_nm or light.colour in the scenario");
    s.origin.reject(key, fmt::format("a list of {}", values.size()),
                    fmt::format("one number a wavelength, of which there are {}", wanted));
}

void check_wavelengths(const Scenario& s) {
    const std::vector<double>& nm = s.sun.wavelengths_nm;
    const std::string key = "light.wavelengths_nm";
    if (s.sun.colour == Colour::rgb && !nm.empty()) s.origin.reject(key, "it beside colour = \"rgb\"", "one of both");
    if (nm.size() > most_wavelengths || std::set<double>(nm.begin(), nm.end()).size() != nm.size())
        s.origin.reject(key, fmt::format("a list of {}", nm.size()),
                        fmt::format("at most {} wavelengths, each once", most_wavelengths));
    const double sum = std::accumulate(s.sun.shares.begin(), s.sun.shares.end(), 0.0);
    constexpr double rounding = 1e-9;
    if (sum > 1 + rounding) s.origin.reject("light.shares", fmt::format("shares of {} together", sum), "at most 1");
}

/// What only light of one colour, or only light in colour, knows.
void check_water(const Scenario& s) {
    const bool coloured = wavelengths_in(s) > 0;
    for (const std::string key : {"water.temperature_c", "water.salinity_permille"})
        if (!coloured && s.origin.places.contains(key))
            s.origin.reject(key, "it beside light of one colour",
                            "light.wavelengths_nm or light.colour in the scenario");
    for (const std::string key : {"water.refractive_index", "water.type"})
        if (coloured && s.origin.places.contains(key))
            s.origin.reject(key, fmt::format("it beside {}", colour_key(s)),
                            "light of one colour; in colour, water.temperature_c, salinity_permille and the "
                            "coefficients");
}

void check_walls(const Scenario& s) {
    if (has_ground(s))
        s.origin.reject("caustics.walls",
                        fmt::format("it beside {}", s.domain.bathymetry ? "domain.bathymetry" : "domain.ground"),
                        "the flat floor, to which walls reach down");
    const Boundary boundary = resolve_boundary(s);
    if (boundary.x != Side::wall && boundary.y != Side::wall)
        s.origin.reject("caustics.walls", "it without a side that is a wall", "waves.boundary with a wall");
    constexpr double most = 1e8;
    const WallSettings settings = wall_settings(s);
    const double around = 2 * (s.domain.size_m.x + s.domain.size_m.y);
    const double pixels = around * (settings.depth_m + settings.above_m) / (settings.pixel_m * settings.pixel_m);
    if (pixels > most)
        s.origin.reject("caustics.walls.pixel_m",
                        fmt::format("{}, which makes {:.3g} pixels", settings.pixel_m, pixels), "at most 1e8 pixels");
}

void check_receiver(const Scenario& s) {
    if (!s.floor) return;
    const bool on_ground = s.floor->on.receiver == Receiver::ground;
    if (!on_ground && s.origin.places.contains("caustics.floor.per_area"))
        s.origin.reject("caustics.floor.per_area", "it beside receiver = \"flat\"", "receiver ground");
    const std::string key = "caustics.floor.receiver";
    require_model(s, on_ground, key, {ModelChoice::shallow_water});
    const FloorMethod method = s.floor->method;
    if (on_ground && (method == FloorMethod::truth || method == FloorMethod::quads))
        s.origin.reject(key, fmt::format("ground beside method = \"{}\"", name_of(method)),
                        "method two-pass, splat or photons");
    if (on_ground && s.sun.disc_deg)
        s.origin.reject("light.disc_deg", "it beside receiver = \"ground\"", "parallel light");
    for (const std::string other : {"window", "footprint", "samples_per_pixel", "angle_deg", "centre_m", "size_m"})
        if (on_ground && s.origin.places.contains("caustics.floor." + other))
            s.origin.reject("caustics.floor." + other, "it beside receiver = \"ground\"",
                            "receiver flat; on the ground the map covers the domain, and has a footprint of its own");
}

}  // namespace

void check_light(const Scenario& s) {
    check_wavelengths(s);
    check_list(s, "light.shares", s.sun.shares);
    check_list(s, "water.absorption_by_band_per_m", s.water_colour.absorption_by_band_per_m);
    check_list(s, "water.scattering_by_band_per_m", s.water_colour.scattering_by_band_per_m);
    check_water(s);
    if (s.walls) check_walls(s);
    check_receiver(s);
    const bool coloured = wavelengths_in(s) > 0, disc = s.sun.disc_deg.has_value();
    const std::string key(disc ? "light.disc_deg" : colour_key(s));
    if (disc && *s.sun.disc_deg > s.light.elevation_deg)
        s.origin.reject(key, fmt::format("{}, part of the disc below the horizon", *s.sun.disc_deg),
                        fmt::format("at most light.elevation_deg = {}", s.light.elevation_deg));
    if ((coloured || disc) && !s.floor) s.origin.reject(key, "it without [caustics.floor]", "a floor map to show it");
    if ((coloured || disc) && s.floor->method == FloorMethod::truth)
        s.origin.reject(key, "it beside caustics.floor.method = \"truth\"", "method two-pass");
    if (disc && s.floor->method == FloorMethod::photons)
        s.origin.reject(key, "it beside caustics.floor.method = \"photons\"",
                        "two-pass, quads or splat; the photons' estimate of their error is of parallel light");
    if (coloured && s.beams)
        s.origin.reject(std::string(colour_key(s)), "it beside [caustics.beams]", "beams with light of one colour");
}

}  // namespace waterlight
