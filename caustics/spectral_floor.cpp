#include "caustics/spectral_floor.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "caustics/light_ledger.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

void check_shares(const std::vector<Band>& bands) {
    double sum = 0;
    for (const Band& band : bands) {
        if (!(band.share > 0))
            throw InputError(fmt::format("floor map: share of the light at {} nm is {}; allowed: > 0",
                                         band.wavelength_nm, band.share));
        sum += band.share;
    }
    constexpr double rounding = 1e-9;
    if (bands.empty() || sum > 1 + rounding)
        throw InputError(
            fmt::format("floor map: {} wavelengths have shares that add up to {}; allowed: one or more "
                        "wavelengths, shares up to 1",
                        bands.size(), sum));
}

void add(const Field<float>& from, Field<float>& to) {
    const float* __restrict a = from.data();
    float* __restrict b = to.data();
    const auto count = static_cast<std::ptrdiff_t>(to.size());
#pragma omp parallel for simd schedule(static)
    for (std::ptrdiff_t i = 0; i < count; ++i) b[i] += a[i];
}

}  // namespace

SpectralFloor::SpectralFloor(const FloorSettings& settings, const std::vector<Band>& bands, const FloorMaker& make) {
    check_shares(bands);
    for (const Band& band : bands) {
        FloorSettings of_band = settings;
        of_band.sun.irradiance_w_m2 *= band.share;
        of_band.optics = band.optics;
        of_band.wavelength_nm = band.wavelength_nm;
        mappers_.push_back(make(of_band));
        maps_.push_back({band, {}});
    }
}

void SpectralFloor::compute(const Surface& surface, FloorMap& sum) {
    sum.ledger = {};
    sum.window = {1, 1};
    for (std::size_t k = 0; k < maps_.size(); ++k) {
        FloorMap& map = maps_[k].map;
        mappers_[k]->compute(surface, map);
        if (sum.irradiance.nx() != map.irradiance.nx() || sum.irradiance.ny() != map.irradiance.ny())
            sum.irradiance = Field<float>(map.irradiance.nx(), map.irradiance.ny());
        if (k == 0)
            std::copy_n(map.irradiance.data(), map.irradiance.size(), sum.irradiance.data());
        else
            add(map.irradiance, sum.irradiance);
        sum.ledger += map.ledger;
        sum.window.samples = std::max(sum.window.samples, map.window.samples);
        sum.window.channels = std::max(sum.window.channels, map.window.channels);
    }
}

}  // namespace waterlight
