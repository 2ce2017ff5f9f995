#include "sim/shallow_initial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sim/error.hpp"
#include "sim/kernels/shallow_exact.hpp"
#include "sim/quadrature.hpp"
#include "sim/shallow_means.hpp"

namespace waterlight {

namespace {

glm::dvec2 heading(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle)};
}

void require(bool holds, const char* state, const char* key, double found, const char* allowed) {
    if (!holds) throw InputError(fmt::format("{}: {} is {}; it must be {}", state, key, found, allowed));
}

void require_finite(const char* state, const char* key, double found) {
    require(std::isfinite(found), state, key, found, "finite");
}

void require_positive(const char* state, const char* key, double found) {
    require(found > 0 && std::isfinite(found), state, key, found, "above 0");
}

/// Distance (m) beyond the crest of `wave`, at the start.
double beyond_crest(const SolitaryWave& wave, double x, double y) {
    return glm::dot(glm::dvec2(x, y) - wave.crest_m, heading(wave.direction_deg));
}

/// The share of a cell in which inside(x, y) holds: 1 or 0 where its corners and its centre agree, else by 32 x 32
/// points.
template <class Inside>
double share_of_cell(const Grid& grid, int i, int j, const Inside& inside) {
    const double x0 = grid.x0_m + i * grid.dx_m;
    const double y0 = grid.y0_m + j * grid.dy_m;
    const auto at = [&](double u, double v) { return inside(x0 + u * grid.dx_m, y0 + v * grid.dy_m) ? 1 : 0; };
    const int agreeing = at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1) + at(0.5, 0.5);
    if (agreeing == 0 || agreeing == 5) return agreeing / 5;
    constexpr int points = 32;
    int count = 0;
    for (int m = 0; m < points; ++m)
        for (int n = 0; n < points; ++n) count += at((n + 0.5) / points, (m + 0.5) / points);
    return count / (1.0 * points * points);
}

class Filler {
  public:
    explicit Filler(ShallowWaterSettings& settings) : s_(settings) {
        const Grid& grid = s_.grid;
        s_.depth_m = Field<double>(grid.nx, grid.ny);
        s_.velocity_x_m_s = Field<double>(grid.nx, grid.ny);
        s_.velocity_y_m_s = Field<double>(grid.nx, grid.ny);
    }

    void operator()(const StillWater& still) {
        require_finite("still water", "level", still.level_m);
        fill_levels([&](int, int) { return 1.0; }, still.level_m, 0);
    }

    void operator()(const PlaneDam& dam) {
        require_finite("the dam", "level behind", dam.behind_level_m);
        require_finite("the dam", "level ahead", dam.ahead_level_m);
        require_finite("the dam", "direction", dam.direction_deg);
        require_finite("the dam", "place", dam.at_m.x + dam.at_m.y);
        const glm::dvec2 n = heading(dam.direction_deg);
        const auto behind = [&](double x, double y) { return glm::dot(glm::dvec2(x, y) - dam.at_m, n) < 0; };
        fill_levels([&](int i, int j) { return share_of_cell(s_.grid, i, j, behind); }, dam.behind_level_m,
                    dam.ahead_level_m);
    }

    void operator()(const CircularDam& dam) {
        require_finite("the round dam", "level inside", dam.inside_level_m);
        require_finite("the round dam", "level outside", dam.outside_level_m);
        require_finite("the round dam", "centre", dam.centre_m.x + dam.centre_m.y);
        require_positive("the round dam", "radius", dam.radius_m);
        const auto inside = [&](double x, double y) {
            return glm::distance(glm::dvec2(x, y), dam.centre_m) < dam.radius_m;
        };
        fill_levels([&](int i, int j) { return share_of_cell(s_.grid, i, j, inside); }, dam.inside_level_m,
                    dam.outside_level_m);
    }

