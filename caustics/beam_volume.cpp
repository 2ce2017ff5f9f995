#include "caustics/beam_volume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>

#include "caustics/cell_shares.hpp"
#include "caustics/kernels/optics.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

/// The corners of all beams at one depth, in cells of the volume.
struct Landed {
    Field<float> x, y, remaining;
    Landed(int nx, int ny) : x(nx, ny), y(nx, ny), remaining(nx, ny) {}
};

/// What a beam brings to a slice.
struct Section {
    std::array<glm::dvec2, 4> corner;
    int corners = 0;
    double flux = 0;  ///< W through the horizontal section
    double path = 1;  ///< of flux through a plane that faces the light for each of it
};

/// One slice after another, by one thread.
class SliceFiller {
  public:
    SliceFiller(const Beams& beams, glm::ivec3 cells)
        : beams_(beams),
          cells_(cells),
          landed_(beams.nx + 1, beams.ny + 1),
          sums_(2 * static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y)) {}

    SliceLedger fill(float z, float* plane, float* scalar) {
        land(z);
        std::fill(sums_.begin(), sums_.end(), 0.0);
        ledger_ = {};
        for (int j = 0; j < beams_.ny; ++j)
            for (int b = 0; b < 2 * beams_.nx; ++b)
                if (beams_.flux(b, j) > 0) add(section(b, j, z));
        const double per_area =
            cells_.x * static_cast<double>(cells_.y) / (beams_.domain.width_m() * beams_.domain.height_m());
        for (std::size_t i = 0; i < sums_.size() / 2; ++i) {
            plane[i] = static_cast<float>(sums_[2 * i] * per_area);
            scalar[i] = static_cast<float>(sums_[2 * i + 1] * per_area);
        }
        return ledger_;
    }

  private:
    void land(float z) {
        const Grid& g = beams_.domain;
        const float scale_x = static_cast<float>(cells_.x / g.width_m()), x0 = static_cast<float>(g.x0_m);
        const float scale_y = static_cast<float>(cells_.y / g.height_m()), y0 = static_cast<float>(g.y0_m);
        const float extinction = static_cast<float>(beams_.extinction_per_m);
        const int count = static_cast<int>(landed_.x.size());
        const float* __restrict px = beams_.x.data(), * __restrict py = beams_.y.data(), * __restrict pz = beams_.z.data();
        const float* __restrict tx = beams_.travel_x.data(), * __restrict ty = beams_.travel_y.data();
        const float* __restrict path = beams_.path.data();
        float* __restrict lx = landed_.x.data(), * __restrict ly = landed_.y.data();
        float* __restrict remaining = landed_.remaining.data();
#pragma GCC ivdep
        for (int i = 0; i < count; ++i) {
            const float descent = f32::max(0.0F, pz[i] - z);
            lx[i] = (px[i] + descent * tx[i] - x0) * scale_x;
            ly[i] = (py[i] + descent * ty[i] - y0) * scale_y;
            remaining[i] = f32::beer_lambert(extinction, descent * path[i]);
        }
    }

    Section section(int b, int j, float z) const {
        const std::array<glm::ivec2, 3> at = corners_of(b, j);
        Section s{{}, 3, beams_.flux(b, j), 0};
        double remaining = 0;
        int wet = 0;
        for (int k = 0; k < 3; ++k) {
            const auto [i, row] = std::pair(at[k].x, at[k].y);
            s.corner[k] = {landed_.x(i, row), landed_.y(i, row)};
            remaining += landed_.remaining(i, row) / 3;
            s.path += beams_.path(i, row) / 3;
            wet += beams_.z(i, row) >= z ? 1 : 0;
        }
        s.flux *= remaining;
        if (wet == 3) return s;
        return cut(s, at, z);
    }

    /// The part of a section whose light has entered the water above z: cut where the surface is at z.
    Section cut(const Section& whole, const std::array<glm::ivec2, 3>& at, float z) const {
        Section s = whole;
        s.corners = 0;
        std::array<glm::dvec2, 4> on_triangle;  // the same corners in the coordinates of the triangle
        constexpr std::array<glm::dvec2, 3> unit{glm::dvec2{0, 0}, {1, 0}, {0, 1}};
        const auto keep = [&](glm::dvec2 corner, glm::dvec2 place) {
            on_triangle[s.corners] = place;
            s.corner[s.corners++] = corner;
        };
        for (int k = 0; k < 3; ++k) {
            const int n = (k + 1) % 3;
            const double above = beams_.z(at[k].x, at[k].y) - z, next = beams_.z(at[n].x, at[n].y) - z;
            if (above >= 0) keep(whole.corner[k], unit[k]);
            if ((above > 0 && next < 0) || (above < 0 && next > 0)) {
                const double part = above / (above - next);
                keep(whole.corner[k] + part * (whole.corner[n] - whole.corner[k]),
                     unit[k] + part * (unit[n] - unit[k]));
            }
        }
        double share = 0;
        for (int k = 1; k + 1 < s.corners; ++k) {
            const glm::dvec2 p = on_triangle[k] - on_triangle[0], q = on_triangle[k + 1] - on_triangle[0];
            share += p.x * q.y - p.y * q.x;
        }
        s.flux *= std::abs(share);
        return s;
    }

    void add(const Section& s) {
        if (s.corners < 3) return;
        ledger_.flux_w += s.flux;
        shares_.share(std::span(s.corner.data(), s.corners), [&](int i, int j, double part) {
            const double flux = part * s.flux;
            if (!wrap(i, cells_.x, beams_.boundary.x) || !wrap(j, cells_.y, beams_.boundary.y)) {
                ledger_.outside_w += flux;
                return;
            }
            ledger_.inside_w += flux;
            double* sum = sums_.data() + 2 * (static_cast<std::size_t>(j) * cells_.x + i);
            sum[0] += flux;
            sum[1] += flux * s.path;
        });
    }

    /// Brings a column (row) into the grid; false where it lies beyond a side.
    static bool wrap(int& i, int n, Side side) {
        if (i >= 0 && i < n) return true;
        if (side != Side::periodic) return false;
        i %= n;
        if (i < 0) i += n;
        return true;
    }

    const Beams& beams_;
    glm::ivec3 cells_;
    Landed landed_;
    std::vector<double> sums_;  ///< plane and scalar flux of each cell, W
    CellShares shares_;
    SliceLedger ledger_;
};

}  // namespace

void fit(const Beams&, glm::ivec3 cells, BeamVolume& volume) {
    if (cells.x < 1 || cells.y < 1 || cells.z < 1)
        throw InputError(
            fmt::format("beams: the volume has {} x {} x {} cells; at least 1 each", cells.x, cells.y, cells.z));
    if (volume.cells != cells || volume.plane_irradiance.empty()) {
        volume.cells = cells;
        volume.plane_irradiance = Field<float>(cells.x, cells.y * cells.z);
        volume.scalar_irradiance = Field<float>(cells.x, cells.y * cells.z);
    }
    volume.ledger.assign(cells.z, {});
}

void fill_volume(const Beams& beams, glm::ivec3 cells, BeamVolume& volume) {
    fit(beams, cells, volume);
#pragma omp parallel
    {
        SliceFiller filler(beams, cells);
#pragma omp for schedule(dynamic, 1)
        for (int k = 0; k < cells.z; ++k)
            volume.ledger[k] =
                filler.fill(static_cast<float>(volume.z_m(k, beams.depth_m)), volume.plane_irradiance.row(k * cells.y),
                            volume.scalar_irradiance.row(k * cells.y));
    }
}

}  // namespace waterlight
