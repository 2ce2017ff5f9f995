#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "export/queue.hpp"

namespace waterlight::testing {
namespace {

using namespace std::chrono_literals;

/// A job that waits until it is let go.
struct Gate {
    std::promise<void> promise;
    std::shared_future<void> opened = promise.get_future().share();
    auto job() {
        return [opened = opened] { opened.wait(); };
    }
    void open() { promise.set_value(); }
};

/// Whether `call` is still waiting after a while; `release` then lets it end.
bool blocks(const std::function<void()>& call, const std::function<void()>& release) {
    auto running = std::async(std::launch::async, call);
    const bool waiting = running.wait_for(50ms) == std::future_status::timeout;
    release();
    running.get();
    return waiting;
}

TEST(ExportQueue, DoesAllInOrder) {
    std::vector<int> done;
    ExportQueue queue;
    for (int i = 0; i < 200; ++i) queue.push(1, [&done, i] { done.push_back(i); });
    queue.finish();
    ASSERT_EQ(done.size(), 200U);
    for (int i = 0; i < 200; ++i) EXPECT_EQ(done[i], i);
}

TEST(ExportQueue, TakesMoveOnlyJobs) {
    ExportQueue queue;
    int result = 0;
    queue.push(4, [number = std::make_unique<int>(7), &result] { result = *number; });
    queue.finish();
    EXPECT_EQ(result, 7);
}

TEST(ExportQueue, HoldsNoMoreJobsThanItsLimit) {
    Gate gate;
    ExportQueue queue({.jobs = 3});
    queue.push(1, gate.job());
    queue.push(1, [] {});
    queue.push(1, [] {});
    EXPECT_TRUE(blocks([&] { queue.push(1, [] {}); }, [&] { gate.open(); }));
    queue.finish();
    EXPECT_GT(queue.blocked_s(), 0.04);
    EXPECT_GT(queue.busy_s(), 0.04);
}

TEST(ExportQueue, HoldsNoMoreBytesThanItsLimit) {
    Gate gate;
    ExportQueue queue({.jobs = 100, .bytes = 1000});
    queue.push(600, gate.job());
    queue.push(400, [] {});
    EXPECT_TRUE(blocks([&] { queue.push(1, [] {}); }, [&] { gate.open(); }));
    queue.finish();
}

TEST(ExportQueue, ALargerJobGoesAlone) {
    Gate first, large;
    ExportQueue queue({.jobs = 100, .bytes = 1000});
    queue.push(1, first.job());
    EXPECT_TRUE(blocks([&] { queue.push(5000, large.job()); }, [&] { first.open(); }));
    EXPECT_TRUE(blocks([&] { queue.push(1, [] {}); }, [&] { large.open(); }));
    queue.finish();
}

/// Counts the live ones among what jobs keep.
struct Counted {
    explicit Counted(std::atomic<int>& live, std::atomic<int>& most) : live_(live) {
        const int now = ++live_;
        for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
        }
    }
    ~Counted() { --live_; }
    std::atomic<int>& live_;
};

TEST(ExportQueue, LetsGoOfMemoryBeforeItTakesMore) {
    std::atomic<int> live = 0, most = 0;
    ExportQueue queue({.jobs = 4});
    for (int i = 0; i < 500; ++i) {
        queue.push(1, [] {});  // so that the next one waits for its room with nothing in hand
        queue.push(1, [kept = std::make_shared<Counted>(live, most)] { std::this_thread::sleep_for(10us); });
    }
    queue.finish();
    EXPECT_EQ(live, 0);
    EXPECT_LE(most, 5) << "four in the queue and the one about to be pushed";
}

TEST(ExportQueue, TheFirstExceptionComesBackAtPushAndFinish) {
    std::atomic<int> done = 0;
    Gate gate;
    ExportQueue queue({.jobs = 4});
    queue.push(1, gate.job());
    queue.push(1, [] { throw std::runtime_error("first"); });
    queue.push(1, [&] { throw std::runtime_error("second"); });
    queue.push(1, [&] { ++done; });
    gate.open();
    const auto message = [](const std::function<void()>& call) -> std::string {
        try {
            call();
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message([&] { queue.finish(); }), "first");
    EXPECT_EQ(message([&] { queue.push(1, [&] { ++done; }); }), "first");
    EXPECT_EQ(message([&] { queue.finish(); }), "first");
    EXPECT_EQ(done, 0);
}

TEST(ExportQueue, AFailureReleasesAPushThatWaits) {
    Gate gate;
    ExportQueue queue({.jobs = 1});
    queue.push(1, [opened = gate.opened] {
        opened.wait();
        throw std::runtime_error("failed");
    });
    EXPECT_TRUE(blocks([&] { EXPECT_THROW(queue.push(1, [] {}), std::runtime_error); }, [&] { gate.open(); }));
}

TEST(ExportQueue, TheDestructorDoesWhatWasPushedAndNeverThrows) {
    int done = 0;
    {
        ExportQueue queue;
        for (int i = 0; i < 20; ++i) queue.push(1, [&done] { ++done; });
    }
    EXPECT_EQ(done, 20);
    {
        ExportQueue queue;
        queue.push(1, [] { throw std::runtime_error("nobody asks"); });
    }
}

}  // namespace
}  // namespace waterlight::testing
