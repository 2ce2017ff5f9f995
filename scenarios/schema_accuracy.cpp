#include "scenarios/schema_accuracy.hpp"

#include "scenarios/schema_parts.hpp"

namespace waterlight {

void describe_accuracy(Visitor& v, AccuracySection& s) {
    v.value(
        {"tolerance",
         "",
         "How wrong the waves may be at the end, as the fraction of a wavelength by which they would have to be "
         "moved to differ as much: RMS(difference) / (2 pi RMS(elevation)). Contrast of light, relative to its mean, "
         "below which waves need not be resolved. What is auto is chosen by it.",
         {.low = 0, .high = 0.3, .excludes_low = true}},
        &s.tolerance);
    v.value({"strict", "", "Whether to refuse a scenario whose tolerance no model meets, instead of a warning."},
            &s.strict);
    v.value({"estimate", "",
             "Whether to estimate the error of every map and, but for model prescribed, of every surface by a finer "
             "or a coarser solution alongside: arrays \"error\" in floor/*.vti and surface/*.vti. Takes many times as "
             "long."},
            &s.estimate);
}

}  // namespace waterlight
