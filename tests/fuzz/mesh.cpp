// The readers of meshes, each given the same bytes.
#include <algorithm>

#include "caustics/objects/mesh_file.hpp"
#include "tests/fuzz/reader.hpp"

using namespace waterlight;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::InputFile obj(".obj"), ply(".ply"), stl(".stl");
    for (const fuzz::InputFile* file : {&obj, &ply, &stl}) {
        file->write(fuzz::text_of(data, size));
        fuzz::expect_result_or_error([&] { validate({.name = "mesh", .shape = read_mesh(file->path(), 1, true)}); });
    }
    return 0;
}
