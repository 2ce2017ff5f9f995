#include "caustics/relief.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "caustics/cell_shares.hpp"
#include "caustics/floor_frame.hpp"
#include "caustics/kernels/optics.hpp"
#include "caustics/kernels/surface_lookup.hpp"
#include "caustics/landed_corner.hpp"
#include "caustics/light_ledger.hpp"
#include "caustics/object_shadows.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

/// A cell-centred field between its cells, and beyond the sides.
class Between {
  public:
    Between(const Grid& grid, Boundary boundary) : grid_(grid), boundary_(boundary) {}

    struct Place {
        f64::AxisPlace x, y;
    };
    Place place(glm::dvec2 at_m) const {
        return {on_axis((at_m.x - grid_.x_m(0)) / grid_.dx_m, grid_.nx, boundary_.x),
                on_axis((at_m.y - grid_.y_m(0)) / grid_.dy_m, grid_.ny, boundary_.y)};
    }
    static double value(const Field<float>& f, const Place& p) {
        return f64::bilinear(f(p.x.low, p.y.low), f(p.x.high, p.y.low), f(p.x.low, p.y.high), f(p.x.high, p.y.high),
                             p.x.weight, p.y.weight);
    }
    /// Of a slope along x (y), which a wall mirrors.
    static double slope_x(const Field<float>& f, const Place& p) {
        const double l = p.x.mirror_low, h = p.x.mirror_high;
        return f64::bilinear(l * f(p.x.low, p.y.low), h * f(p.x.high, p.y.low), l * f(p.x.low, p.y.high),
                             h * f(p.x.high, p.y.high), p.x.weight, p.y.weight);
    }
    static double slope_y(const Field<float>& f, const Place& p) {
        const double l = p.y.mirror_low, h = p.y.mirror_high;
        return f64::bilinear(l * f(p.x.low, p.y.low), l * f(p.x.high, p.y.low), h * f(p.x.low, p.y.high),
                             h * f(p.x.high, p.y.high), p.x.weight, p.y.weight);
    }
    /// Gradient of a field, of the bilinear patch it lies on.
    glm::dvec2 gradient(const Field<float>& f, const Place& p) const {
        const double ll = f(p.x.low, p.y.low), hl = f(p.x.high, p.y.low), lh = f(p.x.low, p.y.high),
                     hh = f(p.x.high, p.y.high);
        return {(hl - ll + p.y.weight * (hh - lh - hl + ll)) / grid_.dx_m,
                (lh - ll + p.x.weight * (hh - hl - lh + ll)) / grid_.dy_m};
    }

  private:
    static f64::AxisPlace on_axis(double cell, int n, Side side) {
        const double whole = std::floor(cell);
        return f64::place_on_axis(static_cast<int>(whole), cell - whole, n, side_number(side), 0.5);
    }
    const Grid& grid_;
    Boundary boundary_;
};

/// The mesh: columns [first, end) and rows of pixels' width, pixel (0, 0) being the domain's first.
struct Mesh {
    glm::ivec2 first{0, 0}, end{0, 0};
};

/// Some rows of the map, and the account of their light. Powers in watts.
struct Part {
    int first_row = 0;
    Field<double> power_w;
    FloorLedger ledger;
};

/// The light of one surface on the ground.
class ReliefLight {
  public:
    ReliefLight(const ReliefSettings& settings, const Surface& surface)
        : s_(settings),
          surface_(surface),
          between_(surface.grid, surface.boundary),
          climb_(surface.tilt * glm::dvec2{surface.grid.width_m(), surface.grid.height_m()}) {
        const bool lit = s_.floor.sun.elevation_deg > 0;
        sun_ = lit ? s_.floor.sun.direction() : glm::dvec3{0, 0, -1};
        irradiance_ = lit ? s_.floor.sun.irradiance_w_m2 : 0;
        const auto [low, high] = std::minmax_element(s_.bed_m.values().begin(), s_.bed_m.values().end());
        lowest_m_ = *low;
        flat_ = *low == *high;
    }

