// The choice of a device, on invented machines.
#include "gpu/device.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "gpu/context.hpp"
#include "gpu/error.hpp"

namespace waterlight::gpu {
namespace {

DeviceDescription device(std::string name, DeviceType type) {
    return {.name = std::move(name),
            .type = type,
            .driver = "driver 1",
            .api = {1, 3, 0},
            .compute = true,
            .largest_storage_buffer_b = std::uint64_t{1} << 30,
            .most_texels = 1U << 27,
            .memory_b = std::uint64_t{1} << 33};
}

const DeviceDescription lavapipe = device("llvmpipe (LLVM 15)", DeviceType::cpu);
const DeviceDescription virtio = device("Virtio GPU", DeviceType::virtual_gpu);
const DeviceDescription iris = device("Iris Xe", DeviceType::integrated);
const DeviceDescription radeon = device("Radeon RX 7600", DeviceType::discrete);

TEST(DeviceSelection, PrefersDiscreteThenIntegratedThenVirtualThenCpu) {
    EXPECT_EQ(select_device({lavapipe, virtio, iris, radeon}).chosen, 3U);
    EXPECT_EQ(select_device({lavapipe, virtio, iris}).chosen, 2U);
    EXPECT_EQ(select_device({lavapipe, virtio}).chosen, 1U);
    EXPECT_EQ(select_device({lavapipe}).chosen, 0U);
}

TEST(DeviceSelection, KeepsTheLoadersOrderAmongEquals) {
    EXPECT_EQ(select_device({lavapipe, radeon, device("Radeon PRO", DeviceType::discrete)}).chosen, 1U);
}

TEST(DeviceSelection, PassesOverABetterDeviceThatCannotBeUsedAndSaysWhy) {
    DeviceDescription old = radeon;
    old.api = {1, 1, 5};
    old.compute = false;
    old.largest_storage_buffer_b = 1 << 16;
    old.most_texels = 1 << 16;
    const Selection selection = select_device({old, lavapipe});
    EXPECT_EQ(selection.chosen, 1U);
    ASSERT_EQ(selection.candidates[0].rejections.size(), 4U);
    EXPECT_EQ(selection.candidates[0].rejections[0], "offers Vulkan 1.1.5, needs 1.3.0");
    EXPECT_EQ(selection.candidates[0].rejections[1], "has no queue for compute passes");
    EXPECT_EQ(selection.candidates[0].rejections[2], "holds storage buffers of 65536 bytes, needs 134217728");
    EXPECT_EQ(selection.candidates[0].rejections[3], "reads 65536 texels of a buffer, needs 33554432");
    EXPECT_TRUE(selection.candidates[1].usable());
}

TEST(DeviceSelection, TakesTheOneAskedForByIndexOrByPartOfItsName) {
    EXPECT_EQ(select_device({lavapipe, iris, radeon}, "0").chosen, 0U);
    EXPECT_EQ(select_device({lavapipe, iris, radeon}, "iris").chosen, 1U);
    EXPECT_EQ(select_device({lavapipe, iris, radeon}, "LLVM").chosen, 0U);
}

TEST(DeviceSelection, DoesNotReplaceTheOneAskedForByAnother) {
    const Selection absent = select_device({lavapipe, iris}, "geforce");
    EXPECT_FALSE(absent.chosen);
    EXPECT_EQ(absent.explanation,
              "no Vulkan device is \"geforce\"; there are: 0 \"llvmpipe (LLVM 15)\" (CPU), 1 \"Iris Xe\" (integrated "
              "GPU)");
    EXPECT_FALSE(select_device({lavapipe, iris}, "2").chosen);

    DeviceDescription old = iris;
    old.api = {1, 2, 0};
    const Selection rejected = select_device({lavapipe, old}, "iris");
    EXPECT_FALSE(rejected.chosen);
    EXPECT_EQ(rejected.explanation, "no Vulkan device can be used: 1 \"Iris Xe\" offers Vulkan 1.2.0, needs 1.3.0");
}

TEST(DeviceSelection, PassesOverADeviceThatCannotShowPicturesWhereAWindowIsAskedFor) {
    DeviceDescription blind = radeon, seeing = iris;
    blind.presents = false;
    seeing.presents = seeing.graphics = seeing.adds_floats = true;
    EXPECT_EQ(select_device({blind, seeing}).chosen, 1U);
    seeing.graphics = false;
    const Selection none = select_device({seeing});
    EXPECT_EQ(none.explanation, "no Vulkan device can be used: 0 \"Iris Xe\" has no queue for drawing");
}

TEST(DeviceSelection, SaysThatThereIsNothing) {
    const Selection none = select_device({});
    EXPECT_FALSE(none.chosen);
    EXPECT_EQ(none.explanation, "no Vulkan device was found");
}

TEST(DeviceSelection, KnowsARealGpuFromAProgramThatPlaysOne) {
    EXPECT_FALSE(has_real_gpu(select_device({lavapipe})));
    EXPECT_TRUE(has_real_gpu(select_device({lavapipe, iris})));
    EXPECT_TRUE(has_real_gpu(select_device({lavapipe, iris}, "0")));
    DeviceDescription old = radeon;
    old.api = {1, 2, 0};
    EXPECT_FALSE(has_real_gpu(select_device({lavapipe, old})));
}

TEST(Survey, NamesWhatToInstallWhereThereIsNoDriver) {
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"}) setenv(name, "/nonexistent.json", 1);
    const Selection selection = survey();
    EXPECT_TRUE(selection.candidates.empty());
    EXPECT_FALSE(selection.chosen);
    const bool names_loader = selection.explanation.find("libvulkan1") != std::string::npos;
    const bool names_driver = selection.explanation.find("mesa-vulkan-drivers") != std::string::npos;
    EXPECT_TRUE(names_loader || names_driver) << selection.explanation;
    EXPECT_THROW(Context(), Error);
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"}) unsetenv(name);
}

}  // namespace
}  // namespace waterlight::gpu
