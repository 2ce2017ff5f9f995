// The floor map: irradiance on the flat floor z = -depth, by the two-pass receiver-side method of Yuksel & Keyser,
// "Fast Real-time Caustics from Height Fields" (2009), with its additional pass 0 and a footprint of our own.
// caustics/kernels/floor.glsl holds the formulas, floor_cpu.cpp and floor_vulkan.cpp the loops.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string_view>

#include "caustics/light.hpp"
#include "sim/surface.hpp"

namespace waterlight {

class ObjectSet;

/// Where the map lies on the floor: width x height pixels of pitch_m, turned by angle_deg about `origin_m`, the outer
/// corner of pixel (0, 0).
struct FloorPlan {
    int width = 1;
    int height = 1;
    glm::dvec2 origin_m{0, 0};
    glm::dvec2 pitch_m{1, 1};
    double angle_deg = 0;  ///< of the map's x axis, counter-clockwise from the domain's

    /// Unit vectors of the map's axes.
    glm::dvec2 axis_x() const;
    glm::dvec2 axis_y() const;
    /// Position on the floor of map coordinates in pixels; (0.5, 0.5) is the centre of the first pixel.
    glm::dvec2 position_m(glm::dvec2 pixel) const;
    /// The inverse of position_m.
    glm::dvec2 pixel(glm::dvec2 position_m) const;
};

/// The map that covers the grid's domain with width x height pixels.
FloorPlan cover(const Grid& grid, int width, int height);

/// How far from its rest position light is followed: N samples along the map's x, M + 1 = channels along its y.
struct FloorWindow {
    int samples = 7;   ///< N, odd, >= 1
    int channels = 7;  ///< M + 1, odd, >= 1
    bool operator==(const FloorWindow&) const = default;
};

/// Over what of the floor a sample's light is spread.
enum class Footprint {
    adaptive,  ///< the parallelogram on which it lands, from the derivatives of the landing map: converges
    pixel      ///< a pixel, as in the paper: does not
};

struct FloorSettings {
    FloorPlan plan;
    Footprint footprint = Footprint::adaptive;
    int samples_per_pixel = 1;          ///< along each axis, >= 1
    std::optional<FloorWindow> window;  ///< in samples; none: auto, the least that loses nothing of the surface at hand
    double depth_m = 1;                 ///< floor at z = -depth, > 0
    Sun sun;
    WaterOptics optics;
    double wavelength_nm = 587.6;  ///< of the light, which glass feels; the water's part is in `optics`
    /// What is in the light's way; none: nothing. Methods that do not follow light through glass or off mirrors stop it
    /// there. Where they are is taken from the surface's time.
    std::shared_ptr<const ObjectSet> objects;
};

/// Where the light of one map went, in watts, over the samples that lie in the domain (periodic sides: over one copy of
/// each). incident + entered = reflected + extinguished + floor + objects + outside + lost.
struct FloorLedger {
    double incident_w = 0;
    double reflected_w = 0;
    double extinguished_w = 0;  ///< absorbed or scattered on the way down
    double floor_w = 0;         ///< on the map, summed over its pixels
    double outside_w = 0;       ///< landed beyond the map: walls, or floor the map does not cover
    double lost_w = 0;          ///< landed beyond the window
    double objects_w = 0;       ///< stopped by objects
    double entered_w = 0;       ///< landed on the map from beyond the domain
    /// |what is unaccounted for| / (incident + entered); 0 where there is no light.
    double closure() const;
};

struct FloorMap {
    Field<float> irradiance;  ///< W/m2 on the horizontal floor, averaged over each pixel
    FloorWindow window;       ///< as used
    FloorLedger ledger;
};

/// A back-end of the floor map. Holds its buffers between frames.
class FloorMapper {
  public:
    virtual ~FloorMapper() = default;
    virtual std::string_view backend() const = 0;
    /// The map of one surface. `map` is reused where its size fits.
    virtual void compute(const Surface& surface, FloorMap& map) = 0;
};

/// Throws InputError where a setting is out of its range.
std::unique_ptr<FloorMapper> make_floor_cpu(const FloorSettings& settings);

}  // namespace waterlight
