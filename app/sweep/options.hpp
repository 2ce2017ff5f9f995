// What the command line says about a sweep.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/floor_stage.hpp"

namespace waterlight {

/// One share of the settings: every of-th, from the index-th on.
struct Part {
    int index = 1;  ///< in [1, of]
    int of = 1;
};

struct SweepOptions {
    std::filesystem::path scenario;
    std::filesystem::path out;            ///< empty: out/<stem of the scenario>-sweep
    std::vector<std::string> overrides;   ///< of every setting, "key=value"
    std::vector<std::string> variations;  ///< "key=v1,v2,..."
    std::vector<std::string> reference;   ///< laid over a setting, they make what it is judged against
    std::optional<double> tolerance;      ///< relative error that is good enough
    double truth_tolerance = 1e-3;        ///< that the truth's own estimate must reach
    double reference_tolerance = 1e-3;    ///< change of the reference waves at which their refinement ends
    int repeats = 1;                      ///< of each setting, for the median of its times
    int judged = 1;                       ///< times at which errors are taken, even spaced, the last at the end
    int jobs = 1;                         ///< settings at once, each in a process
    std::optional<Part> part;
    int max_runs = std::numeric_limits<int>::max();               ///< settings to run at most
    double max_time_s = std::numeric_limits<double>::infinity();  ///< after which no setting is begun
    int threads = 0;                                              ///< 0: all
    DeviceWish device;
    bool fresh = false;    ///< forget what an earlier sweep left
    bool collect = false;  ///< run nothing
    bool quiet = false;
};

}  // namespace waterlight
