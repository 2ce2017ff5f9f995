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
    const std::string file = fmt::format("{0}/{0}_{1:06}.vti", name_, frames_);
    const std::filesystem::path path = folder_ / file;
    write_vti(path, frame, compression_);
    entries_ += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", frame.time_s, file);
    ++frames_;
    write_file(folder_ / (name_ + ".pvd"), head + entries_ + foot);
    return path;
}

void VtiSeries::exchange_state(StateArchive& state) {
    state.value(frames_);
    state.text(entries_);
}

}  // namespace waterlight
