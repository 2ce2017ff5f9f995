#include "caustics/beam_enlarge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "caustics/beam_picture.hpp"
#include "caustics/beam_view.hpp"
#include "caustics/water_box.hpp"

namespace waterlight {

namespace {

/// Way of a camera's rays through the water, m, by pixel.
Field<float> ways(BeamImageSettings settings, const Camera& camera, const Beams& beams) {
    settings.camera = camera;
    const WaterBox box(beams, Viewpoint(camera).eye_m);
    const Field<float> reach = picture_reach(settings, beams);
    const ViewRays rays(Viewpoint(camera).rays);
    Field<float> way(camera.size.x, camera.size.y);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < camera.size.y; ++j) {
        float* __restrict row = way.row(j);
        const glm::vec3 first = rays.corner + static_cast<float>(j) * rays.up, right = rays.right;
#pragma GCC ivdep
        for (int i = 0; i < camera.size.x; ++i) {
            const float x = static_cast<float>(i);
            const glm::vec3 r{first.x + x * right.x, first.y + x * right.y, first.z + x * right.z};
            const f32::WaterSpan span = box.span(r);
            row[i] = f32::max(0.0F, span.far - span.near) * f32::sqrt(r.x * r.x + r.y * r.y + r.z * r.z);
        }
        for (int i = 0; i < reach.nx(); ++i)
            row[i] = f32::min(row[i],
                              reach(i, j) * static_cast<float>(glm::length(rays.corner + static_cast<float>(i) * right +
                                                                           static_cast<float>(j) * rays.up)));
    }
    return way;
}

/// Where pixels of one axis lie among the coarse ones.
struct Place {
    int low = 0, high = 0;
    float part = 0;  ///< of high
};

std::vector<Place> places(int fine, int coarse, int reduction) {
    std::vector<Place> all(static_cast<std::size_t>(fine));
    for (int i = 0; i < fine; ++i) {
        const float at = (static_cast<float>(i) - 0.5F * static_cast<float>(fine - 1)) / static_cast<float>(reduction) +
                         0.5F * static_cast<float>(coarse - 1);
        const float held = std::clamp(at, 0.0F, static_cast<float>(coarse - 1));
        const int low = static_cast<int>(held);
        all[static_cast<std::size_t>(i)] = {low, std::min(low + 1, coarse - 1), held - static_cast<float>(low)};
    }
    return all;
}

/// Weight of a coarse ray by how far its way through the water is from the pixel's; half where one is 4 % longer.
float likeness(float way, float other) {
    const float off = 50 * (way - other) / (way + other + 1e-6F);
    return 1 / (1 + off * off * off * off);
}

}  // namespace

Camera reduced(const Camera& camera, int reduction) {
    Camera coarse = camera;
    coarse.size = (camera.size + reduction - 1) / reduction;
    const double half = std::tan(camera.fov_deg * std::numbers::pi / 360) * coarse.size.y * reduction / camera.size.y;
    coarse.fov_deg = std::atan(half) * 360 / std::numbers::pi;
    return coarse;
}

void enlarge(const BeamImageSettings& settings, const Beams& beams, const Field<float>& coarse, Field<float>& picture) {
    const Field<float> own = ways(settings, settings.camera, beams),
                       of_coarse = ways(settings, reduced(settings.camera, settings.reduction), beams);
    const std::vector<Place> column = places(picture.nx(), coarse.nx(), settings.reduction);
    const std::vector<Place> row = places(picture.ny(), coarse.ny(), settings.reduction);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < picture.ny(); ++j) {
        const Place y = row[static_cast<std::size_t>(j)];
        const float *low = coarse.row(y.low), *high = coarse.row(y.high);
        const float *low_way = of_coarse.row(y.low), *high_way = of_coarse.row(y.high);
        for (int i = 0; i < picture.nx(); ++i) {
            const Place x = column[static_cast<std::size_t>(i)];
            const float way = own(i, j);
            const std::array<float, 4> weight{(1 - x.part) * (1 - y.part) * likeness(way, low_way[x.low]),
                                              x.part * (1 - y.part) * likeness(way, low_way[x.high]),
                                              (1 - x.part) * y.part * likeness(way, high_way[x.low]),
                                              x.part * y.part * likeness(way, high_way[x.high])};
            const float sum =
                weight[0] * low[x.low] + weight[1] * low[x.high] + weight[2] * high[x.low] + weight[3] * high[x.high];
            picture(i, j) = sum / (weight[0] + weight[1] + weight[2] + weight[3]);
        }
    }
}

}  // namespace waterlight