    void operator()(SolitaryWave wave) {
        require_positive("the solitary wave", "height", wave.height_m);
        require_positive("the solitary wave", "depth", wave.depth_m);
        require_finite("the solitary wave", "direction", wave.direction_deg);
        require_finite("the solitary wave", "crest", wave.crest_m.x + wave.crest_m.y);
        wave.gravity_m_s2 = s_.water.gravity_m_s2;
        for (int j = 0; j < s_.grid.ny; ++j)
            for (int i = 0; i < s_.grid.nx; ++i)
                if (s_.depth_m(i, j) > 0) add(wave, i, j);
    }

    void operator()(const ExactStart& start) {
        const ShallowExact state = with_gravity(start.state, s_.water.gravity_m_s2);
        std::visit([](const auto& exact) { exact.check(); }, state);
        require_finite("the exact state", "time", start.time_s);
        ShallowMeans means = cell_means(state, s_.grid, start.time_s);
        for (std::size_t n = 0; n < s_.grid.cells(); ++n) {
            const double depth = means.depth_m.data()[n];
            s_.velocity_x_m_s.data()[n] = depth > 0 ? means.discharge_x_m2_s.data()[n] / depth : 0;
            s_.velocity_y_m_s.data()[n] = depth > 0 ? means.discharge_y_m2_s.data()[n] / depth : 0;
        }
        s_.depth_m = std::move(means.depth_m);
    }

  private:
    double bed(int i, int j) const { return s_.bed_m.empty() ? -s_.water.depth_m : s_.bed_m(i, j); }

    /// Still water at level a in the share of each cell that share(i, j) gives, at level b in the rest.
    template <class Share>
    void fill_levels(const Share& share, double a, double b) {
        for (int j = 0; j < s_.grid.ny; ++j) {
            for (int i = 0; i < s_.grid.nx; ++i) {
                const double part = share(i, j);
                const double z = bed(i, j);
                s_.depth_m(i, j) = part * std::max(0.0, a - z) + (1 - part) * std::max(0.0, b - z);
            }
        }
        s_.velocity_x_m_s.fill(0);
        s_.velocity_y_m_s.fill(0);
    }

    /// The wave's water and momentum, as means over cell (i, j).
    void add(const SolitaryWave& wave, int i, int j) {
        struct Sums {
            double depth = 0;
            glm::dvec2 discharge{0, 0};
            void add(double weight, const ShallowState& state) {
                depth += weight * state.depth_m;
                discharge += weight * state.depth_m * state.velocity_m_s;
            }
        };
        const Grid& grid = s_.grid;
        const double still = s_.depth_m(i, j);
        const auto at = [&](double x, double y) {
            return ShallowState{still + wave.elevation_m(x, y, 0), wave.velocity_m_s(x, y, 0)};
        };
        const Sums mean =
            lobatto_mean<Sums>(at, {grid.x0_m + i * grid.dx_m, grid.y0_m + j * grid.dy_m, grid.dx_m, grid.dy_m});
        s_.velocity_x_m_s(i, j) += mean.discharge.x / mean.depth;
        s_.velocity_y_m_s(i, j) += mean.discharge.y / mean.depth;
        s_.depth_m(i, j) = mean.depth;
    }

    ShallowWaterSettings& s_;
};

}  // namespace

double SolitaryWave::speed_m_s() const { return f64::solitary_speed(height_m, depth_m, gravity_m_s2); }

double SolitaryWave::elevation_m(double x, double y, double t) const {
    return f64::solitary_elevation(beyond_crest(*this, x, y) - speed_m_s() * t, height_m, depth_m);
}

glm::dvec2 SolitaryWave::velocity_m_s(double x, double y, double t) const {
    const double eta = elevation_m(x, y, t);
    return speed_m_s() * eta / (depth_m + eta) * heading(direction_deg);
}

double SolitaryWave::volume_m2() const { return 4 * std::sqrt(height_m * depth_m * depth_m * depth_m / 3); }

void set_initial(const std::vector<ShallowInitial>& initial, ShallowWaterSettings& settings) {
    Filler filler(settings);
    filler(StillWater{});
    for (const ShallowInitial& state : initial) std::visit(filler, state);
}

}  // namespace waterlight
