#include "export/checkpoint_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <libdeflate.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "export/atomic_file.hpp"
#include "export/descriptor.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

struct Header {
    std::array<char, 24> magic{"waterlight checkpoint\n"};
    std::uint32_t format = 1;
    std::uint32_t crc = 0;  ///< CRC-32 of what follows
    std::uint64_t bytes = 0;
};
static_assert(sizeof(Header) == 40, "no padding, which would be written as it happens to be");

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what) {
    throw WorldError(fmt::format("{} {}; without --resume the run starts from the beginning", path.string(), what));
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, std::span<const std::string> parts) {
    Header header;
    for (const std::string& part : parts) {
        header.crc = libdeflate_crc32(header.crc, part.data(), part.size());
        header.bytes += part.size();
    }
    PendingFile pending(path);
    Descriptor file(pending.temporary(), path, O_WRONLY | O_CREAT | O_TRUNC);
    file.write({reinterpret_cast<const char*>(&header), sizeof(header)});
    for (const std::string& part : parts) file.write(part);
    file.sync_all();
    file.close();
    pending.commit();
    Descriptor(path.has_parent_path() ? path.parent_path() : ".", path, O_RDONLY | O_DIRECTORY).sync();
}

std::string read_checkpoint(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse(path, "cannot be read");
    Header header, expected;
    file.read(reinterpret_cast<char*>(&header), sizeof(header));
    if (!file || header.magic != expected.magic) refuse(path, "is not a checkpoint");
    if (header.format != expected.format)
        refuse(path, fmt::format("has format {}; this program reads format {}", header.format, expected.format));
    file.seekg(0, std::ios::end);
    const auto there = static_cast<std::uint64_t>(file.tellg()) - sizeof(header);
    if (there != header.bytes)
        refuse(path, fmt::format("is damaged: it has {} bytes of state instead of {}", there, header.bytes));
    std::string bytes(header.bytes, '\0');
    file.seekg(sizeof(header));
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!file || libdeflate_crc32(0, bytes.data(), bytes.size()) != header.crc)
        refuse(path, "is damaged: its checksum is wrong");
    return bytes;
}

}  // namespace waterlight
