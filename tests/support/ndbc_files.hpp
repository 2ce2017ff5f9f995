// Buoy files made up for a test, in a folder that goes with it.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace waterlight::testing {

/// Writes STEM.data_spec, .swdir, .swdir2, .swr1, .swr2 from the text after the header line.
class NdbcFiles : public ::testing::Test {
  protected:
    NdbcFiles() {
        std::string pattern = (std::filesystem::temp_directory_path() / "ndbc_XXXXXX").string();
        folder_ = mkdtemp(pattern.data());
    }
    ~NdbcFiles() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path stem() const { return folder_ / "99999"; }
    void write(const std::string& suffix, const std::string& text) const {
        std::ofstream(stem().string() + suffix) << "#YY  MM DD hh mm ... >\n" << text;
    }
    /// One record of four frequencies in each file.
    void write_good() const {
        write(".data_spec", "2024 03 05 12 00 0.1 0.400 (0.100) 2.000 (0.110) 1.000 (0.130) 0.100 (0.150)\n");
        write(".swdir", "2024 03 05 12 00 270.0 (0.100) 270.0 (0.110) 999.0 (0.130) 180.0 (0.150)\n");
        write(".swdir2", "2024 03 05 12 00 270.0 (0.100) 270.0 (0.110) 999.0 (0.130) 180.0 (0.150)\n");
        write(".swr1", "2024 03 05 12 00 0.80 (0.100) 0.80 (0.110) 999.00 (0.130) 0.60 (0.150)\n");
        write(".swr2", "2024 03 05 12 00 0.50 (0.100) 0.50 (0.110) 999.00 (0.130) 0.30 (0.150)\n");
    }

  private:
    std::filesystem::path folder_;
};

}  // namespace waterlight::testing
