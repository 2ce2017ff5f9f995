#include "export/series.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cctype>

#include "export/atomic_file.hpp"

namespace waterlight {

namespace {

constexpr const char* head =
    "<?xml version=\"1.0\"?>\n"
    "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
    "  <Collection>\n";
constexpr const char* foot =
    "  </Collection>\n"
    "</VTKFile>\n";

}  // namespace

VtiSeries::VtiSeries(std::filesystem::path folder, std::string name, Compression compression)
    : folder_(std::move(folder)), name_(std::move(name)), compression_(compression) {
    for ([[maybe_unused]] const unsigned char c : name_) assert(std::isalnum(c) != 0 || c == '_');
}

std::filesystem::path VtiSeries::write(const VtiFrame& frame) {
    const VtiPart part{name_, frame};
    return write_parts({&part, 1}).front();
}

std::vector<std::filesystem::path> VtiSeries::write_parts(std::span<const VtiPart> parts) {
    std::vector<std::filesystem::path> paths;
    for (const VtiPart& part : parts) {
        const std::string file = fmt::format("{}/{}_{:06}.vti", name_, part.name, frames_);
        write_vti(folder_ / file, part.frame, compression_);
        entries_ += fmt::format("    <DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n", part.frame.time_s,
                                paths.size(), file);
        paths.push_back(folder_ / file);
    }
    ++frames_;
    write_file(folder_ / (name_ + ".pvd"), head + entries_ + foot);
    return paths;
}

void VtiSeries::exchange_state(StateArchive& state) {
    state.value(frames_);
    state.text(entries_);
}

}  // namespace waterlight
