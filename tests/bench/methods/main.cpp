// The ways to a caustic side by side, as the Markdown of docs/methods.md:
// waterlight_methods [--quick] [--pictures FOLDER] SCENARIOS [PART...], of the parts waves, pool, abilities, cups.
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>

#include "tests/bench/accuracy/scenes.hpp"
#include "tests/bench/methods/report.hpp"

namespace {

using namespace waterlight;

/// As the kernel names it; empty where it does not.
std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return {};
}

void print_frame() {
    fmt::print(R"(# The roads to a caustic

Written by `./waterlight methods > docs/methods.md`: every method for the floor map, on the processor, against the truth
(`caustics/truth`, double precision), and what it costs. What the two-pass map itself is worth at every footprint and on Vulkan
is in [accuracy.md](accuracy.md).

Measured with {} threads of {}, {}. Times are the fastest of some rounds in which what is compared ran in turn;
others may have used the machine: read multiples rather than milliseconds. Every number is printed by the program.

- **two-pass** (`method = "two-pass"`): one ray a sample lands, then pixels gather within a window (Yuksel & Keyser 2009);
  footprint `pixel` is the paper's, `adaptive` the parallelogram on which a sample lands.
- **quads** (`"quads"`): the landed quads of the surface, shared exactly among the pixels.
- **splat** (`"splat"`): caustics mapping (Shah et al. 2007): vertices land by iteration in the light's image and are splatted
  as Gaussians, all of one size (`fixed`) or of their footprint's (`jacobian`).
- **photons** (`"photons"`): photon mapping from the light's view (Kim 2019).
- **beams**: the volume field's slice at the floor (Liktor & Dachsbacher 2010).
)",
               omp_get_max_threads(), processor(), "GCC " __VERSION__);
}

int report(const methods::Options& options, const std::vector<std::string>& parts) {
    const auto wanted = [&](const char* part) {
        return parts.empty() || std::ranges::find(parts, part) != parts.end();
    };
    const auto start = std::chrono::steady_clock::now();
    if (parts.empty()) print_frame();
    if (wanted("abilities")) methods::report_abilities();
    if (wanted("waves")) methods::report_waves(options);
    if (wanted("pool")) methods::report_pool(options);
    if (wanted("cups")) methods::report_cups(options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print("\nAll of this took {:.0f} s.\n", seconds);
    return 0;
}

}  // namespace

int main(int argc, char** argv) try {
    methods::Options options;
    std::vector<std::string> rest;
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k];
        if (word == "--quick")
            options.common.quick = true;
        else if (word == "--pictures" && k + 1 < argc)
            options.pictures = argv[++k];
        else
            rest.push_back(word);
    }
    const auto known = [](const std::string& part) {
        return part == "waves" || part == "pool" || part == "abilities" || part == "cups";
    };
    if (rest.empty() || !std::all_of(rest.begin() + 1, rest.end(), known)) {
        std::fprintf(stderr,
                     "usage: waterlight_methods [--quick] [--pictures FOLDER] SCENARIOS [PART...], of the parts "
                     "waves, pool, abilities, cups\n");
        return 2;
    }
    options.scenarios = rest.front();
    options.common.yardstick = accuracy::make_yardstick();
    return report(options, {rest.begin() + 1, rest.end()});
} catch (const std::exception& error) {
    std::fprintf(stderr, "methods: %s\n", error.what());
    return 3;
}
