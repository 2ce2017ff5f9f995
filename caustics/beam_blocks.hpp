// Blocks of rays through the beams of a cell, as many rays at once as the widest vector has lanes. The loops of a
// picture: in a header of their own for the one file that compiles them with the widest vectors.
#pragma once

#include <array>

#include "caustics/beam_view.hpp"
#include "caustics/kernels/beams.hpp"
#include "caustics/phase.hpp"

namespace waterlight::blocks {

constexpr int lanes = 16;

/// Rays of a block, from some pixel of a column upwards: where they enter the water, and from where to where they are
/// looked at.
struct Rays {
    const float *length, *per_length, *entry, *near, *far;
    float* sum;
};

/// The chords of one block of rays in the two beams of a cell.
struct Chords {
    struct OfBeam {
        alignas(64) float density[lanes];  ///< times the beam's power and the phase function
        alignas(64) float begin[lanes];
        alignas(64) float end[lanes];
    };
    std::array<OfBeam, 2> beam;
};

/// A cell's numbers that do not change over the picture.
struct Constants {
    alignas(64) float per_row[cell_forms];
    std::array<float, 2> lid_distance, power;
    float lowest_lid, above, path, extinction;
};

/// A cell's numbers at one block of rays.
struct Section {
    const Constants& constant;
    const float* at;

    float number(int form, float row) const { return at[form] + constant.per_row[form] * row; }
    f32::EdgeNumbers edge(int k, float row) const {
        const int own = k * numbers_of_edge;
        return {number(own + along, row), number(own + across, row), number(own + leads, row),
                number(own + warps, row)};
    }
};

/// How far a chord reaches beyond the ray's part that is looked at or over the lowest corner on the surface.
inline float excess(const f32::BeamChord& c, float from, float to, float descent, float lowest_lid) {
    const float shallow = f32::min(descent * c.begin, descent * c.end);
    return c.density * f32::max(f32::max(from - c.begin, c.end - to), lowest_lid - shallow);
}

/// Where the rays of a block meet the beams of a cell, and how much of their light they scatter there. Returns 1 where
/// any chord is to be cut, else 0.
template <class PhaseFunction>
int meet(const Section& s, const Rays& rays, const PhaseFunction& phase, Chords& chords) {
    const float* __restrict near = rays.near, * __restrict far = rays.far, * __restrict per_length = rays.per_length;
    Chords::OfBeam &beam0 = chords.beam[0], &beam1 = chords.beam[1];
    const float power0 = s.constant.power[0], power1 = s.constant.power[1];
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
        const f32::SectionCorner c3 = f32::section_corner(s.edge(3, row), inverse, descent, from, to);
        const PhaseFraction p = phase(s.number(towards, row) * per_length[l]);
        const f32::BeamChord a = f32::beam_chord(c0, c1, c2, p.denominator);
        const f32::BeamChord b = f32::beam_chord(c0, c2, c3, p.denominator);
        const float over = f32::max(excess(a, from, to, descent, s.constant.lowest_lid),
                                    excess(b, from, to, descent, s.constant.lowest_lid));
        beam0.density[l] = power0 * p.numerator * a.density;
        beam0.begin[l] = a.begin;
        beam0.end[l] = a.end;
        beam1.density[l] = power1 * p.numerator * b.density;
        beam1.begin[l] = b.begin;
        beam1.end[l] = b.end;
        beyond |= static_cast<int>(over > 0);
    }
    return beyond;
}

/// Cuts the chords of one beam at their rays' ends and at the surface.
inline void cut(const Section& s, const Rays& rays, int beam, Chords::OfBeam& chords) {
    const float* __restrict near = rays.near, * __restrict far = rays.far;
    const float distance = s.constant.lid_distance[beam];
#pragma GCC ivdep
    for (int l = 0; l < lanes; ++l) {
        const float speed = s.number(lid + beam, static_cast<float>(l));
        const float cover = distance / (f32::abs(speed) < 1e-12F ? 1e-12F : speed);
        const float from = speed < 0 ? f32::max(near[l], cover) : near[l];
        const float to = speed < 0 ? far[l] : f32::min(far[l], cover);
        const float begin = chords.begin[l], end = chords.end[l];
        chords.density[l] *= f32::part_within(begin, end, from, to);
        chords.begin[l] = f32::clamp(begin, from, to);
        chords.end[l] = f32::clamp(end, from, to);
    }
}

