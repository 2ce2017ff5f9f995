#include "caustics/objects/triangle_scene.hpp"

#include <cmath>

#include "caustics/objects/embree.hpp"

namespace waterlight {

struct TriangleScene::Data {
    std::vector<glm::dvec3> corners_m;
    std::vector<glm::ivec3> triangles;
    embree::Device device;
    embree::Scene scene;
};

namespace {

/// A ray's search, as Embree's filter sees it: the context comes first.
struct Search {
    RTCIntersectContext context;
    const Ray* ray;
    const std::vector<glm::dvec3>* corners_m;
    const std::vector<glm::ivec3>* triangles;
    TriangleScene::Hit nearest;
    bool met;
};

/// Möller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (1997), of a triangle that is known to be met.
TriangleScene::Hit meet(const Search& search, int triangle) {
    const glm::ivec3 t = (*search.triangles)[static_cast<std::size_t>(triangle)];
    const auto corner = [&](int k) { return (*search.corners_m)[static_cast<std::size_t>(t[k])]; };
    const glm::dvec3 a = corner(0), ab = corner(1) - a, ac = corner(2) - a, from = search.ray->from_m - a;
    const glm::dvec3 across = glm::cross(search.ray->direction, ac), normal = glm::cross(ab, ac);
    const double determinant = glm::dot(ab, across);
    const glm::dvec3 turned = glm::cross(from, ab);
    const double u = glm::dot(from, across) / determinant, v = glm::dot(search.ray->direction, turned) / determinant;
    return {glm::dot(ac, turned) / determinant, triangle, {1 - u - v, u, v}, glm::normalize(normal)};
}

/// Takes a triangle that Embree found if it is nearer in double precision too.
void filter(const RTCFilterFunctionNArguments* args) {
    auto& search = *reinterpret_cast<Search*>(args->context);
    const auto triangle = static_cast<int>(RTCHitN_primID(args->hit, args->N, 0));
    const TriangleScene::Hit hit = meet(search, triangle);
    const bool nearer = hit.distance_m > search.ray->nearest_m && hit.distance_m < search.nearest.distance_m;
    if (nearer) {
        search.nearest = hit;
        search.met = true;
    } else {
        args->valid[0] = 0;
    }
}

void fill(RTCGeometry geometry, const std::vector<glm::dvec3>& corners, const std::vector<glm::ivec3>& triangles) {
    auto* xyz = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                            3 * sizeof(float), corners.size()));
    auto* abc = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                               3 * sizeof(unsigned), triangles.size()));
    if (xyz == nullptr || abc == nullptr) return;
    for (const glm::dvec3& p : corners)
        for (int k = 0; k < 3; ++k) *xyz++ = static_cast<float>(p[k]);
    for (const glm::ivec3& t : triangles)
        for (int k = 0; k < 3; ++k) *abc++ = static_cast<unsigned>(t[k]);
}

}  // namespace

TriangleScene::TriangleScene(std::vector<glm::dvec3> corners_m, std::vector<glm::ivec3> triangles)
    : data_(new Data{std::move(corners_m), std::move(triangles), embree::make_device(), nullptr}) {
    Data& d = *data_;
    d.scene.reset(rtcNewScene(d.device.get()));
    rtcSetSceneFlags(d.scene.get(), RTC_SCENE_FLAG_ROBUST);
    const embree::Geometry geometry(rtcNewGeometry(d.device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    fill(geometry.get(), d.corners_m, d.triangles);
    embree::check(d.device);
    rtcSetGeometryIntersectFilterFunction(geometry.get(), filter);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(d.scene.get(), geometry.get());
    rtcCommitScene(d.scene.get());
    embree::check(d.device);
}

TriangleScene::~TriangleScene() = default;
TriangleScene::TriangleScene(TriangleScene&&) noexcept = default;
TriangleScene& TriangleScene::operator=(TriangleScene&&) noexcept = default;

const std::vector<glm::dvec3>& TriangleScene::corners_m() const { return data_->corners_m; }
const std::vector<glm::ivec3>& TriangleScene::triangles() const { return data_->triangles; }

std::optional<TriangleScene::Hit> TriangleScene::first_hit(const Ray& ray) const {
    Search search{{}, &ray, &data_->corners_m, &data_->triangles, {.distance_m = ray.farthest_m}, false};
    rtcInitIntersectContext(&search.context);
    RTCRayHit query = embree::ray_query(ray);
    rtcIntersect1(data_->scene.get(), &search.context, &query);
    return search.met ? std::optional(search.nearest) : std::nullopt;
}

}  // namespace waterlight
