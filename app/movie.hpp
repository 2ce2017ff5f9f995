// Pictures of a run as a movie.
#pragma once

#include <filesystem>
#include <span>

namespace waterlight {

/// Throws WorldError, naming what to install, where ffmpeg is not there.
void require_ffmpeg();

/// An H.264 movie (.mp4, 4:2:0, BT.709, the sides made even by a black line where they are odd) of the .png files in
/// their order, by ffmpeg. Whole or not at all. Throws WorldError naming the file and what ffmpeg said.
void write_movie(const std::filesystem::path& file, std::span<const std::filesystem::path> pictures,
                 double frames_per_s);

}  // namespace waterlight
