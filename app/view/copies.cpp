#include "app/view/copies.hpp"

namespace waterlight {

void copy(const Surface& from, Surface& to) {
    to.grid = from.grid;
    to.boundary = from.boundary;
    to.time_s = from.time_s;
    to.tilt = from.tilt;
    copy(from.elevation, to.elevation);
    copy(from.slope_x, to.slope_x);
    copy(from.slope_y, to.slope_y);
    copy(from.velocity_x, to.velocity_x);
    copy(from.velocity_y, to.velocity_y);
    copy(from.depth, to.depth);
}

void copy(const BeamVolume& from, BeamVolume& to) {
    to.cells = from.cells;
    to.ledger = from.ledger;
    to.depth_m = from.depth_m;
    copy(from.plane_irradiance, to.plane_irradiance);
    copy(from.scalar_irradiance, to.scalar_irradiance);
    copy(from.ground_m, to.ground_m);
}

void copy(const BeamImage& from, BeamImage& to) {
    to.counts = from.counts;
    copy(from.radiance, to.radiance);
}

void copy(const WallMaps& from, WallMaps& to) {
    for (std::size_t w = 0; w < from.irradiance.size(); ++w) copy(from.irradiance[w], to.irradiance[w]);
    to.power_w = from.power_w;
    to.ledger = from.ledger;
}

}  // namespace waterlight
