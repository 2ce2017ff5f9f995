// The command line. The only place that turns an error into an exit: 0 done, 1 a check failed, 2 the scenario or the
// command line is wrong, 3 the world failed, 128 + N stopped by signal N.
#include <fmt/format.h>
#include <omp.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <new>

#include "app/check.hpp"
#include "app/devices.hpp"
#include "app/explain.hpp"
#include "app/run.hpp"
#include "app/signals.hpp"
#include "app/sweep/command.hpp"
#include "app/sweep/sweep.hpp"
#include "app/version.hpp"
#include "app/view/view.hpp"
#include "gpu/error.hpp"
#include "scenarios/document.hpp"
#include "sim/error.hpp"

namespace {

using namespace waterlight;

enum ExitCode { done = 0, check_failed = 1, wrong_input = 2, world_failed = 3 };

struct Arguments {
    RunOptions run;
    CheckOptions check;
    SweepOptions sweep;
    ViewOptions view;
    std::pair<int, int> view_size{1280, 720};
    std::string backend = "auto";
    int threads = 0;
    std::string movie;
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
    run->add_option("--movie", args.movie, "Make a movie of the pictures of output.image; default DIR/movie.mp4")
        ->type_name("FILE")
        ->expected(0, 1);
    run->add_option("--movie-speed", args.run.movie_speed, "Simulated seconds a second of it; default 1")
        ->needs("--movie")
        ->check(CLI::Range(1e-6, 1e6))
        ->type_name("X");
    run->add_flag("--quiet", args.run.quiet, "Say nothing but errors and failed checks");
}

void add_view(CLI::App& program, Arguments& args) {
    CLI::App* view = program.add_subcommand("view", "Open a window on a running scenario");
    view->footer(
        "Example:\n  waterlight view scenarios/pool.toml --set domain.cells=[256,192]\n\n"
        "Mouse: left click drops a ripple, shift and left drag pull a ball through the water, right drag goes round, "
        "the wheel nearer. W A S D Q E fly, space plays and pauses, . steps, R starts again, P and F2 take a picture, "
        "Escape closes.");
    view->add_option("scenario", args.view.scenario, "Scenario file (.toml)")->required()->type_name("SCENARIO");
    view->add_option("--set", args.view.overrides, "Another value for a key of the scenario; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->allow_extra_args(false)
        ->take_all()
        ->delimiter('\0');
    view->add_option("--size", args.view_size, "Pixels of the window; default 1280x720")
        ->delimiter('x')
        ->check(CLI::Range(1, 16384).description(""))
        ->type_name("WxH");
    view->add_option("--backend", args.backend, "Where to compute: auto, cpu or vulkan")
        ->check(CLI::IsMember({"auto", "cpu", "vulkan"}).description(""))
        ->type_name("BACKEND");
    view->add_option("--device", args.view.device.device, "Vulkan device, by index or part of its name; it draws, too")
        ->type_name("NAME");
    view->add_option("--threads", args.threads, "Threads of the CPU; default all")
        ->check(CLI::Range(1, 4096))
        ->type_name("N");
    view->add_flag("--validate", args.view.device.validation,
                   "Vulkan with its validation layer; a message of it fails at the end");
    view->add_option("--frames", args.view.frames, "Close after so many pictures, and say how quickly they came")
        ->check(CLI::Range(1, 1 << 30).description(""))
        ->type_name("N");
    view->add_option("--screenshot", args.view.screenshot,
                     "Where pictures taken by P or F2 go; with --frames the last one too")
        ->type_name("FILE");
}

void add_explain(CLI::App& program, Arguments& args) {
    CLI::App* explain =
        program.add_subcommand("explain", "Say what a scene needs: model, grid, time step, light, cost");
    explain->footer("Example:\n  waterlight explain scenarios/pool.toml --set waves.model=auto");
    explain->add_option("scenario", args.run.scenario, "Scenario file (.toml)")->required()->type_name("SCENARIO");
    explain->add_option("--set", args.run.overrides, "Another value for a key of the scenario; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->allow_extra_args(false)
        ->take_all()
        ->delimiter('\0');
}

void add_check(CLI::App& program, Arguments& args) {
    CLI::App* check = program.add_subcommand("check", "Run scenarios as tests: those that state [[check]]");
    check->footer(
        "Example:\n  waterlight check scenarios --filter 'dam_break*/waves.*' --junit checks.xml\n\n"
        "Exit: 0 all passed; 1 a check failed; 2 a scenario or the command line is wrong; 3 a run failed or took "
        "longer "
        "than --timeout; 130 or 143 stopped by SIGINT or SIGTERM.");
    check->add_option("path", args.check.paths, "Scenarios, and folders to search for them")
        ->required()
        ->type_name("PATH");
    check->add_option("--filter", args.check.filter, "Only checks whose SCENARIO/QUANTITY matches")->type_name("GLOB");
    check->add_option("--junit", args.check.junit, "Write the outcome as JUnit XML")->type_name("FILE");
    check->add_option("--jobs", args.check.jobs, "Scenarios at once, memory allowing; default one for each thread")
        ->check(CLI::Range(1, 4096))
        ->type_name("N");
    check->add_flag("--update", args.check.update,
                    "Where a value that equals expects is not met, show and write the value found");
    check->add_option("--out", args.check.out, "Keep what the runs write below this folder, pictures and fields too")
        ->type_name("DIR");
    check->add_option("--set", args.check.overrides, "Another value for a key of every scenario; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->allow_extra_args(false)
        ->take_all()
        ->delimiter('\0');
    check->add_option("--backend", args.check.backend, "Where to compute: auto, cpu or vulkan")
        ->check(CLI::IsMember({"auto", "cpu", "vulkan"}).description(""))
        ->type_name("BACKEND");
    check->add_option("--threads", args.threads, "Threads of the CPU, of all runs together; default all")
        ->check(CLI::Range(1, 4096))
        ->type_name("N");
    check->add_option("--timeout", args.check.timeout_s, "Stop the runs of a scenario after so long; default never")
        ->check(CLI::PositiveNumber.description(""))
        ->type_name("SECONDS");
    check->add_flag("--quiet", args.check.quiet, "No progress");
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
    args.run.device.backend = args.view.device.backend = backends.at(args.backend);
    if (program.got_subcommand("schema")) {
        fmt::print("{}", args.json ? schema_json() : args.markdown ? schema_markdown() : schema_text());
        return done;
    }
    if (program.got_subcommand("devices")) {
        fmt::print("{}", devices_text());
        return done;
    }
    if (program.got_subcommand("check")) {
        args.check.threads = args.threads > 0 ? args.threads : omp_get_max_threads();
        catch_stop_signals();
        args.check.stop_signal = stop_signal;
        constexpr ExitCode exits[] = {done, check_failed, wrong_input, world_failed};
        return exits[static_cast<int>(run_checks(args.check))];
    }
    if (program.got_subcommand("explain")) {
        fmt::print("{}", explain_scenario(args.run.scenario, args.run.overrides));
        return done;
    }
    if (program.got_subcommand("sweep")) {
        if (args.sweep.threads > 0) omp_set_num_threads(args.sweep.threads);
        return sweep(args.sweep) ? done : check_failed;
    }
    if (args.threads > 0) omp_set_num_threads(args.threads);
    if (program.get_subcommand("run")->count("--movie") > 0) args.run.movie = args.movie;
    catch_stop_signals();
    if (program.got_subcommand("view")) {
        args.view.size = {args.view_size.first, args.view_size.second};
        args.view.stop_signal = stop_signal;
        view_scenario(args.view);
        return done;
    }
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
    args.check.program = argv[0];
    add_run(program, args);
    add_view(program, args);
    add_explain(program, args);
    add_check(program, args);
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
    const int exit = execute(program, args);
    if (std::fflush(stdout) != 0)
        throw WorldError(fmt::format("cannot write to standard output: {}", std::strerror(errno)));
    return exit;
}

/// Threads that wait should soon sleep: a run shares its cores with the thread that writes and with other programs, and
/// threads that spin for their turn hold them up (40 times slower, measured). OpenMP reads this before main(), so the
/// program starts itself anew, once; where that fails they spin.
void let_waiting_threads_sleep(char** argv) {
    if (std::getenv("OMP_WAIT_POLICY") || std::getenv("GOMP_SPINCOUNT")) return;
    setenv("GOMP_SPINCOUNT", "1000", 1);
    execv("/proc/self/exe", argv);
}

/// Where even that cannot be written the exit code remains.
void say(const char* what, const char* more = "") { std::fprintf(stderr, "waterlight: %s%s\n", what, more); }

}  // namespace

int main(int argc, char** argv) {
    let_waiting_threads_sleep(argv);
    outlive_file_limit();
    try {
        return parse_and_execute(argc, argv);
    } catch (const InputError& error) {
        say(error.what());
        return wrong_input;
    } catch (const Interrupted& interrupted) {
        say("stopped by ", interrupted.text.c_str());
        return 128 + interrupted.signal;
    } catch (const std::bad_alloc&) {
        say("out of memory");
    } catch (const std::exception& error) {
        say(error.what());
    }
    return world_failed;
}
