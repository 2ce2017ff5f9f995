// Signals that the program does not die of: SIGINT and SIGTERM ask it to stop in good order.
#pragma once

#include <string>

namespace waterlight {

/// What was asked to stop has stopped. Not a failure, and so no std::exception.
struct Interrupted {
    int signal = 0;
    std::string text;  ///< which signal, when, and how to go on
};

/// From now on the first SIGINT or SIGTERM is only remembered; a second ends the program at once with 128 + its number.
void catch_stop_signals();

/// The signal that came, 0 where none did.
int stop_signal();

/// SIGINT or SIGTERM.
const char* signal_name(int signal);

/// From now on a file that would grow beyond the system's limit is an error of its writing, not the end.
void outlive_file_limit();

}  // namespace waterlight
