// The known word closest to a misspelt one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace waterlight {

/// Least number of insertions, deletions, replacements and swaps of neighbours that turn a into b (optimal string
/// alignment; Damerau 1964).
int edit_distance(std::string_view a, std::string_view b);

/// The closest of `known`, or nothing where none is closer than a third of the word's length (at least two edits).
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace waterlight
