#include "app/sweep/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/exact_surface.hpp"
#include "app/readings.hpp"
#include "app/sweep/lock.hpp"
#include "app/sweep/raster.hpp"
#include "app/sweep/store.hpp"
#include "export/report.hpp"
#include "scenarios/build.hpp"
#include "scenarios/reader.hpp"
#include "scenarios/resolve.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int most_halvings = 3;
constexpr double most_cells = 4096.0 * 4096.0;

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

bool states_cells(const std::vector<std::string>& overrides) {
    return std::any_of(overrides.begin(), overrides.end(),
                       [](const std::string& o) { return o.starts_with("domain.cells"); });
}

std::string cells_override(glm::ivec2 n) { return fmt::format("domain.cells=[{}, {}]", n.x, n.y); }

/// The waves of one scenario at each time.
struct Waves {
    Scenario scenario;
    BuiltModel built;
    std::vector<Surface> surfaces;
    const SurfaceFormula* formula() const { return built.prescribed ? built.prescribed->formula() : nullptr; }
};

Surface copy_of(const Surface& s) {
    Surface copy;
    copy.grid = s.grid;
    copy.boundary = s.boundary;
    copy.time_s = s.time_s;
    copy.tilt = s.tilt;
    copy.elevation = s.elevation.clone();
    copy.slope_x = s.slope_x.clone();
    copy.slope_y = s.slope_y.clone();
    if (s.depth) copy.depth = s.depth->clone();
    return copy;
}

Waves waves_of(Scenario scenario, const std::vector<double>& times_s) {
    Waves waves{std::move(scenario), {}, {}};
    waves.built = build_model(waves.scenario);
    double now = 0;
    for (const double time : times_s) {
        waves.built.model->advance(time - now);
        now = time;
        waves.surfaces.push_back(copy_of(waves.built.model->surface()));
        require_finite(waves.surfaces.back(), waves.built.model->steps());
    }
    return waves;
}

/// Relative RMS difference of the slopes at the points, or of elevations where that is more. Dry ground has no slope to
/// compare.
double difference(const Waves& coarse, const Waves& fine, glm::ivec2 points) {
    double elevation = 0, slope = 0, slopes = 0;
    RelativeError of_elevation;
    for (std::size_t k = 0; k < fine.surfaces.size(); ++k) {
        const Surface &a = coarse.surfaces[k], &b = fine.surfaces[k];
        of_elevation.add(elevations(a, points), elevations(b, points));
        if (b.depth) continue;
        const TruthSurface ta = interpolate(a), tb = interpolate(b);
        const glm::dvec2 step{b.grid.width_m() / points.x, b.grid.height_m() / points.y};
#pragma omp parallel for schedule(static) reduction(+ : slope, slopes)
        for (int j = 0; j < points.y; ++j) {
            for (int i = 0; i < points.x; ++i) {
                const glm::dvec2 at = glm::dvec2{b.grid.x0_m, b.grid.y0_m} + step * glm::dvec2(i + 0.5, j + 0.5);
                const glm::dvec2 fine_slope = tb.at(at).slope, d = ta.at(at).slope - fine_slope;
                slope += d.x * d.x + d.y * d.y;
                slopes += fine_slope.x * fine_slope.x + fine_slope.y * fine_slope.y;
            }
        }
    }
    if (const double e = of_elevation.value(); std::isfinite(e)) elevation = e;
    return std::max(elevation, slopes > 0 ? std::sqrt(slope / slopes) : 0.0);
}

