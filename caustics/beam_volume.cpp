#include "caustics/beam_volume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <optional>

#include "caustics/beam_pieces.hpp"
#include "caustics/cell_shares.hpp"
#include "caustics/cut_triangle.hpp"
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
    std::array<glm::dvec2, CutTriangle::most_corners> corner;
    int corners = 0;
    double flux = 0;  ///< W through the horizontal section
    double path = 1;  ///< of flux through a plane that faces the light for each of it
};

/// The ground in the middle of each column of a volume.
Field<float> ground_under(const BeamGround& ground, const Grid& domain, glm::ivec3 cells) {
    const glm::dvec2 corner{domain.x0_m, domain.y0_m};
    const glm::dvec2 pitch = glm::dvec2{domain.width_m(), domain.height_m()} / glm::dvec2(cells);
    Field<float> heights(cells.x, cells.y);
    for (int j = 0; j < cells.y; ++j)
        for (int i = 0; i < cells.x; ++i)
            heights(i, j) = static_cast<float>(ground.height_m(corner + pitch * glm::dvec2{i + 0.5, j + 0.5}));
    return heights;
}

/// The sections of beams at one depth after another.
class BeamSections {
  public:
    BeamSections(const Beams& beams, glm::ivec3 cells)
        : beams_(beams), cells_(cells), landed_(beams.nx + 1, beams.ny + 1) {}

    /// Calls take(section) for all that carry light.
    template <class Take>
    void at(float z, Take take) {
        land(z);
        for (int j = 0; j < beams_.ny; ++j)
            for (int b = 0; b < 2 * beams_.nx; ++b)
                if (beams_.flux(b, j) > 0) take(section(b, j, z));
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
        int entered = 0, going_on = 0;
        for (int k = 0; k < 3; ++k) {
            const auto [i, row] = std::pair(at[k].x, at[k].y);
            s.corner[k] = {landed_.x(i, row), landed_.y(i, row)};
            remaining += landed_.remaining(i, row) / 3;
            s.path += beams_.path(i, row) / 3;
            entered += beams_.z(i, row) >= z ? 1 : 0;
            going_on += beams_.end_z(i, row) <= z ? 1 : 0;
        }
        s.flux *= remaining;
        if (entered == 3 && going_on == 3) return s;
        if (entered == 0 || going_on == 0) return {};
        return cut(s, at, z);
    }

    /// The part of a section whose light has entered the water above z and ends below: cut where the surface, and where
    /// the light's end, is at z.
    Section cut(const Section& whole, const std::array<glm::ivec2, 3>& at, float z) const {
        CutTriangle part;
        for (int k = 0; k < 3; ++k) {
            const double above = beams_.z(at[k].x, at[k].y) - z, below = z - beams_.end_z(at[k].x, at[k].y);
            part.add({CutTriangle::corners[k], {above, below}});
        }
        part = part.where_positive(0).where_positive(1);
        Section s = whole;
        s.corners = part.count;
        for (int k = 0; k < part.count; ++k) {
            const glm::dvec2 p = part.corner[k].at;
            s.corner[k] =
                whole.corner[0] + p.x * (whole.corner[1] - whole.corner[0]) + p.y * (whole.corner[2] - whole.corner[0]);
        }
        s.flux *= part.share();
        return s;
    }

    const Beams& beams_;
    glm::ivec3 cells_;
    Landed landed_;
};

