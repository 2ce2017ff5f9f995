// Five cups, one upside down, and a ring on a plane under a spot and the sun, by photon maps of several sizes.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "caustics/photons/photons.hpp"
#include "caustics/splat/splat.hpp"
#include "export/atomic_file.hpp"
#include "export/png.hpp"
#include "render/traced/traced_picture.hpp"
#include "tests/bench/methods/report.hpp"

namespace waterlight::methods {

namespace {

/// Interfaces of three walls of glass, each met twice, and of the still water of index 1 that lies on the plane.
constexpr int walls_seen = 3, interfaces = 2 * walls_seen + 1;
constexpr double plane_m = -1e-3;

Object on_plane(std::string name, Shape shape, Material material, glm::dvec2 at, double lift) {
    Object o;
    o.name = std::move(name);
    o.shape = std::move(shape);
    o.material = material;
    o.centre_m = {at.x, at.y, plane_m + 2e-4 + lift};
    return o;
}

std::shared_ptr<const ObjectSet> cups_and_ring() {
    const Material glass{.type = Material::Type::glass, .index = 1.5, .absorption_per_m = 0.5};
    const Material gold{.type = Material::Type::mirror, .reflectance = 0.9};
    const Cup cup{.bottom_radius_m = 0.28, .top_radius_m = 0.36, .height_m = 0.8, .wall_m = 0.03, .base_m = 0.05};
    std::vector<Object> all;
    int number = 0;
    for (const glm::dvec2 at : {glm::dvec2{3.0, 3.2}, {4.1, 3.8}, {5.0, 2.7}, {3.7, 2.1}})
        all.push_back(on_plane(fmt::format("cup {}", ++number), cup, glass, at, 0));
    all.push_back(on_plane("cup upside down", cup, glass, {5.7, 3.7}, cup.height_m));
    all.back().rotation_deg = {180, 0, 0};
    all.push_back(on_plane("ring", Ring{.inner_radius_m = 0.42, .outer_radius_m = 0.46, .height_m = 0.18}, gold,
                           {5.8, 1.9}, 0.09));
    return std::make_shared<const ObjectSet>(std::move(all));
}

/// The plane and its two lights.
struct Table {
    Surface surface{make_grid(18, 15, 9, 7.5), {Side::absorbing, Side::absorbing}};
    PhotonSettings sun, spot;