/// Adds what reaches the camera from the middle of the way through both beams.
inline void add_up(const Section& s, const Rays& rays, const Chords& chords) {
    const float* __restrict entry = rays.entry, * __restrict length = rays.length;
    const Chords::OfBeam &a = chords.beam[0], &b = chords.beam[1];
    float* __restrict sum = rays.sum;
#pragma GCC ivdep
    for (int l = 0; l < lanes; ++l) {
        const f32::BeamChord whole =
            f32::joined_chord({a.density[l], a.begin[l], a.end[l]}, {b.density[l], b.begin[l], b.end[l]});
        const float middle = 0.5F * (whole.begin + whole.end);
        const float descent = s.number(down, static_cast<float>(l));
        const float left = f32::beam_attenuation(s.constant.extinction, s.constant.path, s.constant.above, descent,
                                                 entry[l], length[l], middle);
        sum[l] += whole.density > 0 ? length[l] * whole.density * left : 0.0F;
    }
}

/// The way through both beams in `samples` parts, each with the warp that the beams have there.
template <class PhaseFunction>
void add_up_finely(const Section& s, const Rays& rays, const PhaseFunction& phase, int samples, const Chords& chords) {
    alignas(64) float near[lanes], far[lanes];
    Rays part = rays;
    part.near = near;
    part.far = far;
    for (int k = 0; k < samples; ++k) {
        for (int l = 0; l < lanes; ++l) {
            const Chords::OfBeam &a = chords.beam[0], &b = chords.beam[1];
            const f32::BeamChord whole =
                f32::joined_chord({a.density[l], a.begin[l], a.end[l]}, {b.density[l], b.begin[l], b.end[l]});
            const float step = (whole.end - whole.begin) / static_cast<float>(samples);
            near[l] = whole.begin + static_cast<float>(k) * step;
            far[l] = k + 1 == samples ? whole.end : whole.begin + static_cast<float>(k + 1) * step;
        }
        Chords of_part;
        meet(s, part, phase, of_part);
        for (int beam = 0; beam < 2; ++beam) cut(s, part, beam, of_part.beam[beam]);
        add_up(s, part, of_part);
    }
}

/// Blocks of rays that meet one cell's beams, worked off many at a time: the processor then need not wait for one to be
/// done.
class BlockQueue {
  public:
    BlockQueue(const CellView& v, const ViewRays& rays, float scattering, float extinction) {
        for (int f = 0; f < cell_forms; ++f) {
            at_[f] = glm::dot(v.form[f], rays.corner);
            per_column_[f] = glm::dot(v.form[f], rays.right);
            constant_.per_row[f] = glm::dot(v.form[f], rays.up);
        }
        constant_.lid_distance = v.lid_distance;
        constant_.power = {v.power[0] * scattering, v.power[1] * scattering};
        constant_.lowest_lid = v.lowest_lid;
        constant_.above = v.above;
        constant_.path = v.path;
        constant_.extinction = extinction;
    }

    bool full() const { return count_ == capacity; }

    void push(int column, int row, const Rays& rays) {
        const float c = static_cast<float>(column), r = static_cast<float>(row);
        for (int f = 0; f < cell_forms; ++f)
            block_at_[count_][f] = at_[f] + c * per_column_[f] + r * constant_.per_row[f];
        block_rays_[count_++] = rays;
    }

    template <class PhaseFunction>
    void work_off(const PhaseFunction& phase, int samples) {
        std::array<int, capacity> beyond;
        int count = 0;
        for (int k = 0; k < count_; ++k) {
            beyond[count] = k;
            count += meet(section(k), block_rays_[k], phase, chords_[k]);
        }
        for (int k = 0; k < count; ++k)
            for (int beam = 0; beam < 2; ++beam)
                cut(section(beyond[k]), block_rays_[beyond[k]], beam, chords_[beyond[k]].beam[beam]);
        for (int k = 0; k < count_; ++k) {
            if (samples == 1)
                add_up(section(k), block_rays_[k], chords_[k]);
            else
                add_up_finely(section(k), block_rays_[k], phase, samples, chords_[k]);
        }
        count_ = 0;
    }

  private:
    static constexpr int capacity = 48;

    Section section(int k) const { return {constant_, block_at_[k]}; }

    Constants constant_;
    alignas(64) float at_[cell_forms];
    alignas(64) float per_column_[cell_forms];
    alignas(64) float block_at_[capacity][cell_forms];
    Rays block_rays_[capacity];
    Chords chords_[capacity];
    int count_ = 0;
};

}  // namespace waterlight::blocks
