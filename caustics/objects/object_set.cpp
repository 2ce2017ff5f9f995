#include "caustics/objects/object_set.hpp"

#include <algorithm>
#include <cmath>

#include "caustics/objects/embree.hpp"
#include "caustics/objects/shape_hits.hpp"
#include "caustics/objects/triangle_scene.hpp"

namespace waterlight {

namespace {

/// A shape made ready to be met.
struct ReadyShape {
    const Shape* shape;
    std::vector<ProfileEdge> profile;        ///< of one of revolution
    std::optional<TriangleScene> triangles;  ///< of a mesh

    void meet(const Ray& ray, NearestHit& nearest) const {
        if (triangles) return meet_triangles(ray, nearest);
        if (!profile.empty()) return waterlight::meet(profile, ray, nearest);
        if (const auto* sphere = std::get_if<Sphere>(shape)) return waterlight::meet(*sphere, ray, nearest);
        if (const auto* box = std::get_if<Box>(shape)) return waterlight::meet(*box, ray, nearest);
    }

  private:
    void meet_triangles(Ray ray, NearestHit& nearest) const {
        ray.farthest_m = nearest.distance_m;
        const auto hit = triangles->first_hit(ray);
        if (!hit) return;
        const Mesh& mesh = std::get<Mesh>(*shape);
        if (mesh.normals.empty()) return nearest.offer(hit->distance_m, ray, hit->normal);
        const glm::ivec3 t = mesh.triangles[static_cast<std::size_t>(hit->triangle)];
        glm::dvec3 smooth{0, 0, 0};
        for (int k = 0; k < 3; ++k) smooth += hit->shares[k] * mesh.normals[static_cast<std::size_t>(t[k])];
        nearest.offer(hit->distance_m, ray, glm::normalize(smooth));
    }
};

/// An object where it is.
struct Placed {
    const ReadyShape* shape;
    glm::dvec3 centre_m;
    glm::dmat3 turn;
    glm::dvec3 low_m, high_m;
};

Placed place(const Object& object, const ReadyShape& shape, double time_s) {
    Placed p{&shape, object.centre_at(time_s), object.turn(), {}, {}};
    const ShapeBox box = box_of(object.shape);
    glm::dvec3 half{0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) half += glm::abs(p.turn[axis]) * box.half_m[axis];
    const glm::dvec3 middle = p.centre_m + p.turn * box.middle_m;
    p.low_m = middle - half;
    p.high_m = middle + half;
    return p;
}

/// A ray's search, as Embree's callback sees it: the context comes first.
struct Search {
    RTCIntersectContext context;
    const Ray* ray;
    ObjectHit nearest;
    bool met;
};

void meet(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto& search = *reinterpret_cast<Search*>(args->context);
    const auto& placed = static_cast<const Placed*>(args->geometryUserPtr)[args->primID];
    // Turning back is the transpose.
    Ray own = *search.ray;
    own.from_m = (own.from_m - placed.centre_m) * placed.turn;
    own.direction = own.direction * placed.turn;
    NearestHit nearest{search.nearest.distance_m};
    placed.shape->meet(own, nearest);
    if (!nearest.met) return;
    search.nearest = {nearest.distance_m, placed.turn * nearest.normal, static_cast<int>(args->primID)};
    search.met = true;
    RTCRayN_tfar(RTCRayHitN_RayN(args->rayhit, args->N), args->N, 0) = static_cast<float>(nearest.distance_m);
}

void bounds(const RTCBoundsFunctionArguments* args) {
    const auto& placed = static_cast<const Placed*>(args->geometryUserPtr)[args->primID];
    // Wider than rounding to single precision, of the box and of rays.
    const double size = glm::length(glm::max(glm::abs(placed.low_m), glm::abs(placed.high_m)));
    const double more = 1e-5 * (1 + size);
    args->bounds_o->lower_x = static_cast<float>(placed.low_m.x - more);
    args->bounds_o->lower_y = static_cast<float>(placed.low_m.y - more);
    args->bounds_o->lower_z = static_cast<float>(placed.low_m.z - more);
    args->bounds_o->upper_x = static_cast<float>(placed.high_m.x + more);
    args->bounds_o->upper_y = static_cast<float>(placed.high_m.y + more);
    args->bounds_o->upper_z = static_cast<float>(placed.high_m.z + more);
}

}  // namespace

struct ObjectSet::Shapes {
    std::vector<ReadyShape> all;
};

ObjectSet::ObjectSet(std::vector<Object> objects) : objects_(std::move(objects)), shapes_(new Shapes) {
    for (const Object& object : objects_) {
        validate(object);
        ReadyShape ready{&object.shape, profile_of(object.shape), std::nullopt};
        if (const auto* mesh = std::get_if<Mesh>(&object.shape))
            ready.triangles.emplace(mesh->corners_m, mesh->triangles);
        shapes_->all.push_back(std::move(ready));
    }
}

ObjectSet::~ObjectSet() = default;

bool ObjectSet::moves() const {
    return std::ranges::any_of(objects_, [](const Object& object) { return object.path.size() > 1; });
}

struct PlacedObjects::Top {
    std::vector<Placed> placed;
    embree::Device device;
    embree::Scene scene;
};

PlacedObjects::PlacedObjects(std::shared_ptr<const ObjectSet> set, double time_s) : set_(std::move(set)) {
    if (!set_ || set_->empty()) return;
    top_ = std::make_unique<Top>();
    for (std::size_t k = 0; k < set_->objects().size(); ++k)
        top_->placed.push_back(place(set_->objects()[k], set_->shapes_->all[k], time_s));
    low_m_ = top_->placed.front().low_m;
    high_m_ = top_->placed.front().high_m;
    for (const Placed& p : top_->placed) {
        low_m_ = glm::min(low_m_, p.low_m);
        high_m_ = glm::max(high_m_, p.high_m);
    }
    top_->device = embree::make_device();
    top_->scene.reset(rtcNewScene(top_->device.get()));
    rtcSetSceneFlags(top_->scene.get(), RTC_SCENE_FLAG_ROBUST);
    const embree::Geometry geometry(rtcNewGeometry(top_->device.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(top_->placed.size()));
    rtcSetGeometryUserData(geometry.get(), top_->placed.data());
    rtcSetGeometryBoundsFunction(geometry.get(), bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), meet);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(top_->scene.get(), geometry.get());
    rtcCommitScene(top_->scene.get());
    embree::check(top_->device);
}

PlacedObjects::~PlacedObjects() = default;
PlacedObjects::PlacedObjects(PlacedObjects&&) noexcept = default;

glm::dvec3 PlacedObjects::low_m(int number) const { return top_->placed[static_cast<std::size_t>(number)].low_m; }
glm::dvec3 PlacedObjects::high_m(int number) const { return top_->placed[static_cast<std::size_t>(number)].high_m; }

std::optional<ObjectHit> PlacedObjects::first_hit(const Ray& ray) const {
    if (!top_) return std::nullopt;
    Search search{{}, &ray, {.distance_m = ray.farthest_m}, false};
    rtcInitIntersectContext(&search.context);
    RTCRayHit query = embree::ray_query(ray);
    rtcIntersect1(top_->scene.get(), &search.context, &query);
    return search.met ? std::optional(search.nearest) : std::nullopt;
}

bool PlacedObjects::clear(glm::dvec3 from_m, glm::dvec3 to_m) const {
    if (!top_) return true;
    const glm::dvec3 way = to_m - from_m;
    const double length = glm::length(way), near = 1e-7;
    if (length <= 2 * near) return true;
    return !first_hit({from_m, way / length, near, length - near});
}

}  // namespace waterlight
