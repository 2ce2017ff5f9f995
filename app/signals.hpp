// SIGINT and SIGTERM ask a run to stop in good order.
#pragma once

namespace waterlight {

/// From now on the first SIGINT or SIGTERM is only remembered; a second ends the program at once with 128 + its number.
/// A file that would grow beyond the system's limit is an error of its writing from now on, not the end.
void catch_stop_signals();

/// The signal that came, 0 where none did.
int stop_signal();

}  // namespace waterlight
