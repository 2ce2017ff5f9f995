#include "export/queue.hpp"

#include <cassert>
#include <chrono>

namespace waterlight {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

ExportQueue::ExportQueue(ExportLimits limits) : limits_(limits) {
    assert(limits.jobs >= 1 && limits.bytes >= 1);
    worker_ = std::thread([this] { run(); });
}

ExportQueue::~ExportQueue() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    changed_.notify_all();
    worker_.join();
}

bool ExportQueue::has_room(std::size_t bytes) const {
    if (held_jobs_ == 0) return true;
    return held_jobs_ < limits_.jobs && bytes <= limits_.bytes && held_bytes_ <= limits_.bytes - bytes;
}

void ExportQueue::wait(std::unique_lock<std::mutex>& lock, const std::function<bool()>& ready) {
    if (ready()) return;
    const Clock::time_point start = Clock::now();
    changed_.wait(lock, ready);
    blocked_s_ += seconds_since(start);
}

void ExportQueue::rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
}

void ExportQueue::push_job(Job job) {
    {
        std::unique_lock lock(mutex_);
        wait(lock, [&] { return failure_ || has_room(job.bytes); });
        rethrow();
        ++held_jobs_;
        held_bytes_ += job.bytes;
        waiting_.push_back(std::move(job));
    }
    changed_.notify_all();
}

void ExportQueue::finish() {
    std::unique_lock lock(mutex_);
    wait(lock, [&] { return held_jobs_ == 0; });
    rethrow();
}

double ExportQueue::busy_s() const {
    const std::lock_guard lock(mutex_);
    return busy_s_;
}

double ExportQueue::blocked_s() const {
    const std::lock_guard lock(mutex_);
    return blocked_s_;
}

void ExportQueue::run() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return closing_ || !waiting_.empty(); });
        if (waiting_.empty()) return;
        Job job = std::move(waiting_.front());
        waiting_.pop_front();
        const std::size_t bytes = job.bytes;
        const bool skip = failure_ != nullptr;
        lock.unlock();
        if (!skip) do_job(std::move(job));
        job = {};  // What it kept alive goes before its room is given to another.
        lock.lock();
        --held_jobs_;
        held_bytes_ -= bytes;
        changed_.notify_all();
    }
}

void ExportQueue::do_job(Job job) {
    const Clock::time_point start = Clock::now();
    std::exception_ptr failure;
    try {
        job.work();
    } catch (...) {
        failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    busy_s_ += seconds_since(start);
    if (failure) failure_ = failure;
}

}  // namespace waterlight
