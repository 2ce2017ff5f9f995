#include "caustics/beam_strip.hpp"

#include <algorithm>
#include <cmath>

namespace waterlight {

namespace {

constexpr float boundless_m = 1e9F;

/// The water around the camera, relative to it: between walls, the highest crest and the floor.
struct WaterBox {
    glm::vec3 low{-boundless_m, -boundless_m, 0}, high{boundless_m, boundless_m, 0};
    WaterBox(const Beams& b, glm::dvec3 eye) {
        const Grid& g = b.domain;
        if (b.boundary.x == Side::wall) {
            low.x = static_cast<float>(g.x0_m - eye.x);
            high.x = static_cast<float>(g.x0_m + g.width_m() - eye.x);
        }
        if (b.boundary.y == Side::wall) {
            low.y = static_cast<float>(g.y0_m - eye.y);
            high.y = static_cast<float>(g.y0_m + g.height_m() - eye.y);
        }
        low.z = static_cast<float>(eye.z - b.highest_m);
        high.z = static_cast<float>(eye.z + b.depth_m);
    }
};

constexpr int lanes = 16;  ///< rays of a block: as many as the widest vector has

int padded(int rows) { return (rows + 2 * lanes - 1) / lanes * lanes; }

/// Rays of a block, from some pixel of a column upwards.
struct Rays {
    const float *length, *per_length, *near, *far;
    float* sum;
};

/// The chords of one block of rays.
struct Chords {
    alignas(64) float density[lanes];  ///< times the phase function
    alignas(64) float begin[lanes];
    alignas(64) float end[lanes];
};

/// A beam's numbers that do not change over the picture.
struct Constants {
    alignas(64) float per_row[beam_forms];
    float lid_per_row;
    float lid_distance, lowest_lid, above, path, power, extinction;
};

/// A beam's numbers at one block of rays.
struct Section {
    const Constants& constant;
    const float* at;
    float lid_at;

    float number(int form, float row) const { return at[form] + constant.per_row[form] * row; }
    f32::EdgeNumbers edge(int k, float row) const {
        const int own = k * numbers_of_edge;
        return {number(own + along, row), number(own + across, row), number(own + leads, row),
                number(own + warps, row)};
    }
};

/// Where the rays of a block meet a beam, and how much of its light they scatter there. Returns 1 where any chord
/// reaches beyond the water that its ray sees or above the lowest corner on the surface, else 0.
template <class PhaseFunction>
int meet(const Section& s, const Rays& rays, const PhaseFunction& phase, Chords& chords) {
    const float* __restrict near = rays.near, * __restrict far = rays.far, * __restrict per_length = rays.per_length;
    int beyond = 0;
#pragma GCC ivdep
    for (int l = 0; l < lanes; ++l) {
        const float row = static_cast<float>(l), descent = s.number(down, row);
        const float vx = s.number(speed_x, row), vy = s.number(speed_y, row);
        const float inverse = 1 / f32::max(vx * vx + vy * vy, 1e-12F);
        const float from = near[l], to = far[l];
        const f32::SectionCorner c0 = f32::section_corner(s.edge(0, row), inverse, descent, from, to);
        const f32::SectionCorner c1 = f32::section_corner(s.edge(1, row), inverse, descent, from, to);
        const f32::SectionCorner c2 = f32::section_corner(s.edge(2, row), inverse, descent, from, to);
        const PhaseFraction p = phase(s.number(towards, row) * per_length[l]);
        const f32::BeamChord chord = f32::beam_chord(c0, c1, c2, p.denominator);
        const float shallow = f32::min(descent * chord.begin, descent * chord.end);
        const float excess = f32::max(f32::max(from - chord.begin, chord.end - to), s.constant.lowest_lid - shallow);
        chords.density[l] = chord.density * p.numerator;
        chords.begin[l] = chord.begin;
        chords.end[l] = chord.end;
        beyond |= static_cast<int>(chord.density * excess > 0);
    }
    return beyond;
}

/// Cuts chords at their rays' ends and at the surface.
void cut(const Section& s, const Rays& rays, Chords& chords) {
    const float* __restrict near = rays.near, * __restrict far = rays.far;
#pragma GCC ivdep
    for (int l = 0; l < lanes; ++l) {
        const float speed = s.lid_at + static_cast<float>(l) * s.constant.lid_per_row;
        const float lid = s.constant.lid_distance / (f32::abs(speed) < 1e-12F ? 1e-12F : speed);
        const float from = speed < 0 ? f32::max(near[l], lid) : near[l];
        const float to = speed < 0 ? far[l] : f32::min(far[l], lid);
        const float begin = chords.begin[l], end = chords.end[l];
        chords.density[l] *= f32::part_within(begin, end, from, to);
        chords.begin[l] = f32::clamp(begin, from, to);
        chords.end[l] = f32::clamp(end, from, to);
    }
}

/// Adds what reaches the camera from the middle of each chord.
void add_up(const Section& s, const Rays& rays, const Chords& chords) {
    const float* __restrict near = rays.near, * __restrict length = rays.length;
    float* __restrict sum = rays.sum;
#pragma GCC ivdep
    for (int l = 0; l < lanes; ++l) {
        const float middle = 0.5F * (chords.begin[l] + chords.end[l]);
        const float descent = s.number(down, static_cast<float>(l));
        const float left = f32::beam_attenuation(s.constant.extinction, s.constant.path, s.constant.above, descent,
                                                 near[l], length[l], middle);
        sum[l] += chords.density[l] > 0 ? s.constant.power * length[l] * chords.density[l] * left : 0.0F;
    }
}

/// Blocks of rays that meet one beam, worked off many at a time: the processor then need not wait for one to be done.
class BlockQueue {
  public:
    BlockQueue(const BeamView& v, const ViewRays& rays, float scattering, float extinction) : rays_(rays), view_(v) {
        for (int f = 0; f < beam_forms; ++f) {
            at_[f] = glm::dot(v.form[f], rays.corner);
            per_column_[f] = glm::dot(v.form[f], rays.right);
            constant_.per_row[f] = glm::dot(v.form[f], rays.up);
        }
        constant_.lid_per_row = glm::dot(v.lid, rays.up);
        constant_.lid_distance = v.lid_distance;
        constant_.lowest_lid = v.lowest_lid;
        constant_.above = v.above;
        constant_.path = v.path;
        constant_.power = v.power * scattering;
        constant_.extinction = extinction;
    }

