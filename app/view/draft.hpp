// A value that a widget edits while another owns it.
#pragma once

#include "app/view/session.hpp"

namespace waterlight {

template <class T>
struct Draft {
    T value{};
    bool is_held = false;      ///< the user works on it
    Session::Ticket sent = 0;  ///< the last command that carried it

    /// Takes the owner's value unless the user's is newer.
    void follow(const T& owned, const SessionStatus& status) {
        if (!is_held && status.command >= sent) value = owned;
    }
};

}  // namespace waterlight
