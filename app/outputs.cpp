#include "app/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "app/ledger_table.hpp"
#include "export/checkpoint_file.hpp"
#include "export/frames.hpp"
#include "export/runup.hpp"
#include "scenarios/resolve.hpp"
#include "scenarios/resolve_light.hpp"
#include "scenarios/resolve_picture.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> probe_columns(const Scenario& scenario) {
    std::vector<std::string> columns;
    for (const Probe& probe : scenario.probes) {
        columns.push_back(fmt::format("{}.elevation_m", probe.name));
        if (scenario.floor || probe.depth_m) columns.push_back(fmt::format("{}.irradiance_w_m2", probe.name));
        if (probe.depth_m) columns.push_back(fmt::format("{}.scalar_irradiance_w_m2", probe.name));
    }
    return columns;
}

/// Depth of the water (m) over a flat floor.
Field<float> depth_over(const Field<float>& elevation, double still_depth_m) {
    Field<float> depth = elevation.clone();
    for (float& d : depth.values()) d += static_cast<float>(still_depth_m);
    return depth;
}

bool wants_extremes(const OutputSection& settings) {
    return settings.shows("max_elevation") || settings.shows("max_speed") || settings.shows("arrival_time");
}

/// The elevation where the water is deeper than wet_m, NaN elsewhere.
Field<float> wet_part(const Surface& surface, double wet_m) {
    Field<float> shown = surface.elevation.clone();
    const auto least = static_cast<float>(wet_m);
    for (std::size_t n = 0; n < shown.size(); ++n)
        if (!(surface.depth->data()[n] > least)) shown.data()[n] = std::numeric_limits<float>::quiet_NaN();
    return shown;
}

fs::path image_name(const std::string& name, int frame, const char* extension) {
    return fs::path("images") / fmt::format("{}_{:06}.{}", name, frame, extension);
}

std::vector<std::string> columns_of_ledgers(const Scenario& scenario) {
    std::vector<std::string> columns;
    const auto add = [&](const std::string& follower) {
        for (std::string& column : ledger_columns(follower)) columns.push_back(std::move(column));
    };
    if (scenario.floor) add("floor");
    if (scenario.beams) add("beams");
    if (scenario.walls) add("walls");
    return columns;
}

Surface copy_of(const Surface& surface, const OutputSection& settings, double still_depth_m) {
    const auto copy_if = [](bool wanted, const std::optional<Field<float>>& field) {
        return wanted && field ? std::optional(field->clone()) : std::nullopt;
    };
    Surface copy;
    copy.grid = surface.grid;
    copy.boundary = surface.boundary;
    copy.time_s = surface.time_s;
    copy.elevation = surface.elevation.clone();
    const bool fields = settings.wants("vti");
    if (fields && settings.shows("slope")) {
        copy.slope_x = surface.slope_x.clone();
        copy.slope_y = surface.slope_y.clone();
    }
    copy.velocity_x = copy_if(fields && settings.shows("velocity"), surface.velocity_x);
    copy.velocity_y = copy_if(fields && settings.shows("velocity"), surface.velocity_y);
    copy.depth = copy_if(fields && settings.shows("depth"), surface.depth);
    if (fields && settings.shows("depth") && !copy.depth) copy.depth = depth_over(surface.elevation, still_depth_m);
    return copy;
}

}  // namespace

std::string guide_line(const fs::path& path, const std::string& what) {
    return fmt::format("  {:<40} {}", path.string(), what);
}

std::size_t FrameFiles::bytes() const {
    std::size_t count =
        surface.elevation.size() + surface.slope_x.size() + surface.slope_y.size() + irradiance.size() + shown.size();
    for (const auto* field : {&surface.velocity_x, &surface.velocity_y, &surface.depth})
        if (*field) count += (*field)->size();
    for (const Field<float>& wall : walls) count += wall.size();
    for (const BandFiles& band : bands) count += band.irradiance.size();
    count += plane_irradiance.size() + scalar_irradiance.size() + radiance.size();
    count += floor_error.size() + waves_error.size();
    return count * sizeof(float) + scene.image.pixels.size();
}