    explicit Table(int pixels) {
        sun.floor.plan = cover(surface.grid, pixels, pixels * 5 / 6);
        sun.floor.depth_m = -plane_m;
        sun.floor.sun = {38, 115, 500};
        sun.floor.optics.refractive_index = 1;
        sun.floor.objects = cups_and_ring();
        sun.options.start = PhotonOptions::Start::light;
        sun.options.bounces = interfaces;
        spot = sun;
        spot.lamp = Lamp{Lamp::Type::spot, {7.4, 5.4, 3.2}, 9000, {4.4, 2.9, 0}, 40};
    }
};

/// Both lights' maps by so many passes of so large a map.
struct LitMap {
    FloorMap sun, spot;
    Field<float> both;
    double seconds = 0;
};

/// The sums of both lights' maps, each by its own mapper.
LitMap lit_by(const Table& table, FloorMapper& by_sun, FloorMapper& by_spot) {
    LitMap all;
    const auto start = std::chrono::steady_clock::now();
    by_sun.compute(table.surface, all.sun);
    by_spot.compute(table.surface, all.spot);
    all.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    all.both = all.sun.irradiance.clone();
    const auto spot = all.spot.irradiance.values();
    for (std::size_t k = 0; k < spot.size(); ++k) all.both.values()[k] += spot[k];
    return all;
}

LitMap lit(const Table& table, int map, int passes, int bounces = interfaces, std::uint64_t seed = 1) {
    const auto mapper = [&](PhotonSettings settings) {
        settings.options.map = map;
        settings.options.passes = passes;
        settings.options.bounces = bounces;
        settings.options.seed = seed;
        return make_photon_floor(settings);
    };
    return lit_by(table, *mapper(table.sun), *mapper(table.spot));
}

LitMap splatted(const Table& table, int grid) {
    const auto mapper = [&](const PhotonSettings& light) {
        SplatSettings s{.floor = light.floor, .lamp = light.lamp};
        s.options.grid = grid;
        s.options.bounces = interfaces;
        return make_splat_floor_cpu(s);
    };
    return lit_by(table, *mapper(table.sun), *mapper(table.spot));
}

Field<float> mean_of(const Field<float>& a, const Field<float>& b) {
    Field<float> mean = a.clone();
    for (std::size_t k = 0; k < mean.size(); ++k) mean.values()[k] = 0.5F * (mean.values()[k] + b.values()[k]);
    return mean;
}

double sum_of(const Field<float>& field) {
    double sum = 0;
    for (const float e : field.values()) sum += e;
    return sum;
}

double lost_part(const LitMap& map) {
    return (map.sun.ledger.lost_w + map.spot.ledger.lost_w) / (map.sun.ledger.incident_w + map.sun.ledger.entered_w +
                                                               map.spot.ledger.incident_w + map.spot.ledger.entered_w);
}

void print_map(const std::string& name, const LitMap& map, const Field<float>& exact) {
    const auto error = [&](int box) {
        return accuracy::relative_rms(accuracy::box_means(map.both, box, box), accuracy::box_means(exact, box, box));
    };
    accuracy::print_row({name, accuracy::digits(map.seconds), accuracy::percent(error(1)), accuracy::percent(error(4)),
                         fmt::format("{:+.1e}", sum_of(map.both) / sum_of(exact) - 1),
                         accuracy::percent(lost_part(map))});
}

ColourImage picture_of(const Table& table, const Field<float>& floor, glm::ivec2 size) {
    TracedScene scene;
    scene.scene.surface = &table.surface;
    scene.scene.depth_m = -plane_m;
    scene.scene.floor = &floor;
    scene.scene.floor_plan = table.sun.floor.plan;
    scene.scene.sun = table.sun.floor.sun;
    scene.scene.optics = table.sun.floor.optics;
    scene.objects = table.sun.floor.objects;
    scene.lamp = table.spot.lamp;
    Look look;
    look.floor = {.pattern = Finish::Pattern::plain, .albedo = {0.62, 0.55, 0.47}};
    look.colour_per_m = {0, 0, 0};
    look.sky.irradiance_w_m2 = 90;
    look.exposure_w_m2_sr = 360;
    Camera camera;
    camera.position_m = {4.4, -1.3, 3.3};
    camera.target_m = {4.45, 2.45, 0.1};
    camera.fov_deg = 36;
    camera.size = size;
    return developed(trace_picture(scene, look, camera, {.samples = 9, .bounces = 16}));
}

ColourImage beside(const std::vector<ColourImage>& all) {
    ColourImage strip{0, all.front().height, {}};
    for (const ColourImage& one : all) strip.width += one.width;
    for (int j = 0; j < strip.height; ++j)
        for (const ColourImage& one : all) {
            const auto row = one.pixels.begin() + static_cast<std::ptrdiff_t>(3) * one.width * j;
            strip.pixels.insert(strip.pixels.end(), row, row + static_cast<std::ptrdiff_t>(3) * one.width);
        }
    return strip;
}

}  // namespace

void report_cups(const Options& options) {
    const bool quick = options.common.quick;
    const Table table(quick ? 144 : 720);
    const int long_map = quick ? 256 : 2048, half_passes = quick ? 2 : 8;
    const LitMap half = lit(table, long_map, half_passes, interfaces, 2),
                 other = lit(table, long_map, half_passes, interfaces, 3);
    const Field<float> both = mean_of(half.both, other.both);
    fmt::print(R"(
## Glass: five cups and a ring

Five cups of glass, n = 1.5, one of them upside down, and a mirror ring on a plane without water, under the sun and a spot.
Photons and splats follow light through them; both are compared with a long run of photons. "Three bounces" means three walls of
glass here, and each wall is two interfaces: light may meet {} of them, the last of which is the plane's own. (The number
that a ray tracer counts, generations of rays, would end light within the second wall of a cup.) Map of {} x {} pixels, no
blur. The long run is of {} passes of {} squared for each light, {:.0f} million photons in {:.0f} s; its two halves say that
its own error is {}.
)",
               interfaces, table.sun.floor.plan.width, table.sun.floor.plan.height, 2 * half_passes, long_map,
               4e-6 * half_passes * long_map * long_map, half.seconds + other.seconds,
               accuracy::percent(0.5 * accuracy::relative_rms(accuracy::box_means(half.both, 1, 1),
                                                              accuracy::box_means(other.both, 1, 1))));
    std::fflush(stdout);
    const Field<float>& exact = both;
    std::vector<ColourImage> pictures;
    const glm::ivec2 size = quick ? glm::ivec2{120, 90} : glm::ivec2{448, 320};
    accuracy::print_heads({"photon map", "s", "RMSE", "RMSE in 4 x 4", "light - 1", "lost"});
    for (const int map : quick ? std::vector<int>{64, 128} : std::vector<int>{512, 1024, 2048}) {
        const LitMap one = lit(table, map, 1);
        print_map(fmt::format("{} squared", map), one, exact);
        if (!options.pictures.empty()) {
            pictures.push_back(picture_of(table, one.both, size));
            write_file(fmt::format("{}/cups_{}.png", options.pictures, map), encode_png(pictures.back()));
        }
    }
    for (const int grid : quick ? std::vector<int>{64} : std::vector<int>{512, 1024}) {
        const LitMap one = splatted(table, grid);
        print_map(fmt::format("splat, {} along x", grid), one, exact);
    }
    fmt::print("\nWhat more bounces bring: light lost for want of them, of that which comes in.\n");
    accuracy::print_heads({"interfaces", "walls", "lost", "light on the plane, of that with 64"});
    const int map = quick ? 64 : 512;
    const double most = sum_of(lit(table, map, 1, 64).both);
    for (const int bounces : {3, 5, 7, 9, 13, 17}) {
        const LitMap one = lit(table, map, 1, bounces);
        accuracy::print_row({std::to_string(bounces), std::to_string((bounces - 1) / 2),
                             accuracy::percent(lost_part(one)), fmt::format("{:.4f}", sum_of(one.both) / most)});
    }
    if (pictures.empty()) return;
    pictures.push_back(picture_of(table, both, size));
    write_file(options.pictures + "/cups_long.png", encode_png(pictures.back()));
    write_file(options.pictures + "/cups.png", encode_png(beside(pictures)));
    fmt::print(
        "\nThe same ray traced, of 512, 1024 and 2048 squared and of the long run:\n\n"
        "![Five cups and a ring by photon maps of 512, 1024 and 2048 squared and by a long run](methods/cups.png)\n");
}

}  // namespace waterlight::methods
