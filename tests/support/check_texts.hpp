// Scenarios whose checks are run, and what `check` says of them.
#pragma once

#include <string>

namespace waterlight::test {

/// A standing wave of 0.01 m and light on its floor, a fraction of a second to run.
inline const std::string standing =
    "# A comment of the author's\n"
    "[domain]\nsize_m = [2.0, 1.0]\ncells = [32, 16]\ndepth_m = 1.0\n"
    "[waves]\nmodel = \"linear\"\nduration_s = 1.0\n[[waves.standing]]\namplitude_m = 0.01\nhalf_waves_x = 2\n"
    "[caustics.floor]\npixels = [64, 32]\n[output]\nevery_s = 0.05\nprobe_every_s = 0.01\n"
    "[[probe]]\nname = \"g\"\nat_m = [0.03125, 0.5]\n";

inline std::string check(const std::string& quantity, const std::string& expects) {
    return "[[check]]\nquantity = \"" + quantity + "\"\n" + expects + "\n";
}

inline int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

/// Where a check stands that follows the scenario above.
inline const std::string first_line_of_check =
    std::string(":").append(std::to_string(count(standing, "\n") + 1)).append(":1");

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace waterlight::test
