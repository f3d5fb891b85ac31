//! poll, again after each signal, until the time is over.
#include "analyzer/source/pipe_wait.hpp"

#include <algorithm>
#include <cerrno>

#include <poll.h>
#include <unistd.h>

namespace maclint {

bool comes_in_time(int descriptor, std::chrono::milliseconds patience) {
    if (isatty(descriptor) != 0) return true;
    const auto end = std::chrono::steady_clock::now() + patience;
    while (true) {
        const auto left =
            std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        pollfd file{.fd = descriptor, .events = POLLIN, .revents = 0};
        const int ready = poll(&file, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
        if (ready >= 0 || errno != EINTR) return ready != 0;
    }
}

} // namespace maclint
