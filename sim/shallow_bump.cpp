// Steady flow over a bump: Bernoulli on either side of the jump, Belanger across it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/error.hpp"
#include "sim/kernels/shallow_exact.hpp"
#include "sim/shallow_exact.hpp"

namespace waterlight {

namespace {

double head_of(double h, double q, double g) { return h + q * q / (2 * g * h * h); }

double critical_depth(const SteadyBump& bump) {
    return std::cbrt(bump.discharge_m2_s * bump.discharge_m2_s / bump.gravity_m_s2);
}

/// Depth where the head over the ground is above the least possible by `excess` metres.
double depth_at(double excess, double critical_m, bool subcritical) {
    return critical_m * f64::bernoulli_depth_ratio(std::max(0.0, excess) / critical_m, subcritical);
}

/// Where, downstream of the crest, the fast flow jumps to a slow one of this head: the x at which the fast flow's
/// conjugate depth is the slow depth. Nearer the crest the fast flow pushes harder, at the foot the slow one does;
/// bisection finds the place to rounding.
double jump_place(const SteadyBump& bump, double critical_m, double downstream_head_m) {
    const auto pushes_on = [&](double x) {
        const double z = bump.bed(x, 0);
        const double slow_excess = downstream_head_m - z - 1.5 * critical_m;
        if (slow_excess < 0) return true;
        const double fast = depth_at(bump.height_m - z, critical_m, false);
        const double conjugate = fast * f64::jump_depth_ratio(std::pow(critical_m / fast, 3));
        return conjugate > depth_at(slow_excess, critical_m, true);
    };
    double near = bump.crest_m;
    double far = bump.crest_m + std::sqrt(bump.height_m / bump.curvature_per_m);
    for (int n = 0; n < 60; ++n) {
        const double middle = 0.5 * (near + far);
        (pushes_on(middle) ? near : far) = middle;
    }
    return 0.5 * (near + far);
}

}  // namespace

double SteadyBump::bed(double x, double) const {
    return std::max(0.0, height_m - curvature_per_m * (x - crest_m) * (x - crest_m));
}

SteadyBump::Flow SteadyBump::flow() const {
    const double critical = critical_depth(*this);
    const double held = head_of(downstream_depth_m, discharge_m2_s, gravity_m_s2);
    const double crest = height_m + 1.5 * critical;
    if (held >= crest) return {BumpRegime::subcritical, critical, held, held};
    // The crest holds the flow back: it is critical there and fast below.
    const double fast = depth_at(height_m, critical, false);
    const double conjugate = fast * f64::jump_depth_ratio(std::pow(critical / fast, 3));
    if (conjugate > downstream_depth_m) return {BumpRegime::transcritical, critical, crest, crest};
    return {BumpRegime::transcritical_with_jump, critical, crest, held, jump_place(*this, critical, held)};
}

ShallowState SteadyBump::exact(double x, double y, double) const {
    const Flow found = flow();
    const double z = bed(x, y);
    double depth;
    if (found.regime == BumpRegime::subcritical || x > found.jump_m) {
        depth = depth_at(found.downstream_head_m - z - 1.5 * found.critical_depth_m, found.critical_depth_m, true);
    } else {
        depth = depth_at(height_m - z, found.critical_depth_m, x < crest_m);
    }
    return {depth, {discharge_m2_s / depth, 0}};
}

void SteadyBump::check() const {
    const auto require = [](bool holds, const char* key, double found, const std::string& allowed) {
        if (!holds)
            throw InputError(fmt::format("steady flow over a bump: {} is {}; it must be {}", key, found, allowed));
    };
    const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
    require(positive(discharge_m2_s), "discharge", discharge_m2_s, "above 0");
    require(positive(height_m), "height", height_m, "above 0");
    require(positive(curvature_per_m), "curvature", curvature_per_m, "above 0");
    require(positive(gravity_m_s2), "gravity", gravity_m_s2, "above 0");
    require(std::isfinite(crest_m), "crest", crest_m, "finite");
    require(positive(downstream_depth_m) && downstream_depth_m > critical_depth(*this), "downstream depth",
            downstream_depth_m, fmt::format("above the critical depth, {:.6g} m", critical_depth(*this)));
}

}  // namespace waterlight
