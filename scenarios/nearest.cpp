#include "scenarios/nearest.hpp"

#include <algorithm>

namespace waterlight {

int edit_distance(std::string_view a, std::string_view b) {
    const std::size_t n = b.size();
    std::vector<int> before(n + 1), above(n + 1), row(n + 1);
    for (std::size_t j = 0; j <= n; ++j) above[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= n; ++j) {
            const int replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(above);
        above.swap(row);
    }
    return above[n];
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
    constexpr std::size_t longest = 64;  // no key is longer, and the cost is quadratic
    if (word.size() > longest) return {};
    int best = std::max(2, static_cast<int>(word.size()) / 3) + 1;
    std::string nearest;
    for (const std::string& candidate : known) {
        const int distance = edit_distance(word, candidate);
        if (distance < best && distance < static_cast<int>(candidate.size())) {
            best = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

}  // namespace waterlight
