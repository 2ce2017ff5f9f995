#include "caustics/truth.hpp"

#include <cmath>
#include <vector>

#include "caustics/floor_frame.hpp"
#include "caustics/landed_corner.hpp"
#include "caustics/polygon.hpp"
#include "caustics/truth_ray.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

/// A mesh of nx by ny rectangles over a patch of the surface, each cut into two triangles.
struct Mesh {
    SurfacePatch patch;
    int nx = 0;
    int ny = 0;
    glm::dvec2 corner(int i, int j) const {
        return patch.low + (patch.high - patch.low) * glm::dvec2{double(i) / nx, double(j) / ny};
    }
};

/// Powers in watts.
struct Powers {
    double incident = 0, reflected = 0, extinguished = 0, outside = 0;
};

/// Some rows of the map, and what fell beside it.
struct Partial {
    int first_row = 0;
    Field<double> power_w;
    Powers powers;
};

using Row = std::vector<LandedCorner>;

Row land_row(const TruthCaster& caster, const FloorPlan& plan, const Mesh& mesh, int j) {
    Row row(mesh.nx + 1);
    for (int i = 0; i <= mesh.nx; ++i) {
        const TruthRay ray = caster.cast(mesh.corner(i, j));
        row[i] = {ray.start_m, plan.pixel(ray.floor_m), ray.transmittance, ray.remaining};
    }
    return row;
}

/// Sends the light of one surface triangle to the pixels.
void carry(const TruthCaster& caster, const LandedCorner& a, const LandedCorner& b, const LandedCorner& c,
           Partial& out) {
    const TrianglePower of_one = triangle_power(a, b, c, caster.direction());
    const double incident = of_one.incident * caster.irradiance(), entered = of_one.entered * caster.irradiance(),
                 arrived = of_one.arrived * caster.irradiance();
    out.powers.incident += incident;
    out.powers.reflected += incident - entered;
    out.powers.extinguished += entered - arrived;
    if (arrived == 0) return;

    const glm::ivec2 low{0, out.first_row}, high{out.power_w.nx(), out.first_row + out.power_w.ny()};
    const auto inside = [&](int i, int j) { return i >= low.x && i < high.x && j >= low.y && j < high.y; };
    const glm::dvec2 pa = glm::floor(a.pixel);
    const Polygon landed{{a.pixel, b.pixel, c.pixel}, 3};
    const double landed_area = std::abs(area(landed));
    // Within one pixel, or folded to a line: no shares to take.
    constexpr double line = 1e-13;
    if ((pa == glm::floor(b.pixel) && pa == glm::floor(c.pixel)) || landed_area < line) {
        const bool on_map = std::abs(pa.x) < 1e9 && std::abs(pa.y) < 1e9 && inside(int(pa.x), int(pa.y));
        if (on_map)
            out.power_w(int(pa.x), int(pa.y) - out.first_row) += arrived;
        else
            out.powers.outside += arrived;
        return;
    }
    double shared = 0;
    rasterise({a.pixel, b.pixel, c.pixel}, low, high, [&](int i, int j, double overlap) {
        const double share = arrived * overlap / landed_area;
        out.power_w(i, j - out.first_row) += share;
        shared += share;
    });
    out.powers.outside += arrived - shared;
}

/// Carries rows [begin, end) of the mesh. Only the map's rows that they reach are held.
Partial carry_rows(const TruthCaster& caster, const FloorPlan& plan, const Mesh& mesh, int begin, int end) {
    std::vector<Row> corners;
    double lowest = 1e300, highest = -1e300;
    for (int j = begin; j <= end; ++j) {
        corners.push_back(land_row(caster, plan, mesh, j));
        for (const LandedCorner& c : corners.back()) {
            lowest = std::min(lowest, c.pixel.y);
            highest = std::max(highest, c.pixel.y);
        }
    }
    const double height = plan.height;
    const int first = static_cast<int>(std::floor(std::clamp(lowest, 0.0, height)));
    const int last = static_cast<int>(std::ceil(std::clamp(highest + 1, 0.0, height)));
    Partial out{first, Field<double>(plan.width, std::max(0, last - first)), {}};
    for (int j = 0; j < end - begin; ++j) {
        const Row &low = corners[j], &high = corners[j + 1];
        for (int i = 0; i < mesh.nx; ++i) {
            carry(caster, low[i], low[i + 1], high[i + 1], out);
            carry(caster, low[i], high[i + 1], high[i], out);
        }
    }
    return out;
}

