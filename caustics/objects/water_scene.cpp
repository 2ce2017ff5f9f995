#include "caustics/objects/water_scene.hpp"

#include <algorithm>
#include <cmath>

#include "caustics/kernels/interface.hpp"
#include "caustics/surface_point.hpp"

namespace waterlight {

struct WaterScene::Data {
    WaterSceneSettings settings;
    const Surface* surface;
    PlacedObjects objects;
    std::optional<TriangleScene> water;   ///< none: flat at z = 0
    std::optional<TriangleScene> ground;  ///< none: flat at -depth
    glm::dvec2 low_m, high_m;             ///< of the domain
    double lowest_m = 0, highest_m = 0;   ///< of the floor, of the water
    double steepest = 0;                  ///< slope of the water
};

namespace {

/// A mesh through the centres of cells and, half a cell further, the sides.
class CellMesh {
  public:
    explicit CellMesh(const Grid& g) : xs_(places(g.x0_m, g.dx_m, g.nx)), ys_(places(g.y0_m, g.dy_m, g.ny)) {}

    template <class Height>
    void corners(Height height, std::vector<glm::dvec3>& out) const {
        for (const double y : ys_)
            for (const double x : xs_) out.emplace_back(x, y, height(glm::dvec2{x, y}));
    }
    /// Counter-clockwise seen from above.
    void triangles(std::vector<glm::ivec3>& out) const {
        const int width = static_cast<int>(xs_.size());
        for (int j = 0; j + 1 < static_cast<int>(ys_.size()); ++j)
            for (int i = 0; i + 1 < width; ++i) {
                const int a = j * width + i;
                out.emplace_back(a, a + 1, a + width + 1);
                out.emplace_back(a, a + width + 1, a + width);
            }
    }

