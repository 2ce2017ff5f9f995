#include "render/water_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace waterlight {

namespace {

constexpr double copies_m = 160;  // to where the domain is repeated
constexpr int most_copies = 10;   // each way along an axis
constexpr double horizon_m = 3e4;
constexpr double nearest_m = 0.2;  // for which a mesh is planned

struct Spans {
    int first = 0, last = 0;
};

Spans spans(Side side, double from, double extent, double eye) {
    if (side != Side::periodic) return {};
    const int home = static_cast<int>(std::floor((eye - from) / extent));
    const int each = std::clamp(static_cast<int>(std::ceil(copies_m / extent)), 1, most_copies);
    return {home - each, home + each};
}

/// A copy of the domain as a box around its water.
struct Box {
    glm::dvec3 low, high;
};

double distance_to(const Box& box, glm::dvec3 eye) {
    return glm::length(glm::max(glm::max(box.low - eye, eye - box.high), glm::dvec3(0)));
}

/// Whether some of the box may be in the picture: not all corners are beyond one of its edges, or behind the eye.
bool in_sight(const Box& box, const PassParameters& v) {
    std::array<int, 5> beyond{};
    for (int k = 0; k < 8; ++k) {
        const glm::dvec3 at{(k & 1) != 0 ? box.high.x : box.low.x, (k & 2) != 0 ? box.high.y : box.low.y,
                            (k & 4) != 0 ? box.high.z : box.low.z};
        const glm::dvec3 d = at - glm::dvec3{v.eye_x, v.eye_y, v.eye_z};
        const double x = v.scale_x * glm::dot(d, glm::dvec3{v.right_x, v.right_y, v.right_z});
        const double y = v.scale_y * glm::dot(d, glm::dvec3{v.up_x, v.up_y, v.up_z});
        const double w = glm::dot(d, glm::dvec3{v.forward_x, v.forward_y, v.forward_z});
        beyond[0] += x > w;
        beyond[1] += x < -w;
        beyond[2] += y > w;
        beyond[3] += y < -w;
        beyond[4] += w < 0;
    }
    return std::ranges::none_of(beyond, [](int corners) { return corners == 8; });
}

/// Width of a pixel per metre of distance.
double pixel_width(const PassParameters& v) { return glm::length(glm::dvec3{v.right_x, v.right_y, v.right_z}); }

/// Level of the fields whose cells the pixels at this distance are as large as, in the mean of both their axes.
int level_at(const Frame& frame, double distance) {
    distance = std::max(distance, nearest_m);
    const double height = std::abs(frame.eye().z);
    const double stretch = std::sqrt(std::max(distance, height) / std::max(height, 0.02 * distance));
    const double cells = pixel_width(frame.view) * distance * stretch / frame.scene.surface->grid.dx_m;
    const int last = static_cast<int>(frame.surface.levels.size()) - 1;
    return std::clamp(static_cast<int>(std::floor(std::log2(std::max(cells, 1.0)))), 0, last);
}

/// Most that straight lines over `cells` leave a field by, measured at their middles.
double line_error(const Field<float>& f, int cells) {
    const int half = (cells + 1) / 2;
    float most = 0;
    for (int j = half; j < f.ny() - half; j += half)
        for (int i = half; i < f.nx() - half; i += half) {
            const float here = 2 * f(i, j);
            most = std::max(most, std::abs(f(i - half, j) + f(i + half, j) - here));
            most = std::max(most, std::abs(f(i, j - half) + f(i, j + half) - here));
        }
    return 0.5 * most;
}

/// Spacing of a mesh, in cells, such that straight lines between its corners leave the surface by less than one and a
/// half pixels where it bends by four times its root mean square, and the ground anywhere. Slopes, and with them all
/// that is seen in and through the water, come from the fields themselves; what a finer mesh costs is that its small
/// triangles cut pixels.
int spacing_at(const Frame& frame, double distance) {
    const Grid& g = frame.scene.surface->grid;
    const double allowed = 1.5 * pixel_width(frame.view) * std::max(distance, nearest_m);
    const double range = frame.surface.highest_m - frame.surface.lowest_m;
    const auto error = [&](int cells) {
        const double spacing = cells * std::max(g.dx_m, g.dy_m);
        return std::min(range, 4 * frame.surface.curvature_per_m * spacing * spacing / 8);
    };
    int cells = 1;
    while (cells < std::max(g.nx, g.ny) && error(cells + 1) <= allowed) ++cells;
    while (frame.scene.ground_m != nullptr && cells > 1 && line_error(*frame.scene.ground_m, cells) > allowed)
        cells = (cells + 1) / 2;
    return cells;
}

struct Detail {
    int level;
    int spacing;
    auto operator<=>(const Detail&) const = default;
};

void plan_copies(const Frame& frame, Spans x, Spans y, WaterMeshes& out) {
    const Surface& surface = *frame.scene.surface;
    const Grid& g = surface.grid;
    std::map<Detail, std::vector<glm::vec4>> copies;
    for (int q = y.first; q <= y.last; ++q)
        for (int p = x.first; p <= x.last; ++p) {
            const glm::dvec2 to{p * g.width_m(), q * g.height_m()};
            const double climb = glm::dot(surface.tilt, to);
            const Box box{{g.x0_m + to.x, g.y0_m + to.y, frame.surface.lowest_m + climb},
                          {g.x0_m + to.x + g.width_m(), g.y0_m + to.y + g.height_m(), frame.surface.highest_m + climb}};
            if (!in_sight(box, frame.view)) continue;
            const double distance = distance_to(box, frame.eye());
            copies[{level_at(frame, distance), spacing_at(frame, distance)}].emplace_back(to.x, to.y, climb, 0);
        }
    for (const auto& [detail, shifts] : copies) {
        const auto parts = [spacing = detail.spacing](int n) { return (n + spacing - 1) / spacing; };
        // Half a cell more over periodic sides: meshes of different spacing leave no gap.
        const float more_x = surface.boundary.x == Side::periodic ? 0.5F : 0;
        const float more_y = surface.boundary.y == Side::periodic ? 0.5F : 0;
        out.meshes.push_back({{-more_x, -more_y, g.nx + more_x, g.ny + more_y},
                              parts(g.nx),
                              parts(g.ny),
                              frame.surface.levels[detail.level],
                              detail.level > 0,
                              static_cast<int>(out.shifts.size()),
                              static_cast<int>(shifts.size())});
        out.shifts.insert(out.shifts.end(), shifts.begin(), shifts.end());
    }
}

/// Four rectangles to the horizon around the copies, or as many as there are sides without walls.
void plan_beyond(const Frame& frame, Spans x, Spans y, WaterMeshes& out) {
    const Surface& surface = *frame.scene.surface;
    if (surface.tilt != glm::dvec2(0, 0)) return;
    const Grid& g = surface.grid;
    const double cells_x = horizon_m / g.dx_m, cells_y = horizon_m / g.dy_m;
    const bool open_x = surface.boundary.x != Side::wall, open_y = surface.boundary.y != Side::wall;
    const double u0 = x.first * g.nx, u1 = (x.last + 1.0) * g.nx, v0 = y.first * g.ny, v1 = (y.last + 1.0) * g.ny;
    const double far_u0 = open_x ? u0 - cells_x : u0, far_u1 = open_x ? u1 + cells_x : u1;
    const int home = static_cast<int>(out.shifts.size());
    out.shifts.emplace_back(0, 0, 0, 0);
    const auto add = [&](double a, double b, double c, double d) {
        out.meshes.push_back({{a, b, c, d}, 1, 1, frame.surface.beyond, true, home, 1});
    };
    if (open_x) {
        add(far_u0, v0, u0, v1);
        add(u1, v0, far_u1, v1);
    }
    if (open_y) {
        add(far_u0, v0 - cells_y, far_u1, v0);
        add(far_u0, v1, far_u1, v1 + cells_y);
    }
}

/// The ground under every copy, and beyond absorbing sides as high as at them.
void plan_ground(const Frame& frame, WaterMeshes& out) {
    const Surface& surface = *frame.scene.surface;
    const Grid& g = surface.grid;
    const float far_x = surface.boundary.x == Side::absorbing ? static_cast<float>(horizon_m / g.dx_m) : 0;
    const float far_y = surface.boundary.y == Side::absorbing ? static_cast<float>(horizon_m / g.dy_m) : 0;
    const auto nx = static_cast<float>(g.nx), ny = static_cast<float>(g.ny);
    const SurfaceLevel finest = frame.surface.levels.front();
    const int home = static_cast<int>(out.shifts.size());
    out.shifts.emplace_back(0, 0, 0, 0);
    for (const WaterMesh& mesh : std::vector(out.meshes)) {
        if (mesh.level.offset == frame.surface.beyond.offset) continue;
        out.ground.push_back(mesh);
        if (far_x == 0 && far_y == 0) continue;
        const auto add = [&](glm::vec4 rectangle, int columns, int rows) {
            out.ground.push_back({rectangle, columns, rows, finest, false, home, 1});
        };
        for (const auto& [u0, u1, columns] :
             {std::tuple(-far_x, 0.0F, 1), {0.0F, nx, mesh.columns}, {nx, nx + far_x, 1}})
            for (const auto& [v0, v1, rows] : {std::tuple(-far_y, 0.0F, 1), {0.0F, ny, mesh.rows}, {ny, ny + far_y, 1}})
                if (u1 > u0 && v1 > v0 && (columns == 1 || rows == 1)) add({u0, v0, u1, v1}, columns, rows);
    }
}

}  // namespace

