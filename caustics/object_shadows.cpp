#include "caustics/object_shadows.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "caustics/surface_point.hpp"
#include "caustics/truth_ray.hpp"

namespace waterlight {

const f64::SampleShadow* ShadowRows::of(int column, int at_row) const {
    const auto all = row(at_row);
    const auto found = std::ranges::lower_bound(all, column, {}, &ShadowedSample::column);
    return found != all.end() && found->column == column ? &found->shadow : nullptr;
}

namespace {

/// Samples [low, high) that an object may darken; `few`: too few to trust their corners.
struct Region {
    glm::ivec2 low{0, 0}, high{0, 0};
    bool few = false;
};

/// Horizontal metres that light goes per metre of descent, least and most.
struct Travel {
    glm::dvec2 least{0, 0}, most{0, 0};
};

/// Where objects can darken what: from the bounds of the surface and of the ways of light under it.
class ShadowReach {
  public:
    ShadowReach(const FloorSettings& settings, const Surface& surface, const ShadowLattice& lattice)
        : lattice_(lattice), sun_(settings.sun.direction()) {
        bound_lattice();
        bound_heights(surface);
        bound_travel(settings, surface);
    }

    void add_regions(const RepeatedObjects& objects, int object, std::vector<Region>& regions) const {
        const double low = objects.placed().low_m(object).z, high = objects.placed().high_m(object).z;
        // Light meets it this far above the surface, and this far below.
        if (high > lowest_water_m_) {
            const glm::dvec2 per_rise = glm::dvec2(sun_) / -sun_.z;
            add_region(objects, object, {std::max(0.0, low - highest_water_m_), high - lowest_water_m_},
                       {per_rise, per_rise}, regions);
        }
        if (low < highest_water_m_ && high > lattice_.lowest_m)
            add_region(objects, object,
                       {std::max(0.0, lowest_water_m_ - high), highest_water_m_ - std::max(low, lattice_.lowest_m)},
                       {-travel_.most, -travel_.least}, regions);
    }

  private:
    struct Heights {
        double least, most;
    };

