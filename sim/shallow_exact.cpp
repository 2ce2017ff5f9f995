#include "sim/shallow_exact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sim/error.hpp"
#include "sim/kernels/shallow_exact.hpp"

namespace waterlight {

namespace {

constexpr double pi = std::numbers::pi;

glm::dvec2 heading(double degrees) { return {std::cos(degrees * pi / 180), std::sin(degrees * pi / 180)}; }

ShallowState state_of(const f64::ExactFlow& flow) { return {flow.depth, flow.velocity}; }

void require(bool holds, const char* state, const char* key, double found, const char* allowed) {
    if (!holds) throw InputError(fmt::format("{}: {} is {}; it must be {}", state, key, found, allowed));
}

void require_positive(double value, const char* state, const char* key) {
    require(value > 0 && std::isfinite(value), state, key, value, "above 0");
}

void require_place(glm::dvec2 at, const char* state, const char* key) {
    require(std::isfinite(at.x), state, key, at.x, "finite");
    require(std::isfinite(at.y), state, key, at.y, "finite");
}

double bowl(double x, double y, glm::dvec2 centre, double h0, double a) {
    const glm::dvec2 r = glm::dvec2(x, y) - centre;
    return h0 * (glm::dot(r, r) / (a * a) - 1);
}

}  // namespace

ShallowState ThackerPlanar::exact(double x, double y, double t) const {
    const double omega = f64::thacker_planar_omega(h0_m, a_m, gravity_m_s2);
    return state_of(f64::thacker_planar(glm::dvec2(x, y) - centre_m, omega * t, h0_m, a_m, eta_m, omega));
}

double ThackerPlanar::bed(double x, double y) const { return bowl(x, y, centre_m, h0_m, a_m); }

double ThackerPlanar::period_s() const { return 2 * pi / f64::thacker_planar_omega(h0_m, a_m, gravity_m_s2); }

void ThackerPlanar::check() const {
    require_positive(h0_m, "Thacker's planar surface", "h0");
    require_positive(a_m, "Thacker's planar surface", "a");
    require(eta_m >= 0 && std::isfinite(eta_m), "Thacker's planar surface", "eta", eta_m, "0 or more");
    require_place(centre_m, "Thacker's planar surface", "centre");
    require_positive(gravity_m_s2, "Thacker's planar surface", "gravity");
}

ShallowState ThackerRadial::exact(double x, double y, double t) const {
    const double omega = f64::thacker_radial_omega(h0_m, a_m, gravity_m_s2);
    return state_of(f64::thacker_radial(glm::dvec2(x, y) - centre_m, omega * t, h0_m, a_m, r0_m, omega));
}

double ThackerRadial::bed(double x, double y) const { return bowl(x, y, centre_m, h0_m, a_m); }

double ThackerRadial::period_s() const { return 2 * pi / f64::thacker_radial_omega(h0_m, a_m, gravity_m_s2); }

void ThackerRadial::check() const {
    require_positive(h0_m, "Thacker's swinging paraboloid", "h0");
    require_positive(a_m, "Thacker's swinging paraboloid", "a");
    require(r0_m > 0 && r0_m <= a_m, "Thacker's swinging paraboloid", "r0", r0_m, "above 0 and at most a");
    require_place(centre_m, "Thacker's swinging paraboloid", "centre");
    require_positive(gravity_m_s2, "Thacker's swinging paraboloid", "gravity");
}

ShallowState TravellingVortex::exact(double x, double y, double t) const {
    const glm::dvec2 carried = speed_m_s * heading(direction_deg);
    const glm::dvec2 r = glm::dvec2(x, y) - centre_m - t * carried;
    return state_of(f64::shallow_vortex(r, carried, h0_m, beta_m2_s, gravity_m_s2));
}

double TravellingVortex::bed(double, double) const { return -h0_m; }

void TravellingVortex::check() const {
    require_positive(gravity_m_s2, "the travelling vortex", "gravity");
    require(std::isfinite(beta_m2_s), "the travelling vortex", "beta", beta_m2_s, "finite");
    require(speed_m_s >= 0 && std::isfinite(speed_m_s), "the travelling vortex", "speed", speed_m_s, "0 or more");
    require(std::isfinite(direction_deg), "the travelling vortex", "direction", direction_deg, "finite");
    require_place(centre_m, "the travelling vortex", "centre");
    require(std::isfinite(h0_m) && exact(centre_m.x, centre_m.y, 0).depth_m > 0, "the travelling vortex", "h0", h0_m,
            "above beta^2 e / (8 pi^2 g), the dip of the middle");
}

ShallowState RiemannProblem::exact(double x, double y, double t) const {
    const glm::dvec2 n = heading(direction_deg);
    const double s = glm::dot(glm::dvec2(x, y) - at_m, n);
    f64::RiemannStar flow;
    if (t > 0) {
        flow = f64::riemann_at(s / t, left_depth_m, left_velocity_m_s, right_depth_m, right_velocity_m_s, gravity_m_s2);
    } else {
        flow = s < 0 ? f64::RiemannStar{left_depth_m, left_velocity_m_s}
                     : f64::RiemannStar{right_depth_m, right_velocity_m_s};
    }
    return flow.depth > 0 ? ShallowState{flow.depth, flow.velocity * n} : ShallowState{};
}

double RiemannProblem::bed(double, double) const { return 0; }

void RiemannProblem::check() const {
    const char* state = "the dam break";
    require(left_depth_m >= 0 && std::isfinite(left_depth_m), state, "left depth", left_depth_m, "0 or more");
    require(right_depth_m >= 0 && std::isfinite(right_depth_m), state, "right depth", right_depth_m, "0 or more");
    require(std::isfinite(left_velocity_m_s), state, "left velocity", left_velocity_m_s, "finite");
    require(std::isfinite(right_velocity_m_s), state, "right velocity", right_velocity_m_s, "finite");
    require(std::isfinite(direction_deg), state, "direction", direction_deg, "finite");
    require_place(at_m, state, "place");
    require_positive(gravity_m_s2, state, "gravity");
}

RiemannProblem::Middle RiemannProblem::middle() const {
    const f64::RiemannStar star =
        f64::riemann_star(left_depth_m, left_velocity_m_s, right_depth_m, right_velocity_m_s, gravity_m_s2);
    const auto shock = [&](double h, double u) {
        return star.depth > h ? f64::riemann_shock_speed(star.depth, h, u, gravity_m_s2)
                              : std::numeric_limits<double>::quiet_NaN();
    };
    return {star.depth, star.velocity, -shock(left_depth_m, -left_velocity_m_s),
            shock(right_depth_m, right_velocity_m_s)};
}

ShallowState ObliqueJump::exact(double x, double y, double) const {
    const Behind after = behind();
    const double from_wall = (after.angle_deg - deflection_deg) * pi / 180;
    const glm::dvec2 r = glm::dvec2(x, y) - corner_m;
    if (r.y * std::cos(from_wall) < r.x * std::sin(from_wall)) return {after.depth_m, {after.speed_m_s, 0}};
    return {depth_m, speed_m_s * heading(-deflection_deg)};
}

double ObliqueJump::bed(double, double) const { return 0; }

ObliqueJump::Behind ObliqueJump::behind() const {
    const double froude = speed_m_s / std::sqrt(gravity_m_s2 * depth_m);
    const double deflection = deflection_deg * pi / 180;
    const double angle = f64::oblique_jump_angle(froude, deflection);
    const double normal = froude * std::sin(angle);
    return {angle * 180 / pi, depth_m * f64::jump_depth_ratio(normal * normal),
            speed_m_s * std::cos(angle) / std::cos(angle - deflection)};
}

void ObliqueJump::check() const {
    const char* state = "the oblique jump";
    require_positive(depth_m, state, "depth");
    require_positive(gravity_m_s2, state, "gravity");
    require_place(corner_m, state, "corner");
    const double froude = speed_m_s / std::sqrt(gravity_m_s2 * depth_m);
    require(froude > 1 && std::isfinite(froude), state, "speed", speed_m_s, "above sqrt(g depth)");
    const double deflection = deflection_deg * pi / 180;
    const double angle = f64::oblique_jump_angle(froude, deflection);
    require(deflection > 0 && std::abs(f64::oblique_turn(angle, froude).deflection - deflection) < 1e-9, state,
            "deflection", deflection_deg, "above 0 degrees and small enough for a jump attached to the corner");
}

ShallowExact with_gravity(ShallowExact state, double gravity_m_s2) {
    std::visit([&](auto& s) { s.gravity_m_s2 = gravity_m_s2; }, state);
    return state;
}

}  // namespace waterlight
