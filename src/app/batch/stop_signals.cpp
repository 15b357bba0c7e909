// SPDX-License-Identifier: MIT
#include "app/batch/stop_signals.h"

#include <cstdlib>
#include <iterator>

namespace edaha {
namespace {

// The one thing that a handler may touch.
volatile std::sig_atomic_t received_signal = 0;

extern "C" void note_signal(int signal) {
    if (received_signal == 0) received_signal = signal;
}

}  // namespace

StopSignals::StopSignals() {
    received_signal = 0;
    for (std::size_t i = 0; i < std::size(kSignals); ++i) {
        struct sigaction action {};
        action.sa_handler = note_signal;
        action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
        sigemptyset(&action.sa_mask);
        ::sigaction(kSignals[i], nullptr, &before_[i]);
        if (before_[i].sa_handler != SIG_IGN) ::sigaction(kSignals[i], &action, nullptr);
    }
}

StopSignals::~StopSignals() {
    for (std::size_t i = 0; i < std::size(kSignals); ++i)
        ::sigaction(kSignals[i], &before_[i], nullptr);
}

int StopSignals::received() {
    return received_signal;
}

void end_by_signal(int signal) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    std::_Exit(128 + signal);  // it was blocked
}

}  // namespace edaha