Outputs::Outputs(const RunFolder& folder, const Scenario& scenario, StateArchive* state)
    : place_(folder),
      folder_(folder.path()),
      settings_(scenario.output),
      depth_m_(scenario.domain.depth_m),
      wet_m_(scenario.waves.wet_m.value_or(ShallowWaterSettings{}.wet_m)),
      irradiance_max_(irradiance_max(scenario)),
      surface_series_(folder_, "surface", settings_.compression),
      floor_series_(folder_, "floor", settings_.compression),
      volume_series_(folder_, "volume", settings_.compression),
      walls_series_(folder_, "walls", settings_.compression),
      camera_series_(folder_, "camera", settings_.compression),
      has_volume_(scenario.beams && scenario.beams->volume_cells),
      has_picture_(sees_scattered_light(scenario)),
      radiance_max_(scenario.camera ? scenario.camera->radiance_max : std::nullopt),
      radiance_decades_(scenario.camera ? scenario.camera->radiance_decades : std::nullopt) {
    if (scenario.floor) plan_ = floor_settings(scenario).plan;
    if (scenario.walls) walls_ = wall_settings(scenario);
    if (scenario.output.image) look_ = look_of(scenario);
    if (state) exchange_state(*state);
    const auto open = [&](std::optional<ProbeTable>& table, const char* name, const std::vector<std::string>& columns,
                          std::uint64_t bytes) {
        if (state)
            table.emplace(folder_ / name, columns, bytes);
        else
            table.emplace(folder_ / name, columns);
        written_.insert(folder_ / name);
    };
    if (const std::vector<std::string> ledgers = columns_of_ledgers(scenario); !ledgers.empty())
        open(ledgers_, "ledger.csv", ledgers, ledger_bytes_);
    if (!scenario.probes.empty()) open(probes_, "probes.csv", probe_columns(scenario), probe_bytes_);
}

void Outputs::exchange_state(StateArchive& state) {
    for (VtiSeries* series : {&surface_series_, &floor_series_, &volume_series_, &walls_series_, &camera_series_})
        series->exchange_state(state);
    state.value(frame_);
    state.value(elevation_range_);
    state.value(radiance_so_far_);
    if (probes_) probe_bytes_ = probes_->size();
    state.value(probe_bytes_);
    if (ledgers_) ledger_bytes_ = ledgers_->size();
    state.value(ledger_bytes_);
    std::string names;
    for (const fs::path& path : written_) names += path.lexically_relative(folder_).generic_string() + '\n';
    state.text(names);
    if (!state.restores()) return;
    std::istringstream lines(names);
    for (std::string name; std::getline(lines, name);) written_.insert(folder_ / name);
    require_written();
    state.value(checkpoint_s_.emplace());
}

void Outputs::require_written() const {
    for (const fs::path& path : written_)
        if (std::error_code error; !fs::exists(path, error) && !error)
            throw WorldError(fmt::format("{} was written by this run and is gone", path.string()));
}

template <class Job>
void Outputs::push_job(std::size_t bytes, Job job) {
    queue_.push(bytes, [this, job = std::move(job)]() mutable {
        place_.require_present();
        try {
            job();
        } catch (const WorldError&) {
            // That the folder vanished meanwhile says more.
            place_.require_present();
            throw;
        }
    });
}

