#include "scenarios/scene_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "scenarios/resolve.hpp"
#include "sim/airy_dispersion.hpp"
#include "sim/kernels/sources.hpp"
#include "sim/time_series.hpp"

namespace waterlight {

namespace {

using std::numbers::pi;

class Gatherer {
  public:
    explicit Gatherer(const Scenario& s) : s_(s), duration_(s.waves.duration_s) {
        const Boundary sides = resolve_boundary(s);
        const glm::dvec2 size = s.domain.size_m;
        if (sides.x == Side::absorbing) reach_m_ = size.x;
        if (sides.y == Side::absorbing) reach_m_ = std::min(reach_m_, size.y);
        area_m2_ = size.x * size.y;
    }

    SceneSpectrum gather() {
        for (const Sine& sine : s_.waves.sines)
            if (!sine.frozen) add(2 * pi / sine.wavelength_m, std::abs(sine.amplitude_m), duration_);
        for (const Sine& sine : s_.waves.sines)
            if (sine.frozen) add(2 * pi / sine.wavelength_m, std::abs(sine.amplitude_m), 0);
        const Grid patch = make_grid(1, 1, s_.domain.size_m.x, s_.domain.size_m.y);
        for (const StandingWave& wave : s_.waves.standing) {
            const double k = glm::length(wave_vector(wave, patch));
            if (k == 0) continue;
            const bool crossed = wave.half_waves_x > 0 && wave.half_waves_y > 0;
            add(k, std::abs(wave.amplitude_m), duration_, true);
            result_.waves.back().variance_m2 *= crossed ? 0.5 : 1;
        }
        for (const Source& source : s_.waves.sources) std::visit([this](const auto& one) { add_source(one); }, source);
        if (s_.waves.spectrum) add_sea(make_spectrum(*s_.waves.spectrum, s_.water));
        if (s_.waves.buoy) add_sea(read_buoy(*s_.waves.buoy, s_.water));
        if (s_.waves.gerstner) add_gerstner(*s_.waves.gerstner);
        for (const Inflow& inflow : s_.waves.inflows) add_inflow(inflow.signal);
        for (const ShallowInitial& state : s_.waves.initial)
            std::visit([this](const auto& one) { add_state(one); }, state);
        return std::move(result_);
    }

  private:
    double wavelengths(double k, double seconds) const {
        const double travelled = std::max(seconds, 0.0) * airy_omega(k, s_.water) / (2 * pi);
        return std::min(travelled, reach_m_ * k / (2 * pi));
    }

    void add(double k, double a, double seconds, bool stands = false) {
        result_.waves.push_back({{k, a, wavelengths(k, seconds), stands}, 0.5 * a * a});
    }

    /// Bins of the drop's transform over wave numbers, `count` such drops in the domain. Their rings get lower as they
    /// widen: what height does to them is done within the first wavelength.
    void add_rings(double radius, double height, double seconds, double count) {
        constexpr double first = 0.25, last = 6, ratio = 1.189207115;  // k R, by quarters of an octave
        for (double kr = first; kr < last; kr *= ratio) {
            const double k = kr / radius;
            const double transform = pi * radius * radius * height * f64::drop_transform(0.25 * kr * kr);
            const double width = k * std::log(ratio);
            const double variance = count * transform * transform * k * width / (2 * pi * area_m2_);
            const double n = wavelengths(k, seconds);
            constexpr double ring = 0.3;  // height of the first ring over that of the drop
            const double relative = f64::drop_transform(0.25 * kr * kr) * std::numbers::e;
            const double a = ring * std::abs(height) * relative / std::sqrt(std::max(n, 1.0));
            result_.waves.push_back({{k, a, n, false}, variance});
        }
    }
    void add_source(const Drop& drop) {
        if (drop.time_s < duration_ || duration_ == 0)
            add_rings(drop.radius_m, drop.height_m, duration_ - drop.time_s, 1);
    }
    void add_source(const Rain& rain) {
        constexpr int sizes = 3;
        const double seconds = std::min(rain.end_s, duration_) - rain.start_s;
        const double drops = rain.drops_per_m2_s * area_m2_ * std::max(seconds, 0.0);
        for (int i = 0; i < sizes; ++i) {
            const double share = static_cast<double>(i) / (sizes - 1);
            add_rings(std::lerp(rain.radius_m.x, rain.radius_m.y, share),
                      std::lerp(rain.height_m.x, rain.height_m.y, share), duration_ - rain.start_s - 0.5 * seconds,
                      drops / sizes);
        }
    }
    void add_source(const Wavemaker& maker) {
        add(airy_wave_number(2 * pi / maker.period_s, s_.water), std::abs(maker.amplitude_m),
            duration_ - maker.start_s);
    }

    /// Quarter octaves of frequency, all directions together; amplitudes from half an octave either way.
    void add_sea(const DirectionalSpectrum& sea) {
        constexpr int directions = 36, most_bins = 48;
        constexpr double ratio = 1.189207115;
        const std::size_t first = result_.waves.size();
        double f = std::max(sea.f_min_hz, 1e-3), carried = 0;
        for (int bin = 0; bin < 4 * most_bins && f < sea.f_max_hz && carried < (1 - 1e-5) * sea.variance_m2;
             ++bin, f *= ratio) {
            const double centre = f * std::sqrt(ratio);
            double density = 0;
            for (int i = 0; i < directions; ++i) density += sea.density(centre, 2 * pi * i / directions);
            const double variance = density * 2 * pi / directions * f * (ratio - 1);
            carried += variance;
            if (variance < 1e-9 * sea.variance_m2) continue;
            add(airy_wave_number(2 * pi * centre, s_.water), std::sqrt(2 * variance), duration_);
        }
        const std::vector<SceneWave> bins(result_.waves.begin() + static_cast<std::ptrdiff_t>(first),
                                          result_.waves.end());
        for (std::size_t i = 0; i < bins.size(); ++i) {
            double variance = 0;
            for (std::size_t j = i < 2 ? 0 : i - 2; j < std::min(i + 3, bins.size()); ++j)
                variance += bins[j].variance_m2;
            result_.waves[first + i].train.amplitude_m = std::sqrt(2 * variance);
        }
    }
    void add_gerstner(const GerstnerSettings& sea) {
        for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const double length = sea.wavelength_m.x * std::pow(sea.wavelength_m.y / sea.wavelength_m.x, share);
            add(2 * pi / length, sea.steepness * length / (2 * pi * std::sqrt(5.0 * sea.waves)), duration_);
        }
    }

