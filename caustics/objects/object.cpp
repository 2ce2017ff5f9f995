#include "caustics/objects/object.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <numbers>
#include <vector>

#include "sim/error.hpp"

namespace waterlight {

namespace {

/// Wavelengths (um) of the lines d, F and C.
constexpr double line_d = 0.5875618, line_f = 0.4861327, line_c = 0.6562725;

constexpr double inverse_square(double x) { return 1 / (x * x); }

/// Of a triangle.
struct Edge {
    int low, high;  ///< corners
    bool is_back;   ///< from high to low
    auto operator<=>(const Edge&) const = default;
};

class Checker {
  public:
    explicit Checker(const Object& object) : object_(object) {}

    void check() const {
        require(finite(object_.centre_m) && finite(object_.rotation_deg), "its place and its turn must be finite");
        for (std::size_t k = 0; k < object_.path.size(); ++k) {
            const PathPoint& p = object_.path[k];
            require(finite(p.centre_m) && std::isfinite(p.time_s), "its path must be finite");
            if (k > 0)
                require(p.time_s > object_.path[k - 1].time_s,
                        fmt::format("its path must be in order of time: {} s after {} s", p.time_s,
                                    object_.path[k - 1].time_s));
        }
        check(object_.material);
        std::visit([this](const auto& shape) { check(shape); }, object_.shape);
    }

  private:
    static bool finite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
    static bool positive(double x) { return x > 0 && std::isfinite(x); }

    [[noreturn]] void reject(const std::string& why) const {
        throw InputError(fmt::format("object \"{}\": {}", object_.name, why));
    }
    void require(bool holds, const std::string& otherwise) const {
        if (!holds) reject(otherwise);
    }
    void require_positive(double x, const char* what) const {
        require(positive(x), fmt::format("{} is {}; allowed: above 0", what, x));
    }

    void check(const Material& m) const {
        require(m.reflectance >= 0 && m.reflectance <= 1,
                fmt::format("reflectance is {}; allowed: 0 to 1", m.reflectance));
        require(m.index >= 1 && std::isfinite(m.index), fmt::format("index is {}; allowed: 1 or more", m.index));
        require(m.absorption_per_m >= 0 && std::isfinite(m.absorption_per_m),
                fmt::format("absorption is {} 1/m; allowed: 0 or more", m.absorption_per_m));
        if (m.abbe_number) require_positive(*m.abbe_number, "Abbe number");
    }
    void check(const Sphere& s) const { require_positive(s.radius_m, "radius"); }
    void check(const Box& s) const {
        for (int axis = 0; axis < 3; ++axis) require_positive(s.size_m[axis], "size");
    }
    void check(const Ring& s) const {
        require_positive(s.inner_radius_m, "inner radius");
        require_positive(s.height_m, "height");
        require(s.outer_radius_m > s.inner_radius_m && std::isfinite(s.outer_radius_m),
                fmt::format("outer radius is {} m; allowed: above the inner one, {} m", s.outer_radius_m,
                            s.inner_radius_m));
    }
    void check(const Cup& s) const {
        require_positive(s.wall_m, "wall");
        require_positive(s.base_m, "base");
        require(s.height_m > s.base_m && std::isfinite(s.height_m),
                fmt::format("height is {} m; allowed: above that of its base, {} m", s.height_m, s.base_m));
        for (const double radius : {s.bottom_radius_m, s.top_radius_m})
            require(radius > s.wall_m && std::isfinite(radius),
                    fmt::format("radius is {} m; allowed: above the wall's thickness, {} m", radius, s.wall_m));
    }
    void check(const Mesh& s) const {
        require(!s.triangles.empty(), "its mesh has no triangle");
        require(s.normals.empty() || s.normals.size() == s.corners_m.size(),
                fmt::format("its mesh has {} corners and {} normals", s.corners_m.size(), s.normals.size()));
        require(std::ranges::all_of(s.corners_m, finite), "a corner of its mesh is not finite");
        // Closed: each edge is passed once in either direction, by the two triangles that it joins.
        std::vector<Edge> edges;
        edges.reserve(3 * s.triangles.size());
        const int count = static_cast<int>(s.corners_m.size());
        for (const glm::ivec3& t : s.triangles)
            for (int k = 0; k < 3; ++k) {
                const int a = t[k], b = t[(k + 1) % 3];
                if (a < 0 || a >= count) reject(fmt::format("its mesh names corner {} of {}", a, count));
                if (a != b) edges.push_back({std::min(a, b), std::max(a, b), a > b});
            }
        std::ranges::sort(edges);
        for (std::size_t k = 0; k < edges.size(); k += 2) {
            const Edge& e = edges[k];
            if (k + 1 == edges.size() || e.is_back || edges[k + 1] != Edge{e.low, e.high, true})
                reject(fmt::format("its mesh is not closed: the edge between corners {} and {} has not two sides",
                                   e.low, e.high));
        }
    }

    const Object& object_;
};

}  // namespace

double Material::index_at(double wavelength_nm) const {
    if (!abbe_number) return index;
    const double b = (index - 1) / *abbe_number / (inverse_square(line_f) - inverse_square(line_c));
    return index + b * (inverse_square(wavelength_nm * 1e-3) - inverse_square(line_d));
}

glm::dvec3 Object::centre_at(double time_s) const {
    if (path.empty()) return centre_m;
    const auto after = std::ranges::upper_bound(path, time_s, {}, &PathPoint::time_s);
    if (after == path.begin()) return path.front().centre_m;
    if (after == path.end()) return path.back().centre_m;
    const PathPoint &a = *(after - 1), &b = *after;
    return a.centre_m + (time_s - a.time_s) / (b.time_s - a.time_s) * (b.centre_m - a.centre_m);
}

glm::dmat3 Object::turn() const {
    const glm::dvec3 angle = rotation_deg * (std::numbers::pi / 180);
    const glm::dvec3 c{std::cos(angle.x), std::cos(angle.y), std::cos(angle.z)};
    const glm::dvec3 s{std::sin(angle.x), std::sin(angle.y), std::sin(angle.z)};
    // Columns.
    const glm::dmat3 x{{1, 0, 0}, {0, c.x, s.x}, {0, -s.x, c.x}};
    const glm::dmat3 y{{c.y, 0, -s.y}, {0, 1, 0}, {s.y, 0, c.y}};
    const glm::dmat3 z{{c.z, s.z, 0}, {-s.z, c.z, 0}, {0, 0, 1}};
    return z * y * x;
}

void validate(const Object& object) { Checker(object).check(); }

}  // namespace waterlight
