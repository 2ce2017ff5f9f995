#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cmath>
#include <limits>
#include <map>

#include "export/canvas.hpp"
#include "export/colour_map.hpp"
#include "export/grey16.hpp"
#include "export/picture.hpp"
#include "export/text.hpp"
#include "export/ticks.hpp"
#include "tests/unit/export_support.hpp"

namespace waterlight::testing {
namespace {

vtkNew<vtkPNGReader> read(const std::filesystem::path& path) {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader;
}

std::map<std::string, std::string> texts(vtkPNGReader& reader) {
    std::map<std::string, std::string> found;
    for (std::size_t i = 0; i < reader.GetNumberOfTextChunks(); ++i) {
        found[reader.GetTextKey(static_cast<int>(i))] = reader.GetTextValue(static_cast<int>(i));
    }
    return found;
}

/// VTK counts rows upwards, as the field does.
Rgb pixel(vtkImageData& image, int x, int y) {
    const auto* c = static_cast<const std::uint8_t*>(image.GetScalarPointer(x, y, 0));
    return {c[0], c[1], c[2]};
}

TEST(Grey16, ValuesComeBackToHalfAStep) {
    const TemporaryFolder folder;
    Field<float> field = noise(257, 131, 3);
    field(5, 0) = -7;
    field(6, 0) = 7;
    field(7, 0) = std::numeric_limits<float>::quiet_NaN();
    write_grey16(folder / "g.png", field, {-1.25, 1.25}, "elevation", "m");
    const auto reader = read(folder / "g.png");
    vtkImageData& image = *reader->GetOutput();
    ASSERT_EQ(image.GetScalarType(), VTK_UNSIGNED_SHORT);
    ASSERT_EQ(image.GetDimensions()[0], 257);
    ASSERT_EQ(image.GetDimensions()[1], 131);
    const double half_step = 1.25 / 65535;
    for (int j = 1; j < 131; ++j) {
        for (int i = 0; i < 257; ++i) {
            const double grey = *static_cast<const std::uint16_t*>(image.GetScalarPointer(i, j, 0));
            ASSERT_NEAR(-1.25 + 2.5 * grey / 65535, field(i, j), half_step * 1.001) << i << ' ' << j;
        }
    }
    const auto grey = [&](int i) { return *static_cast<const std::uint16_t*>(image.GetScalarPointer(i, 0, 0)); };
    EXPECT_EQ(grey(5), 0);
    EXPECT_EQ(grey(6), 65535);
    EXPECT_EQ(grey(7), 0);
    const std::map<std::string, std::string> expected{
        {"low", "-1.25"}, {"high", "1.25"}, {"quantity", "elevation"}, {"unit", "m"}};
    EXPECT_EQ(texts(*reader), expected);
}

TEST(ColourMap, MatchesThePublishedEnds) {
    EXPECT_EQ(colour(ColourMap::viridis, 0), (Rgb{68, 1, 84}));
    EXPECT_EQ(colour(ColourMap::viridis, 1), (Rgb{253, 231, 37}));
    EXPECT_EQ(colour(ColourMap::cool_warm, 0), (Rgb{59, 76, 192}));
    EXPECT_EQ(colour(ColourMap::cool_warm, 0.5), (Rgb{221, 221, 221}));
    EXPECT_EQ(colour(ColourMap::cool_warm, 1), (Rgb{180, 4, 38}));
}

/// CIE 1976 lightness of an sRGB colour.
double lightness(Rgb c) {
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    const double y = 0.2126 * linear(c.r / 255.0) + 0.7152 * linear(c.g / 255.0) + 0.0722 * linear(c.b / 255.0);
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(ColourMap, LightnessSaysTheOrder) {
    for (int i = 0; i < 64; ++i) {
        const double a = i / 64.0, b = (i + 1) / 64.0;
        const double step = lightness(colour(ColourMap::viridis, b)) - lightness(colour(ColourMap::viridis, a));
        EXPECT_NEAR(step, 76.0 / 64, 0.5) << "viridis climbs evenly from 15 to 91, at " << a;
    }
    for (int i = 0; i <= 32; ++i) {
        const double left = lightness(colour(ColourMap::cool_warm, i / 64.0));
        const double right = lightness(colour(ColourMap::cool_warm, 1 - i / 64.0));
        EXPECT_NEAR(left, right, 3.0) << "cool_warm is as dark on either side, at " << i / 64.0;
    }
}

TEST(Picture, ShowsEachCellInItsPlaceAndColour) {
    const TemporaryFolder folder;
    const Field<float> field = noise(600, 500, 8);
    PictureSettings settings;
    settings.range = {-1, 1};
    settings.legend = false;
    write_picture(folder / "p.png", field, settings);
    const auto reader = read(folder / "p.png");
    ASSERT_EQ(reader->GetOutput()->GetDimensions()[0], 600);
    ASSERT_EQ(reader->GetOutput()->GetDimensions()[1], 500);
    for (int j = 0; j < 500; ++j) {
        for (int i = 0; i < 600; ++i) {
            const int step = std::min(239, static_cast<int>((field(i, j) + 1) * 120));
            ASSERT_EQ(pixel(*reader->GetOutput(), i, j), colour(ColourMap::viridis, step / 239.0)) << i << ' ' << j;
        }
    }
}

TEST(Picture, SmallFieldsAreEnlargedAndOblongCellsDrawnToScale) {
    Field<float> field(32, 64);
    PictureSettings settings;
    settings.legend = false;
    settings.pitch_m = {0.2, 0.1};
    const IndexedImage image = draw_picture(field, settings);
    EXPECT_EQ(image.width, 512);
    EXPECT_EQ(image.height, 512);
}

TEST(Picture, ValuesWithoutNumberAndBeyondTheRangeAreSeen) {
    Field<float> field(480, 1);
    field(0, 0) = std::numeric_limits<float>::quiet_NaN();
    field(1, 0) = std::numeric_limits<float>::infinity();
    field(2, 0) = -std::numeric_limits<float>::infinity();
    PictureSettings settings;
    settings.legend = false;
    const IndexedImage image = draw_picture(field, settings);
    const auto colour_at = [&](int x) { return image.palette[image.pixels[x]]; };
    EXPECT_EQ(colour_at(0), (Rgb{255, 0, 200}));
    EXPECT_EQ(colour_at(1), colour(ColourMap::viridis, 1));
    EXPECT_EQ(colour_at(2), colour(ColourMap::viridis, 0));
}

TEST(Picture, DryGroundHasAColourOfItsOwn) {
    Field<float> field(480, 1);
    field(0, 0) = std::numeric_limits<float>::quiet_NaN();
    PictureSettings settings;
    settings.legend = false;
    settings.missing = ground_colour;
    const IndexedImage image = draw_picture(field, settings);
    EXPECT_EQ(image.palette[image.pixels[0]], ground_colour);
    for (const ColourMap map : {ColourMap::viridis, ColourMap::cool_warm})
        for (int i = 0; i <= 100; ++i) {
            const Rgb c = colour(map, i / 100.0);
            EXPECT_GT(std::hypot(c.r - ground_colour.r, c.g - ground_colour.g, c.b - ground_colour.b), 30) << i;
        }
}

/// Where the whole picture with its legend differs from white paper.
TEST(Picture, TheLegendFitsOnThePaperWhateverItSays) {
    for (const auto& [nx, ny] : {std::pair{480, 360}, {40, 400}, {400, 3}, {1024, 768}}) {
        PictureSettings settings;
        settings.range = {-123456.789, 99999};
        settings.quantity = "A long name for what is to be seen in this picture";
        settings.unit = "W/m\u00b2";
        settings.time_s = 86400;
        Field<float> field(nx, ny);
        const IndexedImage image = draw_picture(field, settings);
        const auto is_paper = [&](int x, int y) {
            return image.palette[image.pixels[static_cast<std::size_t>(y) * image.width + x]] == Rgb{255, 255, 255};
        };
        for (int x = 0; x < image.width; ++x) EXPECT_TRUE(is_paper(x, 0) && is_paper(x, image.height - 1));
        for (int y = 0; y < image.height; ++y) EXPECT_TRUE(is_paper(0, y) && is_paper(image.width - 1, y));
    }
}

TEST(Text, HasInkForEveryLetterItNeeds) {
    for (const std::string letter : {"a", "7", "-", ".", "/", "%", "\u00b2", "\u00b0", "="}) {
        const TextBlock block = render_text(letter, 24);
        EXPECT_GT(std::count_if(block.coverage.begin(), block.coverage.end(), [](int c) { return c > 128; }), 3)
            << letter;
        EXPECT_LE(block.height, render_text("Ag", 24).height);
    }
    const TextBlock plain = render_text("m", 24), squared = render_text("m\u00b2", 24);
    EXPECT_GT(squared.width, plain.width);
    EXPECT_EQ(squared.height, plain.height);
    EXPECT_EQ(render_text("", 24).width, 0);
}

TEST(Ticks, AreRoundAndWithinTheRange) {
    for (const ValueRange range : {ValueRange{0, 1}, {-0.03, 0.03}, {-7, 1234}, {0, 2e-7}, {3.1, 3.2}, {-1e9, 1e9}}) {
        for (const int most : {2, 5, 9}) {
            const std::vector<Tick> ticks = round_ticks(range, most);
            ASSERT_LE(static_cast<int>(ticks.size()), most);
            ASSERT_GE(ticks.size(), 1U);
            const double slack = 1e-9 * (range.high - range.low);
            EXPECT_GE(ticks.front().value, range.low - slack);
            EXPECT_LE(ticks.back().value, range.high + slack);
            for (const Tick& tick : ticks)
                EXPECT_NEAR(std::stod(tick.label), tick.value, 1e-3 * (range.high - range.low));
        }
    }
    std::string labels;
    for (const Tick& tick : round_ticks({-0.05, 0.05}, 6)) labels += tick.label + ' ';
    EXPECT_EQ(labels, "-0.04 -0.02 0.00 0.02 0.04 ");
}

TEST(Ticks, OfALogarithmicScaleAreRoundAndWithinTheRange) {
    for (const ValueRange range :
         {ValueRange{1, 100, true}, {0.2, 200, true}, {3e-9, 4e4, true}, {1, 2, true}, {70, 900, true}}) {
        for (const int most : {2, 5, 9}) {
            const std::vector<Tick> ticks = round_ticks(range, most);
            ASSERT_LE(static_cast<int>(ticks.size()), most) << range.low;
            ASSERT_GE(ticks.size(), 1U) << range.low << ' ' << most;
            for (const Tick& tick : ticks) {
                EXPECT_GE(range.position(tick.value), -1e-9);
                EXPECT_LE(range.position(tick.value), 1 + 1e-9);
                EXPECT_NEAR(std::stod(tick.label), tick.value, 1e-3 * tick.value);
            }
        }
    }
    std::string labels;
    for (const Tick& tick : round_ticks({1, 100, true}, 9)) labels += tick.label + ' ';
    EXPECT_EQ(labels, "1 2 5 10 20 50 100 ");
}

/// Equal ratios are equal steps of colour; darkness and what is below the range take the first.
TEST(Picture, ALogarithmicScaleSpreadsRatiosEvenly) {
    Field<float> field(480, 1);
    for (int i = 0; i < 480; ++i) field(i, 0) = static_cast<float>(std::pow(10.0, -3 + 3 * (i + 0.5) / 480));
    field(0, 0) = 0;
    PictureSettings settings;
    settings.range = {1e-3, 1, true};
    settings.legend = false;
    const IndexedImage image = draw_picture(field, settings);
    EXPECT_EQ(image.pixels[0], 0);
    for (int i = 1; i < 480; ++i)
        EXPECT_NEAR(image.pixels[i], palette::map_steps * (i + 0.5) / 480 - 0.5, 0.51 + 1e-3) << i;
}

TEST(Range, IsRoundAndHoldsTheValues) {
    Field<float> field(100, 100);
    EXPECT_EQ(symmetric_range(field).high, 1);
    for (std::size_t i = 0; i < field.size(); ++i) field.data()[i] = static_cast<float>(i) * -1e-6F;
    EXPECT_DOUBLE_EQ(symmetric_range(field).high, 0.01);
    EXPECT_DOUBLE_EQ(symmetric_range(field).low, -0.01);
    for (float& value : field.values()) value = 700;
    for (int i = 0; i < 50; ++i) field(i, 3) = 9000;
    field(0, 0) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_DOUBLE_EQ(positive_range(field, 0.01).high, 800);
    EXPECT_DOUBLE_EQ(positive_range(field, 0).high, 10000);
}

}  // namespace
}  // namespace waterlight::testing