    /// As a sine of equal mean square and mean square rate.
    void add_record(const TimeSeries& series) {
        double square = 0, rate_square = 0;
        for (std::size_t i = 1; i < series.time_s.size(); ++i) {
            const double dt = series.time_s[i] - series.time_s[i - 1], step = series.value[i] - series.value[i - 1];
            square += series.value[i] * series.value[i] * dt;
            rate_square += step * step / dt;
        }
        if (square <= 0 || rate_square <= 0) return;
        const double seconds = series.time_s.back() - series.time_s.front();
        add(airy_wave_number(std::sqrt(rate_square / square), s_.water), std::sqrt(2 * square / seconds), duration_);
    }
    void add_inflow(const Signal& signal) {
        result_.bores = true;
        if (signal.file) add_record(read_time_series(*signal.file, signal.scale));
        if (signal.period_s)
            add(airy_wave_number(2 * pi / *signal.period_s, s_.water), std::abs(signal.amplitude_m), duration_);
        if (signal.solitary_height_m) add_solitary(*signal.solitary_height_m, s_.water.depth_m);
    }

    /// Bins of the transform of sech^2, k / sinh(pi k / (2 kappa)). Their amplitudes are those of sines as steep as the
    /// wave is where it is steepest, so that all of them steepen as it does.
    void add_solitary(double height, double depth) {
        const double kappa = std::sqrt(0.75 * height / (depth * depth * depth));
        const double steepest = 0.77 * kappa * height;
        constexpr double first = 0.25, last = 4, ratio = 1.189207115;
        for (double q = first; q < last; q *= ratio) {
            const double k = q * kappa, transform = q / std::sinh(0.5 * pi * q);
            add(k, steepest / k, duration_);
            result_.waves.back().variance_m2 = height * height * transform * transform * q * std::log(ratio);
        }
        result_.bores = true;
    }
    void add_jump(double jump, double length) {
        result_.jump_m = std::max(result_.jump_m, std::abs(jump));
        add_feature(bore_over(length));
        add(pi / length, 0.5 * std::abs(jump), duration_);
    }
    void add_feature(const Feature& feature) {
        result_.bores = true;
        result_.features.push_back(feature);
    }
    double longer_side() const { return std::max(s_.domain.size_m.x, s_.domain.size_m.y); }
    void add_state(const StillWater&) { result_.bores = true; }
    void add_state(const PlaneDam& dam) { add_jump(dam.behind_level_m - dam.ahead_level_m, longer_side()); }
    void add_state(const CircularDam& dam) { add_jump(dam.inside_level_m - dam.outside_level_m, 2 * dam.radius_m); }
    void add_state(const SolitaryWave& wave) { add_solitary(wave.height_m, wave.depth_m); }
    void add_state(const ExactStart& exact) {
        std::visit([this](const auto& state) { add_exact(state); }, exact.state);
    }
    void add_exact(const ThackerPlanar& state) { add_feature(shore_over(state.a_m)); }
    void add_exact(const ThackerRadial& state) { add_feature(shore_over(state.a_m)); }
    void add_exact(const TravellingVortex&) { add_feature(vortex_over(1)); }
    void add_exact(const SteadyBump& state) {
        add_feature(shore_over(std::sqrt(state.height_m / state.curvature_per_m)));
    }
    void add_exact(const ObliqueJump&) { add_feature(bore_over(longer_side())); }
    void add_exact(const RiemannProblem& dam) {
        result_.jump_m = std::abs(dam.left_depth_m - dam.right_depth_m);
        const bool dry = std::min(dam.left_depth_m, dam.right_depth_m) <= 0;
        add_feature(dry ? dry_front_over(longer_side()) : bore_over(longer_side()));
    }

    const Scenario& s_;
    double duration_;
    double reach_m_ = std::numeric_limits<double>::infinity();
    double area_m2_ = 1;
    SceneSpectrum result_;
};

}  // namespace

double SceneSpectrum::variance_m2() const {
    double sum = 0;
    for (const SceneWave& wave : waves) sum += wave.variance_m2;
    return sum;
}

double SceneSpectrum::amplitude_m() const {
    double largest = waves.empty()
                         ? 0
                         : std::min(2.0, std::sqrt(2.0 * static_cast<double>(waves.size()))) * std::sqrt(variance_m2());
    for (const SceneWave& wave : waves) largest = std::max(largest, wave.train.amplitude_m);
    return largest;
}

double SceneSpectrum::rms_slope() const {
    double sum = 0;
    for (const SceneWave& wave : waves) sum += wave.train.wave_number * wave.train.wave_number * wave.variance_m2;
    return std::sqrt(sum);
}

SceneSpectrum scene_spectrum(const Scenario& scenario) { return Gatherer(scenario).gather(); }

}  // namespace waterlight
