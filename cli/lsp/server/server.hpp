//! Takes messages and has them answered, one after the other, in the order in which they came.
#pragma once

#include "cli/lsp/server/session.hpp"
#include "cli/lsp/transport/message_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>

namespace maclint::cli::lsp {

class Server {
  public:
    /// More are not taken before some are answered.
    static constexpr std::size_t most_waiting = 1000;

    Server(Outbox::Write write, AnalystOptions options)
        : session_(std::move(write), options) {}

    /// Puts a message behind those that wait. One that cancels another does so at once.
    void receive(const Received& received);
    [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }
    /// Answers the message that has waited longest.
    void handle_next();
    /// `exit` came: nothing is answered any more.
    [[nodiscard]] bool is_done() const { return phase_ == Phase::done; }
    /// 0 where `shutdown` came before the end.
    [[nodiscard]] int exit_status() const { return was_shut_down_ ? 0 : 1; }

  private:
    enum class Phase : std::uint8_t { before_initialize, running, shut_down, done };

    void cancel(const Json& params);
    void handle_request(const Json& message, const std::string& method);
    void handle_notification(const Json& message, const std::string& method);
    [[nodiscard]] Json answer(const std::string& method, const Json& params);

    Session session_;
    std::deque<Json> waiting_;
    Phase phase_ = Phase::before_initialize;
    bool was_shut_down_ = false;
};

} // namespace maclint::cli::lsp
