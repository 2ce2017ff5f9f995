// A series of frames in time: numbered .vti files and the .pvd that names them.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "export/vti.hpp"
#include "sim/state_archive.hpp"

namespace waterlight {

/// A part of a frame: its name, of letters, digits and underscores, and what it holds.
struct VtiPart {
    std::string name;
    VtiFrame frame;
};

/// FOLDER/NAME.pvd and FOLDER/NAME/NAME_000000.vti, NAME_000001.vti, ...
class VtiSeries {
  public:
    /// `name` is made of letters, digits and underscores. Writes nothing yet.
    VtiSeries(std::filesystem::path folder, std::string name, Compression compression);

    /// Writes the frame and then the .pvd that names it too, each whole or not at all: whenever the process ends, the
    /// .pvd names whole files only. Returns the path of the frame. Throws WorldError.
    std::filesystem::path write(const VtiFrame& frame);

    /// As write(), of a frame in several parts: FOLDER/NAME/PART_000000.vti of each. Returns their paths.
    std::vector<std::filesystem::path> write_parts(std::span<const VtiPart> parts);

    int frames() const { return frames_; }

    /// Gives the archive what was written so far, or goes on from there with files that are still in their place.
    void exchange_state(StateArchive& state);

  private:
    std::filesystem::path folder_;
    std::string name_;
    Compression compression_;
    int frames_ = 0;
    std::string entries_;
};

}  // namespace waterlight
