#include "caustics/beam_strip.hpp"

#include <algorithm>
#include <cmath>

#include "caustics/beam_blocks.hpp"
#include "caustics/beam_outline.hpp"
#include "caustics/water_box.hpp"

namespace waterlight {

namespace {

using blocks::lanes;

int padded(int rows) { return (rows + 2 * lanes - 1) / lanes * lanes; }

}  // namespace

BeamStrip::BeamStrip(const BeamImageSettings& settings, const Beams& beams, const Field<float>& reach)
    : settings_(settings),
      beams_(beams),
      reach_(reach),
      view_(settings.camera),
      view_rays_(view_.rays),
      uneven_(!ends_level(beams)) {
    const int rows = padded(settings.camera.size.y);
    for (Field<float>* f : {&length_, &per_length_, &near_, &far_, &sum_}) *f = Field<float>(rows, columns);
}

void BeamStrip::begin(int first_column) {
    first_column_ = first_column;
    sum_.fill(0);
    const WaterBox box(beams_, view_.eye_m);
    const float range = static_cast<float>(settings_.range_m);
    for (int k = 0; k < columns; ++k) {
        const glm::vec3 first = view_rays_.corner + static_cast<float>(first_column + k) * view_rays_.right;
        const glm::vec3 up = view_rays_.up;
        float* __restrict length = length_.row(k), * __restrict per_length = per_length_.row(k);
        float* __restrict near = near_.row(k), * __restrict far = far_.row(k);
        const int rows = length_.nx();
#pragma GCC ivdep
        for (int i = 0; i < rows; ++i) {
            const float row = static_cast<float>(i);
            const glm::vec3 r{first.x + row * up.x, first.y + row * up.y, first.z + row * up.z};
            const f32::WaterSpan span = box.span(r);
            length[i] = f32::sqrt(r.x * r.x + r.y * r.y + r.z * r.z);
            per_length[i] = 1 / length[i];
            near[i] = span.near;
            far[i] = f32::min(span.far, range * per_length[i]);
        }
        if (reach_.empty() || first_column_ + k >= reach_.nx()) continue;
        for (int i = 0; i < reach_.ny(); ++i) far[i] = f32::min(far[i], reach_(first_column_ + k, i));
    }
}

template <class PhaseFunction>
std::int64_t BeamStrip::add(const CellCopy& copy, const PhaseFunction& phase) {
    const auto rays_at = [this](int k, int row) {
        return blocks::Rays{length_.row(k) + row, per_length_.row(k) + row, near_.row(k) + row,
                            near_.row(k) + row,   far_.row(k) + row,        sum_.row(k) + row};
    };
    const std::array<glm::vec3, 8> corners = beam_corners(beams_, copy, view_.eye_m);
    const BeamOutline outline(view_.rays, corners);
    const CellView view = view_of(beams_, copy, corners);
    blocks::BlockQueue queue(view, view_rays_, static_cast<float>(settings_.optics.scattering_per_m),
                             static_cast<float>(beams_.extinction_per_m));
    const float first = static_cast<float>(first_column_), top = static_cast<float>(settings_.camera.size.y - 1);
    const float last = static_cast<float>(std::min(first_column_ + columns, settings_.camera.size.x) - 1);
    const int begin = static_cast<int>(std::ceil(std::clamp(outline.left(), first, last)));
    const int end = static_cast<int>(std::floor(std::clamp(outline.right(), first, last)));
    std::int64_t met = 0;
    const auto work_off = [&] {
        uneven_ ? queue.template work_off<true>(phase, settings_.samples)
                : queue.template work_off<false>(phase, settings_.samples);
    };
    for (int i = begin; i <= end; ++i) {
        const PixelSpan span = outline.rows(static_cast<float>(i));
        if (span.high < 0 || span.low > top) continue;
        const int low = static_cast<int>(std::ceil(std::max(span.low, 0.0F)));
        const int high = static_cast<int>(std::floor(std::min(span.high, top)));
        for (int row = low; row <= high; row += lanes) {
            queue.push(i, row, rays_at(i - first_column_, row));
            if (queue.full()) work_off();
        }
        met += std::max(0, high - low + 1);
    }
    work_off();
    return met;
}

std::int64_t BeamStrip::finish(Field<float>& radiance) const {
    const int last = std::min(columns, radiance.nx() - first_column_);
    std::int64_t covered = 0;
    for (int j = 0; j < radiance.ny(); ++j) {
        float* row = radiance.row(j) + first_column_;
        for (int k = 0; k < last; ++k) {
            row[k] = sum_(j, k);
            covered += row[k] > 0 ? 1 : 0;
        }
    }
    return covered;
}

template std::int64_t BeamStrip::add(const CellCopy&, const HenyeyGreenstein&);
template std::int64_t BeamStrip::add(const CellCopy&, const PhaseTable&);

}  // namespace waterlight
