#include "caustics/splat/receivers.hpp"

#include <algorithm>
#include <cmath>

#include "caustics/axis_place.hpp"
#include "caustics/first_crossing.hpp"

namespace waterlight {

namespace {

/// The height at which the ray of a place in the image first meets the ground.
double height_on_ray(const f64::LightImage& image, const BeamGround& ground, glm::dvec2 place) {
    const double top = ground.highest_m(), bottom = ground.lowest_m();
    const auto at = [&](double down) { return f64::of_image(image, place, top - down); };
    const double way = glm::length(glm::dvec2(at(0) - at(top - bottom)));
    const int steps = std::max(1, static_cast<int>(std::ceil(2 * way / ground.step_m())));
    return top - first_crossing({0, top - bottom, steps},
                                [&](double down) { return top - down - ground.height_m(glm::dvec2(at(down))); });
}

/// The box in the image of the domain between two heights.
std::pair<glm::dvec2, glm::dvec2> box_in_image(const f64::LightImage& image, const Grid& g, double low_m,
                                               double high_m) {
    glm::dvec2 low{1e300, 1e300}, high{-1e300, -1e300};
    for (const double x : {g.x0_m, g.x0_m + g.width_m()})
        for (const double y : {g.y0_m, g.y0_m + g.height_m()})
            for (const double z : {low_m, high_m}) {
                const glm::dvec2 p = f64::in_image(image, {x, y, z});
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
    return {low, high};
}

}  // namespace

Receivers::Receivers(const SplatFrame& frame, const Surface& surface, const Field<float>& bed_m)
    : ground_(std::in_place, surface.grid, surface.boundary, bed_m.clone()), boundary_(surface.boundary) {
    const Grid& g = surface.grid;
    const f64::LightImage& image = frame.light.image;
    // A lamp's image of ground that repeats does not repeat.
    const bool parallel = image.parallel == 1;
    const auto [low, high] = box_in_image(image, g, ground_->lowest_m(), ground_->highest_m());
    const bool around_x = parallel && boundary_.x == Side::periodic,
               around_y = parallel && boundary_.y == Side::periodic;
    if (!around_x) boundary_.x = Side::absorbing;
    if (!around_y) boundary_.y = Side::absorbing;
    const glm::dvec2 from{around_x ? g.x0_m : low.x, around_y ? g.y0_m : low.y};
    const glm::dvec2 size{around_x ? g.width_m() : high.x - low.x, around_y ? g.height_m() : high.y - low.y};
    // No coarser than the ground or the vertices.
    const auto texels = [](double extent, double whole, int cells, int vertices) {
        return static_cast<int>(std::ceil(std::max(cells, vertices) * extent / whole - 1e-9));
    };
    const int nx = texels(size.x, g.width_m(), g.nx, frame.lattice.domain.x);
    const int ny = texels(size.y, g.height_m(), g.ny, frame.lattice.domain.y);
    texels_ = {nx, ny, size.x / nx, size.y / ny, from.x, from.y};
    heights_ = Field<float>(nx, ny);
#pragma omp parallel for schedule(static)
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
            heights_(i, j) = static_cast<float>(height_on_ray(image, *ground_, {texels_.x_m(i), texels_.y_m(j)}));
}

double Receivers::height_m(glm::dvec2 at) const {
    if (level()) return level_;
    const f64::AxisPlace x = axis_place(at.x, texels_.x_m(0), texels_.dx_m, texels_.nx, boundary_.x);
    const f64::AxisPlace y = axis_place(at.y, texels_.y_m(0), texels_.dy_m, texels_.ny, boundary_.y);
    return f64::bilinear(heights_(x.low, y.low), heights_(x.high, y.low), heights_(x.low, y.high),
                         heights_(x.high, y.high), x.weight, y.weight);
}

bool Receivers::sees(glm::dvec2 at) const {
    if (level()) return true;
    const auto within = [](double x, double from, double extent, Side side) {
        return side == Side::periodic || (x >= from && x <= from + extent);
    };
    return within(at.x, texels_.x0_m, texels_.width_m(), boundary_.x) &&
           within(at.y, texels_.y0_m, texels_.height_m(), boundary_.y);
}

double Receivers::steepness(glm::dvec2 at) const {
    if (!ground_) return 1;
    const double h = 1e-3 * ground_->step_m();
    const glm::dvec2 gradient{ground_->height_m(at + glm::dvec2{h, 0}) - ground_->height_m(at - glm::dvec2{h, 0}),
                              ground_->height_m(at + glm::dvec2{0, h}) - ground_->height_m(at - glm::dvec2{0, h})};
    return std::sqrt(1 + glm::dot(gradient, gradient) / (4 * h * h));
}

Landed land(const SplatOptions& options, const f64::LightImage& image, const Receivers& receivers, glm::dvec3 start,
            glm::dvec3 direction) {
    const bool by_height = options.landing == SplatOptions::Landing::height;
    const double above = std::max(0.0, start.z - image.level);
    Landed landed{by_height ? above / -direction.z : above, 0, true};
    for (int k = 0; k < options.iterations; ++k) {
        const glm::dvec2 place = f64::in_image(image, start + landed.distance_m * direction);
        const glm::dvec3 found = f64::of_image(image, place, receivers.height_m(place));
        const double next = f64::next_distance(start, direction, found, by_height);
        landed.last_step_m = std::abs(next - landed.distance_m);
        landed.distance_m = next;
        if (landed.last_step_m == 0) break;
    }
    landed.seen = receivers.sees(f64::in_image(image, start + landed.distance_m * direction));
    return landed;
}

}  // namespace waterlight
