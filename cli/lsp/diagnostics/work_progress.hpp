//! `$/progress` of the search through the folders.
#pragma once

#include "cli/lsp/protocol/outbox.hpp"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

namespace maclint::cli::lsp {

/// One piece of work after the other. May be used on several threads.
class WorkProgress {
  public:
    explicit WorkProgress(Outbox& outbox)
        : outbox_(outbox) {}

    void begin();
    /// `percent` of the phase that runs.
    void report(std::string_view phase, std::size_t percent);
    void end();
    [[nodiscard]] bool is_running(const Json& token) const;

  private:
    void send(Json value);

    Outbox& outbox_;
    mutable std::mutex mutex_;
    std::uint64_t number_ = 0; ///< of the work
    bool running_ = false;
};

} // namespace maclint::cli::lsp
