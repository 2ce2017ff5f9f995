#include "app/floor_colours.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace waterlight {

namespace {

constexpr std::array<double, 3> colours_nm{650, 550, 450};

double distance(const BandMap& band, std::size_t colour) {
    return std::abs(band.band.wavelength_nm - colours_nm[colour]);
}

std::size_t nearest_colour(const BandMap& band) {
    std::size_t nearest = 0;
    for (std::size_t c = 1; c < 3; ++c)
        if (distance(band, c) < distance(band, nearest)) nearest = c;
    return nearest;
}

std::vector<const BandMap*> bands_of_colour(std::span<const BandMap> bands, std::size_t colour) {
    std::vector<const BandMap*> own;
    for (const BandMap& band : bands)
        if (nearest_colour(band) == colour) own.push_back(&band);
    if (own.empty())
        own.push_back(&*std::ranges::min_element(bands, {}, [=](const BandMap& b) { return distance(b, colour); }));
    return own;
}

}  // namespace

void fill_colours(std::span<const BandMap> bands, std::array<Field<float>, 3>& colours) {
    assert(!bands.empty());
    const Field<float>& first = bands.front().map.irradiance;
    for (std::size_t c = 0; c < 3; ++c) {
        Field<float>& sum = colours[c];
        if (sum.nx() != first.nx() || sum.ny() != first.ny()) sum = Field<float>(first.nx(), first.ny());
        std::ranges::fill(sum.values(), 0.0F);
        double share = 0;
        const std::vector<const BandMap*> own = bands_of_colour(bands, c);
        for (const BandMap* band : own) share += band->band.share;
        const auto scale = static_cast<float>(1 / share);
        for (const BandMap* band : own)
            for (std::size_t n = 0; n < sum.size(); ++n) sum.data()[n] += scale * band->map.irradiance.data()[n];
    }
}

}  // namespace waterlight
