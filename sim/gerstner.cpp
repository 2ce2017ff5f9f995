#include "sim/gerstner.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sim/error.hpp"
#include "sim/kernels/dispersion.hpp"
#include "sim/random.hpp"

namespace waterlight {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

void require(bool holds, const char* what) {
    if (!holds) throw InputError(std::string("gerstner: ") + what);
}

void check(const GerstnerSettings& settings) {
    require(settings.waves >= 1, "waves must be 1 or more");
    require(settings.wavelength_m.x > 0 && settings.wavelength_m.y >= settings.wavelength_m.x,
            "wavelength_m must be 0 < shortest <= longest");
    require(settings.steepness >= 0 && settings.steepness < 1, "steepness must be in [0, 1)");
    require(settings.spread_deg >= 0, "spread_deg must be 0 or more");
}

// The wave vector nearest to k that repeats with the domain on its periodic sides; never zero.
glm::dvec2 fitting(glm::dvec2 k, const Grid& grid, Boundary boundary) {
    const glm::dvec2 lowest{two_pi / grid.width_m(), two_pi / grid.height_m()};
    glm::dvec2 fit = k;
    if (boundary.x == Side::periodic) fit.x = lowest.x * std::round(k.x / lowest.x);
    if (boundary.y == Side::periodic) fit.y = lowest.y * std::round(k.y / lowest.y);
    if (fit != glm::dvec2(0, 0)) return fit;
    return std::abs(k.x) >= std::abs(k.y) ? glm::dvec2(std::copysign(lowest.x, k.x), 0)
                                          : glm::dvec2(0, std::copysign(lowest.y, k.y));
}

}  // namespace

std::vector<GerstnerWave> gerstner_waves(const GerstnerSettings& settings, const Grid& grid, Boundary boundary,
                                         const Water& water) {
    check(settings);
    std::vector<GerstnerWave> waves;
    RandomStream random(settings.seed, 0);
    const double octaves = std::log(settings.wavelength_m.y / settings.wavelength_m.x);
    const double tension = water.surface_tension_n_m / water.density_kg_m3;
    for (int n = 0; n < settings.waves; ++n) {
        const double length = settings.wavelength_m.x * std::exp(octaves * random.uniform());
        const double degrees = settings.direction_deg + settings.spread_deg * random.uniform(-1, 1);
        const double angle = degrees * std::numbers::pi / 180;
        GerstnerWave wave;
        wave.k = fitting(two_pi / length * glm::dvec2(std::cos(angle), std::sin(angle)), grid, boundary);
        const double k = glm::length(wave.k);
        wave.amplitude_m = settings.steepness / (settings.waves * k);
        wave.omega = std::sqrt(f64::airy_omega2(k, water.depth_m, water.gravity_m_s2, tension));
        wave.phase = random.uniform(0, two_pi);
        const auto same = std::ranges::find(waves, wave.k, &GerstnerWave::k);
        if (same == waves.end()) {
            waves.push_back(wave);
        } else {
            same->amplitude_m += wave.amplitude_m;
        }
    }
    return waves;
}

GerstnerSea::GerstnerSea(std::vector<GerstnerWave> waves) : waves_(std::move(waves)) {
    double steepness = 0;
    for (const GerstnerWave& wave : waves_) {
        const double k = glm::length(wave.k);
        assert(k > 0);
        steepness += k * std::abs(wave.amplitude_m);
        amplitude_sum_ += std::abs(wave.amplitude_m);
        raised_ += f64::gerstner_sinking(k, wave.amplitude_m);
    }
    assert(steepness < 1);
}

f64::Gerstner GerstnerSea::sums_at(glm::dvec2 particle, double time_s) const {
    f64::Gerstner sums = f64::gerstner_none();
    for (const GerstnerWave& wave : waves_) {
        const double theta = glm::dot(wave.k, particle) - wave.omega * time_s + wave.phase;
        sums =
            f64::gerstner_add(sums, wave.k, glm::normalize(wave.k), wave.amplitude_m, std::sin(theta), std::cos(theta));
    }
    return sums;
}

// Solves A - shift(A) = x. The left side is the gradient of a convex function, |A|^2 / 2 + sum of (a / k) cos(theta),
// since the sum of k a is below 1: Newton's steps, halved while they do not bring the miss down, always arrive.
glm::dvec2 GerstnerSea::particle_at(glm::dvec2 at_m, double time_s) const {
    const auto miss_of = [&](glm::dvec2 particle, const f64::Gerstner& sums) {
        return particle - glm::dvec2(sums.shift_x, sums.shift_y) - at_m;
    };
    glm::dvec2 particle = at_m;
    f64::Gerstner sums = sums_at(particle, time_s);
    glm::dvec2 miss = miss_of(particle, sums);
    const double tolerance = 1e-13 * amplitude_sum_;
    for (int n = 0; n < 100 && glm::length(miss) > tolerance; ++n) {
        const glm::dvec2 step = f64::gerstner_solve(sums, miss);
        for (double part = 1; part > 1e-6; part *= 0.5) {
            const glm::dvec2 next = particle - part * step;
            const f64::Gerstner next_sums = sums_at(next, time_s);
            const glm::dvec2 next_miss = miss_of(next, next_sums);
            if (glm::length(next_miss) >= glm::length(miss)) continue;
            particle = next;
            sums = next_sums;
            miss = next_miss;
            break;
        }
    }
    return particle;
}

SurfacePoint GerstnerSea::at(glm::dvec2 at_m, double time_s) const {
    const glm::dvec2 particle = particle_at(at_m, time_s);
    const f64::Gerstner sums = sums_at(particle, time_s);
    SurfacePoint point;
    point.elevation_m = raised_ + sums.elevation;
    point.slope = f64::gerstner_solve(sums, {sums.rise_x, sums.rise_y});
    // The surface at a fixed place rises as the particle does, less what the particle climbs by moving along.
    for (const GerstnerWave& wave : waves_) {
        const double theta = glm::dot(wave.k, particle) - wave.omega * time_s + wave.phase;
        const double speed = wave.omega * wave.amplitude_m;
        point.rate_m_s +=
            speed * std::sin(theta) - speed * std::cos(theta) * glm::dot(point.slope, glm::normalize(wave.k));
    }
    return point;
}

}  // namespace waterlight
