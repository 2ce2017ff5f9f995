#include "app/sweep/jobs.hpp"

#include <fmt/format.h>
#include <omp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <limits>
#include <system_error>
#include <thread>

#include "scenarios/memory.hpp"
#include "sim/error.hpp"

namespace waterlight {

namespace {

std::vector<std::string> arguments_of(const SweepOptions& o, int jobs) {
    std::vector<std::string> a{"waterlight", "sweep", o.scenario.string(), "--out", o.out.string(), "--quiet"};
    const auto add = [&a](const char* name, const std::string& value) { a.insert(a.end(), {name, value}); };
    for (const std::string& text : o.overrides) add("--set", text);
    for (const std::string& text : o.variations) add("--vary", text);
    for (const std::string& text : o.reference) add("--reference", text);
    add("--repeats", fmt::format("{}", o.repeats));
    add("--judge", fmt::format("{}", o.judged));
    add("--truth-tolerance", fmt::format("{}", o.truth_tolerance));
    add("--reference-tolerance", fmt::format("{}", o.reference_tolerance));
    const Part part = o.part.value_or(Part{});
    add("--part", fmt::format("{}/{}", part.index, part.of));
    const int threads = o.threads > 0 ? o.threads : omp_get_max_threads();
    add("--threads", fmt::format("{}", std::max(1, threads / jobs)));
    const char* backends[] = {"auto", "cpu", "vulkan"};
    add("--backend", backends[static_cast<int>(o.device.backend)]);
    if (!o.device.device.empty()) add("--device", o.device.device);
    if (o.max_runs < std::numeric_limits<int>::max()) add("--max-runs", fmt::format("{}", o.max_runs / jobs));
    if (o.max_time_s < 1e300) add("--max-time", fmt::format("{}", o.max_time_s));
    return a;
}

pid_t start(const std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child < 0) throw WorldError(fmt::format("cannot start a process: {}", std::generic_category().message(errno)));
    if (child > 0) return child;
    // It ends when this process does, however that ends; what it was at is then done anew.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    execv("/proc/self/exe", argv.data());
    _exit(127);
}

}  // namespace

int jobs_at_once(const SweepOptions& options, const std::vector<Setting>& settings) {
    double greatest = 1;
    for (const Setting& setting : settings) greatest = std::max(greatest, estimate_memory(setting.scenario).total());
    return std::clamp(static_cast<int>(std::min(machine_memory() / greatest, 1e6)), 1,
                      std::min(options.jobs, options.max_runs));
}

void run_jobs(const SweepOptions& options, int jobs, const std::function<void()>& look) {
    std::vector<pid_t> children;
    for (int i = 0; i < jobs; ++i) children.push_back(start(arguments_of(options, jobs)));
    bool all_well = true;
    while (!children.empty()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        std::erase_if(children, [&](pid_t child) {
            int status = 0;
            if (waitpid(child, &status, WNOHANG) != child) return false;
            all_well = all_well && WIFEXITED(status) && WEXITSTATUS(status) == 0;
            return true;
        });
        look();
    }
    if (!all_well) throw WorldError("a process of the sweep failed; it says why above");
}

}  // namespace waterlight
