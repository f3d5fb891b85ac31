//! `maclint lsp`: a language server over standard input and output.
#include "analyzer/source/platform/console.hpp"
#include "analyzer/source/platform/input.hpp"
#include "cli/commands/commands.hpp"
#include "cli/lsp/server/server.hpp"
#include "cli/terminal.hpp"

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace maclint::cli {
namespace {

using namespace std::chrono_literals;

/// What comes from the client, message by message.
class ClientInput {
  public:
    /// Waits so long for bytes and hands on what they complete; false: the client has gone.
    bool take(lsp::Server& server, std::chrono::milliseconds patience) {
        const auto portion = input_.read_some(buffer_, patience);
        if (!portion) return true;
        if (portion->count == 0) return false;
        reader_.feed({buffer_.data(), portion->count});
        while (auto received = reader_.next()) server.receive(*received);
        return true;
    }

  private:
    platform::OpenFile input_ = platform::OpenFile::standard_input();
    std::vector<char> buffer_ = std::vector<char>(std::size_t{1} << 18U);
    lsp::MessageReader reader_;
};

} // namespace

/// Between two answers it looks for what has come: a request may be cancelled by then.
int run_lsp(const LspRequest& request) {
    lsp::Server server(
        [](const std::string& body) { (void)platform::write(platform::Stream::output, lsp::framed(body)); },
        {.jobs = request.jobs});
    ClientInput input;
    bool is_there = true;
    while (!server.is_done() && (is_there || server.waiting() > 0)) {
        if (is_there && server.waiting() < lsp::Server::most_waiting)
            is_there = input.take(server, server.waiting() > 0 ? 0ms : 1h);
        if (server.waiting() > 0) server.handle_next();
    }
    return server.exit_status();
}

} // namespace maclint::cli
