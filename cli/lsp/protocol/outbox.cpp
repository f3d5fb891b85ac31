//! One message after the other, whole.
#include "cli/lsp/protocol/outbox.hpp"

#include <algorithm>
#include <utility>

namespace maclint::cli::lsp {
namespace {

/// MessageType of LSP.
constexpr int error_message = 1, log_message = 4;

} // namespace

void Outbox::send(const Json& message) {
    const std::string body = text_of(message);
    const std::lock_guard lock(mutex_);
    write_(body);
}

void Outbox::respond(const Json& id, Json result) {
    send({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
}

void Outbox::fail(const Json& id, const ResponseError& error) {
    send({{"jsonrpc", "2.0"},
          {"id", id},
          {"error", {{"code", static_cast<int>(error.code)}, {"message", error.message}}}});
}

void Outbox::notify(std::string_view method, Json params) {
    send({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
}

void Outbox::request(std::string_view method, Json params) {
    std::string id;
    {
        const std::lock_guard lock(mutex_);
        id = "maclint-" + std::to_string(next_id_++);
    }
    send({{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", std::move(params)}});
}

void Outbox::show_once(const std::string& message) {
    {
        const std::lock_guard lock(mutex_);
        if (std::ranges::find(shown_, message) != shown_.end()) return;
        shown_.push_back(message);
    }
    notify("window/showMessage", {{"type", error_message}, {"message", message}});
}

void Outbox::log(const std::string& message) {
    notify("window/logMessage", {{"type", log_message}, {"message", message}});
}

} // namespace maclint::cli::lsp
