// Writing beside computing: jobs that a thread of its own does in their order.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace waterlight {

/// What the queue may hold, jobs waiting and the one at work together.
struct ExportLimits {
    int jobs = 4;                              ///< >= 1
    std::size_t bytes = std::size_t{1} << 30;  ///< >= 1
};

/// One thread that does the jobs pushed, in their order. The memory held by jobs never exceeds limits.bytes, except
/// that a single job larger than that is let in alone. Used by one thread at a time.
class ExportQueue {
  public:
    explicit ExportQueue(ExportLimits limits = {});
    /// Does all that was pushed. An exception that no one has fetched is dropped: call finish() to see it.
    ~ExportQueue();
    ExportQueue(const ExportQueue&) = delete;
    ExportQueue& operator=(const ExportQueue&) = delete;

    /// Hands over a callable, which may be move-only; `bytes` is the memory it keeps alive. Waits while the queue is
    /// full. Rethrows the first exception of a job; once one has failed no later one is done.
    template <class Job>
    void push(std::size_t bytes, Job&& job) {
        auto kept = std::make_shared<std::decay_t<Job>>(std::forward<Job>(job));
        push_job({[kept = std::move(kept)] { (*kept)(); }, bytes});
    }

    /// Waits until all is done; rethrows the first exception of a job. More may be pushed afterwards.
    void finish();

    double busy_s() const;     ///< time spent in jobs so far
    double blocked_s() const;  ///< time that push() and finish() have waited so far

  private:
    struct Job {
        std::function<void()> work;
        std::size_t bytes = 0;
    };
    void push_job(Job job);
    void run();
    void do_job(Job job);
    bool has_room(std::size_t bytes) const;
    void wait(std::unique_lock<std::mutex>& lock, const std::function<bool()>& ready);
    void rethrow() const;

    const ExportLimits limits_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> waiting_;
    int held_jobs_ = 0;
    std::size_t held_bytes_ = 0;
    bool closing_ = false;
    std::exception_ptr failure_;
    double busy_s_ = 0;
    double blocked_s_ = 0;
    std::thread worker_;
};

}  // namespace waterlight
