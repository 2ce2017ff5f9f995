// The reader of time series.
#include "sim/time_series.hpp"
#include "tests/fuzz/reader.hpp"

using namespace waterlight;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::InputFile file(".txt");
    file.write(fuzz::text_of(data, size));
    fuzz::expect_result_or_error([&] {
        const TimeSeries series = read_time_series(file.path());
        for (std::size_t i = 1; i < series.time_s.size(); ++i)
            if (!(series.time_s[i] > series.time_s[i - 1])) std::abort();
    });
    return 0;
}
