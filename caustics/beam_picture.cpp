#include "caustics/beam_picture.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "caustics/beam_enlarge.hpp"
#include "caustics/beam_outline.hpp"
#include "caustics/objects/repeated_objects.hpp"
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
struct AllBeams {
    glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};
    AllBeams(const Beams& b, glm::dvec3 eye) {
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

namespace {

/// Objects in the world of the beams, for rays of a picture.
class SeenObjects {
  public:
    SeenObjects(const BeamImageSettings& s, const Beams& beams)
        : objects_(s.objects, beams.time_s, beams.domain, beams.boundary), mirrored_(beams.mirrored) {}

    /// What a ray meets first; places and directions of the beams' world.
    std::optional<ObjectHit> first_hit(glm::dvec3 from, glm::dvec3 direction, double farthest) const {
        return objects_.first_hit(
            {.from_m = world(from), .direction = world(direction), .nearest_m = 0, .farthest_m = farthest});
    }
    /// Whether a place is within an object: whatever a ray from there meets first, it leaves.
    const Object* around(glm::dvec3 place, double farthest) const {
        const glm::dvec3 up{0, 0, 1};
        const auto hit = first_hit(place, up, farthest);
        return hit && glm::dot(world(up), hit->normal) > 0 ? &objects_.placed().object(hit->object) : nullptr;
    }

  private:
    glm::dvec3 world(glm::dvec3 v) const { return mirrored_ ? Camera::flipped(v) : v; }

    RepeatedObjects objects_;
    bool mirrored_;
};

/// The t at which each pixel's ray first meets an object before the range, else that of the range.
Field<float> object_reach(const BeamImageSettings& s, const Beams& beams) {
    const Viewpoint view(s.camera);
    const SeenObjects objects(s, beams);
    if (const Object* around = objects.around(view.eye_m, s.range_m))
        throw InputError(fmt::format("camera: it stands in the object \"{}\"; outside of objects", around->name));
    Field<float> reach(s.camera.size.x, s.camera.size.y);
#pragma omp parallel for schedule(dynamic, 4)
    for (int j = 0; j < s.camera.size.y; ++j)
        for (int i = 0; i < s.camera.size.x; ++i) {
            const glm::dvec3 r = view.rays.at(i, j);
            const double length = glm::length(r);
            const auto hit = objects.first_hit(view.eye_m, r / length, s.range_m);
            reach(i, j) = static_cast<float>((hit ? hit->distance_m : s.range_m) / length);
        }
    return reach;
}

}  // namespace

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
    const AllBeams whole(beams, view.eye_m);
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

Field<float> picture_reach(const BeamImageSettings& s, const Beams& beams) {
    Field<float> reach = s.ground ? ground_reach(s.camera, *s.ground, s.range_m) : Field<float>();
    if (!s.objects || s.objects->empty()) return reach;
    Field<float> to_objects = object_reach(s, beams);
    for (std::size_t i = 0; i < reach.size(); ++i)
        to_objects.data()[i] = std::min(to_objects.data()[i], reach.data()[i]);
    return to_objects;
}

void resize(const BeamImageSettings& s, BeamImage& image) {
    const glm::ivec2 size = s.camera.size;
    if (image.radiance.nx() != size.x || image.radiance.ny() != size.y) image.radiance = Field<float>(size.x, size.y);
}

namespace {

/// The whole beams, and the pieces of the others.
void draw_parts(const BeamImageSettings& s, const Beams& beams, const DrawAll& draw, BeamImage& image) {
    const Field<float> reach = picture_reach(s, beams);
    draw(s, beams, reach, image);
    if (!beams.pieces) return;
    BeamImage more;
    draw(s, beams.pieces->beams, reach, more);
    add(more, image);
}

}  // namespace

void add(const BeamImage& more, BeamImage& image) {
    std::int64_t covered = 0;
    for (std::size_t i = 0; i < image.radiance.size(); ++i) {
        image.radiance.data()[i] += more.radiance.data()[i];
        covered += image.radiance.data()[i] > 0 ? 1 : 0;
    }
    image.counts.beams += more.counts.beams;
    image.counts.sections += more.counts.sections;
    image.counts.covered_pixels = covered;
}

void draw_reduced(const BeamImageSettings& settings, const Beams& beams, const DrawAll& draw, BeamImage& image) {
    if (settings.reduction == 1) return draw_parts(settings, beams, draw, image);
    BeamImageSettings fewer = settings;
    fewer.camera = reduced(settings.camera, settings.reduction);
    fewer.reduction = 1;
    BeamImage coarse;
    draw_parts(fewer, beams, draw, coarse);
    image.counts = coarse.counts;
    resize(settings, image);
    enlarge(settings, beams, coarse.radiance, image.radiance);
}

}  // namespace waterlight
