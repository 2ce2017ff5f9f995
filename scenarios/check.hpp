// An expectation about one number of a run.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

namespace waterlight {

/// What becomes of the values that a window of time holds, in place of their mean.
enum class Over { min, max, rms };

/// A value that a key takes in a study of convergence.
struct Resolution {
    std::string text;       ///< as TOML
    double size = 1;        ///< of what it counts or measures: its first number that the study varies
    bool is_count = false;  ///< of cells or the like, which grow as the step shrinks
};

/// The scenario is run with each value of a key; the quantity is an error that falls as a power of the step.
struct OrderStudy {
    std::string key;
    std::vector<Resolution> values;
    double at_least = 0;
};

enum class OtherBackend { cpu, vulkan };

/// The scenario is run on two back-ends. Of norms of a field it is the norm of the difference that counts.
struct Agreement {
    OtherBackend backend = OtherBackend::vulkan;
    double tolerance = 0;
    double relative_tolerance = 0;  ///< the larger of both counts
};

struct Check {
    std::string quantity;
    std::optional<double> equals;
    std::optional<double> below;
    std::optional<double> above;
    std::optional<glm::dvec2> between;  ///< both ends included
    double tolerance = 0;               ///< of equals, absolute
    double relative_tolerance = 0;      ///< of equals, relative; the larger of both counts

    std::optional<double> at_s;          ///< none: at the end
    std::optional<glm::dvec2> window_s;  ///< its frames instead of a time
    std::optional<Over> over;            ///< of window_s; none: their mean
    /// What a field is compared with: "exact", a .vti or .pvd, or a scenario that is run beside this one.
    std::optional<std::string> reference;
    std::optional<OrderStudy> order;
    std::optional<Agreement> agrees;

    bool states_bound() const { return equals || below || above || between; }
    bool is_against_scenario() const { return reference && reference->ends_with(".toml"); }
    /// Whether judging it takes more than the run itself: only the command `check` does it.
    bool needs_more_runs() const { return order || agrees || is_against_scenario(); }
};

/// What the command `check` does differently from `run`.
struct CheckRunSection {
    std::vector<std::string> set;  ///< "key=value", laid over the scenario
};

}  // namespace waterlight