void Outputs::push(const FrameView& view, std::vector<double> probes) {
    const Surface& surface = view.surface;
    FrameFiles frame;
    frame.surface = copy_of(surface, settings_, depth_m_);
    if (view.floor) frame.irradiance = view.floor->irradiance.clone();
    for (std::size_t w = 0; view.walls && w < frame.walls.size(); ++w)
        frame.walls[w] = view.walls->irradiance[w].clone();
    for (const BandMap& band : view.bands)
        frame.bands.push_back({band.band.wavelength_nm, band.band.share, band.map.irradiance.clone()});
    if (view.volume && settings_.wants("vti")) {
        frame.volume_cells = view.volume->cells;
        frame.volume_depth_m = view.volume->depth_m;
        frame.plane_irradiance = view.volume->plane_irradiance.clone();
        frame.scalar_irradiance = view.volume->scalar_irradiance.clone();
    }
    if (view.picture) frame.radiance = view.picture->radiance.clone();
    if (view.floor_error && settings_.wants("vti")) frame.floor_error = view.floor_error->clone();
    if (view.waves_error && settings_.wants("vti")) frame.waves_error = view.waves_error->clone();
    if (view.scene) frame.scene = *view.scene;
    const bool pictures = settings_.wants("png") || settings_.wants("png16");
    if (pictures && surface.depth) frame.shown = wet_part(surface, wet_m_);
    frame.probes = std::move(probes);
    frame.ledgers = ledger_row(view.ledgers);
    const std::size_t bytes = frame.bytes();
    push_job(bytes, [this, frame = std::move(frame)] { write(frame); });
}

void Outputs::push_row(double time_s, std::vector<double> probes) {
    const std::size_t bytes = probes.size() * sizeof(double);
    push_job(bytes, [this, time_s, probes = std::move(probes)] { probes_->append(time_s, probes); });
}

void Outputs::push_checkpoint(double time_s, StateArchive state) {
    const std::size_t bytes = state.bytes();
    push_job(bytes, [this, time_s, state = std::move(state)]() mutable {
        exchange_state(state);
        state.value(time_s);
        write_checkpoint(folder_ / checkpoint_name, state.parts());
        checkpoint_s_ = time_s;
    });
}

void Outputs::push_end(const Grid& grid, double time_s, const Field<float>& bed_m, const ShallowRecords& records,
                       std::vector<RunupLine> lines) {
    has_end_ = true;
    push_job(0, [&, this, time_s, lines = std::move(lines)] {
        write_runup(folder_ / "runup.csv", lines);
        written_.insert(folder_ / "runup.csv");
        const VtiFrame extremes = extremes_frame(grid, time_s, bed_m, records, settings_.fields);
        if (!wants_extremes(settings_) || !settings_.wants("vti")) return;
        write_vti(folder_ / "extremes.vti", extremes, settings_.compression);
        written_.insert(folder_ / "extremes.vti");
    });
}

void Outputs::write_fields(const FrameFiles& frame) {
    const double time_s = frame.surface.time_s;
    VtiFrame fields = surface_frame(frame.surface);
    if (!frame.surface.slope_x.empty())
        fields.arrays.push_back({"slope", {frame.surface.slope_x.values(), frame.surface.slope_y.values(), {}}});
    if (!frame.waves_error.empty()) fields.arrays.push_back({"error", {frame.waves_error.values()}});
    add_to(surface_series_, "surface.pvd", fields);
    if (plan_) {
        VtiFrame map = floor_frame(*plan_, depth_m_, time_s, frame.irradiance);
        for (const BandFiles& band : frame.bands)
            map.arrays.push_back({fmt::format("irradiance_{}nm", band.wavelength_nm), {band.irradiance.values()}});
        if (!frame.floor_error.empty()) map.arrays.push_back({"error", {frame.floor_error.values()}});
        add_to(floor_series_, "floor.pvd", map);
    }
    if (has_volume_)
        add_to(volume_series_, "volume.pvd",
               volume_frame({frame.surface.grid, frame.volume_depth_m, time_s}, frame.volume_cells,
                            frame.plane_irradiance, frame.scalar_irradiance));
    if (walls_) write_walls(frame);
    if (has_picture_) add_to(camera_series_, "camera.pvd", picture_frame(time_s, frame.radiance));
}