    /// Pixels beside the domain whose light may land in it.
    Mesh mesh() const {
        const FloorPlan& plan = s_.floor.plan;
        Mesh mesh{{0, 0}, {plan.width, plan.height}};
        double highest = 0, steepest = 0;
        for (const float e : surface_.elevation.values()) highest = std::max<double>(highest, e);
        steepest = glm::length(glm::dvec2(refract({0, 0}).travel));
        const double reach_m = (highest - lowest_m_) * steepest;
        if (surface_.boundary.x == Side::absorbing) widen(mesh, 0, reach_m / plan.pitch_m.x);
        if (surface_.boundary.y == Side::absorbing) widen(mesh, 1, reach_m / plan.pitch_m.y);
        return mesh;
    }

    /// Where light enters above a place of the map, and where it lands.
    LightWay way(glm::dvec2 pixel) const { return landing(pixel).way; }
    double lowest_m() const { return lowest_m_; }

    Part carry_rows(const Mesh& mesh, const ShadowRows& shadows, int begin, int end) const {
        std::vector<std::vector<LandedCorner>> rows;
        double lowest = 1e300, highest = -1e300;
        for (int j = begin; j <= end; ++j) {
            rows.push_back(corner_row(mesh, j));
            for (const LandedCorner& c : rows.back()) {
                lowest = std::min(lowest, c.pixel.y);
                highest = std::max(highest, c.pixel.y);
            }
        }
        Part part;
        const bool wraps = surface_.boundary.y == Side::periodic;
        const double height = s_.floor.plan.height;
        part.first_row = static_cast<int>(std::floor(wraps ? lowest : std::clamp(lowest, 0.0, height)));
        const int last = static_cast<int>(std::ceil(wraps ? highest + 1 : std::clamp(highest + 1, 0.0, height)));
        part.power_w = Field<double>(s_.floor.plan.width, std::max(0, last - part.first_row));
        CellShares shares;
        for (int j = begin; j < end; ++j) {
            const auto &low = rows[static_cast<std::size_t>(j - begin)],
                       &high = rows[static_cast<std::size_t>(j - begin + 1)];
            for (std::size_t i = 0; i + 1 < low.size(); ++i) {
                const int column = mesh.first.x + static_cast<int>(i);
                const bool own = column >= 0 && column < s_.floor.plan.width && j >= 0 && j < s_.floor.plan.height;
                const f64::SampleShadow* shadow = shadows.of(static_cast<int>(i), j - mesh.first.y);
                carry({low[i], low[i + 1], high[i + 1]}, own, shadow, shares, part);
                carry({low[i], high[i + 1], high[i]}, own, shadow, shares, part);
            }
        }
        return part;
    }

    /// Area of the ground over that of its horizontal projection, at the middle of a pixel.
    double steepness(int i, int j) const {
        const Between::Place p = between_.place(s_.floor.plan.position_m({i + 0.5, j + 0.5}));
        const glm::dvec2 g = between_.gradient(s_.bed_m, p);
        return std::sqrt(1 + glm::dot(g, g));
    }

  private:
    static void widen(Mesh& mesh, int axis, double pixels) {
        const int by = static_cast<int>(std::ceil(std::min(pixels, 1e6))) + 1;
        mesh.first[axis] -= by;
        mesh.end[axis] += by;
    }

    f64::Refraction refract(glm::dvec2 slope) const {
        return f64::refract_sun(sun_, slope, s_.floor.optics.refractive_index, s_.floor.optics.fresnel ? 1 : 0);
    }

    double ground_m(glm::dvec2 at_m) const {
        return flat_ ? lowest_m_ : Between::value(s_.bed_m, between_.place(at_m));
    }

