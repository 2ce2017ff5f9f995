#include "caustics/walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "caustics/cell_shares.hpp"
#include "caustics/kernels/optics.hpp"
#include "caustics/kernels/surface_lookup.hpp"
#include "caustics/wall_split.hpp"
#include "sim/error.hpp"

namespace waterlight {

WallPlan wall_plan(const WallSettings& settings, const Grid& grid, int wall) {
    const double length = wall < 2 ? grid.height_m() : grid.width_m();
    constexpr double slack = 1e-9;  // a length that is a multiple of pixels but for rounding
    const auto pixels_in = [&](double m) { return static_cast<int>(std::ceil(m / settings.pixel_m - slack)); };
    WallPlan plan;
    plan.columns = std::max(1, pixels_in(length));
    const int below = std::max(1, pixels_in(settings.depth_m));
    plan.pitch_m = {length / plan.columns, settings.depth_m / below};
    plan.rows = below + static_cast<int>(std::ceil(settings.above_m / plan.pitch_m.y - slack));
    return plan;
}

namespace {

/// A corner of the mesh: its ray, what of its light enters, and its way under water a metre of ray.
struct Corner {
    WallRay ray;
    double transmittance = 0;
    double way_m = 0;      ///< to the ray's end
    double remaining = 1;  ///< of its light there
};

/// Power on one pixel of a wall.
struct Hit {
    std::uint32_t pixel;
    float power_w;
};

/// What some rows of the mesh send to the walls. Powers in watts.
struct Part {
    std::array<std::vector<Hit>, 4> hits;
    double incident = 0, reflected = 0, extinguished = 0, floor = 0, walls = 0, outside = 0;
};

/// Lights the walls from the triangles of one surface.
class WallLight {
  public:
    WallLight(const WallSettings& settings, const Surface& surface)
        : settings_(settings), surface_(surface), split_(surface.grid, surface.boundary) {
        const bool lit = settings.sun.elevation_deg > 0;
        sun_ = lit ? settings.sun.direction() : glm::dvec3{0, 0, -1};
        irradiance_ = lit ? settings.sun.irradiance_w_m2 : 0;
        climb_ = surface.tilt * glm::dvec2{surface.grid.width_m(), surface.grid.height_m()};
        for (int i = 0; i <= surface.grid.nx; ++i)
            columns_.push_back(between_cells(i, surface.grid.nx, surface.boundary.x));
        for (int wall = 0; wall < 4; ++wall)
            plans_[static_cast<std::size_t>(wall)] = wall_plan(settings, surface.grid, wall);
    }

    bool is_wall(int wall) const { return (wall < 2 ? surface_.boundary.x : surface_.boundary.y) == Side::wall; }
    const WallPlan& plan(int wall) const { return plans_[static_cast<std::size_t>(wall)]; }

    /// The light of rows [begin, end) of the mesh, whose cells are the surface's.
    Part light_rows(int begin, int end) const {
        Part part;
        CellShares shares;
        std::vector<Corner> low = corner_row(begin), high;
        for (int j = begin; j < end; ++j) {
            high = corner_row(j + 1);
            for (int i = 0; i < surface_.grid.nx; ++i) {
                const auto n = static_cast<std::size_t>(i);
                light_triangle({&low[n], &low[n + 1], &high[n + 1]}, shares, part);
                light_triangle({&low[n], &high[n + 1], &high[n]}, shares, part);
            }
            std::swap(low, high);
        }
        return part;
    }

  private:
    f64::AxisPlace between_cells(int corner, int n, Side side) const {
        return f64::place_on_axis(corner - 1, 0.5, n, side_number(side), 0.5);
    }