void Outputs::add_to(VtiSeries& series, const char* name, const VtiFrame& frame) {
    place_.require_present();
    written_.insert(series.write(frame));
    written_.insert(folder_ / name);
}

void Outputs::write_walls(const FrameFiles& frame) {
    const WaterBody water{frame.surface.grid, depth_m_, frame.surface.time_s};
    std::vector<VtiPart> parts;
    for (int wall = 0; wall < 4; ++wall) {
        const Field<float>& map = frame.walls[static_cast<std::size_t>(wall)];
        if (map.empty()) continue;
        const WallPlan plan = wall_plan(*walls_, water.grid, wall);
        parts.push_back({std::string(wall_names[static_cast<std::size_t>(wall)]), wall_frame(water, wall, plan, map)});
    }
    place_.require_present();
    for (const fs::path& path : walls_series_.write_parts(parts)) written_.insert(path);
    written_.insert(folder_ / "walls.pvd");
}

void Outputs::write(const FrameFiles& frame) {
    const double time_s = frame.surface.time_s;
    if (settings_.wants("vti")) write_fields(frame);
    if (settings_.wants("png")) write_pictures(frame);
    if (settings_.wants("png16")) write_greys(frame);
    if (settings_.wants("exr")) write_exrs(frame);
    if (look_) write_scene(frame);
    if (probes_) probes_->append(time_s, frame.probes);
    if (ledgers_) ledgers_->append(time_s, frame.ledgers);
    ++frame_;
}

fs::path Outputs::image(const std::string& name, const char* extension) {
    place_.require_present();
    fs::path path = folder_ / image_name(name, frame_, extension);
    written_.insert(path);
    return path;
}

fs::path Outputs::scene_file(int frame) const { return folder_ / image_name("scene", frame, "png"); }

void Outputs::settle() {
    queue_.finish();
    place_.require_present();
    require_written();
}

void Outputs::finish() {
    settle();
    place_.remove_stale(written_);
}

std::optional<double> Outputs::last_checkpoint_s() {
    try {
        queue_.finish();
    } catch (const std::exception&) {
        // A run that fails has its reason already.
    }
    return checkpoint_s_;
}

std::vector<std::string> Outputs::guide() const {
    std::vector<std::string> lines;
    const auto add = [&](const fs::path& path, const std::string& what) { lines.push_back(guide_line(path, what)); };
    if (look_) add(folder_ / "images" / "scene_*.png", "the scene as the camera sees it: any image viewer");
    if (settings_.wants("png") || settings_.wants("png16"))
        add(folder_ / "images" / "*.png", "pictures: any image viewer");
    if (settings_.wants("vti")) {
        add(folder_ / "surface.pvd", "surface in time: ParaView, or python3-vtk9");
        if (has_volume_) add(folder_ / "volume.pvd", "irradiance in the water in time: ParaView, or python3-vtk9");
        if (walls_) add(folder_ / "walls.pvd", "irradiance on the walls in time: ParaView, or python3-vtk9");
        if (has_picture_) add(folder_ / "camera.pvd", "what the camera sees in time: ParaView, or python3-vtk9");
        if (plan_) add(folder_ / "floor.pvd", "floor irradiance in time: ParaView, or python3-vtk9");
    }
    if (settings_.wants("exr")) add(folder_ / "images" / "*.exr", "full precision: any OpenEXR viewer");
    if (has_end_) add(folder_ / "runup.csv", "how far the water came: any spreadsheet");
    if (has_end_ && settings_.wants("vti") && wants_extremes(settings_))
        add(folder_ / "extremes.vti", "highest water, speed, arrival: ParaView, or python3-vtk9");
    if (probes_) add(folder_ / "probes.csv", "gauges: any spreadsheet");
    if (ledgers_) add(folder_ / "ledger.csv", "where the light went: any spreadsheet");
    add(folder_ / "report.json", "numbers, checks, times: any text editor");
    return lines;
}

}  // namespace waterlight