    void bound_lattice() {
        const glm::dvec2 first(lattice_.columns.first, lattice_.rows.first),
            size(lattice_.columns.count, lattice_.rows.count);
        low_m_ = glm::dvec2(1e300);
        high_m_ = -low_m_;
        for (const glm::dvec2 corner : {glm::dvec2{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
            const glm::dvec2 at = lattice_.plan.position_m(first + corner * size) - lattice_.shift_m;
            low_m_ = glm::min(low_m_, at);
            high_m_ = glm::max(high_m_, at);
        }
    }

    void bound_heights(const Surface& surface) {
        const auto [low, high] = std::ranges::minmax_element(surface.elevation.values());
        // Still water beyond absorbing sides; tilted water goes on climbing.
        const Grid& g = surface.grid;
        const glm::dvec2 from(g.x0_m, g.y0_m), to = from + glm::dvec2{g.width_m(), g.height_m()};
        const double climb =
            glm::dot(glm::abs(surface.tilt), glm::max(glm::dvec2(0, 0), glm::max(from - low_m_, high_m_ - to)));
        lowest_water_m_ = std::min<double>(*low, 0) - climb;
        highest_water_m_ = std::max<double>(*high, 0) + climb;
    }

    void bound_travel(const FloorSettings& settings, const Surface& surface) {
        const f32::real3 sun(sun_);
        const auto n = static_cast<float>(settings.optics.refractive_index);
        const f32::real2 still = f32::refract_sun(sun, {0, 0}, n, 1).travel;
        const float* slope_x = surface.slope_x.data();
        const float* slope_y = surface.slope_y.data();
        const auto cells = static_cast<std::ptrdiff_t>(surface.grid.cells());
        float stray_x = 0, stray_y = 0;
#pragma omp parallel for simd schedule(static) reduction(max : stray_x, stray_y)
        for (std::ptrdiff_t i = 0; i < cells; ++i) {
            const f32::real2 travel = f32::refract_sun(sun, {slope_x[i], slope_y[i]}, n, 1).travel;
            stray_x = f32::max(stray_x, f32::abs(travel.x - still.x));
            stray_y = f32::max(stray_y, f32::abs(travel.y - still.y));
        }
        // More, for what a wall's mirror makes of slopes and for what is between cells.
        const glm::dvec2 stray = 1.2 * glm::dvec2{stray_x, stray_y} + 1e-6;
        travel_ = {glm::dvec2(still) - stray, glm::dvec2(still) + stray};
    }

    /// Of the surface whose light passes an object's box at these heights from it, from where it lies `aside` metres
    /// for each metre of height.
    void add_region(const RepeatedObjects& objects, int object, Heights heights, const Travel& aside,
                    std::vector<Region>& regions) const {
        const glm::dvec2 a = heights.least * aside.least, b = heights.most * aside.least,
                         c = heights.least * aside.most, d = heights.most * aside.most;
        const glm::dvec2 least = glm::min(glm::min(a, b), glm::min(c, d)),
                         most = glm::max(glm::max(a, b), glm::max(c, d));
        const glm::dvec2 low = glm::dvec2(objects.placed().low_m(object)) + least,
                         high = glm::dvec2(objects.placed().high_m(object)) + most;
        const RepeatedObjects::Shifts shifts = objects.shifts(object, low_m_ - most, high_m_ - least);
        for (int q = shifts.first.y; q <= shifts.last.y; ++q)
            for (int p = shifts.first.x; p <= shifts.last.x; ++p) {
                const glm::dvec2 shift = glm::dvec2(p, q) * objects.period_m();
                const Region region = samples(low + shift, high + shift);
                if (region.low.x < region.high.x && region.low.y < region.high.y) regions.push_back(region);
            }
    }

    Region samples(glm::dvec2 low_m, glm::dvec2 high_m) const {
        glm::dvec2 low(1e300), high(-1e300);
        for (const glm::dvec2 at : {low_m, {high_m.x, low_m.y}, high_m, {low_m.x, high_m.y}}) {
            const glm::dvec2 pixel =
                lattice_.plan.pixel(at + lattice_.shift_m) - glm::dvec2(lattice_.columns.first, lattice_.rows.first);
            low = glm::min(low, pixel);
            high = glm::max(high, pixel);
        }
        constexpr double few = 64;
        const glm::dvec2 count(lattice_.columns.count, lattice_.rows.count), zero(0, 0);
        return {glm::ivec2(glm::floor(glm::clamp(low, zero, count))),
                glm::ivec2(glm::ceil(glm::clamp(high, zero, count))), (high.x - low.x) * (high.y - low.y) < few};
    }

    const ShadowLattice& lattice_;
    glm::dvec3 sun_;
    glm::dvec2 low_m_{0, 0}, high_m_{0, 0};  ///< where the lattice's light enters
    double lowest_water_m_ = 0, highest_water_m_ = 0;
    Travel travel_;
};

/// What becomes of the light of one place.
struct Fate {
    enum class Where { lands, above, below };
    Where where = Where::lands;
    double left = 0;  ///< of light that is stopped below: after the water's extinction
};

class ShadowCaster {
  public:
    ShadowCaster(const FloorSettings& settings, const RepeatedObjects& objects, const ShadowLattice& lattice,
                 const std::function<LightWay(glm::dvec2)>& way, std::vector<Region> regions)
        : objects_(objects),
          lattice_(lattice),
          way_(way),
          regions_(std::move(regions)),
          sun_(settings.sun.direction()),
          extinction_(settings.optics.extinction_per_m()) {}

    /// Rows [begin, end).
    void cast(int begin, int end, ShadowRows& shadows) const {
        const int count = lattice_.columns.count;
        std::vector<unsigned char> marks(static_cast<std::size_t>(count), none);
        if (!mark(begin, end, marks)) return;
        std::vector<Fate> low(static_cast<std::size_t>(count) + 1), high = low;
        corner_row(begin, marks, high);
        for (int j = begin; j < end; ++j) {
            std::swap(low, high);
            corner_row(j + 1, marks, high);
            for (int i = 0; i < count; ++i) {
                if (marks[i] == none) continue;
                const std::array corners{low[i], low[i + 1], high[i], high[i + 1]};
                const bool agree = std::ranges::all_of(corners, [&](Fate f) { return f.where == corners[0].where; });
                const f64::SampleShadow shadow = agree && marks[i] == some ? mean_of(corners) : cut(i, j);
                if (shadow.above + shadow.below > 0) shadows.rows[static_cast<std::size_t>(j)].push_back({i, shadow});
            }
        }
    }

  private:
    static constexpr unsigned char none = 0, some = 1, few = 2;

    /// Marks the columns in which there is something to look at.
    bool mark(int begin, int end, std::vector<unsigned char>& marks) const {
        bool any = false;
        for (const Region& r : regions_) {
            if (r.high.y <= begin || r.low.y >= end) continue;
            any = true;
            for (int i = r.low.x; i < r.high.x; ++i) marks[i] = std::max(marks[i], r.few ? few : some);
        }
        return any;
    }

    void corner_row(int j, const std::vector<unsigned char>& marks, std::vector<Fate>& fates) const {
        const int count = lattice_.columns.count;
        for (int i = 0; i <= count; ++i) {
            const bool wanted = (i < count && marks[i] != none) || (i > 0 && marks[i - 1] != none);
            if (wanted) fates[i] = fate({i, j});
        }
    }

    Fate fate(glm::dvec2 place) const {
        const LightWay way = way_(glm::dvec2(lattice_.columns.first, lattice_.rows.first) + place);
        const double rise = objects_.placed().high_m().z - way.enters_m.z;
        constexpr double near = 1e-7;
        if (rise > 0 && objects_.first_hit({way.enters_m, -sun_, near, rise / -sun_.z + near}))
            return {Fate::Where::above, 0};
        const glm::dvec3 down = way.lands_m - way.enters_m;
        const double length = glm::length(down);
        if (length <= 2 * near) return {};
        const auto hit = objects_.first_hit({way.enters_m, down / length, near, length - near});
        return hit ? Fate{Fate::Where::below, f64::beer_lambert(extinction_, hit->distance_m)} : Fate{};
    }

    template <class Fates>
    static f64::SampleShadow mean_of(const Fates& fates) {
        f64::SampleShadow sum{0, 0, 0};
        const double each = 1 / static_cast<double>(fates.size());
        for (const Fate& f : fates) {
            sum.above += f.where == Fate::Where::above ? each : 0;
            sum.below += f.where == Fate::Where::below ? each : 0;
            sum.stopped += f.where == Fate::Where::below ? each * f.left : 0;
        }
        return sum;
    }

    f64::SampleShadow cut(int i, int j) const {
        constexpr int parts = 4;
        std::array<Fate, static_cast<std::size_t>(parts * parts)> fates;
        for (int k = 0; k < parts * parts; ++k)
            fates[k] = fate(glm::dvec2(i, j) + glm::dvec2(k % parts + 0.5, k / parts + 0.5) / double(parts));
        return mean_of(fates);
    }

    const RepeatedObjects& objects_;
    const ShadowLattice& lattice_;
    const std::function<LightWay(glm::dvec2)>& way_;
    std::vector<Region> regions_;
    glm::dvec3 sun_;
    double extinction_;
};

}  // namespace

const RepeatedObjects& ObjectShadows::place(const Surface& surface) {
    const bool still = objects_ && !settings_.objects->moves() && grid_ == surface.grid &&
                       boundary_.x == surface.boundary.x && boundary_.y == surface.boundary.y;
    if (!still) objects_.emplace(settings_.objects, surface.time_s, surface.grid, surface.boundary);
    grid_ = surface.grid;
    boundary_ = surface.boundary;
    return *objects_;
}

ShadowRows ObjectShadows::cast(const Surface& surface, const ShadowLattice& lattice,
                               const std::function<LightWay(glm::dvec2)>& way) {
    ShadowRows shadows;
    if (!settings_.objects || settings_.objects->empty() || !(settings_.sun.elevation_deg > 0)) return shadows;
    const RepeatedObjects& objects = place(surface);
    const ShadowReach reach(settings_, surface, lattice);
    std::vector<Region> regions;
    for (int k = 0; k < objects.placed().count(); ++k) reach.add_regions(objects, k, regions);
    if (regions.empty()) return shadows;

    shadows.rows.resize(static_cast<std::size_t>(lattice.rows.count));
    const ShadowCaster caster(settings_, objects, lattice, way, std::move(regions));
    constexpr int band = 16;
    const int bands = (lattice.rows.count + band - 1) / band;
#pragma omp parallel for schedule(dynamic, 1)
    for (int b = 0; b < bands; ++b) caster.cast(b * band, std::min(lattice.rows.count, (b + 1) * band), shadows);
    return shadows;
}

ShadowRows ObjectShadows::cast(const Surface& surface, const FloorFrame& frame) {
    if (!settings_.objects) return {};
    const TruthSurface truth{surface.grid, surface.boundary, [&](glm::dvec2 at) { return surface_point(surface, at); }};
    const TruthCaster caster(settings_, truth);
    const glm::dvec2 shift = settings_.plan.origin_m - entry_m(frame, settings_, {0, 0});
    const ShadowLattice lattice{settings_.plan, shift, frame.columns, frame.rows, -settings_.depth_m};
    return cast(surface, lattice, [&](glm::dvec2 pixel) {
        const TruthRay ray = caster.cast(entry_m(frame, settings_, pixel));
        return LightWay{ray.start_m, glm::dvec3(ray.floor_m, -settings_.depth_m)};
    });
}

}  // namespace waterlight
