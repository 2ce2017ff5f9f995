// Beams of refracted light: a grid projected from the sun onto the surface, each of its triangles the base of a warped
// prism of light that ends on the floor or on the ground. The formulas are in kernels/beams.glsl, with their source.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "caustics/beam_ground.hpp"
#include "caustics/light.hpp"
#include "sim/surface.hpp"

namespace waterlight {

class ObjectSet;
struct BeamPieces;

/// A rectangle of the plane z = 0 that the sun's rays cross on their way to the surface.
struct BeamWindow {
    glm::dvec2 origin_m{0, 0};
    glm::dvec2 size_m{1, 1};
};

struct BeamSettings {
    glm::ivec2 grid{128, 128};         ///< cells, each of two beams, >= 1
    std::optional<BeamWindow> window;  ///< none: all that lights the domain
    double depth_m = 1;                ///< floor at z = -depth, > 0; with `ground`, how deep the water is at least
    std::shared_ptr<const BeamGround> ground;  ///< none: a flat floor
    Sun sun;
    WaterOptics optics;
    /// What stops beams; none: nothing. Glass and mirrors stop them as well: beams neither pass through nor turn.
    /// Placed by the surface's time, repeated beyond periodic sides. What is above the water shades its surface.
    std::shared_ptr<const ObjectSet> objects;
    /// Triangles that face the sun less than this are discarded (the paper's heuristic), in [0, 1).
    double least_cosine = 0.02;
};

/// Where the light on the grid went, in watts. incident = reflected + extinguished + floor + outside + objects +
/// discarded + dry.
struct BeamLedger {
    double incident_w = 0;
    double reflected_w = 0;     ///< off the surface; of reflected beams, what the surface lets in
    double extinguished_w = 0;  ///< absorbed or scattered on the way
    double floor_w = 0;
    double outside_w = 0;    ///< landed beyond the domain's sides
    double discarded_w = 0;  ///< on triangles that turn away from the sun
    double dry_w = 0;        ///< on ground without water
    double objects_w = 0;    ///< stopped by objects
    /// |what is unaccounted for| / incident; 0 where there is no light.
    double closure() const;
};

BeamLedger operator+(BeamLedger a, const BeamLedger& b);

/// The beams of one surface. Corners are shared: corner (i, j) is at the grid's column i of 0 .. nx, row j of 0 .. ny.
/// Cell (i, j) has beam 2 i with corners (i, j), (i + 1, j), (i + 1, j + 1) and beam 2 i + 1 with corners (i, j),
/// (i + 1, j + 1), (i, j + 1).
struct Beams {
    int nx = 0;
    int ny = 0;
    Grid domain;  ///< what the beams light; periodic sides repeat them
    Boundary boundary;
    double depth_m = 1;  ///< of the floor, or of the lowest ground where that is deeper
    double extinction_per_m = 0;
    double time_s = 0;
    /// Whether these are beams of reflected light: heights are counted downwards from still water, so that the air is
    /// where the water is of other beams, with a floor at -depth_m where they end.
    bool mirrored = false;

    Field<float> x, y, z;             ///< corners on the surface, m
    Field<float> travel_x, travel_y;  ///< metres per metre of descent
    Field<float> path;                ///< metres of way per metre of descent
    /// Where the way of each corner's light ends: on the floor, m. Above z where the ground is dry.
    Field<float> end_z;
    Field<float> transmittance;  ///< Fresnel
    /// Of each beam just below the surface, W, as if all of its triangle were wet; 0 where discarded or dry, or where
    /// objects stop any of it: then what is left of it is in `pieces`.
    Field<float> flux;
    float lowest_m = 0, highest_m = 0;  ///< of z
    BeamLedger ledger;
    std::shared_ptr<const BeamGround> ground;  ///< as in the settings
    std::shared_ptr<BeamPieces> pieces;        ///< none where no object stops a beam
};

/// Beams that objects cut, in pieces that end together: on the floor, on the ground or on an object. Piece k is beam 4
/// k of the one row; the other beams have no flux. Fields, places and pictures add them to the whole beams.
struct BeamPieces {
    Beams beams;
    std::vector<glm::ivec2> of;  ///< of each piece the whole beam, and its row
    std::vector<bool> stopped;   ///< of each piece, whether it ends on an object
};

/// Gives `beams` room for a grid of so many cells.
void resize(Beams& beams, glm::ivec2 grid);

/// The corners of beam b (2 i or 2 i + 1) in row j as {column, row}.
inline std::array<glm::ivec2, 3> corners_of(int b, int j) {
    const int i = b / 2;
    if (b % 2 == 0) return {{{i, j}, {i + 1, j}, {i + 1, j + 1}}};
    return {{{i, j}, {i + 1, j + 1}, {i, j + 1}}};
}

/// Captures the surface along the sun's rays, the first that each meets, and refracts. Between the surface's cells it
/// is bilinear in elevation and slopes; beyond periodic sides it repeats, beyond absorbing sides the water is still; at
/// walls the outermost corners are drawn in, so that beams end at the wall. On ground each corner's light ends where
/// its ray first meets it; beams between dry corners carry none. Objects take what falls on them, in the water and on
/// its way to it; a beam that is partly stopped is cut along the edge of the shadow (beam_cut.hpp), the others are as
/// without objects, to the last bit. `beams` is reused where its size fits.
/// Throws InputError where a setting is out of its range.
void make_beams(const BeamSettings& settings, const Surface& surface, Beams& beams);

/// Beams of the light that the surface reflects, up to the height `depth_m`; absorption and scattering in `optics` are
/// those of the air. Fields, places and pictures are made of them as of others, in heights counted downwards
/// (`mirrored` of Beams; pictures with mirrored() of the camera). Light reflected twice is not followed: it passes
/// through waves in its way, and where it leaves less than 0.57 degrees above the horizon it counts as discarded. The
/// ground does not matter. Objects above the water stop it as they stop light in it. Throws as make_beams().
void make_reflected_beams(const BeamSettings& settings, const Surface& surface, Beams& beams);

}  // namespace waterlight
