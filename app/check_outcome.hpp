// What became of the scenarios under check.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace waterlight {

/// error: there is no value to judge, because a run failed; stopped: because check itself was asked to stop.
enum class Verdict { passed, failed, updated, skipped, error, stopped };

/// One bound of one check.
struct CheckOutcome {
    int check = 0;  ///< its index in the scenario
    std::string quantity;
    std::string name;      ///< the quantity with its time and its reference
    std::string expected;  ///< "= 850", "< 0.001"
    double value = std::numeric_limits<double>::quiet_NaN();
    double tolerance = 0;
    Verdict verdict = Verdict::passed;
    std::string place;   ///< FILE:LINE:COL
    std::string detail;  ///< what other runs gave, or why there is no value
    double wall_s = 0;   ///< of the runs made for it
};

struct ItemOutcome {
    std::vector<CheckOutcome> checks;
    double wall_s = 0;
    std::string log;  ///< what a run that failed said
};

}  // namespace waterlight