  private:
    static std::vector<double> places(double from, double pitch, int n) {
        std::vector<double> all{from};
        for (int i = 0; i < n; ++i) all.push_back(from + (i + 0.5) * pitch);
        all.push_back(from + n * pitch);
        return all;
    }
    std::vector<double> xs_, ys_;
};

/// A level rectangle, and the margin of still water beyond absorbing sides made of four.
void add_rectangle(glm::dvec2 low, glm::dvec2 high, std::vector<glm::dvec3>& corners,
                   std::vector<glm::ivec3>& triangles) {
    if (low.x >= high.x || low.y >= high.y) return;
    const int a = static_cast<int>(corners.size());
    for (const glm::dvec2 p : {low, {high.x, low.y}, high, {low.x, high.y}}) corners.emplace_back(p, 0);
    triangles.emplace_back(a, a + 1, a + 2);
    triangles.emplace_back(a, a + 2, a + 3);
}

bool is_flat(const Surface& s) {
    const auto zero = [](const Field<float>& f) {
        return std::ranges::all_of(f.values(), [](float v) { return v == 0; });
    };
    return zero(s.elevation) && zero(s.slope_x) && zero(s.slope_y);
}

TriangleScene water_of(const Surface& surface, glm::dvec2 low, glm::dvec2 high, double margin) {
    std::vector<glm::dvec3> corners;
    std::vector<glm::ivec3> triangles;
    const CellMesh mesh(surface.grid);
    mesh.corners([&](glm::dvec2 at) { return surface_point(surface, at).elevation_m; }, corners);
    mesh.triangles(triangles);
    const double x = surface.boundary.x == Side::absorbing ? margin : 0,
                 y = surface.boundary.y == Side::absorbing ? margin : 0;
    add_rectangle({low.x - x, low.y - y}, {low.x, high.y + y}, corners, triangles);
    add_rectangle({high.x, low.y - y}, {high.x + x, high.y + y}, corners, triangles);
    add_rectangle({low.x, low.y - y}, {high.x, low.y}, corners, triangles);
    add_rectangle({low.x, high.y}, {high.x, high.y + y}, corners, triangles);
    return {std::move(corners), std::move(triangles)};
}

TriangleScene ground_of(const Grid& grid, const Field<float>& bed) {
    std::vector<glm::dvec3> corners;
    std::vector<glm::ivec3> triangles;
    const CellMesh mesh(grid);
    // Constant over the half cells at the sides, as the ground of beams and maps is.
    const auto cell = [](double at, double from, double pitch, int n) {
        return std::clamp(static_cast<int>(std::floor((at - from) / pitch)), 0, n - 1);
    };
    mesh.corners(
        [&](glm::dvec2 at) {
            return bed(cell(at.x, grid.x0_m, grid.dx_m, grid.nx), cell(at.y, grid.y0_m, grid.dy_m, grid.ny));
        },
        corners);
    mesh.triangles(triangles);
    return {std::move(corners), std::move(triangles)};
}

glm::dvec3 upward_normal(glm::dvec2 slope) { return glm::normalize(glm::dvec3(-slope, 1)); }

/// Keeps the nearer of two.
void offer(SceneHit& nearest, SceneHit::What what, double distance, glm::dvec3 normal) {
    if (distance < nearest.distance_m) nearest = {what, distance, normal, -1, {0, 0}};
}

/// Where a ray meets the plane z = level.
std::optional<double> at_level(const Ray& ray, double level) {
    if (ray.direction.z == 0) return std::nullopt;
    const double t = (level - ray.from_m.z) / ray.direction.z;
    return t > ray.nearest_m && t < ray.farthest_m ? std::optional(t) : std::nullopt;
}

}  // namespace

WaterScene::WaterScene(const WaterSceneSettings& settings, const Surface& surface)
    : data_(new Data{settings, &surface, PlacedObjects(settings.objects, surface.time_s), {}, {}, {}, {}, 0, 0, 0}) {
    Data& d = *data_;
    const Grid& g = surface.grid;
    d.low_m = {g.x0_m, g.y0_m};
    d.high_m = d.low_m + glm::dvec2{g.width_m(), g.height_m()};
    d.lowest_m = -settings.depth_m;
    if (settings.bed_m) {
        d.lowest_m = *std::ranges::min_element(settings.bed_m->values());
        d.ground.emplace(ground_of(g, *settings.bed_m));
    }
    d.highest_m = std::max(0.0F, *std::ranges::max_element(surface.elevation.values()));
    d.steepest = steepest_slope(surface);
    if (!is_flat(surface)) d.water.emplace(water_of(surface, d.low_m, d.high_m, settings.still_beyond_m));
}

WaterScene::~WaterScene() = default;
WaterScene::WaterScene(WaterScene&&) noexcept = default;

namespace {

/// The water from the side on which the traveller is: of air from above, of water from below. Where triangles and the
/// bilinear surface differ a ray that starts on the one may be on the wrong side of the other. Light that leaves more
/// steeply than the water is anywhere does not meet it: there is nothing to search.
void meet_water(const WaterScene& scene, const std::optional<TriangleScene>& water, double steepest,
                const Traveller& traveller, SceneHit& nearest) {
    Ray ray = traveller.ray;
    ray.farthest_m = nearest.distance_m;
    const double towards = traveller.in_water ? 1 : -1;
    if (towards * ray.direction.z < -steepest * glm::length(glm::dvec2(ray.direction))) return;
    if (!water) {
        const auto t = at_level(ray, 0);
        if (t && towards * ray.direction.z > 0) offer(nearest, SceneHit::What::water, *t, {0, 0, 1});
        return;
    }
    constexpr int most_wrong_sides = 8;
    for (int k = 0; k < most_wrong_sides; ++k) {
        const auto hit = water->first_hit(ray);
        if (!hit) return;
        if (towards * glm::dot(ray.direction, hit->normal) > 0) {
            const glm::dvec3 normal = upward_normal(scene.surface_at(glm::dvec2(ray.at(hit->distance_m))).slope);
            return offer(nearest, SceneHit::What::water, hit->distance_m, normal);
        }
        ray.nearest_m = hit->distance_m;
    }
}

}  // namespace

SceneHit WaterScene::first_hit(const Traveller& traveller) const {
    const Data& d = *data_;
    SceneHit nearest;
    nearest.distance_m = traveller.ray.farthest_m;
    if (const auto object = d.objects.first_hit(traveller.ray))
        nearest = {SceneHit::What::object, object->distance_m, object->normal, object->object, {0, 0}};
    if (traveller.inside >= 0) return nearest;  // within glass there is neither water nor ground
    meet_water(*this, d.water, d.steepest, traveller, nearest);
    Ray ray = traveller.ray;
    ray.farthest_m = nearest.distance_m;
    if (d.ground) {
        if (const auto hit = d.ground->first_hit(ray))
            offer(nearest, SceneHit::What::floor, hit->distance_m, hit->normal);
    } else if (const auto t = at_level(ray, -d.settings.depth_m)) {
        offer(nearest, SceneHit::What::floor, *t, {0, 0, 1});
    }
    if (!traveller.in_water) return nearest;
    for (int axis = 0; axis < 2; ++axis) {
        const Side side = axis == 0 ? d.surface->boundary.x : d.surface->boundary.y;
        const double speed = ray.direction[axis];
        if (side == Side::absorbing || speed == 0) continue;
        // No nearest_m here: a start on the side, going out, is at the side.
        const double t = std::max(0.0, ((speed > 0 ? d.high_m : d.low_m)[axis] - ray.from_m[axis]) / speed);
        if (t >= nearest.distance_m) continue;
        const int outwards = speed > 0 ? 1 : -1;
        nearest = {SceneHit::What::side, t, {0, 0, 0}, -1, {0, 0}};
        nearest.normal[axis] = -outwards;
        nearest.side[axis] = outwards;
    }
    return nearest;
}

Branches WaterScene::branch(const Traveller& traveller, const SceneHit& hit) const {
    const Data& d = *data_;
    const glm::dvec3 at = traveller.ray.at(hit.distance_m), direction = traveller.ray.direction;
    const bool along = glm::dot(direction, hit.normal) > 0;
    const glm::dvec3 facing = along ? -hit.normal : hit.normal;
    Branches ways;
    ways.reflected = traveller;
    ways.reflected.ray = {at, glm::normalize(f64::reflect_ray(direction, facing))};
    const double outside = traveller.in_water ? d.settings.optics.refractive_index : 1;
    double from = outside, to = outside;
    ways.refracted = traveller;
    if (hit.what == SceneHit::What::object) {
        const Material& material = d.objects.object(hit.object).material;
        if (material.type != Material::Type::glass) return ways;
        const double glass = material.index_at(d.settings.wavelength_nm);
        const bool leaves = traveller.inside >= 0;
        ways.refracted.inside = leaves ? -1 : hit.object;
        if (leaves) {
            ways.refracted.in_water = is_under_water(at);
            from = glass;
            to = ways.refracted.in_water ? d.settings.optics.refractive_index : 1;
        } else {
            to = glass;
        }
    } else {
        ways.refracted.in_water = !traveller.in_water;
        to = traveller.in_water ? 1 : d.settings.optics.refractive_index;
    }
    const bool all_enters = hit.what == SceneHit::What::water && !d.settings.optics.fresnel;
    const f64::RayRefraction r = f64::refract_ray(direction, facing, to / from, all_enters ? 0 : 1);
    ways.transmittance = r.transmittance;
    if (r.transmittance > 0) ways.refracted.ray = {at, glm::normalize(r.direction)};
    return ways;
}

Traveller WaterScene::wrapped(const Traveller& traveller, const SceneHit& hit) const {
    const Data& d = *data_;
    Traveller again = traveller;
    again.ray.from_m = traveller.ray.at(hit.distance_m);
    for (int axis = 0; axis < 2; ++axis) {
        if (hit.side[axis] == 0) continue;
        // To the side itself, whatever rounding says.
        again.ray.from_m[axis] = hit.side[axis] > 0 ? d.low_m[axis] : d.high_m[axis];
    }
    again.ray.nearest_m = 0;
    return again;
}

double WaterScene::extinction_per_m(const Traveller& traveller) const {
    if (traveller.inside >= 0) return data_->objects.object(traveller.inside).material.absorption_per_m;
    return traveller.in_water ? data_->settings.optics.extinction_per_m() : 0;
}

bool WaterScene::is_under_water(glm::dvec3 at_m) const { return at_m.z < surface_at(glm::dvec2(at_m)).elevation_m; }

SurfacePoint WaterScene::surface_at(glm::dvec2 at_m) const { return surface_point(*data_->surface, at_m); }
double WaterScene::lowest_floor_m() const { return data_->lowest_m; }
double WaterScene::highest_water_m() const { return data_->highest_m; }
const PlacedObjects& WaterScene::objects() const { return data_->objects; }
const Surface& WaterScene::surface() const { return *data_->surface; }
const WaterSceneSettings& WaterScene::settings() const { return data_->settings; }

}  // namespace waterlight