struct Solution {
    Field<double> irradiance;
    FloorLedger ledger;
};

Solution solve(const TruthCaster& caster, const FloorPlan& plan, const SurfacePatch& patch, int subsamples) {
    Solution solution{Field<double>(plan.width, plan.height), {}};
    if (patch.empty()) return solution;
    const glm::dvec2 cells = (patch.high - patch.low) / std::min(plan.pitch_m.x, plan.pitch_m.y) * double(subsamples);
    const Mesh mesh{patch, std::max(1, int(std::ceil(cells.x))), std::max(1, int(std::ceil(cells.y)))};

    // Bands of fixed height, added in order: the sum does not depend on the number of threads.
    const int band = std::max(8, std::min(64, (1 << 20) / (mesh.nx + 1)));
    const int bands = (mesh.ny + band - 1) / band;
    Powers total;
#pragma omp parallel for schedule(static, 1) ordered
    for (int b = 0; b < bands; ++b) {
        const Partial part = carry_rows(caster, plan, mesh, b * band, std::min(mesh.ny, (b + 1) * band));
#pragma omp ordered
        {
            for (int j = 0; j < part.power_w.ny(); ++j)
                for (int i = 0; i < plan.width; ++i) solution.irradiance(i, part.first_row + j) += part.power_w(i, j);
            total.incident += part.powers.incident;
            total.reflected += part.powers.reflected;
            total.extinguished += part.powers.extinguished;
            total.outside += part.powers.outside;
        }
    }
    const double pixel_area = plan.pitch_m.x * plan.pitch_m.y;
    double floor_w = 0;
    for (double& e : solution.irradiance.values()) {
        floor_w += e;
        e /= pixel_area;
    }
    solution.ledger = {.incident_w = total.incident,
                       .reflected_w = total.reflected,
                       .extinguished_w = total.extinguished,
                       .floor_w = floor_w,
                       .outside_w = total.outside};
    return solution;
}

double relative_difference(const Field<double>& a, const Field<double>& b) {
    double difference = 0, square = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double d = a.data()[i] - b.data()[i];
        difference += d * d;
        square += b.data()[i] * b.data()[i];
    }
    return square > 0 ? std::sqrt(difference / square) : 0;
}

}  // namespace

TruthMap truth_map(const TruthSettings& settings, const TruthSurface& surface) {
    validate(settings.floor);
    if (settings.subsamples < 1) throw InputError("truth: subsamples must be at least 1");
    if (!(settings.tolerance > 0)) throw InputError("truth: the tolerance must be above 0");
    const FloorPlan& plan = settings.floor.plan;
    const TruthCaster caster(settings.floor, surface);
    const double pitch = std::min(plan.pitch_m.x, plan.pitch_m.y);

    glm::dvec2 low = plan.position_m({0, 0}), high = low;
    for (const glm::dvec2 corner : {glm::dvec2{plan.width, 0}, {0, plan.height}, {plan.width, plan.height}}) {
        low = glm::min(low, plan.position_m(corner));
        high = glm::max(high, plan.position_m(corner));
    }
    const SurfacePatch patch = patch_above(caster, low, high, largest_stray(caster, pitch));

    int subsamples = settings.subsamples;
    Solution coarse = solve(caster, plan, patch, subsamples);
    while (true) {
        subsamples *= 2;
        Solution fine = solve(caster, plan, patch, subsamples);
        const double difference = relative_difference(coarse.irradiance, fine.irradiance);
        if (difference <= settings.tolerance || 2 * subsamples > settings.most_subsamples)
            return {std::move(fine.irradiance), subsamples, difference, fine.ledger};
        coarse = std::move(fine);
    }
}

double relative_rmse(const Field<float>& map, const Field<double>& truth, int box) {
    double difference = 0, square = 0;
    for (int j = 0; j + box <= truth.ny(); j += box) {
        for (int i = 0; i + box <= truth.nx(); i += box) {
            double d = 0, t = 0;
            for (int b = 0; b < box; ++b)
                for (int a = 0; a < box; ++a) {
                    d += map(i + a, j + b) - truth(i + a, j + b);
                    t += truth(i + a, j + b);
                }
            difference += d * d;
            square += t * t;
        }
    }
    return square > 0 ? std::sqrt(difference / square) : 0;
}

}  // namespace waterlight
