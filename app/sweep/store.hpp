// Fields that a sweep keeps in its folder, as .vti, so that each is computed once whoever needs it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "sim/field.hpp"

namespace waterlight {

/// `name` is that of the array; a cell is drawn 1 m wide. Whole or not at all. Throws WorldError.
void write_field(const std::filesystem::path& path, const std::string& name, const Field<float>& field);
/// Throws WorldError where it cannot be read.
Field<float> read_field(const std::filesystem::path& path, const std::string& name);

/// Reads the field or, where there is none, computes and writes it. Of several processes one computes, the others wait.
Field<float> kept_field(const std::filesystem::path& path, const std::string& name,
                        const std::function<Field<float>()>& compute);

}  // namespace waterlight
