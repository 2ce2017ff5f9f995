// Ground from files on grids of other cells: exactness, order, volume, datum.
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/ground_files.hpp"

namespace waterlight::testing {
namespace {

using std::numbers::pi;

/// One wave along each side of the unit square.
double hills(double x, double y) { return std::sin(2 * pi * x + 0.4) * std::cos(2 * pi * y - 0.3); }

/// Its exact mean over a cell: that of sin(k x) over a width w is sin(k x) sinc(k w / 2).
double mean_of_hills(double x, double y, const Grid& grid) {
    const auto sinc = [](double a) { return std::sin(a) / a; };
    return hills(x, y) * sinc(pi * grid.dx_m) * sinc(pi * grid.dy_m);
}

double largest_difference(const Field<double>& a, const Field<double>& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a.data()[k] - b.data()[k]));
    return largest;
}

double sum(const Field<double>& field) {
    double total = 0;
    for (const double value : field.values()) total += value;
    return total;
}

TEST(GroundResampling, PointsAtTheCellCentresAreReproducedExactly) {
    const Grid grid{23, 17, 0.1, 0.1, -0.7, 0.3};
    const Field<double> heights = sampled(grid, hills);
    for (const char* extension : {".vti", ".asc", ".xyz"}) {
        const Field<double> read = read_text(extension, ground_text(extension, grid, heights), grid);
        EXPECT_EQ(largest_difference(read, heights), 0) << extension;
    }
}

TEST(GroundResampling, LinearGroundIsExactOnAnyCells) {
    const auto slope = [](double x, double y) { return 0.3 * x - 0.7 * y + 0.1; };
    const Grid from{40, 40, 0.1, 0.1, -1, -1};
    const std::string text = esri_text(from, sampled(from, slope));
    for (const Grid& grid : {Grid{5, 3, 0.31, 0.17, 0.01, 0.2}, Grid{70, 90, 0.013, 0.02, 0.04, 0},
                             Grid{3, 50, 0.77, 0.01, 0.1, 0.1}, Grid{10, 10, 0.1, 0.1, 0.03, 0.06}}) {
        EXPECT_LT(largest_difference(read_text(".asc", text, grid), sampled(grid, slope)), 3e-15) << grid.dx_m;
    }
}

/// Errors fall fourfold where the file's spacing is halved, between its points and in means over its points.
TEST(GroundResampling, IsOfSecondOrder) {
    const Grid fine{91, 77, 1.0 / 300, 1.0 / 300, 0.3, 0.4}, coarse{3, 3, 0.1, 0.1, 0.31, 0.42};
    const auto error = [&](int cells, const Grid& grid, const Field<double>& truth) {
        const Grid from = make_grid(cells, cells, 1, 1);
        return largest_difference(read_text(".asc", esri_text(from, sampled(from, hills)), grid), truth);
    };
    const Field<double> points = sampled(fine, hills);
    const Field<double> means = sampled(coarse, [&](double x, double y) { return mean_of_hills(x, y, coarse); });
    for (const int cells : {20, 40}) {
        const double between = std::log2(error(cells, fine, points) / error(2 * cells, fine, points));
        EXPECT_NEAR(between, 2, 0.1) << cells;
        const double over = std::log2(error(cells, coarse, means) / error(2 * cells, coarse, means));
        EXPECT_NEAR(over, 2, 0.25) << cells;
    }
}

TEST(GroundResampling, MeansOverCellsKeepTheVolume) {
    const Grid from{120, 90, 0.05, 0.05, 2, -1};
    std::mt19937 random(5);
    const Field<double> heights =
        sampled(from, [&](double, double) { return std::uniform_real_distribution<double>(-3, 1)(random); });
    const double volume = sum(heights) * from.cell_area_m2();
    const double rounding = std::numeric_limits<double>::epsilon() * static_cast<double>(from.cells());
    for (const glm::ivec2 cells : {glm::ivec2{119, 89}, {60, 45}, {37, 11}, {1, 1}, {1, 90}, {7, 90}}) {
        const Grid grid{cells.x, cells.y, 6.0 / cells.x, 4.5 / cells.y, 2, -1};
        const Field<double> read = read_text(".vti", vti_text(from, heights), grid);
        EXPECT_NEAR(sum(read) * grid.cell_area_m2() / volume, 1, rounding) << cells.x << ", " << cells.y;
    }
}

TEST(GroundResampling, HighDatumLosesNothing) {
    const Grid grid = make_grid(16, 16, 4, 4);
    const Field<double> heights = sampled(grid, [](double x, double y) { return std::ldexp(x * y, -9) - 0.25; });
    Field<double> in_datum = heights.clone();
    for (double& height : in_datum.values()) height += 10000;
    GroundFile file;
    file.datum_m = 10000;
    for (const char* extension : {".vti", ".asc", ".xyz"}) {
        const Field<double> read = read_text(extension, ground_text(extension, grid, in_datum), grid, file);
        EXPECT_EQ(largest_difference(read, heights), 0) << extension;
        // Means of rounded heights: had they been taken at 10 000 m, they would be wrong by 1e-12 of it.
        const Grid other = make_grid(3, 3, 4, 4);
        const Field<double> above = read_text(extension, ground_text(extension, grid, in_datum), other, file);
        const Field<double> level = read_text(extension, ground_text(extension, grid, heights), other);
        EXPECT_EQ(largest_difference(above, level), 0) << extension;
    }
}

