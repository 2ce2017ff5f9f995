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
    std::array<float, 2> top_distance, ground_distance, power;
    std::array<f32::BeamEdge, 4> edge;
    float off2;
    float lowest_lid, highest_end, above, path, extinction;
};

/// A cell's numbers at one block of rays.
struct Section {
    const Constants& constant;
    const float* at;

    float number(int form, float row) const { return at[form] + constant.per_row[form] * row; }
    glm::vec2 speed(float row) const { return {number(speed_x, row), number(speed_y, row)}; }
    f32::EdgeNumbers edge(int k, float row) const {
        const int own = k * numbers_of_edge;
        return {number(own + along, row), number(own + across, row), number(own + leads, row),
                number(own + warps, row)};
    }
};

/// What is left to do for a block.
enum Remains { to_cut = 1, to_follow = 2 };

/// Where the rays of a block meet the beams of a cell, and how much of their light they scatter there; rays that run
/// along the beams are left out. Returns the sum of `to_cut`, where any chord is to be cut, and `to_follow`, where any
/// ray runs along. `uneven`: the beams end on ground of their own.
template <bool uneven, class PhaseFunction>
int meet(const Section& s, const Rays& rays, const PhaseFunction& phase, Chords& chords) {
    const float* __restrict near = rays.near, * __restrict far = rays.far, * __restrict per_length = rays.per_length;
    const float* __restrict length = rays.length;
    Chords::OfBeam &beam0 = chords.beam[0], &beam1 = chords.beam[1];
    const float power0 = s.constant.power[0], power1 = s.constant.power[1];
    const float lowest_lid = s.constant.lowest_lid, highest_end = s.constant.highest_end;
    const float off2 = s.constant.off2;
    int remains = 0;
#pragma GCC ivdep
    for (int l = 0; l < lanes; ++l) {
        const float row = static_cast<float>(l), descent = s.number(down, row), from = near[l], to = far[l];
        const glm::vec2 v = s.speed(row);
        const f32::CellCorners c =
            f32::cell_corners(s.edge(0, row), s.edge(1, row), s.edge(2, row), s.edge(3, row), v, descent, from, to);
        const bool along = f32::runs_along(v, length[l], descent, off2);
        const PhaseFraction p = phase(s.number(towards, row) * per_length[l]);
        const f32::BeamChord a = f32::beam_chord(c.c0, c.c1, c.c2, p.denominator);
        const f32::BeamChord b = f32::beam_chord(c.c0, c.c2, c.c3, p.denominator);
        float over = f32::max(f32::chord_excess(a, from, to, descent, lowest_lid),
                              f32::chord_excess(b, from, to, descent, lowest_lid));
        if (uneven)
            over = f32::max(over, f32::max(f32::chord_excess_below(a, descent, highest_end),
                                           f32::chord_excess_below(b, descent, highest_end)));
        const float numerator = along ? 0 : p.numerator;
        beam0.density[l] = power0 * numerator * a.density;
        beam0.begin[l] = a.begin;
        beam0.end[l] = a.end;
        beam1.density[l] = power1 * numerator * b.density;
        beam1.begin[l] = b.begin;
        beam1.end[l] = b.end;
        remains |= static_cast<int>(over > 0) | (along ? to_follow : 0);
    }
    return remains;
}

/// The part of a ray of the block that is in the water where one beam may be.
template <bool uneven>
f32::WaterSpan beam_span(const Section& s, f32::WaterSpan span, int beam, float row) {
    span = f32::within_lid(span, s.number(top_lid + beam, row), s.constant.top_distance[beam]);
    if (uneven) span = f32::within_lid(span, s.number(ground_lid + beam, row), s.constant.ground_distance[beam]);
    return span;
}

/// Cuts the chords of one beam at their rays' ends, at the surface and on the ground.
template <bool uneven>
void cut(const Section& s, const Rays& rays, int beam, Chords::OfBeam& chords) {
    const float* __restrict near = rays.near, * __restrict far = rays.far;
#pragma GCC ivdep
    for (int l = 0; l < lanes; ++l) {
        const float row = static_cast<float>(l);
        const f32::WaterSpan span = beam_span<uneven>(s, {near[l], far[l]}, beam, row);
        const f32::BeamChord kept = f32::cut_chord({chords.density[l], chords.begin[l], chords.end[l]}, span);
        chords.density[l] = kept.density;
        chords.begin[l] = kept.begin;
        chords.end[l] = kept.end;
    }
}

inline f32::BeamChord whole_chord(const Chords& chords, int l) {
    const Chords::OfBeam &a = chords.beam[0], &b = chords.beam[1];
    return f32::joined_chord({a.density[l], a.begin[l], a.end[l]}, {b.density[l], b.begin[l], b.end[l]});
}

/// Adds what reaches the camera from the middle of the way through both beams.
inline void add_up(const Section& s, const Rays& rays, const Chords& chords) {
    const float* __restrict entry = rays.entry, * __restrict length = rays.length;
    float* __restrict sum = rays.sum;
#pragma GCC ivdep
    for (int l = 0; l < lanes; ++l)
        sum[l] += f32::light_from_chord(whole_chord(chords, l), s.constant.extinction, s.constant.path,
                                        s.constant.above, s.number(down, static_cast<float>(l)), entry[l], length[l]);
}