    std::vector<Corner> corner_row(int j) const {
        const Grid& g = surface_.grid;
        const double n = settings_.optics.refractive_index, fresnel = settings_.optics.fresnel ? 1 : 0;
        const f64::AxisPlace y = between_cells(j, g.ny, surface_.boundary.y);
        std::vector<Corner> row;
        row.reserve(static_cast<std::size_t>(g.nx) + 1);
        for (int i = 0; i <= g.nx; ++i) {
            const f64::AxisPlace& x = columns_[static_cast<std::size_t>(i)];
            const auto mean = [&](const Field<float>& f, double xl, double xh, double yl, double yh) {
                return f64::bilinear(xl * yl * f(x.low, y.low), xh * yl * f(x.high, y.low), xl * yh * f(x.low, y.high),
                                     xh * yh * f(x.high, y.high), x.weight, y.weight);
            };
            const double elevation = mean(surface_.elevation, 1, 1, 1, 1) + f64::wraps_between(x) * climb_.x +
                                     f64::wraps_between(y) * climb_.y;
            const glm::dvec2 slope{mean(surface_.slope_x, x.mirror_low, x.mirror_high, 1, 1),
                                   mean(surface_.slope_y, 1, 1, y.mirror_low, y.mirror_high)};
            const f64::Refraction r = f64::refract_sun(sun_, slope, n, fresnel);
            const double descent = std::max(0.0, elevation + settings_.depth_m);
            const glm::dvec2 at{g.x0_m + i * g.dx_m, g.y0_m + j * g.dy_m};
            row.push_back({{{at, elevation}, {at + descent * r.travel, elevation - descent}},
                           r.transmittance,
                           descent * r.path,
                           f64::beer_lambert(settings_.optics.extinction_per_m(), descent * r.path)});
        }
        return row;
    }

    /// Its incident power is that through its own plane, as in the truth.
    void light_triangle(const std::array<const Corner*, 3>& corners, CellShares& shares, Part& part) const {
        const Corner &a = *corners[0], &b = *corners[1], &c = *corners[2];
        const glm::dvec3 twice_area = glm::cross(b.ray.start - a.ray.start, c.ray.start - a.ray.start);
        const double incident = std::max(0.0, -0.5 * glm::dot(sun_, twice_area)) * irradiance_;
        const double entered = incident * (a.transmittance + b.transmittance + c.transmittance) / 3;
        part.incident += incident;
        part.reflected += incident - entered;
        if (split_.stays(a.ray, b.ray, c.ray)) {
            const double arrived = entered * (a.remaining + b.remaining + c.remaining) / 3;
            part.floor += arrived;
            part.extinguished += entered - arrived;
            return;
        }
        const std::array<WallRay, 3> rays{a.ray, b.ray, c.ray};
        split_.split(rays, [&](WayEnd end, const Polygon& polygon) {
            for (int k = 1; k + 1 < polygon.count; ++k) {
                const std::array<glm::dvec2, 3> uv{polygon.corner[0], polygon.corner[k], polygon.corner[k + 1]};
                end_light(corners, rays, end, uv, entered, shares, part);
            }
        });
    }

    /// The light of the triangle uv of a triangle at its end.
    void end_light(const std::array<const Corner*, 3>& corners, const std::array<WallRay, 3>& rays, WayEnd end,
                   const std::array<glm::dvec2, 3>& uv, double entered, CellShares& shares, Part& part) const {
        const double share = std::abs(area(Polygon{{uv[0], uv[1], uv[2]}, 3})) * 2;
        if (share == 0) return;
        std::array<glm::dvec3, 3> met;
        double remaining = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const WallRay ray = WallSplit::ray_at(rays, uv[k]);
            const double way = split_.part_of_way(ray, end);
            met[k] = ray.start + way * (ray.end - ray.start);
            const double path = corners[0]->way_m + uv[k].x * (corners[1]->way_m - corners[0]->way_m) +
                                uv[k].y * (corners[2]->way_m - corners[0]->way_m);
            remaining += f64::beer_lambert(settings_.optics.extinction_per_m(), way * path) / 3;
        }
        const double arrived = entered * share * remaining;
        part.extinguished += entered * share - arrived;
        if (end == WayEnd::floor)
            part.floor += arrived;
        else if (is_wall(static_cast<int>(end)))
            hit_wall(static_cast<int>(end), met, arrived, shares, part);
        else
            part.outside += arrived;
    }

