#include "caustics/quads.hpp"

#include <algorithm>
#include <cmath>

#include "caustics/floor_row_ledger.hpp"
#include "caustics/floor_samples.hpp"
#include "caustics/quads_land.hpp"
#include "caustics/quads_share.hpp"

namespace waterlight {

namespace {

/// The frame whose quads hold all light that can reach the map.
FloorFrame frame_of(FloorSettings settings, const Surface& surface) {
    settings.footprint = Footprint::pixel;
    settings.window.reset();
    // What holds the light of every cell, and a pixel to each side for what is between them.
    FloorWindow window = prepare(settings, surface).window;
    window.samples += 2;
    window.channels += 2;
    settings.window = window;
    return prepare(settings, surface);
}

class FloorQuads final : public FloorMapper {
  public:
    explicit FloorQuads(const FloorSettings& settings) : settings_(settings), shadows_(settings) {}

    std::string_view backend() const override { return "cpu"; }

    void compute(const Surface& surface, FloorMap& map) override {
        FloorFrame frame = frame_of(settings_, surface);
        if (map.irradiance.nx() != frame.map_width || map.irradiance.ny() != frame.map_height)
            map.irradiance = Field<float>(frame.map_width, frame.map_height);
        map.window = {1, 1};
        std::vector<RowLedger> rows(frame.rows.count);
        land_quads(frame, settings_, surface, shadows_.cast(surface, frame), landed_, rows);
        const SurfaceRows reader(frame, surface);
        const double sum = sharer_.collect(frame, reader, landed_, map.irradiance, rows);
        map.ledger = total(rows, frame.pixel_area_m2);
        map.ledger.floor_w = frame.pixel_area_m2 * sum;
    }

  private:
    FloorSettings settings_;
    ObjectShadows shadows_;
    LandedQuads landed_;
    QuadSharer sharer_;
};

}  // namespace

std::unique_ptr<FloorMapper> make_floor_quads(const FloorSettings& settings) {
    validate(settings);
    if (settings.samples_per_pixel == 1) return std::make_unique<FloorQuads>(settings);
    return average_samples(settings, make_floor_quads(one_sample_a_pixel(settings)));
}

}  // namespace waterlight