/// The way through both beams in `samples` parts, each with the warp that the beams have there.
template <bool uneven, class PhaseFunction>
void add_up_finely(const Section& s, const Rays& rays, const PhaseFunction& phase, int samples, const Chords& chords) {
    alignas(64) float near[lanes], far[lanes];
    Rays part = rays;
    part.near = near;
    part.far = far;
    for (int k = 0; k < samples; ++k) {
        for (int l = 0; l < lanes; ++l) {
            const f32::WaterSpan span =
                f32::chord_part(whole_chord(chords, l), {rays.near[l], rays.far[l]}, k, samples);
            near[l] = span.near;
            far[l] = span.far;
        }
        Chords of_part;
        meet<uneven>(s, part, phase, of_part);
        for (int beam = 0; beam < 2; ++beam) cut<uneven>(s, part, beam, of_part.beam[beam]);
        add_up(s, part, of_part);
    }
}

inline f32::CellSides sides_at(const Section& s, glm::vec2 v, float down, float t) {
    const std::array<f32::BeamEdge, 4>& e = s.constant.edge;
    return f32::cell_sides(
        f32::beside_ray(e[0].at, e[0].travel, v, down, t), f32::beside_ray(e[1].at, e[1].travel, v, down, t),
        f32::beside_ray(e[2].at, e[2].travel, v, down, t), f32::beside_ray(e[3].at, e[3].travel, v, down, t));
}

/// What the speeds of the edges span.
inline f32::CellSides bends(const Section& s, glm::vec2 v, float down) {
    const std::array<f32::BeamEdge, 4>& e = s.constant.edge;
    return f32::cell_sides(f32::edge_speed(e[0].travel, v, down), f32::edge_speed(e[1].travel, v, down),
                           f32::edge_speed(e[2].travel, v, down), f32::edge_speed(e[3].travel, v, down));
}

/// Adds what reaches the camera from the rays of a block that run along the cell's beams, from `parts` of their ways.
template <bool uneven, class PhaseFunction>
void follow(const Section& s, const Rays& rays, const PhaseFunction& phase, int parts) {
    for (int k = 0; k < parts; ++k) {
#pragma GCC ivdep
        for (int l = 0; l < lanes; ++l) {
            const float row = static_cast<float>(l), descent = s.number(down, row), length = rays.length[l];
            const glm::vec2 v = s.speed(row);
            const f32::WaterSpan ray{rays.near[l], rays.far[l]};
            const float step = (ray.far - ray.near) / static_cast<float>(parts);
            const float begin = ray.near + static_cast<float>(k) * step;
            const f32::CellSides a = sides_at(s, v, descent, begin), b = sides_at(s, v, descent, begin + step);
            const f32::WaterSpan first = beam_span<uneven>(s, ray, 0, row), second = beam_span<uneven>(s, ray, 1, row);
            const f32::CellSides bend = bends(s, v, descent);
            const float square = step * step;
            const glm::vec3 diagonal{a.s20, b.s20, square * bend.s20};
            const float density0 = f32::density_in_part(first, begin, step, {a.s01, b.s01, square * bend.s01},
                                                        {a.s12, b.s12, square * bend.s12}, diagonal);
            const float density1 = f32::density_in_part(
                second, begin, step, -diagonal, {a.s23, b.s23, square * bend.s23}, {a.s30, b.s30, square * bend.s30});
            const PhaseFraction p = phase(s.number(towards, row) * rays.per_length[l]);
            const float light =
                (s.constant.power[0] * density0 + s.constant.power[1] * density1) * p.numerator / p.denominator;
            const float left = f32::beam_attenuation(s.constant.extinction, s.constant.path, s.constant.above, descent,
                                                     rays.entry[l], length, begin + 0.5F * step);
            const bool along = f32::runs_along(v, length, descent, s.constant.off2) & (step > 0);
            rays.sum[l] += along ? length * light * left : 0;
        }
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
        constant_.top_distance = v.top_distance;
        constant_.ground_distance = v.ground_distance;
        constant_.edge = v.edge;
        constant_.off2 = v.off2;
        constant_.power = {v.power[0] * scattering, v.power[1] * scattering};
        constant_.lowest_lid = v.lowest_lid;
        constant_.highest_end = v.highest_end;
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

    template <bool uneven, class PhaseFunction>
    void work_off(const PhaseFunction& phase, int samples) {
        std::array<int, capacity> beyond, along;
        int count = 0, follows = 0;
        for (int k = 0; k < count_; ++k) {
            const int remains = meet<uneven>(section(k), block_rays_[k], phase, chords_[k]);
            beyond[count] = along[follows] = k;
            count += remains & to_cut;
            follows += (remains & to_follow) / to_follow;
        }
        for (int k = 0; k < count; ++k)
            for (int beam = 0; beam < 2; ++beam)
                cut<uneven>(section(beyond[k]), block_rays_[beyond[k]], beam, chords_[beyond[k]].beam[beam]);
        for (int k = 0; k < follows; ++k)
            follow<uneven>(section(along[k]), block_rays_[along[k]], phase, f32::parts_along(samples));
        for (int k = 0; k < count_; ++k) {
            if (samples == 1)
                add_up(section(k), block_rays_[k], chords_[k]);
            else
                add_up_finely<uneven>(section(k), block_rays_[k], phase, samples, chords_[k]);
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
