// Nobody waits for the session's solver, and many may talk to it at once.
#include <chrono>
#include <set>
#include <thread>

#include "tests/unit/session_support.hpp"

namespace waterlight::test {
namespace {

TEST_F(SessionTest, BuffersComeBack) {
    Session session(scenario(), cpu, by_hand);
    std::set<const Snapshot*> seen;
    for (int n = 0; n < 50; ++n) seen.insert(after(session, session.step()).get());
    EXPECT_LE(seen.size(), 4U);
    std::shared_ptr<const Snapshot> kept = session.latest();
    const std::uint64_t number = kept->number;
    for (int n = 0; n < 5; ++n) session.await(session.step());
    EXPECT_EQ(kept->number, number);
}

TEST_F(SessionTest, PlaysInRealTimeAndNeverMoreThanAFrameAhead) {
    Session session(scenario(), cpu, {.frame_s = 0.01, .plays = true});
    const auto start = std::chrono::steady_clock::now();
    while (session.latest()->time_s < 0.2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_GE(wall, 0.2 - 2 * 0.01);
    EXPECT_GT(session.status().rate, 0);
    EXPECT_LE(session.status().rate, 1.05);
    session.await(session.pause());
    const auto stopped = session.latest();
    EXPECT_FALSE(session.status().plays);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(session.latest()->time_s, stopped->time_s);
}

TEST_F(SessionTest, NobodyWaitsForASlowSolver) {
    // The truth of a map takes long; the reader's calls, even so, are of a mutex held for copies of a pointer.
    Session session(scenario(small_pool, {"caustics.floor.method=truth", "caustics.floor.tolerance=1e-6",
                                          "caustics.floor.pixels=[160, 120]"}),
                    cpu, {.frame_s = 0.01, .plays = true});
    session.drop({1, 0.7}, 0.1, 0.01);
    // Were a reader held up by the solver, each of its calls would find another frame.
    Session::Ticket last = 0;
    const std::uint64_t first = session.latest()->number;
    std::uint64_t number = first;
    int within_frame = 0, most_within_frame = 0;
    for (int n = 0; n < 500; ++n) {
        const std::uint64_t seen = session.latest()->number;
        last = session.drop({0.5, 0.5}, 0.1, 1e-4);
        within_frame = seen == number ? within_frame + 1 : 0;
        most_within_frame = std::max(most_within_frame, within_frame);
        number = seen;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_GT(most_within_frame, 20);
    session.await(last);
    EXPECT_GT(session.latest()->number, first);
    EXPECT_LT(session.status().rate, 1);
    EXPECT_EQ(session.status().refusal, "");
}

TEST_F(SessionTest, ManyHandsAtOnce) {
    Session session(scenario(), cpu, {.frame_s = 0.002, .plays = true});
    std::vector<std::thread> hands;
    for (int h = 0; h < 3; ++h)
        hands.emplace_back([&session, h] {
            for (int n = 0; n < 40; ++n) {
                session.drop({0.3 + 0.4 * h, 0.6}, 0.1, 1e-3);
                session.sun(40 + n % 30, 10 * h);
                if (n % 20 == 0)
                    session.set({n % 40 == 0 ? "caustics.floor.pixels=[20, 16]" : "domain.cells=[40, 30]"});
                const auto seen = session.latest();
                volatile float value = seen->surface.elevation(3, 3) + seen->floor.irradiance(2, 2);
                (void)value;
                (void)session.status();
                (void)session.text();
            }
        });
    for (std::thread& hand : hands) hand.join();
    session.await(session.pause());
    EXPECT_EQ(session.status().failure, "");
    EXPECT_EQ(session.status().refusal, "");
}

}  // namespace
}  // namespace waterlight::test