WaterMeshes plan_water(const Frame& frame) {
    const Surface& surface = *frame.scene.surface;
    const Grid& g = surface.grid;
    const Spans x = spans(surface.boundary.x, g.x0_m, g.width_m(), frame.eye().x);
    const Spans y = spans(surface.boundary.y, g.y0_m, g.height_m(), frame.eye().y);
    WaterMeshes planned;
    plan_copies(frame, x, y, planned);
    plan_beyond(frame, x, y, planned);
    if (frame.variant.uneven) plan_ground(frame, planned);
    return planned;
}

PassParameters mesh_parameters(const PassParameters& view, const WaterMesh& mesh) {
    PassParameters p = view;
    p.u0 = mesh.rectangle.x;
    p.v0 = mesh.rectangle.y;
    p.u1 = mesh.rectangle.z;
    p.v1 = mesh.rectangle.w;
    p.columns = mesh.columns;
    p.rows = mesh.rows;
    p.level_offset = mesh.level.offset;
    p.level_nx = mesh.level.nx;
    p.level_ny = mesh.level.ny;
    p.level_scale = mesh.level.scale;
    p.first_copy = mesh.first_copy;
    return p;
}

gpu::Strips strips_of(const WaterMesh& mesh) {
    return {static_cast<std::uint32_t>(mesh.copies * mesh.rows), 2 * static_cast<std::uint32_t>(mesh.columns + 1)};
}

}  // namespace waterlight
