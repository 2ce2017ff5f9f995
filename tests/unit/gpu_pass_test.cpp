// Buffers, passes and command lists on whatever device there is, under the validation layer.
#include "gpu/pass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"
#include "gpu/error.hpp"
#include "shaders/gpu_scale.hpp"
#include "shaders/gpu_texels.hpp"
#include "tests/support/gpu_fixture.hpp"

namespace waterlight::gpu {
namespace {

struct Scale {
    float factor;
    int count;
};

PassSettings scale_settings() { return {"scale", shaders::gpu_scale, 2, sizeof(Scale), {64, 1, 1}}; }

class GpuPass : public GpuTest {};

// 1000 is no multiple of the workgroup, and every power of two is exact in float.
void expect_each_dispatch_sees_the_one_before(const std::shared_ptr<Context>& context) {
    constexpr int count = 1000, rounds = 10;
    Buffer from(context, count * sizeof(float), BufferUse::from_host);
    Buffer between(context, count * sizeof(float), BufferUse::device);
    Buffer to(context, count * sizeof(float), BufferUse::to_host);
    Pass in(context, scale_settings()), there(context, scale_settings()), back(context, scale_settings());
    in.bind({&from, &between});
    there.bind({&between, &to});
    back.bind({&to, &between});
    std::iota(from.host<float>().begin(), from.host<float>().end(), 0.0F);

    Commands commands(context, 64);
    commands.upload(from);
    commands.clear(to);
    commands.dispatch(in, {count, 1, 1}, Scale{1, count});
    for (int round = 0; round < rounds; ++round) {
        commands.dispatch(there, {count, 1, 1}, Scale{2, count});
        commands.dispatch(back, {count, 1, 1}, Scale{2, count});
    }
    commands.dispatch(there, {count, 1, 1}, Scale{2, count});
    commands.download(to);
    commands.run();

    for (int i = 0; i < count; ++i)
        ASSERT_EQ(to.host<float>()[i], std::ldexp(static_cast<float>(i), 2 * rounds + 1)) << i;
    for (const Timing& timing : commands.timings()) {
        EXPECT_EQ(timing.pass, "scale");
        EXPECT_GE(timing.seconds, 0);
        EXPECT_LT(timing.seconds, 10);
    }
}

TEST_F(GpuPass, EachDispatchSeesWhatTheOneBeforeWrote) { expect_each_dispatch_sees_the_one_before(context); }

TEST_F(GpuPass, AndSoItDoesThroughStagingAreas) {
    open({.staging = true, .validation = true});
    expect_each_dispatch_sees_the_one_before(context);
}

// The second dispatch reads as texels what the first one wrote; numbers and sums are whole and exact in float.
TEST_F(GpuPass, TexelsAreTheNumbersOfABufferOneTwoOrFourAtATime) {
    constexpr int count = 1000;
    Buffer from(context, count * sizeof(float), BufferUse::from_host);
    Buffer between(context, count * sizeof(float), BufferUse::device);
    Buffer to(context, count * sizeof(float), BufferUse::to_host);
    const PassSettings settings{.name = "texels",
                                .spirv = shaders::gpu_texels,
                                .buffers = 1,
                                .push_bytes = sizeof(int),
                                .workgroup = {64, 1, 1},
                                .texels = {Texels::r32f, Texels::rg32f, Texels::rgba32f}};
    Pass there(context, settings), on(context, settings);
    there.bind({&between}, {&from, &from, &from});
    on.bind({&to}, {&between, &between, &between});
    std::iota(from.host<float>().begin(), from.host<float>().end(), 0.0F);
    Commands commands(context);
    commands.upload(from);
    commands.dispatch(there, {count, 1, 1}, count);
    commands.dispatch(on, {count, 1, 1}, count);
    commands.download(to);
    commands.run();
    for (int i = 0; i < count; ++i) ASSERT_EQ(to.host<float>()[i], 111.0F * 111.0F * static_cast<float>(i)) << i;
}

TEST_F(GpuPass, AListCanBeRecordedAgainAfterItRan) {
    Buffer from(context, sizeof(float), BufferUse::from_host), to(context, sizeof(float), BufferUse::to_host);
    Pass pass(context, scale_settings());
    pass.bind({&from, &to});
    Commands commands(context);
    for (const float value : {3.0F, 5.0F, 7.0F}) {
        from.host<float>()[0] = value;
        commands.upload(from);
        commands.dispatch(pass, {1, 1, 1}, Scale{4, 1});
        commands.download(to);
        commands.run();
        EXPECT_EQ(to.host<float>()[0], 4 * value);
    }
    EXPECT_TRUE(commands.timings().empty());
}

TEST_F(GpuPass, ClearSetsEveryByteToZero) {
    Buffer from(context, 4 * sizeof(float), BufferUse::from_host), to(context, 4 * sizeof(float), BufferUse::to_host);
    Pass pass(context, scale_settings());
    pass.bind({&from, &to});
    std::ranges::fill(from.host<float>(), 1.0F);
    Commands commands(context);
    commands.upload(from);
    commands.dispatch(pass, {4, 1, 1}, Scale{1, 4});
    commands.clear(to);
    commands.dispatch(pass, {4, 1, 1}, Scale{9, 2});
    commands.download(to);
    commands.run();
    const std::vector<float> found(to.host<float>().begin(), to.host<float>().end());
    EXPECT_EQ(found, (std::vector<float>{9, 9, 0, 0}));
}

TEST_F(GpuPass, RefusesABufferThatTheDeviceCannotHold) {
    const std::uint64_t limit = context->device().largest_storage_buffer_b;
    EXPECT_THROW(Buffer(context, limit + 4, BufferUse::device), Error);
}

// Silence in the other tests means something only if the layer would have spoken.
TEST_F(GpuPass, ValidationSpeaksOfAShaderThatAsksForMoreThanItsLayoutGives) {
    expect_silence = false;
    PassSettings settings = scale_settings();
    settings.buffers = 1;
    const Pass pass(context, settings);
    EXPECT_FALSE(context->validation_messages().empty());
}

TEST_F(GpuPass, AContextDescribesItsDevice) {
    EXPECT_FALSE(context->device().name.empty());
    EXPECT_FALSE(context->device().driver.empty());
    EXPECT_FALSE(context->device().api < (Version{1, 3, 0}));
    EXPECT_GT(context->device().memory_b, 0U);
    EXPECT_EQ(context->device().name, context->selection().candidates[*context->selection().chosen].device.name);
}

TEST_F(GpuPass, AContextIsRefusedWhereTheDeviceAskedForIsAbsent) {
    try {
        const Context absent({.device = "no such device"});
        FAIL() << "opened " << absent.device().name;
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(context->device().name), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace waterlight::gpu
