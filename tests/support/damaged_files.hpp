// Files damaged at random, and what reading them says.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <functional>
#include <random>
#include <string>

#include "sim/error.hpp"
#include "tests/support/damage.hpp"
#include "tests/unit/export_support.hpp"

namespace waterlight::testing {

/// What reading throws as an InputError, or an empty text. It must name the file, in one line.
inline std::string complaint_of(const std::filesystem::path& path, const std::function<void()>& read) {
    try {
        read();
    } catch (const InputError& error) {
        const std::string text = error.what();
        EXPECT_EQ(text.find(path.string()), 0U) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        return text;
    }
    return "";
}

inline long peak_memory_kib() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

/// Reads `count` damaged copies of `whole` at `path`: each must give a result or an InputError, and all of them must be
/// content with little memory. Some must be rejected.
inline void expect_survives_damage(const std::filesystem::path& path, const std::string& whole, int count,
                                   const std::function<void()>& read) {
    std::mt19937 random(17);
    const long before_kib = peak_memory_kib();
    int rejected = 0;
    for (int i = 0; i < count; ++i) {
        const std::string bytes = damaged(whole, std::span(&whole, 1), random);
        put_bytes(path, bytes);
        EXPECT_NO_THROW(rejected += complaint_of(path, read).empty() ? 0 : 1) << bytes;
    }
    EXPECT_GT(rejected, count / 5);
    // What a sanitizer keeps of freed memory included.
    EXPECT_LT(peak_memory_kib() - before_kib, 512 * 1024);
}

}  // namespace waterlight::testing
