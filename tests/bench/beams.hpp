// The benchmarks of beams.
#pragma once

namespace waterlight::bench {

void register_beams();

}  // namespace waterlight::bench
