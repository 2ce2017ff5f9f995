// A session of a small pool, stepped by hand.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "app/view/session.hpp"
#include "scenarios/reader.hpp"

namespace waterlight::test {

namespace fs = std::filesystem;

inline const std::string small_pool = R"(# A small pool.
title = "pool"
[domain]
size_m = [2.0, 1.5]
cells = [48, 36]
depth_m = 0.8
[waves]
model = "airy"
boundary = { x = "wall", y = "wall" }
duration_s = 1.0
[light]
elevation_deg = 70.0  # high
[caustics.floor]
pixels = [40, 30]
)";

inline const DeviceWish cpu{Backend::cpu, "", false};
inline const SessionSettings by_hand{.frame_s = 1.0 / 30, .plays = false, .estimate_every = 10};

class SessionTest : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ =
            fs::temp_directory_path() /
            ("waterlight-session-" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    Scenario scenario(const std::string& text = small_pool, const std::vector<std::string>& overrides = {}) const {
        const fs::path file = folder_ / "scenario.toml";
        std::ofstream(file) << text;
        return read_scenario(file, overrides);
    }

    fs::path folder_;
};

inline std::shared_ptr<const Snapshot> after(const Session& session, Session::Ticket command) {
    session.await(command);
    return session.latest();
}

inline bool is_same(const Field<float>& a, const Field<float>& b) { return std::ranges::equal(a.values(), b.values()); }

inline double largest(const Field<float>& field) {
    double most = 0;
    for (const float v : field.values()) most = std::max(most, std::abs(static_cast<double>(v)));
    return most;
}

}  // namespace waterlight::test
