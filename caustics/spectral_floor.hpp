// The floor map in colour, for any back-end: one map for each wavelength.
#pragma once

#include "caustics/sun_disc.hpp"
#include "caustics/water_colour.hpp"

namespace waterlight {

/// The map of one wavelength.
struct BandMap {
    Band band;
    FloorMap map;
};

/// The sum of the maps of all bands, each of its share of the sun's irradiance through the water as it feels it. Of one
/// band of share 1 it is that band's map bit for bit. The ledger is the sum of theirs, the window the largest.
class SpectralFloor final : public FloorMapper {
  public:
    /// `settings.optics` is not used. Throws InputError where there is no band, a share is not above 0 or their sum
    /// exceeds 1, or a setting is out of its range.
    SpectralFloor(const FloorSettings& settings, const std::vector<Band>& bands, const FloorMaker& make);

    std::string_view backend() const override { return mappers_.front()->backend(); }
    void compute(const Surface& surface, FloorMap& sum) override;
    /// Of the last call of compute().
    const std::vector<BandMap>& maps() const { return maps_; }

  private:
    std::vector<std::unique_ptr<FloorMapper>> mappers_;
    std::vector<BandMap> maps_;
};

}  // namespace waterlight
