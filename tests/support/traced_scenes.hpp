// Scenes with objects whose pictures are known.
#pragma once

#include <cmath>
#include <numbers>

#include "render/traced/traced_picture.hpp"
#include "tests/support/render_scenes.hpp"

namespace waterlight {

inline Object object_of(Shape shape, Material material, glm::dvec3 centre_m) {
    Object o;
    o.name = "thing";
    o.shape = std::move(shape);
    o.material = material;
    o.centre_m = centre_m;
    return o;
}

inline Material glass_of(double index, double absorption_per_m = 0) {
    return {.type = Material::Type::glass, .index = index, .absorption_per_m = absorption_per_m};
}

inline Material mirror_of(double reflectance) { return {.type = Material::Type::mirror, .reflectance = reflectance}; }

inline Material diffuse_of(double reflectance) { return {.type = Material::Type::diffuse, .reflectance = reflectance}; }

inline std::shared_ptr<const ObjectSet> set_of(std::vector<Object> objects) {
    for (std::size_t k = 0; k < objects.size(); ++k) objects[k].name = std::string(1, static_cast<char>('a' + k));
    return std::make_shared<const ObjectSet>(std::move(objects));
}

/// A plane without water: a floor at z = -1 mm below still water that does not refract.
inline TracedScene dry_scene(const Surface& surface) {
    TracedScene scene;
    scene.scene.surface = &surface;
    scene.scene.depth_m = 1e-3;
    scene.scene.optics.refractive_index = 1;
    return scene;
}

}  // namespace waterlight
