// SPDX-License-Identifier: MIT
#pragma once
#include <csignal>

namespace edaha {

// While one lives, SIGINT, SIGTERM and SIGHUP are only noted: the run ends when it finds one. A
// second one of the same kind ends the program at once. Signals that were ignored stay ignored
// (nohup). One at a time.
class StopSignals {
  public:
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    // The first one that came; 0 if none did.
    static int received();

  private:
    static constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction before_[3]{};
};

// Ends the program as the signal would have, so that shells and schedulers see it.
[[noreturn]] void end_by_signal(int signal);

}  // namespace edaha
