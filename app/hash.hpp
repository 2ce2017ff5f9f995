// A short name for some text.
#pragma once

#include <cstdint>
#include <string_view>

namespace waterlight {

/// FNV-1a, 64 bits (Fowler, Noll, Vo), over all that is added.
class Hash {
  public:
    void add(std::string_view bytes) {
        for (const char c : bytes) value_ = (value_ ^ static_cast<unsigned char>(c)) * 1099511628211U;
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 14695981039346656037U;
};

}  // namespace waterlight
