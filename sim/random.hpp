// Random numbers that are the same on every machine: a counter goes in, a number comes out, there is no state.
#pragma once

#include <cstdint>

namespace waterlight {

/// The finalizer of SplitMix64 (Steele, Lea & Flood 2014, "Fast splittable pseudorandom number generators").
constexpr std::uint64_t mix_bits(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

/// One stream of numbers among 2^64 of the same seed.
class RandomStream {
  public:
    constexpr RandomStream(std::uint64_t seed, std::uint64_t stream)
        : key_(mix_bits(mix_bits(seed + golden) + (stream + 1) * golden)) {}

    /// Uniform in [0, 1), 53 bits.
    constexpr double uniform() { return static_cast<double>(mix_bits(key_ + ++count_ * golden) >> 11) * 0x1p-53; }
    /// Uniform in [from, to).
    constexpr double uniform(double from, double to) { return from + (to - from) * uniform(); }

  private:
    static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15ULL;
    std::uint64_t key_;
    std::uint64_t count_ = 0;
};

}  // namespace waterlight
