// Caustics mapping on the CPU.
#include "caustics/splat/capture.hpp"
#include "caustics/splat/splat_map.hpp"
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
        const Receivers receivers = receivers_of(s_, frame, surface);
        SplatCloud cloud = water_alone(s_) ? land_water(s_, frame, receivers, surface)
                                           : land_captured(s_, frame, receivers, capture(s_, frame, surface));
        Field<double> power(frame.plan.width, frame.plan.height);
        spread(s_.options, frame, cloud, power);
        report_ = cloud.report;
        map.ledger = cloud.ledger;
        write_map(s_, frame, receivers, power.data(), map);
    }

  private:
    SplatSettings s_;
    SplatReport report_;
};

}  // namespace

std::unique_ptr<SplatFloor> make_splat_floor_cpu(const SplatSettings& settings) {
    return std::make_unique<SplatCpu>(settings);
}

}  // namespace waterlight
