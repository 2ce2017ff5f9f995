// A checkpoint on the disk: it is whole and as it was written, or it is refused.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace waterlight {

/// Writes `parts`, one after the other, with their length and checksum. What was written to the same file system
/// before, by this thread or handed over by others, is on the disk when the checkpoint appears, and so is the
/// checkpoint itself when this returns. Throws WorldError, and then the checkpoint that was there before still is.
void write_checkpoint(const std::filesystem::path& path, std::span<const std::string> parts);

/// The parts as one. Throws WorldError naming the file and what is wrong with it: it cannot be read, is something else,
/// of another format, cut short, or damaged.
std::string read_checkpoint(const std::filesystem::path& path);

}  // namespace waterlight
