#include "app/sweep/sweep.hpp"

#include <fmt/format.h>

#include <chrono>
#include <map>

#include "app/hash.hpp"
#include "app/progress.hpp"
#include "app/sweep/jobs.hpp"
#include "app/sweep/lock.hpp"
#include "app/sweep/measure.hpp"
#include "app/sweep/plot.hpp"
#include "app/version.hpp"
#include "export/atomic_file.hpp"

namespace waterlight {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

class Sweep {
  public:
    explicit Sweep(SweepOptions options) : options_(std::move(options)) {
        if (options_.out.empty()) options_.out = fs::path("out") / (options_.scenario.stem().string() + "-sweep");
        for (const std::string& text : options_.variations) variations_.push_back(parse_variation(text));
        settings_ = settings_of(options_, variations_);
        comparison_ = comparison_of(options_, variations_, settings_);
        for (std::size_t i = 0; i < settings_.size(); ++i)
            if (is_ours(i)) ours_.push_back(i);
    }

    bool go() {
        if (options_.fresh) forget();
        if (!options_.collect) run();
        if (options_.part) return true;
        return gather();
    }

  private:
    bool is_ours(std::size_t i) const {
        return !options_.part ||
               i % static_cast<std::size_t>(options_.part->of) + 1 == static_cast<std::size_t>(options_.part->index);
    }

    void forget() const {
        for (const char* name : {"settings", "reference", "truth"}) fs::remove_all(options_.out / name);
    }

    /// A name for all that a number depends on: these overrides, and how it is measured.
    std::string name_of(const std::vector<std::string>& overrides) const {
        Hash hash;
        const auto add = [&hash](const std::string& text) {
            hash.add(text);
            hash.add("\n");
        };
        add(version);
        add(settings_.front().scenario.origin.text);
        for (const std::string& text : overrides) add(text);
        for (const std::string& text : options_.reference) add("reference " + text);
        for (const auto& list : {comparison_.cells, comparison_.model})
            for (const std::string& text : list) add("reference " + text);
        add(fmt::format("{} {} {} {}", comparison_.raster.x, comparison_.raster.y, comparison_.points.x,
                        comparison_.points.y));
        add(fmt::format("{} {} {}", options_.judged, options_.truth_tolerance, options_.reference_tolerance));
        return fmt::format("{:016x}", hash.value());
    }

    fs::path result_file(std::size_t i) const {
        std::vector<std::string> overrides = settings_[i].overrides;
        overrides.push_back(fmt::format("{} repeats on {} {}", options_.repeats,
                                        static_cast<int>(options_.device.backend), options_.device.device));
        return options_.out / "settings" / (name_of(overrides) + ".json");
    }

    int done() const {
        int count = 0;
        for (const std::size_t i : ours_)
            if (fs::exists(result_file(i))) ++count;
        return count;
    }

    const Reference& reference(std::size_t i) {
        const fs::path folder = options_.out / "reference" / name_of(settings_[i].scene);
        const auto [entry, is_new] = references_.try_emplace(folder);
        if (is_new) entry->second = reference_of(options_, comparison_, settings_[i], folder);
        return entry->second;
    }

    /// Unless it has run or runs elsewhere. Returns whether it ran.
    bool run_one(std::size_t i) {
        const fs::path file = result_file(i);
        if (fs::exists(file)) return false;
        const Reference& judge = reference(i);
        const auto lock = FileLock::try_for(file.string() + ".lock");
        if (!lock || fs::exists(file)) return false;
        const fs::path truth = options_.out / "truth" / name_of(settings_[i].waves);
        write_result(file, measure(options_, comparison_, settings_[i], judge, truth));
        return true;
    }

    void run() {
        const int had = done(), total = static_cast<int>(ours_.size()) - had;
        if (total == 0) return;
        Progress progress(stderr, total, options_.quiet, "setting");
        const int jobs = jobs_at_once(options_, settings_);
        if (jobs > 1) {
            int shown = 0;
            run_jobs(options_, jobs, [&] {
                if (const int now = done() - had; now != shown) progress.show(shown = now);
            });
            return;
        }
        const Clock::time_point start = Clock::now();
        int ran = 0;
        for (const std::size_t i : ours_) {
            const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
            if (ran >= options_.max_runs || elapsed > options_.max_time_s) break;
            if (!run_one(i)) continue;
            ++ran;
            progress.show(done() - had);
        }
    }

    bool gather() const {
        Table table{options_.scenario,
                    variations_,
                    settings_.size(),
                    comparison_.raster,
                    comparison_.points,
                    comparison_.times_s,
                    options_.tolerance,
                    {},
                    {},
                    {}};
        for (std::size_t i = 0; i < settings_.size(); ++i)
            if (std::optional<SettingResult> result = read_result(result_file(i)))
                table.rows.push_back({i + 1, &settings_[i], std::move(*result)});
        finish(table);
        write_file(options_.out / "sweep.csv", csv_of(table));
        write_file(options_.out / "sweep.md", markdown_of(table));
        const Drawing plot = plot_of(table);
        write_file(options_.out / "sweep.svg", svg_of(plot));
        write_file(options_.out / "sweep.png", encode_png(image_of(plot)));
        const bool is_whole = table.rows.size() == settings_.size();
        if (!options_.quiet) say(table, is_whole);
        return !is_whole || meets_tolerance(table);
    }

    void say(const Table& table, bool is_whole) const {
        if (!table.rows.empty()) fmt::print("{}\n{}", text_of(table), explanation(table));
        fmt::print("{}", recommendation(table));
        if (!is_whole)
            fmt::print("{} of {} settings have run; the same command goes on\n", table.rows.size(), settings_.size());
        fmt::print("  {:<40} the table and the plot, also as .md, .svg and .png\n",
                   (options_.out / "sweep.csv").string());
    }

    SweepOptions options_;
    std::vector<Variation> variations_;
    std::vector<Setting> settings_;
    std::vector<std::size_t> ours_;
    Comparison comparison_;
    std::map<fs::path, Reference> references_;
};

}  // namespace

bool sweep(const SweepOptions& options) { return Sweep(options).go(); }

}  // namespace waterlight
