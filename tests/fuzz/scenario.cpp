// The scenario reader: keys, values, combinations, memory; no data files.
#include "scenarios/memory.hpp"
#include "scenarios/reader.hpp"
#include "tests/fuzz/reader.hpp"

using namespace waterlight;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::expect_result_or_error([&] {
        const Scenario scenario = parse_scenario(fuzz::text_of(data, size), "input.toml");
        check_combinations(scenario);
        check_memory(scenario, machine_memory());
    });
    return 0;
}
