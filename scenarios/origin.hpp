// Where a scenario came from, and how it is rejected: in one line that names the place, the key, what was found there
// and what is allowed.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/error.hpp"

namespace waterlight {

/// Throws InputError("PLACE: KEY: found FOUND; allowed: ALLOWED"), in one line whatever the parts contain; a nearest
/// known word is offered where there is one.
[[noreturn]] void reject(std::string_view place, std::string_view key, std::string_view found, std::string_view allowed,
                         std::string_view nearest = {});

/// The file, the overrides and the place of each key that they state.
struct Origin {
    std::filesystem::path file;          ///< as it was given
    std::string text;                    ///< of the file
    std::vector<std::string> overrides;  ///< "key=value", in order
    /// "FILE:LINE:COL" or "--set KEY=VALUE" by full key, as in waves.source[0].at_m.
    std::map<std::string, std::string, std::less<>> places;

    /// The place of a key or, where it was not stated, of the closest section that was.
    std::string place(std::string_view key) const;
    [[noreturn]] void reject(std::string_view key, std::string_view found, std::string_view allowed) const;
    /// What a part of the program says against a key or section, with its place: throws InputError("PLACE: KEY: WHAT").
    [[noreturn]] void reject(std::string_view key, const InputError& what) const;
    /// Does work for a key or section; what is refused there names it.
    template <class Work>
    auto in_place(std::string_view key, Work work) const {
        try {
            return work();
        } catch (const InputError& error) {
            reject(key, error);
        }
    }
};

}  // namespace waterlight
