// The command line. The only place that turns an error into an exit: 0 done, 1 a check failed, 2 the scenario or the
// command line is wrong, 3 the world failed, 128 + N stopped by signal N.
#include <fmt/format.h>
#include <omp.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <new>

#include "app/devices.hpp"
#include "app/run.hpp"
#include "app/signals.hpp"
#include "app/sweep/command.hpp"
#include "app/sweep/sweep.hpp"
#include "app/version.hpp"
#include "gpu/error.hpp"
#include "scenarios/document.hpp"
#include "sim/error.hpp"

namespace {

using namespace waterlight;

enum ExitCode { done = 0, check_failed = 1, wrong_input = 2, world_failed = 3 };

struct Arguments {
    RunOptions run;
    SweepOptions sweep;
    std::string backend = "auto";
    int threads = 0;
    bool json = false;
    bool markdown = false;
};

void add_run(CLI::App& program, Arguments& args) {
    CLI::App* run = program.add_subcommand("run", "Run a scenario: pictures, fields, gauges and a report");
    run->footer("Example:\n  waterlight run scenarios/pool.toml --out out/pool --set domain.cells=[256,192]");
    run->add_option("scenario", args.run.scenario, "Scenario file (.toml)")->required()->type_name("SCENARIO");
    run->add_option("--out", args.run.out, "Folder for everything written; default out/<name of the scenario>")
        ->type_name("DIR");
    run->add_option("--set", args.run.overrides, "Another value for a key of the scenario; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->allow_extra_args(false)
        ->take_all()
        ->delimiter('\0');
    run->add_option("--backend", args.backend, "Where to compute: auto, cpu or vulkan")
        ->check(CLI::IsMember({"auto", "cpu", "vulkan"}).description(""))
        ->type_name("BACKEND");
    run->add_option("--device", args.run.device.device, "Vulkan device, by index or part of its name")
        ->type_name("NAME");
    run->add_option("--threads", args.threads, "Threads of the CPU; default all")
        ->check(CLI::Range(1, 4096))
        ->type_name("N");
    run->add_flag("--validate", args.run.device.validation,
                  "Vulkan with its validation layer; a message of it fails the run");
    run->add_flag("--resume", args.run.resume, "Go on from the checkpoint that an interrupted run left in DIR");
    run->add_flag("--quiet", args.run.quiet, "Say nothing but errors and failed checks");
}

void add_schema(CLI::App& program, Arguments& args) {
    CLI::App* schema = program.add_subcommand("schema", "Print every key that a scenario may have");
    schema->footer("Example:\n  waterlight schema --json");
    CLI::Option* json = schema->add_flag("--json", args.json, "For programs");
    schema->add_flag("--markdown", args.markdown, "For documentation")->excludes(json);
}

int execute(const CLI::App& program, Arguments& args) {
    const std::map<std::string, Backend> backends{
        {"auto", Backend::automatic}, {"cpu", Backend::cpu}, {"vulkan", Backend::vulkan}};
    args.run.device.backend = backends.at(args.backend);
    if (program.got_subcommand("schema")) {
        fmt::print("{}", args.json ? schema_json() : args.markdown ? schema_markdown() : schema_text());
        return done;
    }
    if (program.got_subcommand("devices")) {
        fmt::print("{}", devices_text());
        return done;
    }
    if (program.got_subcommand("sweep")) {
        if (args.sweep.threads > 0) omp_set_num_threads(args.sweep.threads);
        return sweep(args.sweep) ? done : check_failed;
    }
    if (args.threads > 0) omp_set_num_threads(args.threads);
    catch_stop_signals();
    args.run.stop_signal = stop_signal;
    return run_scenario(args.run) ? done : check_failed;
}

int parse_and_execute(int argc, char** argv) {
    CLI::App program("Water surfaces and the light they focus", "waterlight");
    Arguments args;
    program.footer(
        "Example:\n  waterlight run scenarios/pool.toml\n\n"
        "Exit: 0 done; 1 a check failed; 2 the scenario or the command line is wrong; 3 the world failed; "
        "130 or 143 stopped by SIGINT or SIGTERM.");
    program.set_version_flag("--version", std::string("waterlight ") + version);
    program.require_subcommand(1);
    add_run(program, args);
    add_sweep(program, args.sweep);
    add_schema(program, args);
    program.add_subcommand("devices", "List the devices that can compute, and why one is chosen")
        ->footer("Example:\n  waterlight devices");
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return program.exit(error);
        throw InputError(fmt::format("command line: {} (waterlight --help says what is allowed)", error.what()));
    }
    return execute(program, args);
}

/// Threads that wait should soon sleep: a run shares its cores with the thread that writes and with other programs, and
/// threads that spin for their turn hold them up (40 times slower, measured). OpenMP reads this before main(), so the
/// program starts itself anew, once; where that fails they spin.
void let_waiting_threads_sleep(char** argv) {
    if (std::getenv("OMP_WAIT_POLICY") || std::getenv("GOMP_SPINCOUNT")) return;
    setenv("GOMP_SPINCOUNT", "1000", 1);
    execv("/proc/self/exe", argv);
}

}  // namespace

int main(int argc, char** argv) {
    let_waiting_threads_sleep(argv);
    try {
        return parse_and_execute(argc, argv);
    } catch (const InputError& error) {
        fmt::print(stderr, "waterlight: {}\n", error.what());
        return wrong_input;
    } catch (const Interrupted& interrupted) {
        fmt::print(stderr, "waterlight: stopped by {}\n", interrupted.text);
        return 128 + interrupted.signal;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "waterlight: out of memory\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "waterlight: {}\n", error.what());
    }
    return world_failed;
}
