#include "app/field_check.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <map>
#include <vector>

#include "scenarios/exact.hpp"
#include "scenarios/quantities.hpp"
#include "sim/error.hpp"
#include "sim/field_norms.hpp"
#include "sim/vti_reader.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;

struct Values {
    int nx = 0, ny = 0;
    std::vector<double> values;
    int layers = 1;  ///< of a field in the water, among the rows
};

template <class T>
Values values_of(const Field<T>& field, int layers = 1) {
    return {field.nx(), field.ny(), {field.values().begin(), field.values().end()}, layers};
}

/// Depth (m) of the water; over a flat floor where the model has none of its own.
Values depth_of(const Scenario& scenario, const Surface& surface) {
    if (surface.depth) return values_of(*surface.depth);
    Values depth = values_of(surface.elevation);
    for (double& d : depth.values) d += scenario.domain.depth_m;
    return depth;
}

/// The field that a name of scenarios/quantities.hpp means. The frame has it: the reader has seen to that.
Values field_of(const Scenario& scenario, std::string_view name, const FrameFields& frame) {
    const Surface& s = frame.surface;
    if (name == "surface.elevation") return values_of(s.elevation);
    if (name == "surface.slope_x") return values_of(s.slope_x);
    if (name == "surface.slope_y") return values_of(s.slope_y);
    if (name == "surface.depth") return depth_of(scenario, s);
    if (name == "surface.velocity_x") return values_of(*s.velocity_x);
    if (name == "surface.velocity_y") return values_of(*s.velocity_y);
    if (name == "floor.irradiance") return values_of(frame.floor->irradiance);
    if (name == "volume.plane_irradiance") return values_of(frame.volume->plane_irradiance, frame.volume->cells.z);
    if (name == "volume.scalar_irradiance") return values_of(frame.volume->scalar_irradiance, frame.volume->cells.z);
    assert(name == "camera.radiance");
    return values_of(frame.picture->radiance);
}

fs::path file_at(const fs::path& reference, double time_s) {
    if (reference.extension() != ".pvd") return reference;
    constexpr double slack = 1e-6;
    const std::vector<TimedFile> files = read_pvd(reference);
    for (const TimedFile& file : files)
        if (std::abs(file.time_s - time_s) <= slack * std::max(1.0, time_s)) return file.path;
    throw InputError(fmt::format("{} has no frame at {} s; it has {} from {} to {} s", reference.string(), time_s,
                                 files.size(), files.front().time_s, files.back().time_s));
}

/// Means of blocks, so that the result has as many values as `own`; fields in the water are compared cell by cell.
Values coarsened(const Values& fine, const Values& own, const fs::path& file) {
    const int nx = own.nx, ny = own.ny;
    const bool in_water = own.layers > 1 || fine.layers > 1;
    if (in_water && (fine.layers != own.layers || fine.nx != nx || fine.ny != ny))
        throw InputError(fmt::format("{} has {} x {} x {} values; allowed: the run's {} x {} x {}", file.string(),
                                     fine.nx, fine.ny / fine.layers, fine.layers, nx, ny / own.layers, own.layers));
    const int bx = fine.nx / nx, by = fine.ny / ny;
    if (bx < 1 || by < 1 || bx * nx != fine.nx || by * ny != fine.ny)
        throw InputError(fmt::format("{} has {} x {} values; allowed: a whole multiple of the run's {} x {}",
                                     file.string(), fine.nx, fine.ny, nx, ny));
    Values means{nx, ny, std::vector<double>(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny))};
    for (std::size_t n = 0; n < fine.values.size(); ++n) {
        const int i = static_cast<int>(n % static_cast<std::size_t>(fine.nx)) / bx;
        const int j = static_cast<int>(n / static_cast<std::size_t>(fine.nx)) / by;
        means.values[static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i)] +=
            fine.values[n] / (bx * by);
    }
    return means;
}

Values reference_of(const Scenario& scenario, const Check& check, const Values& own, double time_s) {
    const std::string_view name = field_statistic(check.quantity)->field;
    if (*check.reference == "exact") return values_of(exact_field(scenario, name, time_s));
    const fs::path file = file_at(*check.reference, time_s);
    const std::string array(name.substr(name.find('.') + 1));
    const VtiScalars<double> read = read_vti_volume(file, array);
    return coarsened(values_of(read.values, read.layers), own, file);
}

double pick(const FieldNorms& n, std::string_view statistic) {
    const std::map<std::string_view, double> by_name{{"min", n.min}, {"max", n.max}, {"mean", n.mean}, {"rms", n.l2},
                                                     {"l1", n.l1},   {"l2", n.l2},   {"linf", n.linf}};
    return by_name.at(statistic);
}

}  // namespace

double field_value(const Scenario& scenario, const Check& check, double time_s, const FrameFields& frame) {
    assert(!check.is_against_scenario());
    FieldStatistic of = *field_statistic(check.quantity);
    Values own = field_of(scenario, of.field, frame);
    const bool is_relative = of.is_relative();
    if (is_relative) of.statistic.remove_prefix(std::string_view("relative_").size());
    double size = 1;
    if (check.reference) {
        const Values reference = reference_of(scenario, check, own, time_s);
        if (is_relative) size = pick(norms_of(std::span<const double>(reference.values)), of.statistic);
        for (std::size_t n = 0; n < own.values.size(); ++n) own.values[n] -= reference.values[n];
    }
    return pick(norms_of(std::span<const double>(own.values)), of.statistic) / size;
}

}  // namespace waterlight
