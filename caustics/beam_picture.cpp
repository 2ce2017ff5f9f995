#include "caustics/beam_picture.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "caustics/beam_enlarge.hpp"
#include "caustics/beam_outline.hpp"
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

/// The box of all beams, relative to the eye.
struct Box {
    glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};
    Box(const Beams& b, glm::dvec3 eye) {
        for (std::size_t i = 0; i < b.z.size(); ++i) {
            const glm::vec3 top{b.x.data()[i], b.y.data()[i], b.z.data()[i]};
            const float descent = std::max(0.0F, top.z - b.end_z.data()[i]);
            const glm::vec3 end = top + descent * glm::vec3{b.travel_x.data()[i], b.travel_y.data()[i], -1};
            low = glm::min(low, glm::min(top, end));
            high = glm::max(high, glm::max(top, end));
        }
        low -= glm::vec3(eye);
        high -= glm::vec3(eye);
    }
    std::array<glm::vec3, 8> moved(glm::vec2 shift) const {
        std::array<glm::vec3, 8> corner;
        for (int k = 0; k < 8; ++k)
            corner[k] = {((k & 1) != 0 ? high.x : low.x) + shift.x, ((k & 2) != 0 ? high.y : low.y) + shift.y,
                         (k & 4) != 0 ? high.z : low.z};
        return corner;
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
    if (s.ground && !(s.ground->step_m > 0)) throw InputError("camera: the step over the ground must be above 0 m");
    if (s.ground && !(c.position_m.z > s.ground->height_m(glm::dvec2(c.position_m))))
        throw InputError(fmt::format("camera: its height is {} m; above the ground at {} m", c.position_m.z,
                                     s.ground->height_m(glm::dvec2(c.position_m))));
    if (s.samples < 1) throw InputError("camera: samples must be at least 1");
    if (s.reduction < 1) throw InputError("camera: reduction must be at least 1");
    if (!(s.range_m > 0)) throw InputError("camera: range_m must be above 0");
    if (std::abs(s.optics.extinction_per_m() - beams.extinction_per_m) > 1e-12)
        throw InputError("camera: the beams were made for another extinction");
}

bool in_range(std::span<const glm::vec3, 8> corners, double range_m) {
    glm::vec3 low = corners[0], high = corners[0];
    for (const glm::vec3& p : corners) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const glm::vec3 nearest = glm::clamp(glm::vec3{0, 0, 0}, low, high);
    const float range = static_cast<float>(range_m);
    return glm::dot(nearest, nearest) <= range * range;
}

std::vector<glm::vec2> copies_in_sight(const BeamImageSettings& s, const Beams& beams) {
    const Viewpoint view(s.camera);
    const Grid& g = beams.domain;
    const Box whole(beams, view.eye_m);
    const Copies along_x(beams.boundary.x, g.x0_m, g.width_m(), view.eye_m.x, s.range_m);
    const Copies along_y(beams.boundary.y, g.y0_m, g.height_m(), view.eye_m.y, s.range_m);
    std::vector<glm::vec2> shifts;
    for (int q = along_y.first; q <= along_y.last; ++q) {
        for (int p = along_x.first; p <= along_x.last; ++p) {
            const glm::vec2 shift{p * g.width_m(), q * g.height_m()};
            const std::array<glm::vec3, 8> corners = whole.moved(shift);
            if (in_range(corners, s.range_m) && in_frame(BeamOutline(view.rays, corners), s.camera.size))
                shifts.push_back(shift);
        }
    }
    return shifts;
}

Field<float> ground_reach(const BeamImageSettings& s) {
    return s.ground ? ground_reach(s.camera, *s.ground, s.range_m) : Field<float>();
}

void resize(const BeamImageSettings& s, BeamImage& image) {
    const glm::ivec2 size = s.camera.size;
    if (image.radiance.nx() != size.x || image.radiance.ny() != size.y) image.radiance = Field<float>(size.x, size.y);
}

void draw_reduced(const BeamImageSettings& settings, const Beams& beams, const DrawAll& draw, BeamImage& image) {
    if (settings.reduction == 1) return draw(settings, image);
    BeamImageSettings fewer = settings;
    fewer.camera = reduced(settings.camera, settings.reduction);
    fewer.reduction = 1;
    BeamImage coarse;
    draw(fewer, coarse);
    image.counts = coarse.counts;
    resize(settings, image);
    enlarge(settings, beams, coarse.radiance, image.radiance);
}

}  // namespace waterlight
