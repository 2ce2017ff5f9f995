#include "caustics/splat/capture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/error.hpp"

namespace waterlight {

namespace {

/// Where in the plane z = 0 light passes that goes to the water of the domain, or to an object.
std::pair<glm::dvec2, glm::dvec2> lit_box(const SplatFrame& frame, const Surface& surface, const WaterScene& scene) {
    const f64::LightImage& image = frame.light.image;
    const Grid& g = surface.grid;
    glm::dvec2 low{g.x0_m, g.y0_m}, high = low + glm::dvec2{g.width_m(), g.height_m()};
    const glm::dvec2 from = low, to = high;
    const auto add_box = [&](glm::dvec3 a, glm::dvec3 b) {
        for (const double x : {a.x, b.x})
            for (const double y : {a.y, b.y})
                for (const double z : {a.z, b.z}) {
                    // What is as high as a lamp it does not light from above.
                    if (image.parallel == 0 && z > image.source.z - 1e-2 * (image.source.z - image.level)) continue;
                    const glm::dvec2 at(f64::ray_at_height(image, {x, y, z}, 0));
                    low = glm::min(low, at);
                    high = glm::max(high, at);
                }
    };
    const auto [lowest, highest] = std::ranges::minmax_element(surface.elevation.values());
    add_box({from, std::min(0.0F, *lowest)}, {to, std::max(0.0F, *highest)});
    const glm::dvec3 object_low = scene.objects().low_m(), object_high = scene.objects().high_m();
    if (object_low.x <= object_high.x) add_box(object_low, object_high);
    // Parallel light that repeats is all in one period.
    for (int axis = 0; axis < 2; ++axis)
        if (image.parallel == 1 && frame.period_m[axis] > 0) {
            low[axis] = from[axis];
            high[axis] = to[axis];
        }
    return {low, high};
}

/// The ways of all vertices in one list, and where those of each vertex of the lattice begin.
struct Traced {
    std::vector<CapturedVertex> all;
    std::vector<int> begin;
    FlightAccount account;
};

/// Whether a vertex beside the lattice repeats one of it: it has no light of its own, but is a neighbour.
bool comes_round(const SplatFrame& frame, glm::ivec2 vertex) {
    const VertexLattice& l = frame.lattice;
    const auto around = [&](int axis) {
        const bool inside = vertex[axis] >= 0 && vertex[axis] < l.domain[axis];
        return inside || (frame.light.image.parallel == 1 && frame.period_m[axis] > 0);
    };
    return around(0) && around(1);
}

void add_dark(LightWays& ways, glm::ivec2 vertex, std::vector<CapturedVertex>& out) {
    const std::size_t before = out.size();
    FlightAccount not_counted;
    ways.follow(vertex, out, not_counted);
    for (std::size_t k = before; k < out.size(); ++k) out[k].flight.power_w = 0;
}

Traced trace(const SplatSettings& settings, const SplatFrame& frame, const WaterScene& scene) {
    const VertexLattice& l = frame.lattice;
    std::vector<std::vector<CapturedVertex>> rows(static_cast<std::size_t>(l.count.y));
    std::vector<std::vector<int>> ends(rows.size());
    std::vector<FlightAccount> accounts(rows.size());
#pragma omp parallel
    {
        LightWays ways(settings, frame, scene);
#pragma omp for schedule(dynamic, 1)
        for (int j = 0; j < l.count.y; ++j) {
            const auto row = static_cast<std::size_t>(j);
            for (int i = 0; i < l.count.x; ++i) {
                const glm::ivec2 vertex = l.first + glm::ivec2{i, j};
                const int from_rim = std::min({i, j, l.count.x - 1 - i, l.count.y - 1 - j}) - vertex_rim;
                if (from_rim >= 0)
                    ways.follow(vertex, rows[row], accounts[row]);
                else if (from_rim == -1 && comes_round(frame, vertex))
                    add_dark(ways, vertex, rows[row]);
                ends[row].push_back(static_cast<int>(rows[row].size()));
            }
        }
    }
    Traced captured;
    captured.begin.push_back(0);
    for (std::size_t j = 0; j < rows.size(); ++j) {
        const int before = static_cast<int>(captured.all.size());
        for (const int end : ends[j]) captured.begin.push_back(before + end);
        captured.all.insert(captured.all.end(), rows[j].begin(), rows[j].end());
        captured.account.add(accounts[j]);
    }
    return captured;
}

/// Among the ways of a vertex of the lattice the one that is like `way`; -1: none.
int same_way(const Traced& captured, int lattice_vertex, std::uint64_t way) {
    for (int k = captured.begin[lattice_vertex]; k < captured.begin[lattice_vertex + 1]; ++k)
        if (captured.all[k].way == way) return k;
    return -1;
}

}  // namespace

CapturedLight capture(const SplatSettings& settings, SplatFrame& frame, const Surface& surface) {
    const glm::dvec2 size{surface.grid.width_m(), surface.grid.height_m()};
    WaterSceneSettings scene_settings{.depth_m = settings.floor.depth_m,
                                      .bed_m = settings.bed_m,
                                      .optics = settings.floor.optics,
                                      .wavelength_nm = settings.floor.wavelength_nm,
                                      .objects = settings.floor.objects};
    {
        const WaterScene scene(scene_settings, surface);
        if (settings.lamp && settings.lamp->at_m.z <= scene.highest_water_m())
            throw InputError(fmt::format("splats: height of the lamp in m is {}; allowed: above all water, {}",
                                         settings.lamp->at_m.z, scene.highest_water_m()));
        widen_lattice(frame, surface, light_shifts(settings, frame, surface), lit_box(frame, surface, scene));
    }
    const VertexLattice& l = frame.lattice;
    const glm::dvec2 low = l.place_m(l.first), high = l.place_m(l.first + l.count);
    const glm::dvec2 beside = glm::max(l.corner_m - low, high - l.corner_m - size);
    scene_settings.still_beyond_m = std::max({0.0, beside.x, beside.y});
    Traced traced = trace(settings, frame, WaterScene(scene_settings, surface));

    CapturedLight light;
    for (int j = 0; j <= l.count.y; ++j) light.row_begin.push_back(traced.begin[j * l.count.x]);
    for (int n = 0; n < l.count.x * l.count.y; ++n)
        for (int k = traced.begin[n]; k < traced.begin[n + 1]; ++k) {
            const std::uint64_t way = traced.all[k].way;
            // The lattice's outermost vertices have no ways: all others have neighbours on all sides.
            light.neighbours.emplace_back(same_way(traced, n - 1, way), same_way(traced, n + 1, way),
                                          same_way(traced, n - l.count.x, way), same_way(traced, n + l.count.x, way));
        }
    light.all = std::move(traced.all);
    light.account = traced.account;
    return light;
}

SplatCloud land_captured(const SplatSettings& settings, const SplatFrame& frame, const Receivers& receivers,
                         CapturedLight light) {
    const Lander lander(settings, frame, receivers);
    SplatCloud cloud;
    cloud.step_x = frame.to_pixels * glm::dvec2{frame.lattice.spacing_m.x, 0};
    cloud.step_y = frame.to_pixels * glm::dvec2{0, frame.lattice.spacing_m.y};
    cloud.row_begin = std::move(light.row_begin);
    cloud.neighbours = std::move(light.neighbours);
    for (const CapturedVertex& v : light.all) {
        const Arrival arrival = lander(v.flight, light.account);
        cloud.pixel.push_back(arrival.pixel);
        cloud.power_w.push_back(arrival.power_w);
        cloud.own.push_back(v.flight.own);
        cloud.vertex.push_back(v.vertex);
    }
    light.account.finish(cloud);
    return cloud;
}

}  // namespace waterlight
