#include "render/pick.hpp"

#include <algorithm>
#include <cmath>

namespace waterlight {

namespace {

struct Span {
    double from, to;
};

struct Ray {
    glm::dvec3 origin, direction;
    glm::dvec3 at(double t) const { return origin + t * direction; }
};

Ray ray_of(const Camera& camera, glm::dvec2 pixel) {
    return {camera.position_m, glm::normalize(camera.rays().at(pixel.x, pixel.y))};
}

// The part of the ray on which one coordinate lies between two values.
Span within(Span span, double origin, double direction, double low, double high) {
    if (direction == 0) return origin >= low && origin <= high ? span : Span{1, 0};
    const double a = (low - origin) / direction, b = (high - origin) / direction;
    return {std::max(span.from, std::min(a, b)), std::min(span.to, std::max(a, b))};
}

struct Place {
    int index;
    double weight;  // of the next; beyond [0, 1] where the plane goes on
};

// Between which centres of cells, of which there are n.
Place place(double cells, int n) {
    const double at = cells - 0.5;
    const int index = std::clamp(static_cast<int>(std::floor(at)), 0, std::max(n - 2, 0));
    return {index, n > 1 ? at - index : 0};
}

double elevation_m(const Surface& s, double x, double y) {
    const Place i = place((x - s.grid.x0_m) / s.grid.dx_m, s.grid.nx);
    const Place j = place((y - s.grid.y0_m) / s.grid.dy_m, s.grid.ny);
    const int next_i = std::min(i.index + 1, s.grid.nx - 1), next_j = std::min(j.index + 1, s.grid.ny - 1);
    const auto along = [&](int row) {
        return std::lerp(static_cast<double>(s.elevation(i.index, row)), static_cast<double>(s.elevation(next_i, row)),
                         i.weight);
    };
    return std::lerp(along(j.index), along(next_j), j.weight);
}

// Above the grid, and between heights that the water does not leave. What goes on as a plane over half a cell may
// leave those of the cells by half of what neighbours differ by, which is less than the whole range.
Span span_of_water(const Surface& surface, const Ray& ray) {
    const auto [low, high] = std::minmax_element(surface.elevation.values().begin(), surface.elevation.values().end());
    const double margin = *high - *low + 1e-6;
    Span span{0, 1e9};
    span = within(span, ray.origin.x, ray.direction.x, surface.grid.x0_m, surface.grid.x0_m + surface.grid.width_m());
    span = within(span, ray.origin.y, ray.direction.y, surface.grid.y0_m, surface.grid.y0_m + surface.grid.height_m());
    return within(span, ray.origin.z, ray.direction.z, *low - margin, *high + margin);
}

}  // namespace

std::optional<glm::dvec3> pick_water(const Surface& surface, const Camera& camera, glm::dvec2 pixel) {
    const Ray ray = ray_of(camera, pixel);
    const Span span = span_of_water(surface, ray);
    const auto above = [&](double t) {
        const glm::dvec3 p = ray.at(t);
        return p.z - elevation_m(surface, p.x, p.y);
    };
    const double cell = std::min(surface.grid.dx_m, surface.grid.dy_m);
    const double level = std::hypot(ray.direction.x, ray.direction.y);
    const auto steps = static_cast<int>(std::ceil((span.to - span.from) * level / (0.25 * cell))) + 1;
    if (!(span.from < span.to)) return std::nullopt;
    const bool starts_above = above(span.from) > 0;
    double before = span.from;
    for (int n = 1; n <= steps; ++n) {
        double after = std::lerp(span.from, span.to, static_cast<double>(n) / steps);
        if ((above(after) > 0) == starts_above) {
            before = after;
            continue;
        }
        while (after - before > 1e-6 * cell) {
            const double middle = 0.5 * (before + after);
            ((above(middle) > 0) == starts_above ? before : after) = middle;
        }
        return ray.at(0.5 * (before + after));
    }
    return std::nullopt;
}

std::optional<glm::dvec3> pick_level(double z_m, const Camera& camera, glm::dvec2 pixel) {
    const Ray ray = ray_of(camera, pixel);
    const double t = (z_m - ray.origin.z) / ray.direction.z;
    if (!(t > 0) || !std::isfinite(t)) return std::nullopt;
    return ray.at(t);
}

}  // namespace waterlight
