// Wavelengths as red, green and blue.
#include "app/floor_colours.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace waterlight::test {
namespace {

BandMap band(double wavelength_nm, double share, float irradiance) {
    BandMap map;
    map.band = {wavelength_nm, share, {}};
    map.map.irradiance = Field<float>(2, 1);
    map.map.irradiance(0, 0) = irradiance;
    map.map.irradiance(1, 0) = 2 * irradiance;
    return map;
}

std::array<float, 3> first_pixel(std::vector<BandMap> bands) {
    std::array<Field<float>, 3> colours;
    fill_colours(bands, colours);
    for (const Field<float>& colour : colours) EXPECT_FLOAT_EQ(colour(1, 0), 2 * colour(0, 0));
    return {colours[0](0, 0), colours[1](0, 0), colours[2](0, 0)};
}

TEST(FloorColours, AreInTheOrderOfWavelengthsAndOfTheWholeSun) {
    std::vector<BandMap> bands;
    for (const auto& [nm, share] : {std::pair(450.0, 0.375), {650.0, 0.25}, {550.0, 0.5}})
        bands.push_back(band(nm, share, static_cast<float>(800 * share)));
    EXPECT_EQ(first_pixel(std::move(bands)), (std::array<float, 3>{800, 800, 800})) << "white light is white";
    bands.clear();
    bands.push_back(band(450, 0.5, 300));
    bands.push_back(band(550, 0.25, 100));
    bands.push_back(band(650, 0.25, 50));
    EXPECT_EQ(first_pixel(std::move(bands)), (std::array<float, 3>{200, 400, 600}));
}

TEST(FloorColours, SeveralWavelengthsOfAColourAreAddedAndOneServesAll) {
    std::vector<BandMap> bands;
    bands.push_back(band(640, 0.25, 100));
    bands.push_back(band(660, 0.25, 50));
    bands.push_back(band(440, 0.5, 500));
    EXPECT_EQ(first_pixel(std::move(bands)), (std::array<float, 3>{300, 400, 1000}))
        << "green takes the nearest, 640 nm";
    bands.clear();
    bands.push_back(band(514, 0.5, 200));
    EXPECT_EQ(first_pixel(std::move(bands)), (std::array<float, 3>{400, 400, 400}));
}

}  // namespace
}  // namespace waterlight::test
