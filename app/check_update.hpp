// Puts the values that a run found in place of those that its scenario expects.
#pragma once

#include <string>
#include <vector>

#include "app/check_outcome.hpp"
#include "app/check_plan.hpp"

namespace waterlight {

/// One number in a scenario's text.
struct CheckUpdate {
    std::size_t outcome = 0;  ///< in the item's outcome
    std::size_t begin = 0;    ///< in the file's bytes
    std::size_t length = 0;
    std::string old_text, new_text;
    int line = 0;
};

/// For each check of the item that states a value in its file and failed on it, what to write instead: with digits
/// enough to be a hundredth of its tolerance right. In order of their places. Others cannot be updated.
std::vector<CheckUpdate> updates_of(const CheckItem& item, const ItemOutcome& outcome);

/// The changed lines, old and new, as of a diff.
std::string diff_text(const CheckItem& item, const std::vector<CheckUpdate>& updates);

/// Writes them; the rest of the file stays as it is, to the byte. Throws WorldError where it cannot be written or
/// changed meanwhile.
void apply_updates(const CheckItem& item, const std::vector<CheckUpdate>& updates);

}  // namespace waterlight
