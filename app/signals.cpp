#include "app/signals.hpp"

#include <unistd.h>

#include <csignal>

namespace waterlight {

namespace {

// A signal handler reaches nothing but what is global.
volatile std::sig_atomic_t received = 0;

void remember(int signal) {
    if (received != 0) ::_exit(128 + signal);
    received = signal;
}

}  // namespace

void catch_stop_signals() {
    struct sigaction action {};
    action.sa_handler = remember;
    action.sa_flags = SA_RESTART;
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
}

int stop_signal() { return received; }

const char* signal_name(int signal) { return signal == SIGINT ? "SIGINT" : "SIGTERM"; }

void outlive_file_limit() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace waterlight
