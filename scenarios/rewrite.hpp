// A scenario's text with other settings.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace waterlight {

/// A text that says what `text` says with the overrides ("key=value") laid over it. What is there already is changed in
/// its place and what is new is added, so that comments, order and layout stay; where TOML's layout does not let that
/// be (a section in the place of a value), all of it is written anew under a comment that says so. Throws InputError
/// where an override cannot be laid over it.
std::string rewritten(std::string_view text, const std::vector<std::string>& overrides);

}  // namespace waterlight
