#include "app/view/screenshot.hpp"

#include <fmt/format.h>

#include "app/scene_image.hpp"
#include "export/atomic_file.hpp"
#include "export/png.hpp"

namespace waterlight {

void write_screenshot(SceneRenderer& renderer, const std::filesystem::path& file) {
    write_file(file, encode_png(scene_image(renderer)));
}

std::filesystem::path next_screenshot(const std::filesystem::path& folder) {
    for (int n = 1;; ++n) {
        std::filesystem::path file = folder / fmt::format("waterlight_{:03}.png", n);
        if (!std::filesystem::exists(file)) return file;
    }
}

}  // namespace waterlight
