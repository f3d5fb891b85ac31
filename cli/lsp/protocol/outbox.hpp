//! Messages to the client, from any thread.
#pragma once

#include "cli/lsp/protocol/json.hpp"

#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace maclint::cli::lsp {

class Outbox {
  public:
    /// Takes one message, without its head.
    using Write = std::function<void(const std::string& body)>;

    explicit Outbox(Write write)
        : write_(std::move(write)) {}

    void respond(const Json& id, Json result);
    void fail(const Json& id, const ResponseError& error);
    void notify(std::string_view method, Json params);
    /// A request whose answer nobody waits for.
    void request(std::string_view method, Json params);
    /// What the user is to read, once for each text.
    void show_once(const std::string& message);
    /// What belongs into the log of the client.
    void log(const std::string& message);

  private:
    void send(const Json& message);

    std::mutex mutex_;
    Write write_;
    std::int64_t next_id_ = 1;
    std::vector<std::string> shown_;
};

} // namespace maclint::cli::lsp
