#include "app/sweep/command.hpp"

#include <fmt/format.h>

#include <charconv>

#include "sim/error.hpp"

namespace waterlight {

namespace {

Part parse_part(const std::string& text) {
    Part part;
    const char *end = text.data() + text.size(), *slash = text.data() + std::min(text.find('/'), text.size());
    const auto index = std::from_chars(text.data(), slash, part.index);
    const auto of = slash == end ? index : std::from_chars(slash + 1, end, part.of);
    const bool is_read =
        slash != end && index.ec == std::errc() && index.ptr == slash && of.ec == std::errc() && of.ptr == end;
    if (!is_read || part.index < 1 || part.index > part.of)
        throw InputError(fmt::format("--part: found \"{}\"; allowed: i/n with 1 <= i <= n", text));
    return part;
}

void add_lists(CLI::App& sweep, SweepOptions& o) {
    const auto add = [&sweep](const char* name, std::vector<std::string>& values, const char* meaning,
                              const char* form) {
        return sweep.add_option(name, values, meaning)
            ->type_name(form)
            ->expected(1)
            ->allow_extra_args(false)
            ->take_all()
            ->delimiter('\0');
    };
    add("--vary", o.variations, "Values for a key of the scenario; may be repeated, for the product", "KEY=V1,V2,...")
        ->required();
    add("--set", o.overrides, "Another value for a key, in every setting; may be repeated", "KEY=VALUE");
    add("--reference", o.reference, "A key of what settings are judged against; may be repeated", "KEY=VALUE");
}

void add_accuracy(CLI::App& sweep, SweepOptions& o) {
    sweep.add_option("--tolerance", o.tolerance, "Name the cheapest setting whose error is at most this, as 0.02")
        ->check(CLI::PositiveNumber.description(""));
    sweep.add_option("--repeats", o.repeats, "Runs of each setting, for the median of their times")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    sweep.add_option("--judge", o.judged, "Times at which errors are taken, the last at the end")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    sweep.add_option("--truth-tolerance", o.truth_tolerance, "Error of the light that maps are judged against")
        ->check(CLI::Range(1e-7, 0.1))
        ->capture_default_str();
    sweep.add_option("--reference-tolerance", o.reference_tolerance, "Change that ends the refinement of its waves")
        ->check(CLI::Range(1e-9, 1.0))
        ->capture_default_str();
}

void add_bounds(CLI::App& sweep, SweepOptions& o) {
    sweep.add_option("--jobs", o.jobs, "Settings at once, each in a process; their times then disturb each other")
        ->check(CLI::Range(1, 4096))
        ->type_name("N");
    sweep
        .add_option_function<std::string>(
            "--part", [&o](const std::string& text) { o.part = parse_part(text); },
            "Only the i-th of n shares of the settings, without a table")
        ->type_name("I/N");
    sweep.add_option("--max-runs", o.max_runs, "End after so many settings")
        ->check(CLI::Range(1, 1 << 30))
        ->type_name("N");
    sweep.add_option("--max-time", o.max_time_s, "Begin no setting after so many seconds")
        ->check(CLI::NonNegativeNumber.description(""))
        ->type_name("S");
    sweep.add_flag("--collect", o.collect, "Run nothing: only the table of what has run");
    sweep.add_flag("--fresh", o.fresh, "Forget what an earlier sweep left in the folder");
    sweep.add_flag("--quiet", o.quiet, "Say nothing but errors");
}

void add_device(CLI::App& sweep, SweepOptions& o) {
    sweep
        .add_option_function<std::string>(
            "--backend",
            [&o](const std::string& name) {
                o.device.backend = name == "cpu"      ? Backend::cpu
                                   : name == "vulkan" ? Backend::vulkan
                                                      : Backend::automatic;
            },
            "Where to compute: auto, cpu or vulkan")
        ->check(CLI::IsMember({"auto", "cpu", "vulkan"}).description(""))
        ->type_name("BACKEND");
    sweep.add_option("--device", o.device.device, "Vulkan device, by index or part of its name")->type_name("NAME");
    sweep.add_option("--threads", o.threads, "Threads of the CPU; default all")
        ->check(CLI::Range(1, 4096))
        ->type_name("N");
}

}  // namespace

void add_sweep(CLI::App& program, SweepOptions& o) {
    CLI::App* sweep = program.add_subcommand("sweep",
                                             "Run a scenario over many settings: what each costs and how "
                                             "wrong it is");
    sweep->footer(
        "Example:\n  waterlight sweep scenarios/pool.toml --vary 'domain.cells=[128,96],[256,192]' "
        "--vary 'caustics.floor.pixels=[256,192],[512,384]' --tolerance 0.1");
    sweep->add_option("scenario", o.scenario, "Scenario file (.toml)")->required()->type_name("SCENARIO");
    sweep->add_option("--out", o.out, "Folder for everything written; default out/<name of the scenario>-sweep")
        ->type_name("DIR");
    add_lists(*sweep, o);
    add_accuracy(*sweep, o);
    add_bounds(*sweep, o);
    add_device(*sweep, o);
}

}  // namespace waterlight
