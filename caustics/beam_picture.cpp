#include "caustics/beam_picture.hpp"

#include <fmt/format.h>

#include <cmath>

#include "sim/error.hpp"

namespace waterlight {

namespace {

/// Whole periods along one axis that lie within `range` of the eye.
struct Copies {
    int first = 0;
    int last = 0;
    Copies(Side side, double from, double extent, double eye, double range) {
        if (side != Side::periodic) return;
        first = static_cast<int>(std::floor((eye - range - from) / extent));
        last = static_cast<int>(std::floor((eye + range - from) / extent));
    }
};

}  // namespace

void validate(const BeamImageSettings& s, const Beams& beams) {
    const Camera& c = s.camera;
    if (c.size.x < 1 || c.size.y < 1)
        throw InputError(fmt::format("camera: size is {} x {} pixels; at least 1 x 1", c.size.x, c.size.y));
    if (!(c.fov_deg > 0 && c.fov_deg < 180)) throw InputError("camera: fov_deg must be in (0, 180)");
    if (c.position_m == c.target_m) throw InputError("camera: it must not stand on its target");
    if (!(c.position_m.z < beams.highest_m && c.position_m.z > -beams.depth_m))
        throw InputError(fmt::format("camera: its height is {} m; below the surface and above the floor at -{} m",
                                     c.position_m.z, beams.depth_m));
    if (s.samples < 1) throw InputError("camera: samples must be at least 1");
    if (s.reduction < 1) throw InputError("camera: reduction must be at least 1");
    if (!(s.range_m > 0)) throw InputError("camera: range_m must be above 0");
    if (std::abs(s.optics.extinction_per_m() - beams.extinction_per_m) > 1e-12)
        throw InputError("camera: the beams were made for another extinction");
}

std::vector<glm::vec2> copies_in_range(const BeamImageSettings& s, const Beams& beams) {
    const glm::dvec3 eye = Viewpoint(s.camera).eye_m;
    const Grid& g = beams.domain;
    const Copies along_x(beams.boundary.x, g.x0_m, g.width_m(), eye.x, s.range_m);
    const Copies along_y(beams.boundary.y, g.y0_m, g.height_m(), eye.y, s.range_m);
    std::vector<glm::vec2> shifts;
    for (int q = along_y.first; q <= along_y.last; ++q)
        for (int p = along_x.first; p <= along_x.last; ++p) shifts.emplace_back(p * g.width_m(), q * g.height_m());
    return shifts;
}

void resize(const BeamImageSettings& s, BeamImage& image) {
    const glm::ivec2 size = s.camera.size;
    if (image.radiance.nx() != size.x || image.radiance.ny() != size.y) image.radiance = Field<float>(size.x, size.y);
}

}  // namespace waterlight
