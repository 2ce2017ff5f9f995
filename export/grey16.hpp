// A field as a 16-bit grey PNG: exact steps of a stated linear scale.
#pragma once

#include <filesystem>
#include <string>

#include "export/range.hpp"
#include "sim/field.hpp"

namespace waterlight {

/// Writes round(65535 (value - low) / (high - low)), clamped; 0 for NaN; the row of largest y on top. The tEXt chunks
/// "low", "high", "quantity" and "unit" state the scale: value = low + (high - low) grey / 65535. Throws WorldError.
void write_grey16(const std::filesystem::path& path, const Field<float>& field, ValueRange range,
                  const std::string& quantity, const std::string& unit);

}  // namespace waterlight
