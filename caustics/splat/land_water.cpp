// Vertices on the water's surface, an even lattice of the domain: with walls none is cut, and each carries the light of
// its own rectangle. As in the other methods waves do not shade each other.
#include <algorithm>
#include <cmath>

#include "caustics/splat/splat_cloud.hpp"
#include "caustics/surface_rows.hpp"

namespace waterlight {

namespace {

SplitPlace split(double place) {
    const double whole = std::floor(place);
    const auto part = static_cast<float>(place - whole);
    return part >= 1 ? SplitPlace{static_cast<int>(whole) + 1, 0} : SplitPlace{static_cast<int>(whole), part};
}

/// Where a vertex beyond a wall reads the water that is mirrored there.
int mirrored(int vertex, int count, Side side) {
    if (side != Side::wall) return vertex;
    return std::clamp(vertex < 0 ? -1 - vertex : (vertex >= count ? 2 * count - 1 - vertex : vertex), 0, count - 1);
}

f32::SplatLight single(const f64::SplatLight& l) {
    return {{glm::vec3(l.image.source), static_cast<float>(l.image.parallel), static_cast<float>(l.image.level)},
            static_cast<float>(l.strength),
            glm::vec3(l.axis),
            static_cast<float>(l.cosine)};
}

void mirror_slopes(const VertexLattice& l, Boundary sides, int j, SampleRow& water) {
    const auto beyond = [](int vertex, int count, Side side) {
        return side == Side::wall && (vertex < 0 || vertex >= count);
    };
    for (int i = 0; i < l.count.x; ++i)
        if (beyond(l.first.x + i, l.domain.x, sides.x)) water.slope_x[i] *= -1;
    if (!beyond(l.first.y + j, l.domain.y, sides.y)) return;
    for (float& slope : water.slope_y) slope *= -1;
}

/// Vertices of a row before they land.
struct EnteredRow {
    std::vector<float> x, y, z, incident, transmitted;
    explicit EnteredRow(int count) : x(count), y(count), z(count), incident(count), transmitted(count) {}
};

void enter(const f32::SplatLight& light, const SplatFrame& frame, const std::vector<float>& place_x, float place_y,
           const SampleRow& water, EnteredRow& row) {
    const int count = static_cast<int>(place_x.size());
    const auto index = static_cast<float>(frame.index), fresnel = static_cast<float>(frame.fresnel);
    const float* __restrict at_x = place_x.data();
    const float* __restrict elevation = water.elevation.data();
    const float* __restrict slope_x = water.slope_x.data();
    const float* __restrict slope_y = water.slope_y.data();
    const float* __restrict lit = water.lit.data();
    float* __restrict x = row.x.data(), * __restrict y = row.y.data(), * __restrict z = row.z.data();
    float* __restrict incident = row.incident.data(), * __restrict transmitted = row.transmitted.data();
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const f32::WaterVertex v = f32::enter_water(light, f32::real3(at_x[i], place_y, elevation[i]),
                                                    f32::real2(slope_x[i], slope_y[i]), index, fresnel);
        x[i] = v.direction.x;
        y[i] = v.direction.y;
        z[i] = v.direction.z;
        incident[i] = lit[i] * v.incident;
        transmitted[i] = lit[i] * v.transmitted;
    }
}

}  // namespace

FloorFrame vertex_rows(const VertexLattice& l, const Grid& g, Boundary sides) {
    FloorFrame f;
    f.columns = {l.first.x, l.count.x};
    f.rows = {l.first.y, l.count.y};
    for (int i = 0; i < l.count.x; ++i)
        f.column_x.push_back(
            split((l.place_m({mirrored(l.first.x + i, l.domain.x, sides.x), 0}).x - g.x_m(0)) / g.dx_m));
    for (int j = 0; j < l.count.y; ++j)
        f.row_y.push_back(split((l.place_m({0, mirrored(l.first.y + j, l.domain.y, sides.y)}).y - g.y_m(0)) / g.dy_m));
    f.column_y.resize(f.column_x.size());
    f.row_x.resize(f.row_y.size());
    f.half_width_x = static_cast<float>(0.5 * l.spacing_m.x / g.dx_m);
    f.half_width_y = static_cast<float>(0.5 * l.spacing_m.y / g.dy_m);
    return f;
}

