#include "caustics/photons/photon_pass.hpp"

#include <algorithm>

#include "caustics/light_ledger.hpp"
#include "caustics/objects/repeated_objects.hpp"
#include "caustics/photons/photon_starts.hpp"

namespace waterlight {

namespace {

class SceneTracer final : public PhotonTracer {
  public:
    SceneTracer(const PhotonSettings& settings, const WaterScene& scene)
        : options_(settings.options), starts_(make_photon_starts(settings, scene)), follower_(scene, options_) {}

    void trace(int pass, std::int64_t first, std::int64_t count, PhotonTally& tally) const override {
        const std::uint64_t key = PhotonRandom::key(options_.seed, pass);
        const double share = 1 / (static_cast<double>(options_.map) * options_.map);
        for (std::int64_t k = first; k < first + count; ++k) {
            PhotonRandom random(key, k);
            Photon photon = starts_->start(random.within_cell(k, options_.map));
            photon.power_w *= share;
            if (photon.power_w > 0) follower_.follow(photon, random, tally);
        }
    }

  private:
    PhotonOptions options_;
    std::unique_ptr<PhotonStarts> starts_;
    PhotonFollower follower_;
};

/// What of the objects is in the domain, those that periodic sides bring in among them, where they are at the time.
std::shared_ptr<const ObjectSet> within(std::shared_ptr<const ObjectSet> set, const Surface& surface) {
    const PhotonDomain domain(surface);
    if (!set || set->empty() || !(domain.periodic(0) || domain.periodic(1))) return set;
    const RepeatedObjects repeated(set, surface.time_s, surface.grid, surface.boundary);
    std::vector<Object> all;
    bool moved = false;
    for (int k = 0; k < repeated.placed().count(); ++k) {
        const auto [first, last] = repeated.shifts(k, domain.low_m, domain.low_m + domain.size_m);
        for (int j = first.y; j <= last.y; ++j)
            for (int i = first.x; i <= last.x; ++i) {
                Object object = repeated.placed().object(k);
                object.centre_m =
                    object.centre_at(surface.time_s) + glm::dvec3(glm::dvec2(i, j) * repeated.period_m(), 0);
                object.path.clear();
                all.push_back(std::move(object));
                moved = moved || i != 0 || j != 0;
            }
    }
    return moved ? std::make_shared<const ObjectSet>(std::move(all)) : set;
}

}  // namespace

std::unique_ptr<PhotonTracer> make_scene_tracer(const PhotonSettings& settings, const WaterScene& scene) {
    return std::make_unique<SceneTracer>(settings, scene);
}

WaterScene make_photon_scene(const PhotonSettings& settings, const Surface& surface) {
    const FloorSettings& floor = settings.floor;
    const Grid& g = surface.grid;
    const LevelBox water = lit_water(settings, surface);
    const glm::dvec2 low{g.x0_m, g.y0_m}, high = low + glm::dvec2{g.width_m(), g.height_m()};
    const glm::dvec2 over = glm::max(low - water.low_m, water.high_m - high);
    // Light that objects send aside meets still water far out too.
    const double far = 10 * (g.width_m() + g.height_m() + floor.depth_m);
    return WaterScene({.depth_m = floor.depth_m,
                       .bed_m = settings.bed_m,
                       .optics = floor.optics,
                       .wavelength_nm = floor.wavelength_nm,
                       .objects = within(floor.objects, surface),
                       .still_beyond_m = std::max({0.0, over.x, over.y}) + far},
                      surface);
}

void run_pass(const PhotonTracer& tracer, std::int64_t photons, int pass, const PhotonReceiver& receive,
              Field<double>& out, FloorLedger& ledger) {
    constexpr std::int64_t band = 4096;
    const std::int64_t bands = (photons + band - 1) / band;
#pragma omp parallel
    {
        PhotonTally tally;
        std::vector<PhotonDeposit> deposits;
#pragma omp for schedule(dynamic, 1) ordered
        for (std::int64_t b = 0; b < bands; ++b) {
            tally.ledger = {};
            tally.landings.clear();
            deposits.clear();
            tracer.trace(pass, b * band, std::min(band, photons - b * band), tally);
            receive(tally.landings, deposits, tally.ledger);
#pragma omp ordered
            {
                for (const PhotonDeposit& deposit : deposits) out.data()[deposit.pixel] += deposit.value;
                ledger += tally.ledger;
            }
        }
    }
}

}  // namespace waterlight
