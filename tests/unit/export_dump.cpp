// Writes series under FOLDER and, beside them, what went in as raw bytes: read_back.py compares the two.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "export/frames.hpp"
#include "export/report.hpp"
#include "export/series.hpp"
#include "tests/unit/export_support.hpp"

namespace {

using namespace waterlight;

/// The arrays of one frame, one dump for each, components interleaved.
nlohmann::json dump(const VtiFrame& frame, const std::filesystem::path& folder, const std::string& stem) {
    nlohmann::json arrays = nlohmann::json::array();
    for (const VtiArray& array : frame.arrays) {
        const std::string name = fmt::format("{}_{}.raw", stem, array.name);
        std::string bytes;
        for (std::size_t i = 0; i < frame.values(); ++i) {
            for (const std::span<const float> component : array.components) {
                const float value = component.empty() ? 0.0F : component[i];
                bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
            }
        }
        testing::put_bytes(folder / name, bytes);
        arrays.push_back({{"name", array.name}, {"components", array.components.size()}, {"dump", name}});
    }
    return {{"time", frame.time_s},
            {"cells", {frame.cells.x, frame.cells.y, frame.cells.z}},
            {"origin", {frame.origin_m.x, frame.origin_m.y, frame.origin_m.z}},
            {"pitch", {frame.pitch_m.x, frame.pitch_m.y, frame.pitch_m.z}},
            {"angle_deg", frame.angle_deg},
            {"arrays", arrays}};
}

void write(const std::filesystem::path& folder, Compression compression) {
    nlohmann::json expected;
    VtiSeries surfaces(folder, "surface", compression), floors(folder, "floor", compression);
    for (int k = 0; k < 4; ++k) {
        Surface surface({60, 40, 0.1, 0.15, -1, 2}, {});
        surface.time_s = k / 3.0;
        surface.elevation = testing::noise(60, 40, 10 * k);
        surface.elevation(3, 3) = std::nanf("");
        surface.velocity_x = testing::noise(60, 40, 10 * k + 1);
        surface.velocity_y = testing::noise(60, 40, 10 * k + 2);
        surface.depth = testing::noise(60, 40, 10 * k + 3);
        const Field<float> irradiance = testing::noise(50, 30, 10 * k + 4);
        const VtiFrame top = surface_frame(surface);
        const VtiFrame bottom = floor_frame({50, 30, {1, 2}, {0.2, 0.3}, 25}, 2.5, surface.time_s, irradiance);
        surfaces.write(top);
        floors.write(bottom);
        expected["surface"].push_back(dump(top, folder, fmt::format("surface_{}", k)));
        expected["floor"].push_back(dump(bottom, folder, fmt::format("floor_{}", k)));
    }
    write_json(folder / "expected.json", expected);
}

}  // namespace

int main(int, char** argv) {
    const std::filesystem::path folder = argv[1];
    std::filesystem::remove_all(folder);
    write(folder / "none", Compression::none);
    write(folder / "lz4", Compression::lz4);
    write(folder / "zlib", Compression::zlib);
}
