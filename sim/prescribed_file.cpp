#include "sim/prescribed_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/error.hpp"

namespace waterlight {

namespace {

// Where one value along an axis comes from: before + part * (after - before).
struct Mix {
    int before = 0;
    int after = 0;
    float part = 0;
};

Mix mix_at(double cell, int count, Side side) {
    // A place that is a cell centre but for rounding takes that cell alone.
    const double nearest = std::round(cell);
    const double exact = std::abs(cell - nearest) < 1e-6 ? nearest : cell;
    const double before = std::floor(exact);
    const int index = static_cast<int>(before);
    const auto inside = [&](int i) {
        return side == Side::periodic ? (i % count + count) % count : std::clamp(i, 0, count - 1);
    };
    return {inside(index), inside(index + 1), static_cast<float>(exact - before)};
}

void require_covered(const Grid& from, const Grid& grid, const std::string& name) {
    const double near_x = 1e-6 * grid.width_m();
    const double near_y = 1e-6 * grid.height_m();
    const bool covered = from.x0_m <= grid.x0_m + near_x && from.y0_m <= grid.y0_m + near_y &&
                         from.x0_m + from.width_m() >= grid.x0_m + grid.width_m() - near_x &&
                         from.y0_m + from.height_m() >= grid.y0_m + grid.height_m() - near_y;
    if (covered) return;
    throw InputError(
        fmt::format("{}: covers [{:g}, {:g}] x [{:g}, {:g}] m, which is not all of the domain, "
                    "[{:g}, {:g}] x [{:g}, {:g}] m",
                    name, from.x0_m, from.x0_m + from.width_m(), from.y0_m, from.y0_m + from.height_m(), grid.x0_m,
                    grid.x0_m + grid.width_m(), grid.y0_m, grid.y0_m + grid.height_m()));
}

}  // namespace

Field<float> resampled(const VtiField& from, const Grid& grid, Boundary boundary, const std::string& name) {
    require_covered(from.grid, grid, name);
    const auto is_number = [](float v) { return std::isfinite(v); };
    if (!std::ranges::all_of(from.values.values(), is_number)) {
        throw InputError(fmt::format("{}: array \"elevation\" holds values that are not finite numbers", name));
    }
    // A file larger than the domain does not repeat with it.
    const auto side = [](Side asked, double file_m, double domain_m) {
        return std::abs(file_m - domain_m) <= 1e-6 * domain_m ? asked : Side::wall;
    };
    const Side side_x = side(boundary.x, from.grid.width_m(), grid.width_m());
    const Side side_y = side(boundary.y, from.grid.height_m(), grid.height_m());
    std::vector<Mix> columns;
    for (int i = 0; i < grid.nx; ++i) {
        columns.push_back(mix_at((grid.x_m(i) - from.grid.x_m(0)) / from.grid.dx_m, from.grid.nx, side_x));
    }
    Field<float> to(grid.nx, grid.ny);
    for (int j = 0; j < grid.ny; ++j) {
        const Mix row = mix_at((grid.y_m(j) - from.grid.y_m(0)) / from.grid.dy_m, from.grid.ny, side_y);
        const float* south = from.values.row(row.before);
        const float* north = from.values.row(row.after);
        float* out = to.row(j);
        for (const Mix& column : columns) {
            const float s = std::lerp(south[column.before], south[column.after], column.part);
            const float n = std::lerp(north[column.before], north[column.after], column.part);
            *out++ = std::lerp(s, n, row.part);
        }
    }
    return to;
}

FileSeries::FileSeries(const std::filesystem::path& path, const Grid& grid, Boundary boundary)
    : grid_(grid), boundary_(boundary) {
    files_ = path.extension() == ".pvd" ? read_pvd(path) : std::vector<TimedFile>{{0, path}};
    for (const TimedFile& file : files_) stamps_.push_back(stamp_of(file.path));
    loaded(0);
}

const Field<float>& FileSeries::loaded(std::size_t index) {
    const auto found = std::ranges::find(recent_, index, &Loaded::index);
    if (found != recent_.end()) return found->elevation_m;
    if (recent_.size() == 2) recent_.erase(recent_.begin());
    const std::filesystem::path& path = files_[index].path;
    const VtiField read = read_vti(path, "elevation");
    if (stamp_of(path) != stamps_[index])
        throw InputError(fmt::format("{}: changed since the run started", path.string()));
    recent_.push_back({index, resampled(read, grid_, boundary_, path.string())});
    return recent_.back().elevation_m;
}

void FileSeries::elevation_at(double time_s, Field<float>& elevation_m) {
    const auto later = std::ranges::upper_bound(files_, time_s, {}, &TimedFile::time_s);
    if (later == files_.begin() || later == files_.end()) {
        std::ranges::copy(loaded(later == files_.begin() ? 0 : files_.size() - 1).values(), elevation_m.data());
        return;
    }
    const auto after_index = static_cast<std::size_t>(later - files_.begin());
    const double before_s = files_[after_index - 1].time_s;
    const auto part = static_cast<float>((time_s - before_s) / (later->time_s - before_s));
    // The older one first, so that it is the one to go when the series moves on.
    loaded(after_index - 1);
    const Field<float>& after = loaded(after_index);
    const Field<float>& before = loaded(after_index - 1);
    for (int j = 0; j < elevation_m.ny(); ++j) {
        for (int i = 0; i < elevation_m.nx(); ++i) {
            elevation_m(i, j) = std::lerp(before(i, j), after(i, j), part);
        }
    }
}

}  // namespace waterlight
