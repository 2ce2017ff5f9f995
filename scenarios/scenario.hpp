// A scenario: everything that a run is made of, as plain data. scenarios/schema.cpp says what each setting is called in
// a file, its unit and its range; the member initialisers here and in sim/ and caustics/ are the defaults.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "caustics/camera.hpp"
#include "caustics/floor.hpp"
#include "caustics/light.hpp"
#include "caustics/objects/object_set.hpp"
#include "caustics/photons/photons.hpp"
#include "caustics/splat/splat.hpp"
#include "export/vti.hpp"
#include "scenarios/check.hpp"
#include "scenarios/inflow.hpp"
#include "scenarios/light_section.hpp"
#include "scenarios/origin.hpp"
#include "scenarios/picture_section.hpp"
#include "sim/bathymetry.hpp"
#include "sim/boundary.hpp"
#include "sim/prescribed.hpp"
#include "sim/shallow_initial.hpp"
#include "sim/sines.hpp"
#include "sim/sources.hpp"
#include "sim/spectrum.hpp"
#include "sim/water.hpp"

namespace waterlight {

/// The rungs of the ladder of wave models; automatic lets the program choose.
enum class ModelChoice { automatic, linear, airy, shallow_water, prescribed };

enum class FloorMethod { two_pass, truth, quads, splat, photons };
/// The name of a method as a scenario has it.
std::string_view name_of(FloorMethod method);
/// The names of all, in the order of the enumeration.
inline constexpr std::array floor_method_names{"two-pass", "truth", "quads", "splat", "photons"};

/// The names of shapes and materials, in the order of Shape and of Material::Type.
inline constexpr std::array shape_names{"sphere", "box", "ring", "cup", "mesh"};
inline constexpr std::array material_names{"diffuse", "mirror", "glass"};

/// The patch of water, [0, size] with the grid's cells.
struct DomainSection {
    glm::dvec2 size_m{1, 1};
    glm::ivec2 cells{0, 0};                 ///< 0: chosen by settle()
    double depth_m = 1;                     ///< of the flat floor, and of the water for light
    std::optional<std::string> bathymetry;  ///< file of the ground, in place of the flat floor
    GroundFile survey;                      ///< how that file is meant; its path is in bathymetry
    std::vector<GroundShape> ground;
};

struct WavesSection {
    ModelChoice model = ModelChoice::automatic;
    std::optional<SideChoice> boundary_x;  ///< none: chosen by resolve_sides()
    std::optional<SideChoice> boundary_y;
    std::optional<SideChoice> boundary_west, boundary_east, boundary_south, boundary_north;  ///< none: of the axis
    std::vector<Inflow> inflows;
    double duration_s = 0;
    std::optional<double> cfl;       ///< none: the model's own
    std::optional<double> margin_m;  ///< none: chosen by the model
    std::optional<double> manning;   ///< s/m^(1/3); none: no friction
    std::optional<double> wet_m;     ///< depth from which ground counts as inundated; none: the model's own
    std::optional<glm::dvec2> slope;
    std::optional<std::string> file;
    std::vector<Sine> sines;
    std::vector<StandingWave> standing;
    std::optional<SpectrumSettings> spectrum;
    std::optional<BuoySettings> buoy;
    std::optional<GerstnerSettings> gerstner;
    std::vector<Source> sources;
    std::vector<ShallowInitial> initial;  ///< of the model shallow-water
};

struct FloorSection {
    FloorMethod method = FloorMethod::two_pass;
    glm::ivec2 pixels{0, 0};            ///< 0: chosen by settle()
    std::optional<FloorWindow> window;  ///< none: auto
    Footprint footprint = Footprint::adaptive;
    int samples_per_pixel = 1;  ///< along each axis
    ReceiverSection on;
    double angle_deg = 0;
    std::optional<glm::dvec2> centre_m;  ///< none: of the domain
    std::optional<glm::dvec2> size_m;    ///< none: the domain's
    double tolerance = 1e-3;             ///< of the truth: relative RMSE that its own estimate is to reach
    int most_subsamples = 32;            ///< of the truth: per pixel and axis, where its refinement ends
    SplatOptions splat;                  ///< of the method splat
    PhotonOptions photons;               ///< of the method photons
};

/// Beams of the light that the surface reflects, and the air that they pass.
struct ReflectedSection {
    double height_m = 1;          ///< where they end
    double absorption_per_m = 0;  ///< of the air, as the next
    double scattering_per_m = 1e-4;
    Phase phase{.g = 0.75};
};

struct BeamsSection {
    glm::ivec2 grid{0, 0};                   ///< 0: chosen by settle()
    std::optional<glm::dvec2> centre_m;      ///< of the grid, at still water along the sun's rays; none: the domain's
    std::optional<glm::dvec2> size_m;        ///< none: all that lights the domain
    std::optional<glm::ivec3> volume_cells;  ///< none: no fields in the water
    std::optional<double> refine_below;      ///< share of make_refined_beams(), for pictures; none: one grid
    std::optional<ReflectedSection> reflected;
};

/// Something in or above the water.
struct ObjectSection {
    Object object;
    std::optional<std::string> file;  ///< of a mesh, which read_data() puts into Scenario::object_set
    double file_scale = 1;            ///< metres per unit of that file
    bool smooth = false;              ///< normals of a mesh
};

/// What sees the scene and the light that the water scatters.
struct CameraSection {
    Camera camera;
    int samples = 1;
    int reduction = 1;
    std::optional<double> range_m;           ///< none: chosen by beam_image_settings()
    std::optional<double> radiance_max;      ///< of the pictures, W/(m2 sr); none: of each frame
    std::optional<double> radiance_decades;  ///< below it that the pictures show, on a logarithmic scale; none: linear
};

struct OutputSection {
    double every_s = 0.1;
    std::optional<double> probe_every_s;  ///< none: every_s
    double checkpoint_every_s = 60;       ///< of wall time; 0: never
    std::vector<std::string> formats{"vti", "png"};
    bool image = false;  ///< a picture of the scene, as the camera sees it
    std::vector<std::string> fields{"elevation", "velocity", "depth"};
    Compression compression = Compression::none;
    std::optional<double> elevation_max_m;      ///< of the pictures; none: of each frame
    std::optional<double> irradiance_max_w_m2;  ///< of the pictures; none: three times that of flat water

