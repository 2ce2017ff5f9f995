// What goes together in objects, lamps, and the methods that follow light to them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "scenarios/combinations.hpp"

namespace waterlight {

namespace {

bool states(const Scenario& s, const std::string& key) { return s.origin.places.contains(key); }

/// One object, with its key for what is said about it.
struct ObjectCheck {
    const Scenario& s;
    const ObjectSection& section;
    std::string key;

    const Object& object() const { return section.object; }

    [[noreturn]] void reject_at(const char* sub, const std::string& found, const std::string& allowed) const {
        s.origin.reject(key + sub, found, allowed);
    }

    void require_above(const char* sub, double value, double least, const char* of) const {
        if (value <= least) reject_at(sub, fmt::format("{}", value), fmt::format("above {} = {}", of, least));
    }

    void operator()(const Sphere&) const {}
    void operator()(const Box&) const {}
    void operator()(const Mesh&) const {}
    void operator()(const Ring& ring) const {
        require_above(".outer_radius_m", ring.outer_radius_m, ring.inner_radius_m, "inner_radius_m");
    }
    void operator()(const Cup& cup) const {
        require_above(".height_m", cup.height_m, cup.base_m, "base_m");
        require_above(".bottom_radius_m", cup.bottom_radius_m, cup.wall_m, "wall_m");
        require_above(".top_radius_m", cup.top_radius_m, cup.wall_m, "wall_m");
    }

    void check_place() const {
        const std::vector<PathPoint>& path = object().path;
        const bool has_centre = states(s, key + ".centre_m");
        if (has_centre && !path.empty()) reject_at(".centre_m", "it beside path", "one of both");
        if (!has_centre && path.empty()) reject_at("", "neither centre_m nor path", "one of both");
        for (std::size_t k = 1; k < path.size(); ++k)
            if (path[k].time_s <= path[k - 1].time_s)
                s.origin.reject(fmt::format("{}.path[{}].time_s", key, k), fmt::format("{}", path[k].time_s),
                                fmt::format("later than the point before, {} s", path[k - 1].time_s));
    }

    void check_material() const {
        const Material::Type type = object().material.type;
        const bool glass = type == Material::Type::glass;
        const std::string beside =
            fmt::format("it beside type = \"{}\"", material_names[static_cast<std::size_t>(type)]);
        for (const std::string of_glass : {"index", "abbe_number", "absorption_per_m"})
            if (!glass && states(s, key + ".material." + of_glass))
                s.origin.reject(key + ".material." + of_glass, beside, "type glass");
        if (glass && states(s, key + ".material.reflectance"))
            s.origin.reject(key + ".material.reflectance", beside, "type diffuse or mirror");
    }
};

void check_each(const Scenario& s) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < s.objects.size(); ++i) {
        const ObjectCheck check{s, s.objects[i], fmt::format("object[{}]", i)};
        const std::string& name = check.object().name;
        if (!is_plain_name(name)) check.reject_at(".name", fmt::format("\"{}\"", name), std::string(plain_names));
        if (!names.insert(name).second)
            check.reject_at(".name", fmt::format("\"{}\" twice", name), "one object a name");
        check.check_place();
        check.check_material();
        std::visit(check, check.object().shape);
    }
}

/// The truth and the maps of walls do not know objects.
void check_who_knows_objects(const Scenario& s) {
    if (s.objects.empty()) return;
    if (s.floor && s.floor->method == FloorMethod::truth)
        s.origin.reject("caustics.floor.method", "\"truth\" beside [[object]]",
                        "two-pass, quads, splat or photons; the truth does not know objects");
    if (s.walls) s.origin.reject("caustics.walls", "it beside [[object]]", "walls without objects, which they ignore");
    if (s.accuracy.estimate && s.floor)
        s.origin.reject("accuracy.estimate", "true beside [[object]] and [caustics.floor]",
                        "false; the truth by which the map's error is estimated does not know objects");
    if (s.sun.disc_deg)
        s.origin.reject("light.disc_deg", "it beside [[object]]",
                        "parallel light; the disc blurs the map as if all its light came from the water's surface");
}

constexpr std::array<const char*, 4> keys_of_lamps{"at_m", "intensity_w_sr", "towards_m", "half_angle_deg"};

void check_keys_of_light(const Scenario& s) {
    const auto require_none = [&](auto keys, const std::string& type, const char* allowed) {
        for (const std::string key : keys)
            if (states(s, "light." + key))
                s.origin.reject("light." + key, fmt::format("it beside type = \"{}\"", type), allowed);
    };
    if (!s.lamp) return require_none(keys_of_lamps, "sun", "type point or spot");
    const bool is_spot = s.lamp->type == Lamp::Type::spot;
    const std::string type = is_spot ? "spot" : "point";
    require_none(std::array{"elevation_deg", "azimuth_deg", "irradiance_w_m2", "disc_deg"}, type, "type sun");
    if (!is_spot) require_none(std::array{"towards_m", "half_angle_deg"}, type, "type spot");
    const auto require = [&](const char* key) {
        if (!states(s, key)) s.origin.reject(key, "nothing", fmt::format("three numbers, required of a {}", type));
    };
    require("light.at_m");
    if (is_spot) require("light.towards_m");
    if (is_spot && s.lamp->at_m == s.lamp->towards_m)
        s.origin.reject("light.towards_m", "the place of at_m", "another place");
}

/// A lamp's light is followed by the methods that look from the light.
void check_lamp(const Scenario& s) {
    check_keys_of_light(s);
    if (!s.lamp) return;
    const std::string lamp = s.lamp->type == Lamp::Type::spot ? "light.type = \"spot\"" : "light.type = \"point\"";
    const auto reject = [&](const char* key, const char* what) {
        s.origin.reject(key, fmt::format("{} beside {}", what, lamp), "a sun, type = \"sun\"");
    };
    if (s.beams) reject("caustics.beams", "it");
    if (s.walls) reject("caustics.walls", "it");
    if (s.accuracy.estimate) reject("accuracy.estimate", "true");
    if (!s.floor) return;
    const FloorMethod method = s.floor->method;
    if (method != FloorMethod::splat && method != FloorMethod::photons)
        s.origin.reject("caustics.floor.method", fmt::format("\"{}\" beside {}", name_of(method), lamp),
                        "splat or photons, which follow the light of lamps");
}

}  // namespace

void check_objects(const Scenario& s) {
    check_each(s);
    check_who_knows_objects(s);
    check_lamp(s);
}

}  // namespace waterlight
