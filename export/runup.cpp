#include "export/runup.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "export/atomic_file.hpp"

namespace waterlight {

void write_runup(const std::filesystem::path& path, std::span<const RunupLine> lines) {
    std::string table = "line,x_m,y_m,elevation_m\n";
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (const RunupPoint& p : lines[i])
            fmt::format_to(std::back_inserter(table), "{},{},{},{}\n", i, p.at_m.x, p.at_m.y, p.ground_m);
    write_file(path, table);
}

}  // namespace waterlight
