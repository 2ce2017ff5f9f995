// The reader of .pvd series.
#include "sim/vti_reader.hpp"
#include "tests/fuzz/reader.hpp"

using namespace waterlight;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::InputFile file(".pvd");
    file.write(fuzz::text_of(data, size));
    fuzz::expect_result_or_error([&] { read_pvd(file.path()); });
    return 0;
}
