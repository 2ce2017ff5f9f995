// Marching squares (Lorensen & Cline 1987, in the plane) on the squares between four cell centres; their segments are
// then followed from edge to edge.
#include "sim/runup.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <map>

namespace waterlight {

namespace {

/// An edge between two neighbouring cell centres, numbered by its first cell and its direction.
using Edge = std::int64_t;

struct Cell {
    int i = 0, j = 0;
};

class Tracer {
  public:
    Tracer(const Grid& grid, const Field<float>& bed_m, const Field<float>& max_elevation_m)
        : grid_(grid), bed_(bed_m), highest_(max_elevation_m) {}

    std::vector<RunupLine> lines() {
        for (int j = 0; j + 1 < grid_.ny; ++j)
            for (int i = 0; i + 1 < grid_.nx; ++i) add_square({i, j});
        std::vector<RunupLine> result;
        // Open lines from one of their ends; what is left are loops.
        for (const auto& [edge, next] : neighbours_)
            if (next[1] == none) follow(edge, result);
        for (const auto& [edge, next] : neighbours_) follow(edge, result);
        return result;
    }

  private:
    static constexpr Edge none = -1;

    bool wet(Cell c) const { return !std::isnan(highest_(c.i, c.j)); }
    Edge along_x(Cell c) const { return 2 * (static_cast<Edge>(c.j) * grid_.nx + c.i); }
    Edge along_y(Cell c) const { return along_x(c) + 1; }

    /// The corners run round the square; edge k joins corner k with the next.
    void add_square(Cell c) {
        const std::array<bool, 4> corner{wet(c), wet({c.i + 1, c.j}), wet({c.i + 1, c.j + 1}), wet({c.i, c.j + 1})};
        const std::array<Edge, 4> edge{along_x(c), along_y({c.i + 1, c.j}), along_x({c.i, c.j + 1}), along_y(c)};
        std::array<Edge, 4> crossed{};
        int count = 0;
        for (std::size_t k = 0; k < 4; ++k)
            if (corner[k] != corner[(k + 1) % 4]) crossed[static_cast<std::size_t>(count++)] = edge[k];
        if (count == 2) join(crossed[0], crossed[1]);
        if (count < 4) return;
        // Wet corners face each other across the square: each dry one is cut off by itself.
        const bool first_is_dry = !corner[0];
        join(edge[0], edge[first_is_dry ? 3 : 1]);
        join(edge[2], edge[first_is_dry ? 1 : 3]);
    }

    void join(Edge a, Edge b) {
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
            auto& next = neighbours_.try_emplace(from, std::array<Edge, 2>{none, none}).first->second;
            next[next[0] == none ? 0 : 1] = to;
        }
    }

    void follow(Edge start, std::vector<RunupLine>& lines) {
        if (followed_[start]) return;
        RunupLine line;
        Edge from = none, at = start;
        while (at != none && !followed_[at]) {
            followed_[at] = true;
            const RunupPoint point = crossing(at);
            if (line.empty() || line.back().at_m != point.at_m) line.push_back(point);
            const std::array<Edge, 2>& next = neighbours_.at(at);
            const Edge onwards = next[0] == from ? next[1] : next[0];
            from = at;
            at = onwards;
        }
        if (at != none && line.size() > 1) line.push_back(line.front());
        lines.push_back(std::move(line));
    }

    /// Where the level of the wet cell meets the ground on the way to the dry one.
    RunupPoint crossing(Edge edge) const {
        const int cell = static_cast<int>(edge / 2);
        const Cell first{cell % grid_.nx, cell / grid_.nx};
        const Cell second{first.i + (edge % 2 == 0 ? 1 : 0), first.j + (edge % 2 == 0 ? 0 : 1)};
        const Cell from = wet(first) ? first : second, to = wet(first) ? second : first;
        const double low = bed_(from.i, from.j), high = bed_(to.i, to.j), water = highest_(from.i, from.j);
        const double part = high > low ? std::clamp((water - low) / (high - low), 0.0, 1.0) : 0.5;
        const glm::dvec2 a{grid_.x_m(from.i), grid_.y_m(from.j)}, b{grid_.x_m(to.i), grid_.y_m(to.j)};
        return {a + part * (b - a), low + part * (high - low)};
    }

    const Grid& grid_;
    const Field<float>& bed_;
    const Field<float>& highest_;
    std::map<Edge, std::array<Edge, 2>> neighbours_;
    std::map<Edge, bool> followed_;
};

}  // namespace

std::vector<RunupLine> runup_lines(const Grid& grid, const Field<float>& bed_m, const Field<float>& max_elevation_m) {
    assert(bed_m.nx() == grid.nx && bed_m.ny() == grid.ny);
    assert(max_elevation_m.nx() == grid.nx && max_elevation_m.ny() == grid.ny);
    return Tracer(grid, bed_m, max_elevation_m).lines();
}

std::optional<RunupPoint> highest_runup(const Grid& grid, const Field<float>& bed_m,
                                        const Field<float>& max_elevation_m) {
    std::optional<RunupPoint> highest;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            if (std::isnan(max_elevation_m(i, j)) || (highest && bed_m(i, j) <= highest->ground_m)) continue;
            highest = RunupPoint{{grid.x_m(i), grid.y_m(j)}, bed_m(i, j)};
        }
    return highest;
}

}  // namespace waterlight
