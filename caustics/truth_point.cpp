// Irradiance at a point of the floor by the rays that reach it.
#include <cmath>
#include <vector>

#include "caustics/truth_ray.hpp"

namespace waterlight {

namespace {

struct Jacobian {
    glm::dvec2 dx{1, 0}, dy{0, 1};  // columns: d floor / dx, d floor / dy
    double determinant() const { return dx.x * dy.y - dy.x * dx.y; }
    /// Solves J step = r.
    glm::dvec2 solve(glm::dvec2 r) const {
        return glm::dvec2{dy.y * r.x - dy.x * r.y, dx.x * r.y - dx.y * r.x} / determinant();
    }
};

Jacobian jacobian(const TruthCaster& caster, glm::dvec2 at, double spacing) {
    const double h = 1e-4 * spacing;
    const glm::dvec2 ex{h, 0}, ey{0, h};
    return {(caster.cast(at + ex).floor_m - caster.cast(at - ex).floor_m) / (2 * h),
            (caster.cast(at + ey).floor_m - caster.cast(at - ey).floor_m) / (2 * h)};
}

bool contains(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 p) {
    const auto turn = [](glm::dvec2 u, glm::dvec2 v) { return u.x * v.y - u.y * v.x; };
    const double s = turn(b - a, p - a), t = turn(c - b, p - b), u = turn(a - c, p - c);
    return (s >= 0 && t >= 0 && u >= 0) || (s <= 0 && t <= 0 && u <= 0);
}

/// Newton's method for floor(x) = target; keeps to a few spacings from its start.
glm::dvec2 refine(const TruthCaster& caster, glm::dvec2 x, glm::dvec2 target, double spacing) {
    for (int k = 0; k < 50; ++k) {
        const glm::dvec2 miss = target - caster.cast(x).floor_m;
        glm::dvec2 step = jacobian(caster, x, spacing).solve(miss);
        const double length = glm::length(step);
        if (!(length < 1e300)) break;
        if (length > spacing) step *= spacing / length;
        x += step;
        if (length < 1e-13 * (1 + glm::length(x))) break;
    }
    return x;
}

}  // namespace

double truth_at(const FloorSettings& settings, const TruthSurface& surface, glm::dvec2 floor_m, double spacing_m) {
    const TruthCaster caster(settings, surface);
    const SurfacePatch patch = patch_above(caster, floor_m, floor_m, largest_stray(caster, spacing_m));
    if (patch.empty()) return 0;
    const glm::dvec2 size = patch.high - patch.low;
    const int nx = std::max(1, int(std::ceil(size.x / spacing_m))),
              ny = std::max(1, int(std::ceil(size.y / spacing_m)));
    const auto corner = [&](int i, int j) { return patch.low + size * glm::dvec2{double(i) / nx, double(j) / ny}; };
    std::vector<glm::dvec2> roots;
    const auto add_root = [&](glm::dvec2 start) {
        const glm::dvec2 root = refine(caster, start, floor_m, spacing_m);
        if (glm::length(caster.cast(root).floor_m - floor_m) > 1e-9 * (1 + spacing_m)) return;
        for (const glm::dvec2& known : roots)
            if (glm::length(known - root) < 1e-6 * spacing_m) return;
        roots.push_back(root);
    };
    std::vector<glm::dvec2> low(nx + 1), high(nx + 1);
    for (int i = 0; i <= nx; ++i) high[i] = caster.cast(corner(i, 0)).floor_m;
    for (int j = 0; j < ny; ++j) {
        std::swap(low, high);
        for (int i = 0; i <= nx; ++i) high[i] = caster.cast(corner(i, j + 1)).floor_m;
        for (int i = 0; i < nx; ++i) {
            const glm::dvec2 middle = 0.5 * (corner(i, j) + corner(i + 1, j + 1));
            if (contains(low[i], low[i + 1], high[i + 1], floor_m) || contains(low[i], high[i + 1], high[i], floor_m))
                add_root(middle);
        }
    }
    double sum = 0;
    for (const glm::dvec2& root : roots) {
        const TruthRay ray = caster.cast(root);
        sum += ray.incident * ray.transmittance * ray.remaining /
               std::abs(jacobian(caster, root, spacing_m).determinant());
    }
    return caster.irradiance() * sum;
}

}  // namespace waterlight
