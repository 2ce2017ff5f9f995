// Points "x y z" of a lattice, in any order.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <unordered_set>
#include <vector>

#include "sim/ground_mixer.hpp"
#include "sim/ground_readers.hpp"
#include "sim/text_file.hpp"

namespace waterlight {

namespace {

struct Point {
    double x = 0, y = 0;
    double z = 0;  ///< NaN for no data
};

constexpr const char* advice = "scattered points must be gridded first";

/// Reads the points one by one.
class PointReader {
  public:
    explicit PointReader(const std::filesystem::path& path) : file_(path) {}

    std::optional<Point> next() {
        while (const auto line = file_.next_line()) {
            if (is_blank(*line) || line->starts_with('#')) continue;
            const std::optional<LineOfNumbers> numbers = numbers_in(*line);
            if (!numbers && in_heading_) continue;
            if (!numbers || numbers->count != 3) {
                file_.fail(fmt::format("three numbers are wanted, x, y and z; found {}", quoted(*line)));
            }
            in_heading_ = false;
            const auto [x, y, z, none] = numbers->values;
            if (!std::isfinite(x) || !std::isfinite(y) || std::isinf(z)) {
                file_.fail(fmt::format("finite numbers are wanted, or NaN for no data as z; found {}", quoted(*line)));
            }
            return Point{x, y, z};
        }
        return {};
    }

    const TextFile& file() const { return file_; }

  private:
    TextFile file_;
    bool in_heading_ = true;
};

/// The first of evenly spaced coordinates and their spacing; sorts them. `axis` is their name in messages.
std::pair<double, double> spacing_of(std::vector<double>& values, const char* axis, const TextFile& file) {
    if (values.size() < 2) {
        file.reject(fmt::format("all its points have the same {0}; a lattice has two {0} or more", axis));
    }
    if (values.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) file.reject("has too many points");
    std::ranges::sort(values);
    const double first = values.front(), spacing = (values.back() - first) / static_cast<double>(values.size() - 1);
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double even = first + static_cast<double>(k) * spacing;
        if (std::abs(values[k] - even) <= spacing / 20) continue;
        file.reject(
            fmt::format("its points are no lattice: {0} = {1:.10g} stands where evenly spaced columns and rows "
                        "have {0} = {2:.10g}; {3}",
                        axis, values[k], even, advice));
    }
    return {first, spacing};
}

/// The lattice on which the points of a file lie.
Lattice lattice_of(const std::filesystem::path& path) {
    PointReader reader(path);
    std::unordered_set<double> xs, ys;
    // A line takes "0 0 0" and its end. Half of the points at least must be there.
    const double most_places = 2 * (static_cast<double>(reader.file().bytes()) / 6 + 1);
    double points = 0;
    const auto require_lattice = [&](double most) {
        if (static_cast<double>(xs.size()) * static_cast<double>(ys.size()) <= most) return;
        reader.file().reject(
            fmt::format("its points are no lattice: {} of them have {} different x and {} different "
                        "y; {}",
                        points, xs.size(), ys.size(), advice));
    };
    while (const auto point = reader.next()) {
        ++points;
        const bool x_is_new = xs.insert(point->x).second, y_is_new = ys.insert(point->y).second;
        if (x_is_new || y_is_new) require_lattice(most_places);
    }
    if (points == 0) reader.file().reject("holds no line of three numbers, x, y and z");
    require_lattice(2 * points);
    std::vector<double> x(xs.begin(), xs.end()), y(ys.begin(), ys.end());
    const auto [x0, dx] = spacing_of(x, "x", reader.file());
    const auto [y0, dy] = spacing_of(y, "y", reader.file());
    return {static_cast<int>(x.size()), static_cast<int>(y.size()), dx, dy, x0, y0};
}

}  // namespace

Field<double> read_ground_xyz(const GroundFile& file, const Grid& grid) {
    const Lattice lattice = lattice_of(file.path);
    GroundMixer mixer(file, lattice, grid);
    std::vector<bool> seen(static_cast<std::size_t>(lattice.nx) * static_cast<std::size_t>(lattice.ny));
    PointReader reader(file.path);
    while (const auto point = reader.next()) {
        const double column = std::round((point->x - lattice.x0_m) / lattice.dx_m);
        const double row = std::round((point->y - lattice.y0_m) / lattice.dy_m);
        if (!(column >= 0 && column < lattice.nx && row >= 0 && row < lattice.ny)) {
            reader.file().fail("the file has changed while it was read");
        }
        const int i = static_cast<int>(column), j = static_cast<int>(row);
        auto at =
            seen[static_cast<std::size_t>(j) * static_cast<std::size_t>(lattice.nx) + static_cast<std::size_t>(i)];
        if (at) reader.file().fail(fmt::format("the point ({:.10g}, {:.10g}) is there twice", point->x, point->y));
        at = true;
        if (!std::isnan(point->z)) mixer.add(i, j, point->z);
        if (std::isnan(point->z) && file.outside == OutsideFile::refuse && mixer.needs(i, j)) {
            reader.file().fail(
                fmt::format("found no data at {}; outside = \"extend\" would take the nearest data "
                            "there",
                            mixer.place(i, j)));
        }
    }
    return mixer.heights();
}

}  // namespace waterlight