    void hit_wall(int wall, const std::array<glm::dvec3, 3>& met, double power, CellShares& shares, Part& part) const {
        const WallPlan& p = plan(wall);
        const Grid& g = surface_.grid;
        const int along = wall < 2 ? 1 : 0;
        const double from = along == 0 ? g.x0_m : g.y0_m;
        std::array<glm::dvec2, 3> pixel;
        for (std::size_t k = 0; k < 3; ++k)
            pixel[k] = glm::dvec2{met[k][along] - from, met[k].z + settings_.depth_m} / p.pitch_m;
        const bool repeats = (along == 0 ? surface_.boundary.x : surface_.boundary.y) == Side::periodic;
        double shared = 0;
        shares.share(pixel, [&](int column, int row, double share) {
            if (repeats) column = ((column % p.columns) + p.columns) % p.columns;
            // Light that grazes an end of the wall is on its last pixels, but for rounding.
            column = std::clamp(column, 0, p.columns - 1);
            if (row >= p.rows) return;
            const int index = std::max(row, 0) * p.columns + column;
            part.hits[static_cast<std::size_t>(wall)].push_back(
                {static_cast<std::uint32_t>(index), static_cast<float>(power * share)});
            shared += power * share;
        });
        part.walls += shared;
        part.outside += power - shared;
    }

    const WallSettings& settings_;
    const Surface& surface_;
    WallSplit split_;
    glm::dvec3 sun_{0, 0, -1};
    double irradiance_ = 0;
    glm::dvec2 climb_{0, 0};
    std::vector<f64::AxisPlace> columns_;
    std::array<WallPlan, 4> plans_;
};

void check(const WallSettings& s, const Boundary& boundary) {
    const auto require = [](bool good, std::string_view what, double found, std::string_view allowed) {
        if (!good) throw InputError(fmt::format("walls: {} is {}; allowed: {}", what, found, allowed));
    };
    require(s.pixel_m > 0 && std::isfinite(s.pixel_m), "size of a pixel in m", s.pixel_m, "> 0");
    require(s.above_m >= 0 && std::isfinite(s.above_m), "height above still water in m", s.above_m, ">= 0");
    require(s.depth_m > 0 && std::isfinite(s.depth_m), "depth in m", s.depth_m, "> 0, finite");
    require(s.optics.refractive_index >= 1, "refractive index", s.optics.refractive_index, ">= 1");
    require(s.optics.extinction_per_m() >= 0, "extinction in 1/m", s.optics.extinction_per_m(), ">= 0");
    if (boundary.x != Side::wall && boundary.y != Side::wall)
        throw InputError("walls: no side of the domain is a wall; allowed: walls along x, y or both");
}

/// Adds the hits of all parts, in their order, to one wall, and returns its power.
double fill_wall(const std::vector<Part>& parts, std::size_t wall, const WallPlan& plan, Field<float>& map) {
    std::vector<double> power(static_cast<std::size_t>(plan.columns) * static_cast<std::size_t>(plan.rows));
    for (const Part& part : parts)
        for (const Hit& hit : part.hits[wall]) power[hit.pixel] += hit.power_w;
    if (map.nx() != plan.columns || map.ny() != plan.rows) map = Field<float>(plan.columns, plan.rows);
    double sum = 0;
    for (std::size_t i = 0; i < power.size(); ++i) {
        sum += power[i];
        map.data()[i] = static_cast<float>(power[i] / (plan.pitch_m.x * plan.pitch_m.y));
    }
    return sum;
}

}  // namespace

void light_walls(const WallSettings& settings, const Surface& surface, WallMaps& maps) {
    check(settings, surface.boundary);
    const WallLight light(settings, surface);
    // Bands of fixed height, added in order: the sums do not depend on the number of threads.
    constexpr int band = 16;
    const int ny = surface.grid.ny, bands = (ny + band - 1) / band;
    std::vector<Part> parts(static_cast<std::size_t>(bands));
#pragma omp parallel for schedule(dynamic, 1)
    for (int b = 0; b < bands; ++b)
        parts[static_cast<std::size_t>(b)] = light.light_rows(b * band, std::min(ny, (b + 1) * band));
#pragma omp parallel for schedule(dynamic, 1)
    for (int wall = 0; wall < 4; ++wall) {
        const auto w = static_cast<std::size_t>(wall);
        if (light.is_wall(wall)) maps.power_w[w] = fill_wall(parts, w, light.plan(wall), maps.irradiance[w]);
    }
    FloorLedger sum;
    double walls = 0;
    for (const Part& part : parts) {
        sum.incident_w += part.incident;
        sum.reflected_w += part.reflected;
        sum.extinguished_w += part.extinguished;
        sum.floor_w += part.floor;
        sum.outside_w += part.outside;
        walls += part.walls;
    }
    maps.ledger = light_ledger(sum, settings.optics);
    maps.ledger.walls_w = walls;
}

}  // namespace waterlight
