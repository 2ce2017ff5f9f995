// The shadows that objects cast on the samples of a floor map whose light is not followed through them: what stands
// between the sun and the surface, or between the surface and where light lands, stops it.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "caustics/floor_frame.hpp"
#include "caustics/kernels/shadow.hpp"
#include "caustics/objects/repeated_objects.hpp"

namespace waterlight {

/// A sample of which some light is stopped.
struct ShadowedSample {
    int column = 0;  ///< counted from the lattice's first
    f64::SampleShadow shadow;
};

/// Those of a lattice, by rows; of each row in order of columns.
struct ShadowRows {
    std::vector<std::vector<ShadowedSample>> rows;  ///< none where nothing is in the way anywhere
    std::span<const ShadowedSample> row(int j) const {
        return rows.empty() ? std::span<const ShadowedSample>() : rows[static_cast<std::size_t>(j)];
    }
    /// Of a sample, if there is one.
    const f64::SampleShadow* of(int column, int row) const;
};

/// Samples of a map's surface: sample (i, j) has the light that enters between pixels (columns.first + i, rows.first +
/// j) and the next, moved by -shift_m, and lands no lower than lowest_m.
struct ShadowLattice {
    FloorPlan plan;
    glm::dvec2 shift_m{0, 0};
    SampleRange columns, rows;
    double lowest_m = 0;
};

/// Where light enters the water, and where it lands.
struct LightWay {
    glm::dvec3 enters_m{0, 0, 0}, lands_m{0, 0, 0};
};

/// Holds the objects between frames.
class ObjectShadows {
  public:
    explicit ObjectShadows(const FloorSettings& settings) : settings_(settings) {}

    /// Of light whose way from a place of the map (pixels) is `way`. Only samples whose light may meet the box of an
    /// object are looked at. Those whose four corners do not agree, and those of objects that few samples see, are cut
    /// in sixteen.
    ShadowRows cast(const Surface& surface, const ShadowLattice& lattice,
                    const std::function<LightWay(glm::dvec2 pixel)>& way);
    /// Of light on the flat floor.
    ShadowRows cast(const Surface& surface, const FloorFrame& frame);

  private:
    const RepeatedObjects& place(const Surface& surface);

    FloorSettings settings_;
    std::optional<RepeatedObjects> objects_;
    Grid grid_;          ///< of the surface for which they were placed
    Boundary boundary_;  ///< likewise
};

}  // namespace waterlight