/// One slice after another, by one thread.
class SliceFiller {
  public:
    SliceFiller(const Beams& beams, glm::ivec3 cells)
        : beams_(beams),
          cells_(cells),
          whole_(beams, cells),
          sums_(2 * static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y)) {
        if (beams.pieces) pieces_.emplace(beams.pieces->beams, cells);
    }

    /// `ledger` keeps what objects stopped.
    void fill(float z, float* plane, float* scalar, SliceLedger& ledger) {
        std::fill(sums_.begin(), sums_.end(), 0.0);
        ledger_ = {.objects_w = ledger.objects_w};
        const auto take = [this](const Section& s) { add(s); };
        whole_.at(z, take);
        if (pieces_) pieces_->at(z, take);
        const double per_area =
            cells_.x * static_cast<double>(cells_.y) / (beams_.domain.width_m() * beams_.domain.height_m());
        for (std::size_t i = 0; i < sums_.size() / 2; ++i) {
            plane[i] = static_cast<float>(sums_[2 * i] * per_area);
            scalar[i] = static_cast<float>(sums_[2 * i + 1] * per_area);
        }
        ledger = ledger_;
    }

  private:
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
    BeamSections whole_;
    std::optional<BeamSections> pieces_;
    std::vector<double> sums_;  ///< plane and scalar flux of each cell, W
    CellShares shares_;
    SliceLedger ledger_;
};

/// Of light that objects stopped above z what would pass there.
double stopped_above(const BeamPieces& pieces, double z) {
    double sum = 0;
    for (std::size_t k = 0; k < pieces.of.size(); ++k) {
        if (!pieces.stopped[k]) continue;
        const int b = 4 * static_cast<int>(k);
        CutTriangle part;
        double remaining = 0;
        const BeamTriangle corner = triangle_of(pieces.beams, b, 0);
        for (int n = 0; n < 3; ++n) {
            const double descent = corner[n].at_m.z - z;
            part.add({CutTriangle::corners[n], {descent, corner[n].end_z - z}});
            remaining += f64::beer_lambert(pieces.beams.extinction_per_m, std::max(0.0, descent) * corner[n].path) / 3;
        }
        sum += pieces.beams.flux(b, 0) * remaining * part.where_positive(0).where_positive(1).share();
    }
    return sum;
}

}  // namespace

void fit(const Beams& beams, glm::ivec3 cells, BeamVolume& volume) {
    if (cells.x < 1 || cells.y < 1 || cells.z < 1)
        throw InputError(
            fmt::format("beams: the volume has {} x {} x {} cells; at least 1 each", cells.x, cells.y, cells.z));
    if (volume.cells != cells || volume.plane_irradiance.empty()) {
        volume.cells = cells;
        volume.plane_irradiance = Field<float>(cells.x, cells.y * cells.z);
        volume.scalar_irradiance = Field<float>(cells.x, cells.y * cells.z);
    }
    volume.depth_m = beams.depth_m;
    volume.ground_m = beams.ground ? ground_under(*beams.ground, beams.domain, cells) : Field<float>();
    volume.ledger.assign(cells.z, {});
    if (!beams.pieces) return;
    for (int k = 0; k < cells.z; ++k) volume.ledger[k].objects_w = stopped_above(*beams.pieces, volume.z_m(k));
}

void add(const BeamVolume& more, BeamVolume& volume) {
    const auto add_field = [](const Field<float>& from, Field<float>& to) {
        for (std::size_t i = 0; i < to.size(); ++i) to.data()[i] += from.data()[i];
    };
    add_field(more.plane_irradiance, volume.plane_irradiance);
    add_field(more.scalar_irradiance, volume.scalar_irradiance);
    for (std::size_t k = 0; k < volume.ledger.size(); ++k) {
        volume.ledger[k].flux_w += more.ledger[k].flux_w;
        volume.ledger[k].inside_w += more.ledger[k].inside_w;
        volume.ledger[k].outside_w += more.ledger[k].outside_w;
    }
}

void fill_volume(const Beams& beams, glm::ivec3 cells, BeamVolume& volume) {
    fit(beams, cells, volume);
#pragma omp parallel
    {
        SliceFiller filler(beams, cells);
#pragma omp for schedule(dynamic, 1)
        for (int k = 0; k < cells.z; ++k)
            filler.fill(static_cast<float>(volume.z_m(k)), volume.plane_irradiance.row(k * cells.y),
                        volume.scalar_irradiance.row(k * cells.y), volume.ledger[k]);
    }
}

}  // namespace waterlight