    /// How far light that enters at `start` descends until it meets the ground: steps of half a cell at most until it
    /// is below, then by the Illinois method.
    double descent_m(glm::dvec3 start, glm::dvec2 travel) const {
        const auto above = [&](double d) { return start.z - d - ground_m(glm::dvec2(start) + d * travel); };
        double d0 = 0, f0 = above(0);
        if (f0 <= 0) return 0;
        const double most = start.z - lowest_m_;
        if (flat_) return most;
        const Grid& g = surface_.grid;
        const double cells = most * std::max(std::abs(travel.x) / g.dx_m, std::abs(travel.y) / g.dy_m);
        const int steps = std::clamp(static_cast<int>(std::ceil(2 * cells)), 1, 4096);
        double d1 = 0, f1 = f0;
        for (int k = 1; k <= steps && f1 > 0; ++k) {
            d0 = d1;
            f0 = f1;
            d1 = most * k / steps;
            f1 = above(d1);
        }
        constexpr double enough_m = 1e-9;
        for (int k = 0; k < 60 && std::abs(d1 - d0) > enough_m && f1 != 0; ++k) {
            const double d = d1 - f1 * (d1 - d0) / (f1 - f0), f = above(d);
            if (f * f1 < 0) {
                d0 = d1;
                f0 = f1;
            } else {
                f0 *= 0.5;
            }
            d1 = d;
            f1 = f;
        }
        return d1;
    }

    struct Landing {
        LightWay way;
        double transmittance = 0, path_m = 0;
    };

    Landing landing(glm::dvec2 pixel) const {
        const glm::dvec2 at = s_.floor.plan.position_m(pixel);
        const Between::Place p = between_.place(at);
        const double water = p.x.water * p.y.water;
        const double climb = f64::wraps_between(p.x) * climb_.x + f64::wraps_between(p.y) * climb_.y;
        const double elevation = water * (Between::value(surface_.elevation, p) + climb);
        const f64::Refraction r =
            refract(water * glm::dvec2{Between::slope_x(surface_.slope_x, p), Between::slope_y(surface_.slope_y, p)});
        const glm::dvec3 start{at, elevation};
        const double descent = descent_m(start, r.travel);
        return {{start, {at + descent * r.travel, elevation - descent}}, r.transmittance, descent * r.path};
    }

    std::vector<LandedCorner> corner_row(const Mesh& mesh, int j) const {
        std::vector<LandedCorner> row;
        row.reserve(static_cast<std::size_t>(mesh.end.x - mesh.first.x) + 1);
        for (int i = mesh.first.x; i <= mesh.end.x; ++i) {
            const Landing l = landing({i, j});
            row.push_back({l.way.enters_m, s_.floor.plan.pixel(glm::dvec2(l.way.lands_m)), l.transmittance,
                           f64::beer_lambert(s_.floor.optics.extinction_per_m(), l.path_m)});
        }
        return row;
    }

    /// Sends the light of a triangle to the pixels; `own` light is of the domain.
    void carry(const std::array<LandedCorner, 3>& t, bool own, const f64::SampleShadow* shadow, CellShares& shares,
               Part& part) const {
        const TrianglePower of_one = triangle_power(t[0], t[1], t[2], sun_);
        const double incident = of_one.incident * irradiance_, entered = of_one.entered * irradiance_;
        const f64::ShadedLight light = f64::shade(shadow != nullptr ? *shadow : f64::SampleShadow{0, 0, 0}, incident,
                                                  entered, of_one.arrived * irradiance_);
        const double arrived = light.arrived;
        double on_map = 0;
        shares.share(std::array{t[0].pixel, t[1].pixel, t[2].pixel}, [&](int i, int j, double share) {
            const int width = s_.floor.plan.width, row = j - part.first_row;
            if (surface_.boundary.x == Side::periodic) i = ((i % width) + width) % width;
            if (i < 0 || i >= width || row < 0 || row >= part.power_w.ny()) return;
            part.power_w(i, row) += arrived * share;
            on_map += arrived * share;
        });
        if (!own) {
            part.ledger.entered_w += on_map;
            return;
        }
        part.ledger.incident_w += incident;
        part.ledger.reflected_w += light.reflected;
        part.ledger.extinguished_w += light.extinguished;
        part.ledger.objects_w += light.objects;
        part.ledger.outside_w += arrived - on_map;
    }

