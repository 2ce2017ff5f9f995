// The reader of a buoy's five files: the input is cut into them at lines that hold nothing but "====".
#include <array>

#include "sim/ndbc_reader.hpp"
#include "tests/fuzz/reader.hpp"

using namespace waterlight;

namespace {

constexpr std::string_view cut = "====\n";

std::string_view next_part(std::string_view& text) {
    const std::size_t end = std::min(text.find(cut), text.size());
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(std::min(end + cut.size(), text.size()));
    return part;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::array<fuzz::InputFile, 5> files{fuzz::InputFile(".data_spec"), fuzz::InputFile(".swdir"),
                                                      fuzz::InputFile(".swdir2"), fuzz::InputFile(".swr1"),
                                                      fuzz::InputFile(".swr2")};
    std::string_view text = fuzz::text_of(data, size);
    for (const fuzz::InputFile& file : files) file.write(next_part(text));
    std::filesystem::path stem = files[0].path();
    stem.replace_extension();
    fuzz::expect_result_or_error([&] { read_ndbc(stem, ""); });
    return 0;
}
