// Caustics mapping on the CPU.
#include "caustics/splat/capture.hpp"
#include "caustics/splat/splat_cloud.hpp"
#include "caustics/splat/splat_spread.hpp"

namespace waterlight {

namespace {

class SplatCpu final : public SplatFloor {
  public:
    explicit SplatCpu(const SplatSettings& settings) : s_(settings) { validate(s_); }

    std::string_view backend() const override { return "cpu"; }
    SplatReport report() const override { return report_; }

    void compute(const Surface& surface, FloorMap& map) override {
        SplatFrame frame = splat_frame(s_, surface);
        const Receivers receivers = s_.bed_m ? Receivers(frame, surface, *s_.bed_m) : Receivers(frame.light.image);
        const bool alone = !s_.floor.objects || s_.floor.objects->empty();
        SplatCloud cloud =
            alone ? land_water(s_, frame, receivers, surface) : land_captured(s_, frame, receivers, surface);
        Field<double> power(frame.plan.width, frame.plan.height);
        spread(s_.options, frame, cloud, power);
        report_ = cloud.report;
        map.ledger = cloud.ledger;
        map.window = {1, 1};
        write(frame, receivers, power, map);
    }

  private:
    void write(const SplatFrame& frame, const Receivers& receivers, const Field<double>& power, FloorMap& map) const {
        const int width = frame.plan.width, height = frame.plan.height;
        if (map.irradiance.nx() != width || map.irradiance.ny() != height) map.irradiance = Field<float>(width, height);
        const bool sloping = !receivers.level() && s_.per_ground_area;
#pragma omp parallel for schedule(static)
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i) {
                const double steepness = sloping ? receivers.steepness(frame.plan.position_m({i + 0.5, j + 0.5})) : 1;
                map.irradiance(i, j) = static_cast<float>(power(i, j) / (frame.pixel_area_m2 * steepness));
            }
        for (const double w : power.values()) map.ledger.floor_w += w;
    }

    SplatSettings s_;
    SplatReport report_;
};

}  // namespace

std::unique_ptr<SplatFloor> make_splat_floor_cpu(const SplatSettings& settings) {
    return std::make_unique<SplatCpu>(settings);
}

}  // namespace waterlight
