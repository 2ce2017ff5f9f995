#include "app/check_runner.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/bytes_of.hpp"
#include "app/floor_stage.hpp"
#include "app/judge.hpp"
#include "app/process.hpp"
#include "app/signals.hpp"
#include "scenarios/quantities.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// One run, and what it came to.
struct RunWish {
    fs::path file;
    fs::path out;
    std::string backend;
    std::vector<std::string> overrides;
};

/// Why a check has no value.
struct RunFailure {
    std::string why;  ///< in one line; empty: it has not failed
    std::string log;
    Verdict verdict = Verdict::error;
};

struct RunResult {
    Json report;  ///< null where the run failed
    RunFailure failure;
    double wall_s = 0;
    /// Of a check; NaN where the run has no value.
    double value_of(int check) const {
        for (const Json& row : report["checks"])
            if (row["check"] == check && row["value"].is_number()) return row["value"];
        return std::numeric_limits<double>::quiet_NaN();
    }
};

std::string last_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

RunFailure failure_of(const ChildResult& child, const std::string& log, const CheckOptions& options) {
    const int signal = options.stop_signal ? options.stop_signal() : 0;
    // From a terminal a signal reaches the run as well, which may then end first.
    if (signal != 0) return {fmt::format("stopped by {}", signal_name(signal)), {}, Verdict::stopped};
    if (child.end == ChildEnd::too_long)
        return {fmt::format("stopped: the scenario takes longer than --timeout {}", options.timeout_s), log};
    if (child.signal != 0) return {fmt::format("the run was ended by signal {}", child.signal), log};
    return {fmt::format("the run ended with exit {}: {}", child.exit, last_line(log)), log};
}

/// `most_s` is the time that is left for it.
RunResult run(const RunWish& wish, const CheckOptions& options, int threads, double most_s) {
    std::vector<std::string> arguments{"run",        wish.file.string(), "--quiet",
                                       "--out",      wish.out.string(),  "--backend",
                                       wish.backend, "--threads",        fmt::format("{}", threads)};
    for (const std::string& override : wish.overrides) arguments.insert(arguments.end(), {"--set", override});
    fs::create_directories(wish.out);
    const fs::path log = wish.out / "log.txt", report = wish.out / "report.json";
    fs::remove(report);
    const ChildResult child = run_child(arguments, log, {most_s, options.stop_signal});
    RunResult result;
    result.wall_s = child.wall_s;
    const bool is_done = child.exit == 0 || child.exit == 1;
    if (is_done) result.report = Json::parse(bytes_of(report), nullptr, false);
    if (is_done && result.report.is_object()) return result;
    result.report = nullptr;
    result.failure = failure_of(child, bytes_of(log), options);
    return result;
}

/// A text as TOML writes it.
std::string toml_text(std::string_view text) {
    std::string toml = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') toml += '\\';
        toml += c;
    }
    return toml + '"';
}

/// Slope of log(error) over log(step), by least squares; NaN where an error is not above 0.
double fitted_order(const std::vector<Resolution>& at, const std::vector<double>& errors) {
    double n = 0, x_sum = 0, y_sum = 0, xx = 0, xy = 0;
    for (std::size_t k = 0; k < at.size(); ++k) {
        const double step = at[k].is_count ? 1 / at[k].size : at[k].size;
        const double x = std::log(step), y = errors[k] > 0 ? std::log(errors[k]) : std::nan("");
        n += 1;
        x_sum += x;
        y_sum += y;
        xx += x * x;
        xy += x * y;
    }
    return (n * xy - x_sum * y_sum) / (n * xx - x_sum * x_sum);
}

std::string name_of(OtherBackend backend) { return backend == OtherBackend::vulkan ? "vulkan" : "cpu"; }

class ItemRunner {
  public:
    ItemRunner(const CheckItem& item, const CheckOptions& options, fs::path out, int threads)
        : item_(item), options_(options), out_(std::move(out)), threads_(threads) {}

