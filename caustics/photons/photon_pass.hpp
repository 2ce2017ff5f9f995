// A pass of photons, band by band, on all threads.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "caustics/photons/photon_path.hpp"

namespace waterlight {

/// Follows photons of one light through one water. Any number of threads at once.
class PhotonTracer {
  public:
    virtual ~PhotonTracer() = default;
    /// Photons first .. first + count - 1 of a pass, added to the tally.
    virtual void trace(int pass, std::int64_t first, std::int64_t count, PhotonTally& tally) const = 0;
};

/// Through all that `scene` holds. What it is given must outlive it.
std::unique_ptr<PhotonTracer> make_scene_tracer(const PhotonSettings& settings, const WaterScene& scene);

/// The scene of these settings, with what periodic sides bring in of its objects, and with as much still water beyond
/// absorbing sides as light may come through.
WaterScene make_photon_scene(const PhotonSettings& settings, const Surface& surface);

/// What is added to a pixel.
struct PhotonDeposit {
    std::int64_t pixel;
    double value;
};

/// Turns what a band of photons landed into deposits, and accounts for it.
using PhotonReceiver = std::function<void(std::span<const PhotonLanding>, std::vector<PhotonDeposit>&, FloorLedger&)>;

/// Adds one pass to `out`: bands of fixed size, in order, so that the sums do not depend on the number of threads.
void run_pass(const PhotonTracer& tracer, std::int64_t photons, int pass, const PhotonReceiver& receive,
              Field<double>& out, FloorLedger& ledger);

}  // namespace waterlight
