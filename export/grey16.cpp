#include "export/grey16.hpp"

#include <fmt/format.h>

#include <cassert>

#include "export/atomic_file.hpp"
#include "export/png.hpp"

namespace waterlight {

void write_grey16(const std::filesystem::path& path, const Field<float>& field, ValueRange range,
                  const std::string& quantity, const std::string& unit) {
    assert(range.low < range.high);
    GreyImage image{field.nx(), field.ny(), std::vector<std::uint16_t>(field.size())};
    const double scale = 65535 / (range.high - range.low);
    for (int j = 0; j < field.ny(); ++j) {
        const float* from = field.row(field.ny() - 1 - j);
        std::uint16_t* to = image.pixels.data() + static_cast<std::ptrdiff_t>(j) * field.nx();
        for (int i = 0; i < field.nx(); ++i) {
            const double grey = (from[i] - range.low) * scale + 0.5;
            to[i] = static_cast<std::uint16_t>(grey > 0 ? (grey < 65535 ? grey : 65535) : 0);
        }
    }
    write_file(path, encode_png(image, {{"low", fmt::format("{}", range.low)},
                                        {"high", fmt::format("{}", range.high)},
                                        {"quantity", quantity},
                                        {"unit", unit}}));
}

}  // namespace waterlight
