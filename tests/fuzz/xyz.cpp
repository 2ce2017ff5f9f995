// The reader of lines x y z as ground.
#include "sim/bathymetry_file.hpp"
#include "tests/fuzz/reader.hpp"

using namespace waterlight;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::InputFile file(".xyz");
    file.write(fuzz::text_of(data, size));
    const Grid grid{.nx = 5, .ny = 4, .dx_m = 0.6, .dy_m = 0.5, .x0_m = 0.25, .y0_m = 0.25};
    for (const OutsideFile outside : {OutsideFile::refuse, OutsideFile::extend})
        fuzz::expect_result_or_error([&] { read_ground({.path = file.path(), .outside = outside}, grid); });
    return 0;
}
