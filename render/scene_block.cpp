#include "render/scene_block.hpp"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <numbers>

#include "render/kernels/ambient.hpp"
#include "render/kernels/finish.hpp"
#include "render/kernels/view_ray.hpp"
#include "render/scene_light.hpp"

namespace waterlight {

namespace {

constexpr double pi = std::numbers::pi;

void put(glm::dvec3 v, float& x, float& y, float& z) {
    x = static_cast<float>(v.x);
    y = static_cast<float>(v.y);
    z = static_cast<float>(v.z);
}

/// The sun's light below flat water.
struct CalmLight {
    glm::dvec2 travel{0, 0};
    double path = 1;
    double entering = 0;
    CalmLight(const Sun& sun, const WaterOptics& optics) {
        if (!(sunlight(sun) > 0)) return;
        const f64::Refraction r =
            f64::refract_sun(sun.direction(), {0, 0}, optics.refractive_index, optics.fresnel ? 1 : 0);
        travel = r.travel;
        path = r.path;
        entering = sunlight(sun) * r.incident * r.transmittance;
    }
};

void put_light(const Scene& scene, const Look& look, SceneParameters& p) {
    const CalmLight calm(scene.sun, scene.optics);
    const SkyLight sky = sky_light(look.sky, scene.sun);
    put(-scene.sun.direction(), p.sun_x, p.sun_y, p.sun_z);
    p.sun_irradiance = static_cast<float>(sunlight(scene.sun));
    p.sun_radius = static_cast<float>(sun_radius);
    p.travel_x = static_cast<float>(calm.travel.x);
    p.travel_y = static_cast<float>(calm.travel.y);
    p.path = static_cast<float>(calm.path);
    p.entering = static_cast<float>(calm.entering);
    p.sky_scale = static_cast<float>(sky.scale);
    put(sky.irradiance, p.sky_r, p.sky_g, p.sky_b);
    const double sun_down = sunlight(scene.sun) * std::max(0.0, -scene.sun.direction().z);
    constexpr double earth_albedo = 0.15;  // of dry ground far away
    put((sun_down + sky.irradiance) * (earth_albedo / pi), p.earth_r, p.earth_g, p.earth_b);
}

void put_water(const Scene& scene, const Look& look, SceneParameters& p) {
    const WaterOptics& o = scene.optics;
    p.index = static_cast<float>(o.refractive_index);
    p.fresnel = o.fresnel ? 1 : 0;
    p.extinction = static_cast<float>(o.extinction_per_m());
    p.scattering = static_cast<float>(o.scattering_per_m);
    const glm::dvec3 on_way = scene.floor_rgb[0] != nullptr ? glm::dvec3(0) : look.colour_per_m;
    put(on_way, p.colour_r, p.colour_g, p.colour_b);
    put(look.colour_per_m + o.extinction_per_m(), p.sight_r, p.sight_g, p.sight_b);
    put(look.colour_per_m + o.absorption_per_m, p.absorption_r, p.absorption_g, p.absorption_b);
    const double lowest = scene.ground_m != nullptr ? std::ranges::min(scene.ground_m->values()) : -scene.depth_m;
    p.depth = static_cast<float>(std::max(-lowest, 0.001));
    p.r_ext = static_cast<float>(diffuse_reflectance(o.refractive_index, o.fresnel));
    p.r_int = 1 - (1 - p.r_ext) / (p.index * p.index);
}

void put_finish(const Finish& f, float& r, float& g, float& b, float& side) {
    put(f.albedo, r, g, b);
    side = static_cast<float>(f.tile_m);
}

/// Diffuse light on a flat floor of this depth, and what comes up from it to the surface.
void put_ambient(const Scene& scene, const Look& look, SceneParameters& p) {
    put_finish(look.floor, p.floor_r, p.floor_g, p.floor_b, p.floor_side);
    put_finish(look.walls, p.wall_r, p.wall_g, p.wall_b, p.wall_side);
    put_finish(look.deck, p.deck_r, p.deck_g, p.deck_b, p.deck_side);
    const double mean = f64::finish_mean(static_cast<int>(look.floor.pattern));
    put(mean * look.floor.albedo, p.mean_r, p.mean_g, p.mean_b);
    const Grid& g = scene.surface->grid;
    const bool wall_x = scene.surface->boundary.x == Side::wall, wall_y = scene.surface->boundary.y == Side::wall;
    const double lit_x = wall_x ? std::max(0.0, 1 - std::abs(p.travel_x) * p.depth / g.width_m()) : 1;
    const double lit_y = wall_y ? std::max(0.0, 1 - std::abs(p.travel_y) * p.depth / g.height_m()) : 1;
    const glm::dvec3 colour{p.colour_r, p.colour_g, p.colour_b};
    put(glm::exp(-colour * static_cast<double>(p.path * p.depth)), p.left_r, p.left_g, p.left_b);
    const glm::dvec3 absorption{p.absorption_r, p.absorption_g, p.absorption_b}, sky{p.sky_r, p.sky_g, p.sky_b};
    glm::dvec3 down, up;
    for (int c = 0; c < 3; ++c) {
        const double sun = lit_x * lit_y * p.entering * std::exp(-(p.extinction + colour[c]) * p.path * p.depth);
        const double albedo = mean * look.floor.albedo[c];
        const double passage = f64::diffuse_passage(absorption[c], p.depth);
        down[c] = f64::ambient_on_floor(sky[c], sun, albedo, p.r_ext, p.r_int, passage);
        up[c] = passage * albedo * (sun + down[c]);
    }
    put(down, p.ambient_r, p.ambient_g, p.ambient_b);
    put(up, p.up_r, p.up_g, p.up_b);
}

void put_maps(const Scene& scene, const LightMaps& maps, SceneParameters& p) {
    const FloorPlan& plan = scene.floor_plan;
    const glm::dvec2 ax = plan.axis_x(), ay = plan.axis_y();
    p.map_xx = static_cast<float>(ax.x / plan.pitch_m.x);
    p.map_xy = static_cast<float>(ax.y / plan.pitch_m.x);
    p.map_yx = static_cast<float>(ay.x / plan.pitch_m.y);
    p.map_yy = static_cast<float>(ay.y / plan.pitch_m.y);
    p.map_x = static_cast<float>(-glm::dot(plan.origin_m, ax) / plan.pitch_m.x);
    p.map_y = static_cast<float>(-glm::dot(plan.origin_m, ay) / plan.pitch_m.y);
    p.map_width = plan.width;
    p.map_height = plan.height;
    p.map_levels = maps.levels;
    p.map_pitch = static_cast<float>(std::min(plan.pitch_m.x, plan.pitch_m.y));
    const std::array<int, LightMaps::most_levels>& offset = maps.floor_offset;
    p.map_offset_0 = offset[0];
    p.map_offset_1 = offset[1];
    p.map_offset_2 = offset[2];
    p.map_offset_3 = offset[3];
    p.map_offset_4 = offset[4];
    p.map_offset_5 = offset[5];
    if (scene.walls == nullptr) return;
    p.wall_offset_0 = maps.wall_offset[0];
    p.wall_offset_1 = maps.wall_offset[1];
    p.wall_offset_2 = maps.wall_offset[2];
    p.wall_offset_3 = maps.wall_offset[3];
    const WallPlan x = wall_plan(scene.wall_settings, scene.surface->grid, 0);
    const WallPlan y = wall_plan(scene.wall_settings, scene.surface->grid, 2);
    p.wall_columns_x = x.columns;
    p.wall_columns_y = y.columns;
    p.wall_rows = x.rows;
    p.wall_pitch_x = static_cast<float>(x.pitch_m.x);
    p.wall_pitch_y = static_cast<float>(y.pitch_m.x);
    p.wall_pitch_up = static_cast<float>(x.pitch_m.y);
}

void put_domain(const Scene& scene, const Look& look, const SurfaceLevels& surface, SceneParameters& p) {
    const Grid& g = scene.surface->grid;
    p.x0 = static_cast<float>(g.x0_m);
    p.y0 = static_cast<float>(g.y0_m);
    p.x1 = static_cast<float>(g.x0_m + g.width_m());
    p.y1 = static_cast<float>(g.y0_m + g.height_m());
    p.cell_x = static_cast<float>(g.dx_m);
    p.cell_y = static_cast<float>(g.dy_m);
    p.freeboard = static_cast<float>(look.freeboard_m);
    p.mean_variance = static_cast<float>(surface.mean_variance);
    p.overlay_low = static_cast<float>(look.range.low);
    p.overlay_scale = static_cast<float>(255.999 / (look.range.high - look.range.low));
    if (scene.ground_m == nullptr) return;
    p.ground_nx = g.nx;
    p.ground_ny = g.ny;
    const auto [low, high] = std::ranges::minmax(scene.ground_m->values());
    p.ground_low = low;
    p.ground_high = high;
}

/// What of the sun's and the sky's light is left at a depth below flat water, in the mean of the colours; 1 above it.
double left_at(const SceneParameters& p, double depth) {
    if (!(depth > 0)) return 1;
    const double deep = std::min(depth, static_cast<double>(p.depth));
    const glm::dvec3 colour{p.colour_r, p.colour_g, p.colour_b}, sky{p.sky_r, p.sky_g, p.sky_b};
    const glm::dvec3 absorption{p.absorption_r, p.absorption_g, p.absorption_b};
    double left = 0, all = 0;
    for (int c = 0; c < 3; ++c) {
        left += p.entering * std::exp(-(p.extinction + colour[c]) * p.path * deep) +
                (1 - p.r_ext) * sky[c] * f64::diffuse_passage(absorption[c], deep);
        all += p.sun_irradiance * std::max(0.0F, p.sun_z) + sky[c];
    }
    return all > 0 ? std::max(left / all, 1e-3) : 1;
}

}  // namespace

PassParameters view_parameters(const Camera& camera) {
    const Camera::Rays rays = camera.rays();
    PassParameters p{};
    put(camera.position_m, p.eye_x, p.eye_y, p.eye_z);
    put(rays.corner, p.corner_x, p.corner_y, p.corner_z);
    put(rays.right, p.right_x, p.right_y, p.right_z);
    put(rays.up, p.up_x, p.up_y, p.up_z);
    put(rays.forward, p.forward_x, p.forward_y, p.forward_z);
    p.near = 0.01F;
    p.scale_x = static_cast<float>(2 / (glm::dot(rays.right, rays.right) * camera.size.x));
    p.scale_y = static_cast<float>(2 / (glm::dot(rays.up, rays.up) * camera.size.y));
    return p;
}

SceneParameters scene_parameters(const Scene& scene, const Look& look, const SurfaceLevels& surface,
                                 const LightMaps& maps, int volume_offset, double camera_depth_m) {
    SceneParameters p{};
    put_light(scene, look, p);
    put_water(scene, look, p);
    put_ambient(scene, look, p);
    put_domain(scene, look, surface, p);
    put_maps(scene, maps, p);
    const double standard = white_radiance(look.sky, scene.sun) * left_at(p, camera_depth_m);
    p.per_exposure = static_cast<float>(1 / look.exposure_w_m2_sr.value_or(standard));
    if (scene.volume != nullptr) {
        p.volume_nx = scene.volume->cells.x;
        p.volume_ny = scene.volume->cells.y;
        p.volume_nz = scene.volume->cells.z;
        p.volume_offset = volume_offset;
        p.volume_depth = static_cast<float>(scene.volume->depth_m);
    }
    return p;
}

}  // namespace waterlight
