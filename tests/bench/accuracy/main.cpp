// How wrong each method is and what it costs, as the Markdown of docs/accuracy.md: waterlight_accuracy [--quick]
#include <fmt/format.h>
#include <omp.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>

#include "gpu/error.hpp"
#include "tests/bench/accuracy/report.hpp"
#include "tests/bench/accuracy/scenes.hpp"

namespace {

using namespace waterlight;

std::shared_ptr<gpu::Context> open_device() {
    try {
        return std::make_shared<gpu::Context>();
    } catch (const gpu::Error& error) {
        std::fprintf(stderr, "no Vulkan: %s\n", error.what());
        return nullptr;
    }
}

/// As the kernel names it; empty where it does not.
std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return {};
}

void print_frame(const accuracy::Options& options) {
    fmt::print(R"(# How wrong, how fast

Written by `./waterlight accuracy > docs/accuracy.md`: every method against the truth, and what it costs. Lengths are in
metres, errors relative. The truth is `caustics/truth`, double precision, whose own estimate stands beside what it judges.

Measured with {} threads of {}, {}.
Vulkan: {}.
Times are the fastest of some rounds in which what is compared ran in turn. Others may have used the machine: read multiples
rather than milliseconds. Every number, the last table's too, is printed by the program.
)",
               omp_get_max_threads(), processor(), "GCC " __VERSION__,
               options.context ? options.context->device().name : "no device here, so its columns are missing");
}

}  // namespace

int main(int argc, char** argv) {
    accuracy::Options options;
    for (int k = 1; k < argc; ++k) {
        if (std::string(argv[k]) == "--quick") {
            options.quick = true;
            continue;
        }
        std::fprintf(stderr, "usage: waterlight_accuracy [--quick], not \"%s\"\n", argv[k]);
        return 2;
    }
    options.context = open_device();
    options.yardstick = accuracy::make_yardstick();
    const auto start = std::chrono::steady_clock::now();
    print_frame(options);
    accuracy::Choices choices;
    accuracy::report_floor(options, choices);
    accuracy::report_light(options);
    accuracy::report_beams(options, choices);
    accuracy::report_waves(options, choices);
    const accuracy::Timed yardstick = accuracy::time_together(options, {options.yardstick}, .2).front();
    fmt::print(R"(
## Which to choose

The cheapest setting measured above that meets a tolerance, and its cost. A setting is its method, pixels a period and
back-end. Of floor maps and slices the error is that of averages over a sixteenth of a period, whatever the pixel, so that
all of a row mean the same; the truth was a candidate too. Costs are counted in pixels of a map with `pixel` of the sine at
1 m, 256 x 256 pixels, which was timed beside everything: how many of them take as long as a square of one wave. A thousand
take {:.2g} microseconds here. Of waves, costs are milliseconds for a second of water.
)",
               1e6 * yardstick.ms / accuracy::yardstick_pixels);
    choices.print();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print("\nAll of this took {:.0f} s.\n", seconds);
    return 0;
}