    ItemOutcome outcome() {
        std::vector<int> of_main;
        for (const int i : item_.chosen)
            if (!check(i).order && prepare(i)) of_main.push_back(i);
        if (!of_main.empty()) judge_main(of_main);
        for (const int i : item_.chosen)
            if (check(i).order) guarded(i, [&] { judge_order(i); });
        std::stable_sort(outcome_.checks.begin(), outcome_.checks.end(),
                         [](const CheckOutcome& a, const CheckOutcome& b) { return a.check < b.check; });
        return std::move(outcome_);
    }

  private:
    const Check& check(int i) const { return item_.scenario->checks[static_cast<std::size_t>(i)]; }
    bool is_norm(int i) const {
        const auto of = field_statistic(check(i).quantity);
        return of && of->is_norm();
    }

    CheckOutcome blank(int i) const {
        CheckOutcome outcome;
        outcome.check = i;
        outcome.quantity = check(i).quantity;
        outcome.name = waterlight::name_of(check(i));
        outcome.place = item_.scenario->origin.place(fmt::format("check[{}]", i));
        outcome.wall_s = spent_s(i);
        const std::vector<CheckResult> stated = judge({check(i)}, std::vector<double>{0});
        outcome.expected = stated.front().expected;
        return outcome;
    }

    /// Work on one check; where a run of it fails it has no value.
    template <class Work>
    bool guarded(int i, Work work) {
        try {
            work();
            return true;
        } catch (const RunFailure& failure) {
            add_without_value(i, failure.verdict, failure.why);
            outcome_.log += failure.log;
            return false;
        }
    }

    void add_without_value(int i, Verdict verdict, const std::string& why) {
        outcome_.checks.push_back(blank(i));
        outcome_.checks.back().verdict = verdict;
        outcome_.checks.back().detail = why;
    }

    RunResult try_run(const RunWish& wish, int i) {
        RunResult result = run(wish, options_, threads_, options_.timeout_s - outcome_.wall_s);
        outcome_.wall_s += result.wall_s;
        if (i >= 0) spent_[i] += result.wall_s;
        return result;
    }
    double spent_s(int i) const {
        const auto spent = spent_.find(i);
        return spent == spent_.end() ? 0 : spent->second;
    }
    RunResult needed_run(const RunWish& wish, int i) {
        RunResult result = try_run(wish, i);
        if (!result.failure.why.empty()) throw result.failure;
        return result;
    }

    RunWish wish(const std::string& name, std::vector<std::string> more) const {
        RunWish wish{item_.file, out_ / name, options_.backend, item_.overrides};
        wish.overrides.insert(wish.overrides.end(), more.begin(), more.end());
        return wish;
    }

    /// The back-end that is not the one of the run itself, as a check wants it.
    std::string other_backend(int i) const {
        const bool on_gpu = options_.backend == "auto" && gpu::has_real_gpu(gpu::survey());
        const std::string own = options_.backend == "vulkan" || on_gpu ? "vulkan" : "cpu";
        const std::string wanted = name_of(check(i).agrees->backend);
        if (wanted != own) return wanted;
        return own == "cpu" ? "vulkan" : "cpu";
    }

    /// Makes what the main run refers to for this check. False where it cannot be judged.
    bool prepare(int i) {
        if (check(i).agrees && !gpu::survey().chosen) {
            add_without_value(i, Verdict::skipped, "no Vulkan device");
            return false;
        }
        if (check(i).is_against_scenario()) return guarded(i, [&] { make_reference(i); });
        if (check(i).agrees && is_norm(i)) return guarded(i, [&] { make_other_fields(i); });
        return true;
    }

    fs::path series_of(int i, const fs::path& out) const {
        const std::string_view field = field_statistic(check(i).quantity)->field;
        return fs::absolute(out / fmt::format("{}.pvd", field.substr(0, field.find('.'))));
    }

    static std::vector<std::string> with_fields() {
        return {"output.formats=[\"vti\"]", "output.fields=[\"elevation\", \"depth\"]"};
    }

