//! A token for each piece of work.
#include "cli/lsp/diagnostics/work_progress.hpp"

#include <utility>

namespace maclint::cli::lsp {
namespace {

std::string token_numbered(std::uint64_t number) { return "maclint/folders/" + std::to_string(number); }

} // namespace

void WorkProgress::send(Json value) {
    outbox_.notify("$/progress", {{"token", token_numbered(number_)}, {"value", std::move(value)}});
}

void WorkProgress::begin() {
    const std::lock_guard lock(mutex_);
    ++number_;
    running_ = true;
    outbox_.request("window/workDoneProgress/create", {{"token", token_numbered(number_)}});
    send({{"kind", "begin"}, {"title", "maclint"}, {"cancellable", true}, {"percentage", 0}});
}

void WorkProgress::report(std::string_view phase, std::size_t percent) {
    const std::lock_guard lock(mutex_);
    if (!running_) return;
    send({{"kind", "report"}, {"message", std::string(phase)}, {"percentage", percent}});
}

void WorkProgress::end() {
    const std::lock_guard lock(mutex_);
    if (std::exchange(running_, false)) send({{"kind", "end"}});
}

bool WorkProgress::is_running(const Json& token) const {
    const std::lock_guard lock(mutex_);
    return running_ && token == token_numbered(number_);
}

} // namespace maclint::cli::lsp