    const ReliefSettings& s_;
    const Surface& surface_;
    Between between_;
    glm::dvec2 climb_;
    glm::dvec3 sun_{0, 0, -1};
    double irradiance_ = 0, lowest_m_ = 0;
    bool flat_ = false;
};

class ReliefFloor final : public FloorMapper {
  public:
    explicit ReliefFloor(ReliefSettings settings) : s_(std::move(settings)), shadows_(s_.floor) { validate(s_.floor); }
    std::string_view backend() const override { return "cpu"; }

    void compute(const Surface& surface, FloorMap& map) override {
        check(surface);
        const FloorPlan& plan = s_.floor.plan;
        const ReliefLight light(s_, surface);
        const Mesh mesh = light.mesh();
        const ShadowRows shadows =
            shadows_.cast(surface, lattice(light, mesh), [&light](glm::dvec2 pixel) { return light.way(pixel); });
        Field<double> power(plan.width, plan.height);
        map.ledger = {};
        map.window = {1, 1};
        // Bands of fixed height, added in order: the sums do not depend on the number of threads.
        constexpr int band = 16;
        const int bands = (mesh.end.y - mesh.first.y + band - 1) / band;
#pragma omp parallel for schedule(static, 1) ordered
        for (int b = 0; b < bands; ++b) {
            const int begin = mesh.first.y + b * band;
            const Part part = light.carry_rows(mesh, shadows, begin, std::min(mesh.end.y, begin + band));
#pragma omp ordered
            {
                map.ledger += part.ledger;
                for (int j = 0; j < part.power_w.ny(); ++j) {
                    const int row = (((part.first_row + j) % plan.height) + plan.height) % plan.height;
                    for (int i = 0; i < plan.width; ++i) power(i, row) += part.power_w(i, j);
                }
            }
        }
        spread(light, power, map);
    }

  private:
    ShadowLattice lattice(const ReliefLight& light, const Mesh& mesh) const {
        const glm::ivec2 count = mesh.end - mesh.first;
        return {s_.floor.plan, {0, 0}, {mesh.first.x, count.x}, {mesh.first.y, count.y}, light.lowest_m()};
    }

    void check(const Surface& surface) const {
        const Grid& g = surface.grid;
        const FloorPlan& plan = s_.floor.plan;
        const double slack = 1e-9 * (g.width_m() + g.height_m());
        const glm::dvec2 size = plan.pitch_m * glm::dvec2{plan.width, plan.height};
        const bool covers = plan.angle_deg == 0 && std::abs(plan.origin_m.x - g.x0_m) < slack &&
                            std::abs(plan.origin_m.y - g.y0_m) < slack && std::abs(size.x - g.width_m()) < slack &&
                            std::abs(size.y - g.height_m()) < slack;
        if (!covers) throw InputError("floor map: on ground that is not flat it covers the domain and no more");
        if (s_.bed_m.nx() != g.nx || s_.bed_m.ny() != g.ny)
            throw InputError("floor map: the ground must have the cells of the surface");
    }

    void spread(const ReliefLight& light, const Field<double>& power, FloorMap& map) const {
        const FloorPlan& plan = s_.floor.plan;
        if (map.irradiance.nx() != plan.width || map.irradiance.ny() != plan.height)
            map.irradiance = Field<float>(plan.width, plan.height);
        const double area = plan.pitch_m.x * plan.pitch_m.y;
        for (int j = 0; j < plan.height; ++j)
            for (int i = 0; i < plan.width; ++i) {
                map.ledger.floor_w += power(i, j);
                const double steepness = s_.per_ground_area ? light.steepness(i, j) : 1;
                map.irradiance(i, j) = static_cast<float>(power(i, j) / (area * steepness));
            }
    }

    ReliefSettings s_;
    ObjectShadows shadows_;
};

}  // namespace

std::unique_ptr<FloorMapper> make_relief_floor(ReliefSettings settings) {
    return std::make_unique<ReliefFloor>(std::move(settings));
}

}  // namespace waterlight
