// Bytes damaged at random, as readers must survive them.
#pragma once

#include <random>
#include <span>
#include <string>
#include <string_view>

namespace waterlight::testing {

/// `bytes` with up to four of them changed, or a part cut out, doubled or brought in from one of `others`, or the end
/// cut off. `others` holds at least one; nothing stays nothing.
inline std::string damaged(std::string bytes, std::span<const std::string> others, std::mt19937& random) {
    using namespace std::string_view_literals;
    constexpr std::string_view telling = "0123456789.,-+eE \n\r\tnaif\"<>=#[]{}\xff\0"sv;
    if (bytes.empty()) return bytes;
    const std::string& other = others[random() % others.size()];
    const std::size_t at = random() % bytes.size(), length = random() % 40;
    switch (random() % 5) {
        case 0:
            bytes.resize(at);
            break;
        case 1:
            bytes.erase(at, length);
            break;
        case 2:
            bytes.insert(at, bytes.substr(at, length));
            break;
        case 3:
            bytes.insert(at, other.substr(random() % (other.size() + 1), length));
            break;
        default:
            for (auto changes = 1 + random() % 4; changes > 0; --changes)
                bytes[random() % bytes.size()] = telling[random() % telling.size()];
    }
    return bytes;
}

}  // namespace waterlight::testing
