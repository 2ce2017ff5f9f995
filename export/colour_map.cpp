// Control points at equal distances, between which colours are linear in sRGB.
#include "export/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace waterlight {

namespace {

using Table = std::array<Rgb, 33>;

/// Smith and van der Walt, "A better default colormap for matplotlib" (SciPy 2015); CC0.
constexpr Table viridis{{
    {68, 1, 84},    {71, 13, 96},   {72, 24, 106},  {72, 35, 116},  {71, 45, 123},  {69, 54, 129},  {66, 64, 134},
    {63, 73, 137},  {59, 82, 139},  {55, 90, 141},  {51, 99, 141},  {47, 106, 142}, {44, 114, 142}, {41, 122, 142},
    {38, 129, 142}, {35, 137, 142}, {33, 144, 140}, {31, 152, 139}, {31, 159, 136}, {33, 166, 133}, {40, 174, 128},
    {49, 181, 123}, {62, 188, 116}, {76, 194, 108}, {93, 201, 99},  {110, 206, 88}, {130, 211, 76}, {150, 216, 63},
    {171, 220, 50}, {192, 223, 36}, {213, 226, 26}, {234, 229, 26}, {253, 231, 37},
}};

/// Moreland, "Diverging color maps for scientific visualization" (ISVC 2009), table of the smooth cool-warm map.
constexpr Table cool_warm{{
    {59, 76, 192},   {68, 90, 204},   {77, 104, 215},  {87, 117, 225},  {98, 130, 234},  {108, 142, 241},
    {119, 154, 247}, {130, 165, 251}, {141, 176, 254}, {152, 185, 255}, {163, 194, 255}, {174, 201, 253},
    {184, 208, 249}, {194, 213, 244}, {204, 217, 238}, {213, 219, 230}, {221, 221, 221}, {229, 216, 209},
    {236, 211, 197}, {241, 204, 185}, {245, 196, 173}, {247, 187, 160}, {247, 177, 148}, {247, 166, 135},
    {244, 154, 123}, {241, 141, 111}, {236, 127, 99},  {229, 112, 88},  {222, 96, 77},   {213, 80, 66},
    {203, 62, 56},   {192, 40, 47},   {180, 4, 38},
}};

/// Our own: the colours of water from the dark of the depth to light, of rising lightness throughout.
constexpr Table deep_water{{
    {2, 8, 24},      {3, 12, 31},     {3, 16, 38},     {4, 19, 44},     {4, 23, 51},     {5, 27, 58},
    {5, 32, 66},     {6, 38, 74},     {6, 44, 82},     {7, 50, 90},     {8, 56, 98},     {9, 63, 107},
    {11, 72, 114},   {13, 81, 122},   {16, 90, 130},   {18, 99, 138},   {20, 108, 146},  {29, 119, 153},
    {39, 129, 160},  {48, 140, 166},  {58, 151, 173},  {67, 161, 180},  {81, 171, 185},  {98, 181, 190},
    {115, 190, 195}, {132, 200, 200}, {149, 210, 205}, {165, 218, 210}, {182, 226, 217}, {198, 233, 224},
    {214, 240, 230}, {230, 247, 237}, {246, 254, 244},
}};

const Table& table_of(ColourMap map) {
    switch (map) {
        case ColourMap::cool_warm:
            return cool_warm;
        case ColourMap::deep_water:
            return deep_water;
        case ColourMap::viridis:
            break;
    }
    return viridis;
}

std::uint8_t mix(std::uint8_t a, std::uint8_t b, double f) {
    return static_cast<std::uint8_t>(std::lround(a + (b - a) * f));
}

}  // namespace

Rgb colour(ColourMap map, double position) {
    const Table& table = table_of(map);
    const double at = std::clamp(position, 0.0, 1.0) * (table.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), table.size() - 2);
    const Rgb a = table[i], b = table[i + 1];
    const double f = at - static_cast<double>(i);
    return {mix(a.r, b.r, f), mix(a.g, b.g, f), mix(a.b, b.b, f)};
}

}  // namespace waterlight
