//! Signals that would end the run where an error tells more.
#pragma once

#include <csignal>

namespace maclint::platform {

/// While this lives, a write fails that would have raised the signal: SIGPIPE of a pipe that is closed at the
/// other end, SIGXFSZ of a file that grows beyond `ulimit -f`.
class WithoutSignal {
  public:
    explicit WithoutSignal(int signal)
        : signal_(signal)
        , before_(std::signal(signal, SIG_IGN)) {} // NOLINT(performance-no-int-to-ptr)
    WithoutSignal(const WithoutSignal&) = delete;
    WithoutSignal& operator=(const WithoutSignal&) = delete;
    ~WithoutSignal() { std::signal(signal_, before_); }

  private:
    int signal_;
    void (*before_)(int);
};

} // namespace maclint::platform