TEST(GroundResampling, DepthsPositiveDownBelowADatum) {
    const Grid grid = make_grid(3, 2, 3, 2);
    const Field<double> depths = sampled(grid, [](double x, double y) { return x + 10 * y; });
    GroundFile file;
    file.positive = Positive::down;
    file.datum_m = 0.5;
    EXPECT_EQ(read_text(".xyz", xyz_text(grid, depths), grid, file)(2, 1), -(2.5 + 15) - 0.5);
    file = {};
    file.array = "depth";
    EXPECT_EQ(read_text(".vti", vti_text(grid, depths, "depth"), grid, file)(2, 1), -17.5) << "depths go down";
    file.positive = Positive::up;
    EXPECT_EQ(read_text(".vti", vti_text(grid, depths, "depth"), grid, file)(2, 1), 17.5);
}

TEST(GroundResampling, OffsetPlacesTheFile) {
    const Grid grid = make_grid(4, 3, 4, 3), survey{4, 3, 1, 1, 500000, 4e6};
    const Field<double> heights = sampled(grid, hills);
    GroundFile file;
    file.offset_m = {-500000, -4e6};
    for (const char* extension : {".vti", ".asc", ".xyz"}) {
        const Field<double> read = read_text(extension, ground_text(extension, survey, heights), grid, file);
        EXPECT_EQ(largest_difference(read, heights), 0) << extension;
    }
}

TEST(GroundResampling, ExtendsByTheNearestData) {
    const Grid from = make_grid(4, 3, 4, 3), grid{8, 5, 1, 1, -2, -1};
    const Field<double> heights = sampled(from, [](double x, double y) { return x + 10 * y; });
    GroundFile file;
    file.outside = OutsideFile::extend;
    for (const char* extension : {".vti", ".asc", ".xyz"}) {
        const Field<double> read = read_text(extension, ground_text(extension, from, heights), grid, file);
        EXPECT_EQ(read(0, 0), heights(0, 0)) << extension;
        EXPECT_EQ(read(7, 2), heights(3, 1)) << extension;
        EXPECT_EQ(read(3, 4), heights(1, 2)) << extension;
    }
    // One large cell: a quarter of it west of the file's centre line has the western value.
    const Field<double> mean = read_text(".vti", vti_text(from, heights), Grid{1, 1, 8, 3, -4, 0}, file);
    EXPECT_NEAR(mean(0, 0), (4 * 0.5 + 4 * 2.0) / 8 + 15, 1e-13);
}

TEST(GroundResampling, FillsHolesFromTheNearestDataWhereAsked) {
    const Grid grid = make_grid(5, 1, 5, 1);
    const std::string text = "ncols 5\nnrows 1\nxllcenter 0.5\nyllcenter 0.5\ncellsize 1\n-9999 2 -9999 -9999 8\n";
    GroundFile file;
    file.outside = OutsideFile::extend;
    const Field<double> filled = read_text(".asc", text, grid, file);
    const double expected[] = {2, 2, 2, 8, 8};
    for (int i = 0; i < 5; ++i) EXPECT_EQ(filled(i, 0), expected[i]) << i;
    const Field<double> means = read_text(".asc", text, make_grid(1, 1, 5, 1), file);
    EXPECT_NEAR(means(0, 0), (2 * 1.0 + 8 * 1.0) / 2, 1e-14) << "the mean of the data there are";
}

TEST(GroundResampling, ReadsTheGroundOfMonai) {
    const char* data = std::getenv("WATERLIGHT_DATA");
    if (data == nullptr) GTEST_SKIP() << "WATERLIGHT_DATA is not set";
    GroundFile file;
    file.path = std::filesystem::path(data) / "nthmp" / "monai_bathymetry.txt";
    file.positive = Positive::down;
    // Its points are at the corners of 392 x 243 cells; around each point is a cell of this grid.
    const Field<double> points = read_ground(file, {393, 244, 0.014, 0.014, -0.007, -0.007});
    EXPECT_EQ(points(0, 0), -0.13535);
    EXPECT_EQ(points(1, 2), -0.13465);
    EXPECT_EQ(points(392, 243), 0.125);
    const Field<double> cells = read_ground(file, {392, 243, 5.488 / 392, 3.402 / 243, 0, 0});
    for (const glm::ivec2 at : {glm::ivec2{0, 0}, {200, 100}, {391, 242}}) {
        const double corners =
            points(at.x, at.y) + points(at.x + 1, at.y) + points(at.x, at.y + 1) + points(at.x + 1, at.y + 1);
        EXPECT_NEAR(cells(at.x, at.y), corners / 4, 1e-12);
    }
}

}  // namespace
}  // namespace waterlight::testing