/// Twice as many cells, but for an axis of one; none where that is too many for the program or this machine.
std::optional<Scenario> halved(const SweepOptions& options, std::vector<std::string> overrides, glm::ivec2 cells) {
    const glm::ivec2 twice{cells.x == 1 ? 1 : 2 * cells.x, cells.y == 1 ? 1 : 2 * cells.y};
    if (static_cast<double>(twice.x) * twice.y > most_cells || twice == cells) return std::nullopt;
    overrides.push_back(cells_override(twice));
    try {
        return read_scenario(options.scenario, overrides);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

struct Refined {
    Waves waves;
    std::string description;
};

Refined refine(const SweepOptions& options, const Comparison& comparison, const Setting& setting) {
    const std::vector<std::string> base =
        joined(joined(joined(setting.scene, comparison.model), comparison.cells), options.reference);
    Refined r{waves_of(read_scenario(options.scenario, base), comparison.times_s), {}};
    const auto name = [&] { return std::string(r.waves.built.model->name()); };
    const auto cells = [&] { return r.waves.scenario.domain.cells; };
    if (r.waves.formula()) {
        r.description = "the formula of the waves";
        return r;
    }
    r.description = fmt::format("{} with {} x {} cells", name(), cells().x, cells().y);
    if (states_cells(options.reference)) return r;
    for (int n = 0; n < most_halvings; ++n) {
        std::optional<Scenario> finer = halved(options, base, cells());
        if (!finer) break;
        Waves waves = waves_of(std::move(*finer), comparison.times_s);
        const double change = difference(r.waves, waves, comparison.points);
        r.waves = std::move(waves);
        r.description = fmt::format("{} with {} x {} cells ({:.2g} % from half as many along each side)", name(),
                                    cells().x, cells().y, 100 * change);
        if (change <= options.reference_tolerance) break;
    }
    return r;
}

Reference compute(const SweepOptions& options, const Comparison& comparison, const Setting& setting) {
    const Refined refined = refine(options, comparison, setting);
    Reference reference;
    reference.description = refined.description;
    double truth_error = 0;
    for (const Surface& surface : refined.waves.surfaces) {
        const TruthSurface exact = exact_surface(surface, refined.waves.formula());
        if (!refined.waves.formula()) {
            reference.elevation_m.push_back(elevations(surface, comparison.points));
        } else {
            const glm::ivec2 n = comparison.points;
            const glm::dvec2 step{surface.grid.width_m() / n.x, surface.grid.height_m() / n.y};
            Field<float> field(n.x, n.y);
            for (int j = 0; j < n.y; ++j)
                for (int i = 0; i < n.x; ++i)
                    field(i, j) = static_cast<float>(exact.at(step * glm::dvec2(i + 0.5, j + 0.5)).elevation_m);
            reference.elevation_m.push_back(std::move(field));
        }
        if (comparison.raster.x == 0) continue;
        RasterTruth truth = truth_on(refined.waves.scenario, comparison.raster, exact, options.truth_tolerance);
        truth_error = std::max(truth_error, truth.error_estimate);
        reference.irradiance.push_back(std::move(truth.irradiance));
    }
    if (comparison.raster.x > 0)
        reference.description += fmt::format(", light converged to {:.2g} %", 100 * truth_error);
    return reference;
}

fs::path file_of(const fs::path& folder, const char* what, std::size_t k) {
    return folder / fmt::format("{}_{:03}.vti", what, k);
}

Reference read(const fs::path& folder, const Comparison& comparison) {
    Reference reference;
    std::ifstream about(folder / "about.json");
    reference.description = Json::parse(about).at("description").get<std::string>();
    for (std::size_t k = 0; k < comparison.times_s.size(); ++k) {
        reference.elevation_m.push_back(read_field(file_of(folder, "elevation", k), "elevation"));
        if (comparison.raster.x > 0)
            reference.irradiance.push_back(read_field(file_of(folder, "irradiance", k), "irradiance"));
    }
    return reference;
}

void write(const fs::path& folder, const Reference& reference) {
    for (std::size_t k = 0; k < reference.elevation_m.size(); ++k)
        write_field(file_of(folder, "elevation", k), "elevation", reference.elevation_m[k]);
    for (std::size_t k = 0; k < reference.irradiance.size(); ++k)
        write_field(file_of(folder, "irradiance", k), "irradiance", reference.irradiance[k]);
    write_json(folder / "about.json", Json{{"description", reference.description}});
}

}  // namespace

Comparison comparison_of(const SweepOptions& options, const std::vector<Variation>& variations,
                         const std::vector<Setting>& settings) {
    Comparison comparison;
    comparison.raster = common_raster(settings);
    comparison.points = common_points(settings);
    const double duration = settings.front().scenario.waves.duration_s;
    const int times = duration > 0 ? options.judged : 1;
    for (int k = 1; k <= times; ++k) comparison.times_s.push_back(duration * k / times);
    glm::ivec2 cells{1, 1};
    for (const Setting& setting : settings) cells = glm::max(cells, setting.scenario.domain.cells);
    comparison.cells.push_back(cells_override(cells));
    for (const Variation& variation : variations) {
        const bool has_airy = std::any_of(settings.begin(), settings.end(), [](const Setting& setting) {
            return resolve_model(setting.scenario).model == ModelChoice::airy;
        });
        if (variation.key == "waves.model" && has_airy) comparison.model.push_back("waves.model=airy");
    }
    return comparison;
}

Reference reference_of(const SweepOptions& options, const Comparison& comparison, const Setting& setting,
                       const fs::path& folder) {
    const fs::path about = folder / "about.json";
    if (fs::exists(about)) return read(folder, comparison);
    const FileLock lock(folder.string() + ".lock");
    if (fs::exists(about)) return read(folder, comparison);
    Reference reference = compute(options, comparison, setting);
    write(folder, reference);
    return reference;
}

RasterTruth truth_on(const Scenario& scenario, glm::ivec2 raster, const TruthSurface& surface, double tolerance) {
    TruthSettings settings;
    settings.floor = floor_settings(scenario);
    FloorPlan& plan = settings.floor.plan;
    plan.pitch_m *= glm::dvec2(plan.width, plan.height) / glm::dvec2(raster);
    plan.width = raster.x;
    plan.height = raster.y;
    // The mesh resolves the cells of the surface to begin with, however coarse the raster.
    const double cells = std::max(plan.pitch_m.x, plan.pitch_m.y) / std::min(surface.grid.dx_m, surface.grid.dy_m);
    settings.subsamples = std::clamp(static_cast<int>(std::ceil(cells)), 4, 64);
    settings.most_subsamples = 8 * settings.subsamples;
    settings.tolerance = tolerance;
    const TruthMap truth = truth_map(settings, surface);
    RasterTruth result{Field<float>(raster.x, raster.y), truth.error_estimate};
    std::copy_n(truth.irradiance.data(), truth.irradiance.size(), result.irradiance.data());
    return result;
}

}  // namespace waterlight
