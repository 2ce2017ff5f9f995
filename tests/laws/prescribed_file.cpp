// Surfaces from .vti files and .pvd series.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "sim/error.hpp"
#include "sim/prescribed.hpp"

namespace waterlight {
namespace {

namespace fs = std::filesystem;

double waves(double x, double y, double t) { return (1 + t) * 0.01 * std::cos(2 * std::numbers::pi * (x + 2 * y)); }

class PrescribedFile : public ::testing::Test {
  protected:
    void SetUp() override {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() / (std::string("waterlight_") + info->name() + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    // Writes waves() at time t on the cells of `grid`, as text.
    fs::path write(const std::string& name, const Grid& grid, double t, const std::string& array = "elevation") const {
        std::ofstream out(folder_ / name);
        out.precision(9);
        out << "<VTKFile type=\"ImageData\" version=\"1.0\">\n<ImageData WholeExtent=\"0 " << grid.nx << " 0 "
            << grid.ny << " 0 0\" Origin=\"" << grid.x0_m << " " << grid.y0_m << " 0\" Spacing=\"" << grid.dx_m << " "
            << grid.dy_m << " 1\">\n<Piece Extent=\"0 " << grid.nx << " 0 " << grid.ny << " 0 0\">\n<CellData>\n"
            << "<DataArray type=\"Float32\" Name=\"" << array << "\" format=\"ascii\">\n";
        for (int j = 0; j < grid.ny; ++j) {
            for (int i = 0; i < grid.nx; ++i) out << static_cast<float>(waves(grid.x_m(i), grid.y_m(j), t)) << "\n";
        }
        out << "</DataArray>\n</CellData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
        return folder_ / name;
    }

    PrescribedSettings settings_for(const fs::path& file, int n, Side side = Side::periodic) const {
        PrescribedSettings settings;
        settings.grid = make_grid(n, n, 1.0, 1.0);
        settings.boundary = {side, side};
        settings.file = file;
        return settings;
    }

    fs::path folder_;
};

// Largest difference to waves() at time t: elevation and slopes.
glm::dvec2 difference(const Surface& surface, double t) {
    glm::dvec2 worst{0, 0};
    for (int j = 0; j < surface.grid.ny; ++j) {
        for (int i = 0; i < surface.grid.nx; ++i) {
            const double x = surface.grid.x_m(i);
            const double y = surface.grid.y_m(j);
            const double rise = -2 * std::numbers::pi * waves(x - 0.25, y, t);
            worst.x = std::max(worst.x, std::abs(surface.elevation(i, j) - waves(x, y, t)));
            worst.y =
                std::max({worst.y, std::abs(surface.slope_x(i, j) - rise), std::abs(surface.slope_y(i, j) - 2 * rise)});
        }
    }
    return worst;
}

TEST_F(PrescribedFile, OnItsOwnGridIsTakenAsItIs) {
    const fs::path file = write("one.vti", make_grid(64, 64, 1, 1), 0);
    const auto model = make_prescribed(settings_for(file, 64));
    EXPECT_EQ(model->formula(), nullptr);
    EXPECT_LT(difference(model->surface(), 0).x, 1e-9);
    // The slope of a central difference over 32 cells a wave: short by (k d)^2 / 6.
    EXPECT_LT(difference(model->surface(), 0).y, 0.0075 * 2 * 2 * std::numbers::pi * 0.01);
    model->advance(5);
    EXPECT_LT(difference(model->surface(), 0).x, 1e-9);
    EXPECT_EQ(model->surface().time_s, 5);
}

TEST_F(PrescribedFile, OnAnotherGridIsBilinearAndWraps) {
    // The error of bilinear interpolation falls with the square of the file's cells, at the rim too.
    std::vector<double> errors;
    for (const int n : {32, 64, 128}) {
        const fs::path file = write("one.vti", make_grid(n, n, 1, 1), 0);
        errors.push_back(difference(make_prescribed(settings_for(file, 90))->surface(), 0).x);
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.2);
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2, 0.2);
}

TEST_F(PrescribedFile, ASeriesIsLinearInTimeAndStillBeyondItsEnds) {
    const Grid grid = make_grid(48, 48, 1, 1);
    std::ofstream(folder_ / "series.pvd")
        << "<VTKFile type=\"Collection\" version=\"0.1\"><Collection>\n"
           "<DataSet timestep=\"1\" file=\"a.vti\"/><DataSet timestep=\"1.5\" file=\"b.vti\"/>\n"
           "<DataSet timestep=\"4\" file=\"c.vti\"/></Collection></VTKFile>\n";
    write("a.vti", grid, 1);
    write("b.vti", grid, 1.5);
    write("c.vti", grid, 4);
    const auto model = make_prescribed(settings_for(folder_ / "series.pvd", 48));
    // waves() grows linearly in time, so that interpolation is exact.
    double t = 0;
    for (const double step : {0.0, 0.7, 0.3, 0.1, 0.4, 0.9, 1.6, 3.0}) {
        model->advance(step);
        t += step;
        EXPECT_LT(difference(model->surface(), std::clamp(t, 1.0, 4.0)).x, 2e-8) << t;
    }
}

TEST_F(PrescribedFile, SlopesRespectTheSides) {
    const fs::path file = write("one.vti", make_grid(32, 32, 1, 1), 0);
    const auto wall = make_prescribed(settings_for(file, 32, Side::wall));
    const auto open = make_prescribed(settings_for(file, 32, Side::absorbing));
    const Surface& w = wall->surface();
    const Surface& o = open->surface();
    for (int j = 1; j < 31; ++j) {
        ASSERT_FLOAT_EQ(w.slope_x(0, j), (w.elevation(1, j) - w.elevation(0, j)) * 16);
        ASSERT_FLOAT_EQ(w.slope_x(31, j), (w.elevation(31, j) - w.elevation(30, j)) * 16);
        ASSERT_FLOAT_EQ(o.slope_x(0, j), o.elevation(1, j) * 16);
        ASSERT_FLOAT_EQ(o.slope_y(j, 31), -o.elevation(j, 30) * 16);
    }
}

TEST_F(PrescribedFile, ATiltIsAdded) {
    PrescribedSettings settings = settings_for(write("one.vti", make_grid(32, 32, 1, 1), 0), 32);
    const auto level = make_prescribed(settings);
    settings.slope = {0.03, 0.01};
    const auto tilted = make_prescribed(settings);
    const Surface& s = tilted->surface();
    for (int j = 0; j < 32; ++j) {
        for (int i = 0; i < 32; ++i) {
            const double plane = 0.03 * s.grid.x_m(i) + 0.01 * s.grid.y_m(j);
            ASSERT_NEAR(s.elevation(i, j), level->surface().elevation(i, j) + plane, 1e-8);
            ASSERT_NEAR(s.slope_x(i, j), level->surface().slope_x(i, j) + 0.03, 1e-8);
        }
    }
}

TEST_F(PrescribedFile, ABadOneIsRefusedByName) {
    const Grid grid = make_grid(8, 8, 1, 1);
    const auto message = [&](const PrescribedSettings& settings) -> std::string {
        try {
            make_prescribed(settings);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(message(settings_for(folder_ / "missing.vti", 8)).find("missing.vti"), std::string::npos);
    EXPECT_NE(message(settings_for(write("array.vti", grid, 0, "height"), 8)).find("elevation"), std::string::npos);
    const std::string small = message(settings_for(write("small.vti", make_grid(8, 8, 0.5, 1), 0), 8));
    EXPECT_NE(small.find("small.vti"), std::string::npos);
    EXPECT_NE(small.find("[0, 0.5]"), std::string::npos);
    const std::string nan = message(settings_for(write("nan.vti", grid, std::nan("")), 8));
    EXPECT_NE(nan.find("nan.vti"), std::string::npos);
    PrescribedSettings both = settings_for(write("good.vti", grid, 0), 8);
    both.sines = {Sine{}};
    EXPECT_NE(message(both), "");
}

}  // namespace
}  // namespace waterlight
