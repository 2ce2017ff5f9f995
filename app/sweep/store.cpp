#include "app/sweep/store.hpp"

#include "app/sweep/lock.hpp"
#include "export/vti.hpp"
#include "sim/error.hpp"
#include "sim/vti_reader.hpp"

namespace waterlight {

namespace fs = std::filesystem;

void write_field(const fs::path& path, const std::string& name, const Field<float>& field) {
    VtiFrame frame;
    frame.cells = {field.nx(), field.ny(), 0};
    frame.arrays.push_back({name, {field.values()}});
    write_vti(path, frame, Compression::none);
}

Field<float> read_field(const fs::path& path, const std::string& name) {
    try {
        return read_vti(path, name).values;
    } catch (const InputError& error) {
        throw WorldError(error.what());
    }
}

Field<float> kept_field(const fs::path& path, const std::string& name, const std::function<Field<float>()>& compute) {
    if (fs::exists(path)) return read_field(path, name);
    const FileLock lock(path.string() + ".lock");
    if (fs::exists(path)) return read_field(path, name);
    Field<float> field = compute();
    write_field(path, name, field);
    return field;
}

}  // namespace waterlight
