#include "scenarios/schema_check.hpp"

#include "scenarios/schema_parts.hpp"

namespace waterlight::schema {

namespace {

void describe_order(Visitor& v, OrderStudy& s) {
    v.value({"key", "", "Key of the scenario that is varied, such as domain.cells.", {}, true}, &s.key);
    v.value({"values",
             "",
             "What it is set to, one after the other. Whole numbers count cells; others are steps.",
             {},
             true},
            &s.values);
    v.value({"at_least", "", "Order: the least that the slope of log(quantity) over log(step) may be.", positive, true},
            &s.at_least);
}

void describe_agreement(Visitor& v, Agreement& s) {
    v.value({"backend", "", "The other back-end; where the run is on it already, the one that is left."},
            choice(s.backend, {"cpu", "vulkan"}));
    v.value({"tolerance", "", "Absolute.", not_negative}, &s.tolerance);
    v.value({"relative_tolerance", "", "Relative to the other's value; not of fields.", not_negative},
            &s.relative_tolerance);
}

}  // namespace

void describe_check(Visitor& v, Check& s) {
    v.value({"quantity", "", "Number of the run to judge.", {}, true}, &s.quantity);
    v.value({"equals", "", "Expected value, within the larger of both tolerances.", {}, false, "none"}, &s.equals);
    v.value({"below", "", "Upper bound.", {}, false, "none"}, &s.below);
    v.value({"above", "", "Lower bound.", {}, false, "none"}, &s.above);
    v.value({"between", "", "Least and greatest value, both allowed.", {}, false, "none"}, &s.between);
    v.value({"tolerance", "", "Absolute tolerance of equals.", not_negative}, &s.tolerance);
    v.value({"relative_tolerance", "", "Relative tolerance of equals.", not_negative}, &s.relative_tolerance);
    v.value({"at_s", "s", "Time of the value; the run makes a frame there.", not_negative, false, "the end"}, &s.at_s);
    v.value(
        {"window_s", "s", "First and last time of a window; all frames in it count, of a probe's elevation all rows.",
         not_negative, false, "none"},
        &s.window_s);
    v.value({.name = "over", .meaning = "What becomes of the values in window_s.", .otherwise = "mean"},
            choice_or("mean", s.over, {"min", "max", "rms"}));
    v.value(
        {"reference",
         "",
         "What a field is compared with, statistics then being those of the difference: exact, a .vti or .pvd file, "
         "or another scenario (.toml, run by `check` only).",
         {},
         false,
         "none"},
        &s.reference);
    v.optional_section({"order", "", "Order of convergence, by `check` only: the quantity is an error."},
                       into(s.order, describe_order));
    v.optional_section({"agrees", "", "Agreement of two back-ends, by `check` only."},
                       into(s.agrees, describe_agreement));
}

void describe_check_run(Visitor& v, CheckRunSection& s) {
    v.value(
        {"set", "", "Values for keys, laid over the scenario by `check` before --set: shorter, smaller, fewer frames."},
        &s.set);
}

}  // namespace waterlight::schema
