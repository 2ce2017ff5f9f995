// The numbers of a report that a [[check]] may judge.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace waterlight {

struct Scenario;

struct Quantity {
    std::string_view name;
    std::string_view unit;
    std::string_view meaning;
};

/// Those of the run as a whole; of the last frame unless their meaning says otherwise.
std::span<const Quantity> run_quantities();
/// Those of each probe; their full name is probe.NAME.quantity.
std::span<const Quantity> probe_quantities();
/// Fields, as in surface.elevation; the full name of a statistic of one is FIELD.STATISTIC.
std::span<const Quantity> field_quantities();
std::span<const Quantity> field_statistics();

/// of_frame: has a value in each frame; of_run: tells of the run so far; of_series: of the rows of a probe; of_field: a
/// statistic of a field in a frame.
enum class QuantityKind { of_frame, of_run, of_series, of_field };
QuantityKind kind_of(std::string_view quantity);

struct FieldStatistic {
    std::string_view field;      ///< "surface.elevation"
    std::string_view statistic;  ///< "l2"
    bool is_relative() const { return statistic.starts_with("relative_"); }
    bool is_norm() const { return is_relative() || statistic.starts_with("l") || statistic == "rms"; }
};
/// What the name says; none where it names no statistic of a field. Refers to the name.
std::optional<FieldStatistic> field_statistic(std::string_view quantity);

/// Whether a run writes the field to a file, as one array of a .vti.
bool is_written(std::string_view field);
/// Whether the rows of probes.csv have it, also between frames.
bool is_row_quantity(std::string_view quantity);
/// Whether only the model shallow-water has it.
bool is_of_shallow_water(std::string_view quantity);
/// Whether it is of the light on the floor or at a probe, if not of the run as a whole.
bool is_of_light(std::string_view quantity);
/// The full names that this scenario's checks may use.
std::vector<std::string> quantity_names(const Scenario& scenario);

}  // namespace waterlight
