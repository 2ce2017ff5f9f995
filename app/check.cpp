#include "app/check.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

#include "app/check_plan.hpp"
#include "app/check_runner.hpp"
#include "app/check_table.hpp"
#include "app/check_update.hpp"
#include "app/junit.hpp"
#include "app/signals.hpp"
#include "app/timed.hpp"
#include "export/atomic_file.hpp"
#include "scenarios/memory.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

bool is_stopped(const CheckOptions& options) { return options.stop_signal && options.stop_signal() != 0; }

/// Where the runs write; a folder that nobody asked for is removed at the end.
class CheckFolder {
  public:
    explicit CheckFolder(const fs::path& wanted)
        : path_(wanted.empty() ? fs::temp_directory_path() / fmt::format("waterlight-check-{}", getpid()) : wanted),
          is_kept_(!wanted.empty()) {}
    ~CheckFolder() {
        std::error_code ignored;
        if (!is_kept_) fs::remove_all(path_, ignored);
    }
    CheckFolder(const CheckFolder&) = delete;
    CheckFolder& operator=(const CheckFolder&) = delete;

    /// One for each scenario, though two may have the same name.
    fs::path of(const std::string& name) {
        std::string own = name;
        for (int n = 2; !taken_.insert(own).second; ++n) own = fmt::format("{}_{}", name, n);
        return path_ / own;
    }

  private:
    fs::path path_;
    bool is_kept_;
    std::set<std::string> taken_;
};

/// Runs the items, several at once: never more than fit the memory together, but always one.
class Pool {
  public:
    Pool(const std::vector<CheckItem>& items, const CheckOptions& options)
        : items_(items),
          options_(options),
          folder_(options.out),
          outcomes_(items.size()),
          free_bytes_(machine_memory()) {
        for (std::size_t i = 0; i < items.size(); ++i) {
            folders_.push_back(folder_.of(items[i].name));
            if (items[i].scenario) waiting_.push_back(i);
        }
        total_ = waiting_.size();
        const int threads = std::max(options.threads, 1), wanted = options.jobs > 0 ? options.jobs : threads;
        jobs_ = std::clamp(static_cast<int>(total_), 1, wanted);
        threads_each_ = std::max(1, threads / jobs_);
    }

    std::vector<ItemOutcome> run() {
        std::vector<std::thread> workers;
        for (int n = 0; n < jobs_; ++n) workers.emplace_back([this] { work(); });
        for (std::thread& worker : workers) worker.join();
        if (failure_) std::rethrow_exception(failure_);
        return std::move(outcomes_);
    }

  private:
    void work() {
        std::unique_lock lock(mutex_);
        while (!waiting_.empty() && !failure_) {
            const auto next = std::find_if(waiting_.begin(), waiting_.end(), [this](std::size_t i) { return fits(i); });
            if (next == waiting_.end()) {
                changed_.wait(lock);
                continue;
            }
            const std::size_t i = *next;
            waiting_.erase(next);
            ++running_;
            free_bytes_ -= items_[i].memory_bytes;
            lock.unlock();
            run_one(i);
            lock.lock();
            --running_;
            free_bytes_ += items_[i].memory_bytes;
            changed_.notify_all();
        }
    }

    bool fits(std::size_t i) const { return running_ == 0 || items_[i].memory_bytes <= free_bytes_; }

    void run_one(std::size_t i) {
        try {
            outcomes_[i] = run_item(items_[i], options_, folders_[i], threads_each_);
            show(i);
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!failure_) failure_ = std::current_exception();
        }
    }

    void show(std::size_t i) {
        const std::lock_guard lock(mutex_);
        ++done_;
        if (options_.quiet || is_stopped(options_)) return;
        fmt::print(stderr, "{} of {} scenarios: {}, {:.1f} s\n", done_, total_, items_[i].name, outcomes_[i].wall_s);
    }

    const std::vector<CheckItem>& items_;
    const CheckOptions& options_;
    CheckFolder folder_;
    std::vector<fs::path> folders_;
    std::vector<ItemOutcome> outcomes_;
    std::vector<std::size_t> waiting_;
    std::size_t total_ = 0, done_ = 0;
    int jobs_ = 1, threads_each_ = 1, running_ = 0;
    double free_bytes_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::exception_ptr failure_;
};

/// Shows what will change, then changes it.
void update(const std::vector<CheckItem>& items, std::vector<ItemOutcome>& outcomes) {
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (!items[i].scenario) continue;
        const std::vector<CheckUpdate> updates = updates_of(items[i], outcomes[i]);
        if (updates.empty()) continue;
        fmt::print("{}", diff_text(items[i], updates));
        std::fflush(stdout);
        apply_updates(items[i], updates);
        for (const CheckUpdate& u : updates) {
            CheckOutcome& outcome = outcomes[i].checks[u.outcome];
            outcome.verdict = Verdict::updated;
            fmt::print("updated {}: {} -> {}\n", full_name(items[i], outcome.quantity), u.old_text, u.new_text);
        }
    }
}

CheckExit worst_of(const std::vector<CheckItem>& items, const std::vector<ItemOutcome>& outcomes) {
    CheckExit worst = CheckExit::passed;
    const auto add = [&worst](bool happened, CheckExit what) {
        if (happened) worst = std::max(worst, what);
    };
    for (std::size_t i = 0; i < items.size(); ++i) {
        add(!items[i].wrong.empty(), CheckExit::wrong_scenario);
        for (const CheckOutcome& check : outcomes[i].checks) {
            add(check.verdict == Verdict::failed, CheckExit::failed);
            add(check.verdict == Verdict::error, CheckExit::world_failed);
        }
    }
    return worst;
}

/// What ends a check that was asked to stop: how much of it is left.
Interrupted interruption(const std::vector<ItemOutcome>& outcomes, int signal) {
    int all = 0, left = 0;
    for (const ItemOutcome& outcome : outcomes) {
        all += static_cast<int>(outcome.checks.size());
        left += static_cast<int>(std::ranges::count(outcome.checks, Verdict::stopped, &CheckOutcome::verdict));
    }
    return {signal, fmt::format("{}: {} of {} checks were not judged", signal_name(signal), left, all)};
}

}  // namespace

CheckExit run_checks(const CheckOptions& options) {
    const Clock::time_point start = Clock::now();
    const std::vector<CheckItem> items = plan_checks(options);
    for (const CheckItem& item : items)
        if (!item.wrong.empty()) fmt::print(stderr, "waterlight: {}\n", item.wrong);
    std::vector<ItemOutcome> outcomes = Pool(items, options).run();
    if (options.update && !is_stopped(options)) update(items, outcomes);
    const double wall_s = seconds_since(start);
    fmt::print("{}{}", table_text(items, outcomes), summary_text(items, outcomes, options, wall_s));
    if (!options.junit.empty()) write_file(options.junit, junit_xml(items, outcomes, options, wall_s));
    if (is_stopped(options)) throw interruption(outcomes, options.stop_signal());
    return worst_of(items, outcomes);
}

}  // namespace waterlight
