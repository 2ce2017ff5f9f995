#include "scenarios/schema_accuracy.hpp"

namespace waterlight {

void describe_accuracy(Visitor& v, AccuracySection& s) {
    v.value({"estimate", "",
             "Whether to estimate the error of every map and, but for model prescribed, of every surface by a finer "
             "or a coarser solution alongside: arrays \"error\" in floor/*.vti and surface/*.vti. Takes many times as "
             "long."},
            &s.estimate);
}

}  // namespace waterlight