void widen_to_water(const SplatSettings& settings, SplatFrame& frame, const Surface& surface) {
    const glm::dvec2 corner = frame.lattice.corner_m, size{surface.grid.width_m(), surface.grid.height_m()};
    widen_lattice(frame, surface, light_shifts(settings, frame, surface), {corner, corner + size});
}

SplatCloud land_water(const SplatSettings& settings, SplatFrame& frame, const Receivers& receivers,
                      const Surface& surface) {
    widen_to_water(settings, frame, surface);
    const VertexLattice& l = frame.lattice;
    const FloorFrame rows = vertex_rows(l, surface.grid, surface.boundary);
    const SurfaceRows reader(rows, surface);
    const Lander lander(settings, frame, receivers);
    const f32::SplatLight light = single(frame.light);
    const double area = l.area_m2();
    std::vector<float> place_x;
    for (int i = 0; i < l.count.x; ++i) place_x.push_back(static_cast<float>(l.place_m({l.first.x + i, 0}).x));

    SplatCloud cloud;
    const std::size_t count = static_cast<std::size_t>(l.count.x) * static_cast<std::size_t>(l.count.y);
    cloud.pixel.resize(count);
    cloud.power_w.resize(count);
    cloud.own.resize(count);
    cloud.columns = l.count.x;
    for (int j = 0; j <= l.count.y; ++j) cloud.row_begin.push_back(j * l.count.x);
    cloud.step_x = frame.to_pixels * glm::dvec2{l.spacing_m.x, 0};
    cloud.step_y = frame.to_pixels * glm::dvec2{0, l.spacing_m.y};
    std::vector<FlightAccount> accounts(static_cast<std::size_t>(l.count.y));
#pragma omp parallel
    {
        SurfaceRows::Scratch scratch = reader.scratch();
        SampleRow water(l.count.x);
        EnteredRow row(l.count.x);
#pragma omp for schedule(static)
        for (int j = 0; j < l.count.y; ++j) {
            const glm::dvec2 first = l.place_m({l.first.x, l.first.y + j});
            reader.read(j, scratch, water);
            mirror_slopes(l, surface.boundary, j, water);
            enter(light, frame, place_x, static_cast<float>(first.y), water, row);
            FlightAccount& account = accounts[static_cast<std::size_t>(j)];
            for (int i = 0; i < l.count.x; ++i) {
                const std::size_t k =
                    static_cast<std::size_t>(j) * static_cast<std::size_t>(l.count.x) + static_cast<std::size_t>(i);
                const bool rim = std::min({i, j, l.count.x - 1 - i, l.count.y - 1 - j}) < vertex_rim;
                const bool own = l.in_domain(l.first + glm::ivec2{i, j});
                const double incident = rim ? 0 : area * row.incident[i],
                             transmitted = rim ? 0 : area * row.transmitted[i];
                if (own) {
                    account.ledger.incident_w += incident;
                    account.ledger.reflected_w += incident - transmitted;
                }
                const glm::dvec3 start{l.place_m(l.first + glm::ivec2{i, j}), water.elevation[i]};
                const Arrival arrival =
                    lander({start, {row.x[i], row.y[i], row.z[i]}, transmitted, frame.extinction_per_m, own}, account);
                cloud.pixel[k] = arrival.pixel;
                cloud.power_w[k] = arrival.power_w;
                cloud.own[k] = own;
            }
        }
    }
    FlightAccount total;
    for (const FlightAccount& account : accounts) total.add(account);
    total.finish(cloud);
    return cloud;
}

}  // namespace waterlight