    bool wants(const std::string& format) const;
    bool shows(const std::string& field) const;
};

/// How wrong the run may be, and how wrong it is.
/// A gauge: the elevation of the surface, and the irradiance below it, at one place.
struct Probe {
    std::string name;
    glm::dvec2 at_m{0, 0};
    std::optional<double> depth_m;  ///< of the irradiance below still water; none: on the floor
};

/// What the run is measured by.
struct AccuracySection {
    double tolerance = 0.02;  ///< of the waves, a fraction of a wavelength (sim/wave_terms.hpp); of contrasts of light
    bool strict = false;      ///< refuse what no model meets
    bool estimate = false;    ///< estimate the errors of maps and surfaces
};

/// A wave model and why it was taken.
struct ModelDecision {
    ModelChoice model = ModelChoice::airy;  ///< never automatic
    std::vector<std::string> reasons;
    std::string warning;  ///< empty where the tolerance is met
};

struct Scenario {
    std::string title;
    DomainSection domain;
    Water water;         ///< its depth is the domain's
    WaterOptics optics;  ///< of light of one colour
    WaterColourSection water_colour;
    WavesSection waves;
    Sun light;
    SunSection sun;
    std::optional<Lamp> lamp;  ///< in place of the sun
    std::vector<ObjectSection> objects;
    std::shared_ptr<const ObjectSet> object_set;  ///< all with their meshes, by read_data(); none: there are none
    AccuracySection accuracy;
    std::optional<FloorSection> floor;
    std::optional<BeamsSection> beams;
    std::optional<WallsSection> walls;
    std::optional<CameraSection> camera;
    PictureSection picture;
    OutputSection output;
    std::vector<Probe> probes;
    std::vector<Check> checks;
    CheckRunSection check_run;

    std::optional<ModelDecision> decided;  ///< by settle(), where something was left open
    Origin origin;                         ///< where each key was stated
};

}  // namespace waterlight