    /// Another scenario, up to the time that counts.
    void make_reference(int i) {
        const double time_s = check(i).at_s.value_or(item_.scenario->waves.duration_s);
        RunWish other = wish(fmt::format("reference_{}", i), {});
        other.file = *check(i).reference;
        other.overrides = with_fields();
        other.overrides.emplace_back("check=[]");
        if (time_s > 0)
            for (const char* key : {"waves.duration_s", "output.every_s"})
                other.overrides.push_back(fmt::format("{}={:.17g}", key, time_s));
        needed_run(other, i);
        main_overrides_.push_back(
            fmt::format("check[{}].reference={}", i, toml_text(series_of(i, other.out).string())));
    }

    /// The same scenario on the other back-end: what is left of the check is that the difference is nothing.
    void make_other_fields(int i) {
        RunWish other = wish(fmt::format("other_backend_{}", i), with_fields());
        other.backend = other_backend(i);
        needed_run(other, i);
        const std::string time = check(i).at_s ? fmt::format(", at_s={:.17g}", *check(i).at_s) : "";
        main_overrides_.push_back(fmt::format(
            "check[{}]={{quantity={}, reference={}, equals=0.0, tolerance={:.17g}{}}}", i, toml_text(check(i).quantity),
            toml_text(series_of(i, other.out).string()), check(i).agrees->tolerance, time));
    }

    void judge_main(const std::vector<int>& checks) {
        RunResult main = try_run(wish("run", main_overrides_), -1);
        for (const int i : checks) spent_[i] += main.wall_s / static_cast<double>(checks.size());
        outcome_.log += main.failure.log;
        for (const int i : checks) {
            if (!main.failure.why.empty())
                add_without_value(i, main.failure.verdict, main.failure.why);
            else if (check(i).agrees && !is_norm(i))
                guarded(i, [&] { judge_agreement(i, main); });
            else
                add_rows(i, main);
        }
    }

    /// As the run itself has judged.
    void add_rows(int i, const RunResult& main) {
        for (const Json& row : main.report["checks"]) {
            if (row["check"] != i) continue;
            CheckOutcome outcome = blank(i);
            if (!check(i).agrees) outcome.expected = row["expected"];
            if (row["value"].is_number()) outcome.value = row["value"];
            outcome.tolerance = row["tolerance"];
            outcome.verdict = row["pass"] == true ? Verdict::passed : Verdict::failed;
            outcome_.checks.push_back(outcome);
        }
    }

    void judge_agreement(int i, const RunResult& main) {
        RunWish other = wish(fmt::format("other_backend_{}", i), {});
        other.backend = other_backend(i);
        const double there = needed_run(other, i).value_of(i);
        CheckOutcome outcome = blank(i);
        outcome.value = main.value_of(i);
        outcome.tolerance = std::max(check(i).agrees->tolerance, check(i).agrees->relative_tolerance * std::abs(there));
        outcome.verdict = std::abs(outcome.value - there) <= outcome.tolerance ? Verdict::passed : Verdict::failed;
        outcome.detail = fmt::format("{} has {:.9g}", other.backend, there);
        outcome_.checks.push_back(outcome);
    }

    void judge_order(int i) {
        const OrderStudy& study = *check(i).order;
        std::vector<double> errors;
        std::vector<std::string> table;
        for (std::size_t k = 0; k < study.values.size(); ++k) {
            const std::string set = fmt::format("{}={}", study.key, study.values[k].text);
            errors.push_back(needed_run(wish(fmt::format("order_{}_{}", i, k), {set}), i).value_of(i));
            table.push_back(fmt::format("{:.4g} at {}", errors.back(), study.values[k].text));
        }
        CheckOutcome outcome = blank(i);
        outcome.value = fitted_order(study.values, errors);
        outcome.verdict = outcome.value >= study.at_least ? Verdict::passed : Verdict::failed;
        outcome.detail = fmt::format("{}", fmt::join(table, ", "));
        outcome_.checks.push_back(outcome);
    }

    const CheckItem& item_;
    const CheckOptions& options_;
    fs::path out_;
    int threads_;
    std::vector<std::string> main_overrides_;
    std::map<int, double> spent_;  ///< seconds of the runs made for a check
    ItemOutcome outcome_;
};

}  // namespace

ItemOutcome run_item(const CheckItem& item, const CheckOptions& options, const fs::path& out, int threads) {
    return ItemRunner(item, options, out, threads).outcome();
}

}  // namespace waterlight
