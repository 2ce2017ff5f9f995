// The vertices of caustics mapping after their landing.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "caustics/floor_frame.hpp"
#include "caustics/splat/receivers.hpp"

namespace waterlight {

/// Landed vertices in rows. Of a lattice the neighbours are a column and a row away, and its outermost vertices carry
/// no light; else they are listed.
struct SplatCloud {
    std::vector<glm::dvec2> pixel;   ///< where each lands, on the map; may be not finite where it carries no light
    std::vector<double> power_w;     ///< with which
    std::vector<char> own;           ///< whether its light is of the domain
    std::vector<int> row_begin;      ///< first vertex of each row, and the end of the last
    int columns = 0;                 ///< of a lattice
    std::vector<glm::ivec2> vertex;  ///< of the lattice, of each; empty for a lattice
    /// West, east, south, north; -1: none whose light goes the same way. Empty for a lattice.
    std::vector<glm::ivec4> neighbours;
    glm::dvec2 step_x{1, 0}, step_y{0, 1};  ///< from vertex to vertex where light goes straight, pixels
    FloorLedger ledger;                     ///< of all but what is laid on the map
    SplatReport report;
};

/// Lands light that leaves start_m along a unit direction with so much power; what the way takes goes to
/// `extinguished`, what is not seen to land to the ledger, and both to the report.
struct Flight {
    glm::dvec3 start_m{0, 0, 0};
    glm::dvec3 direction{0, 0, -1};
    double power_w = 0;
    double extinction_per_m = 0;
    bool own = true;
};
struct Arrival {
    glm::dvec2 pixel{0, 0};
    double power_w = 0;
};

/// The account of some flights, to be added in order.
struct FlightAccount {
    FloorLedger ledger;
    SplatReport report;
    double step2_m2 = 0;  ///< sum of squares of the last steps

    void add(const FlightAccount& other);
    SplatReport summed_report() const;
    /// Into a cloud.
    void finish(SplatCloud& cloud) const;
};

/// Lands flights of one frame.
class Lander {
  public:
    Lander(const SplatSettings& settings, const SplatFrame& frame, const Receivers& receivers)
        : options_(settings.options), frame_(frame), receivers_(receivers) {}
    Arrival operator()(const Flight& flight, FlightAccount& account) const;

  private:
    const SplatOptions& options_;
    const SplatFrame& frame_;
    const Receivers& receivers_;
};

/// How SurfaceRows is told where the vertices of a lattice are. Beyond walls they read the water that is mirrored
/// there; the sign of its slopes is theirs to change.
FloorFrame vertex_rows(const VertexLattice& lattice, const Grid& grid, Boundary sides);

/// Widens the frame's lattice to all vertices of the water alone.
void widen_to_water(const SplatSettings& settings, SplatFrame& frame, const Surface& surface);

/// The water alone: a lattice of vertices on its surface. Widens the frame's lattice.
SplatCloud land_water(const SplatSettings& settings, SplatFrame& frame, const Receivers& receivers,
                      const Surface& surface);

}  // namespace waterlight
