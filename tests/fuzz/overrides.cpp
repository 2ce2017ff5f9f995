// --set: each line of the input is one, laid over a scenario that is right.
#include "scenarios/reader.hpp"
#include "tests/fuzz/reader.hpp"

using namespace waterlight;

namespace {

constexpr std::string_view scenario_text = R"(
[domain]
size_m = [8.0, 6.0]
cells = [64, 48]
depth_m = 2.0
[waves]
model = "airy"
boundary = { x = "wall", y = "wall" }
duration_s = 1.0
[[waves.source]]
type = "drop"
at_m = [4.0, 3.0]
radius_m = 0.4
height_m = 0.02
[caustics.floor]
pixels = [64, 48]
[[probe]]
name = "centre"
at_m = [4.0, 3.0]
[[check]]
quantity = "floor.mean_irradiance"
equals = 850.0
tolerance = 1.0
)";

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::expect_result_or_error(
        [&] { check_combinations(parse_scenario(scenario_text, "input.toml", lines_of(fuzz::text_of(data, size)))); });
    return 0;
}
