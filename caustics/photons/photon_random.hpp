// Random numbers by counting: each is a hash of seed, pass, photon and draw, so that it does not matter who draws when.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace waterlight {

/// The finaliser of SplitMix64 (Steele, Lea & Flood, "Fast Splittable Pseudorandom Number Generators", 2014).
inline std::uint64_t scrambled(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
}

class PhotonRandom {
  public:
    /// What the photons of a pass have in common.
    static std::uint64_t key(std::uint64_t seed, int pass) {
        return scrambled(scrambled(seed + golden) + static_cast<std::uint64_t>(pass) * golden);
    }
    PhotonRandom(std::uint64_t key, std::int64_t photon)
        : state_(scrambled(key + static_cast<std::uint64_t>(photon) * golden)) {}

    /// In [0, 1).
    double next() {
        state_ += golden;
        return static_cast<double>(scrambled(state_) >> 11) * 0x1p-53;
    }

    /// A place in the unit square, at random within cell `photon` of across x across.
    glm::dvec2 within_cell(std::int64_t photon, int across) {
        const double x = static_cast<double>(photon % across) + next(),
                     y = static_cast<double>(photon / across) + next();
        return glm::dvec2{x, y} / static_cast<double>(across);
    }

  private:
    static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15U;
    std::uint64_t state_;
};

}  // namespace waterlight
