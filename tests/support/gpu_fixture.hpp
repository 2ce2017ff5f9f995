// Tests that need a Vulkan device.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "gpu/context.hpp"

#ifdef __SANITIZE_ADDRESS__
// The validation layer and the driver leak memory of their own.
extern "C" [[gnu::used]] inline const char* __lsan_default_suppressions() {
    return "leak:libVkLayer_khronos_validation\nleak:libvulkan_lvp\n";
}
#endif

namespace waterlight {

/// Opens the best device with the validation layer, and fails the test if the layer has said anything by its end.
/// Skips only where there is no Vulkan device at all.
class GpuTest : public testing::Test {
  protected:
    void SetUp() override {
        const gpu::Selection selection = gpu::survey();
        if (selection.candidates.empty()) GTEST_SKIP() << selection.explanation;
#ifdef __SANITIZE_ADDRESS__
        // Once the layer is unloaded the leak checker can no longer tell its leaks from ours: keep it loaded.
        [[maybe_unused]] static const auto* const kept = new gpu::Context({.validation = true});
#endif
        open({.validation = true});
    }

    void open(const gpu::ContextSettings& settings) { context = std::make_shared<gpu::Context>(settings); }

    void TearDown() override {
        if (!context || !expect_silence) return;
        EXPECT_EQ(context->validation_messages(), std::vector<std::string>{});
    }

    std::shared_ptr<gpu::Context> context;
    bool expect_silence = true;
};

}  // namespace waterlight
