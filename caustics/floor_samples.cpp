#include "caustics/floor_samples.hpp"

namespace waterlight {

namespace {

class SampleAverager final : public FloorMapper {
  public:
    SampleAverager(const FloorSettings& settings, std::unique_ptr<FloorMapper> of_samples)
        : width_(settings.plan.width),
          height_(settings.plan.height),
          samples_(settings.samples_per_pixel),
          of_samples_(std::move(of_samples)) {}

    std::string_view backend() const override { return of_samples_->backend(); }

    void compute(const Surface& surface, FloorMap& map) override {
        of_samples_->compute(surface, fine_);
        if (map.irradiance.nx() != width_ || map.irradiance.ny() != height_)
            map.irradiance = Field<float>(width_, height_);
#pragma omp parallel for schedule(static)
        for (int j = 0; j < height_; ++j) average_row(j, map.irradiance.row(j));
        map.window = fine_.window;
        map.ledger = fine_.ledger;
    }

  private:
    void average_row(int j, float* to) const {
        const float each = 1.0F / static_cast<float>(samples_ * samples_);
        std::fill_n(to, width_, 0.0F);
        for (int b = 0; b < samples_; ++b) {
            const float* from = fine_.irradiance.row(j * samples_ + b);
            for (int i = 0; i < width_; ++i)
                for (int a = 0; a < samples_; ++a) to[i] += from[i * samples_ + a];
        }
        for (int i = 0; i < width_; ++i) to[i] *= each;
    }

    int width_;
    int height_;
    int samples_;
    std::unique_ptr<FloorMapper> of_samples_;
    FloorMap fine_;
};

}  // namespace

FloorSettings one_sample_a_pixel(const FloorSettings& settings) {
    FloorSettings fine = settings;
    fine.plan.width *= settings.samples_per_pixel;
    fine.plan.height *= settings.samples_per_pixel;
    fine.plan.pitch_m /= settings.samples_per_pixel;
    fine.samples_per_pixel = 1;
    return fine;
}

std::unique_ptr<FloorMapper> average_samples(const FloorSettings& settings, std::unique_ptr<FloorMapper> of_samples) {
    return std::make_unique<SampleAverager>(settings, std::move(of_samples));
}

}  // namespace waterlight