    bool full() const { return count_ == capacity; }

    void push(int column, int row, const Rays& rays) {
        const float c = static_cast<float>(column), r = static_cast<float>(row);
        for (int f = 0; f < beam_forms; ++f)
            block_at_[count_][f] = at_[f] + c * per_column_[f] + r * constant_.per_row[f];
        lid_at_[count_] = glm::dot(view_.lid, rays_.corner + c * rays_.right + r * rays_.up);
        block_rays_[count_++] = rays;
    }

    template <class PhaseFunction>
    void work_off(const PhaseFunction& phase) {
        std::array<int, capacity> beyond;
        int count = 0;
        for (int k = 0; k < count_; ++k) {
            beyond[count] = k;
            count += meet(section(k), block_rays_[k], phase, chords_[k]);
        }
        for (int k = 0; k < count; ++k) cut(section(beyond[k]), block_rays_[beyond[k]], chords_[beyond[k]]);
        for (int k = 0; k < count_; ++k) add_up(section(k), block_rays_[k], chords_[k]);
        count_ = 0;
    }

  private:
    static constexpr int capacity = 64;

    Section section(int k) const { return {constant_, block_at_[k], lid_at_[k]}; }

    const ViewRays& rays_;
    const BeamView& view_;
    Constants constant_;
    alignas(64) float at_[beam_forms];
    alignas(64) float per_column_[beam_forms];
    alignas(64) float block_at_[capacity][beam_forms];
    float lid_at_[capacity];
    Rays block_rays_[capacity];
    Chords chords_[capacity];
    int count_ = 0;
};

}  // namespace

BeamStrip::BeamStrip(const BeamImageSettings& settings, const Beams& beams)
    : settings_(settings), beams_(beams), rays_(settings.camera.rays()), view_rays_(rays_) {
    const int rows = padded(settings.camera.size.y);
    for (Field<float>* f : {&length_, &per_length_, &near_, &far_, &sum_}) *f = Field<float>(rows, columns);
}

void BeamStrip::begin(int first_column) {
    first_column_ = first_column;
    sum_.fill(0);
    const WaterBox box(beams_, settings_.camera.position_m);
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
            const f32::WaterSpan span = f32::water_span(r, box.low, box.high);
            length[i] = f32::sqrt(r.x * r.x + r.y * r.y + r.z * r.z);
            per_length[i] = 1 / length[i];
            near[i] = span.near;
            far[i] = f32::min(span.far, range * per_length[i]);
        }
    }
}

template <class PhaseFunction>
std::int64_t BeamStrip::add(const BeamCopy& copy, const PhaseFunction& phase) {
    const std::array<glm::vec3, 6> corners = beam_corners(beams_, copy, settings_.camera.position_m);
    const BeamOutline outline(rays_, corners);
    const BeamView view = view_of(beams_, copy, corners);
    BlockQueue queue(view, view_rays_, static_cast<float>(settings_.optics.scattering_per_m),
                     static_cast<float>(beams_.extinction_per_m));
    const float first = static_cast<float>(first_column_), top = static_cast<float>(settings_.camera.size.y - 1);
    const float last = static_cast<float>(std::min(first_column_ + columns, settings_.camera.size.x) - 1);
    const int begin = static_cast<int>(std::ceil(std::clamp(outline.left(), first, last)));
    const int end = static_cast<int>(std::floor(std::clamp(outline.right(), first, last)));
    std::int64_t met = 0;
    for (int i = begin; i <= end; ++i) {
        const PixelSpan span = outline.rows(static_cast<float>(i));
        if (span.high < 0 || span.low > top) continue;
        const int low = static_cast<int>(std::ceil(std::max(span.low, 0.0F)));
        const int high = static_cast<int>(std::floor(std::min(span.high, top)));
        const int k = i - first_column_;
        for (int row = low; row <= high; row += lanes) {
            queue.push(i, row,
                       {length_.row(k) + row, per_length_.row(k) + row, near_.row(k) + row, far_.row(k) + row,
                        sum_.row(k) + row});
            if (queue.full()) queue.work_off(phase);
        }
        met += std::max(0, high - low + 1);
    }
    queue.work_off(phase);
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

template std::int64_t BeamStrip::add(const BeamCopy&, const HenyeyGreenstein&);
template std::int64_t BeamStrip::add(const BeamCopy&, const PhaseTable&);

}  // namespace waterlight
