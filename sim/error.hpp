// The two ways a run can fail that are not bugs. A bug asserts.
#pragma once

#include <stdexcept>

namespace waterlight {

/// The scenario, a data file or the command line asks for something that cannot be: the program exits 2.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The world failed: disk, memory or device: the program exits 3.
struct WorldError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace waterlight
