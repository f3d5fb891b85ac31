//! Bytes that a client may send to the language server: whatever they are, it answers messages and goes on.
#include "cli/lsp/server/server.hpp"
#include "fuzz/harness.hpp"

#include <chrono>
#include <string>
#include <string_view>

using namespace maclint;

namespace {

constexpr std::string_view initialize = R"({"jsonrpc":"2.0","id":0,"method":"initialize","params":{}})";

} // namespace

/// Read in pieces; half of the sessions begin as clients do.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = fuzz::text_of(data, size);
    if (bytes.find("file:") != std::string_view::npos) return 0; // no files of this machine
    cli::lsp::Server server(
        [](const std::string& body) {
            fuzz::require(cli::lsp::Json::accept(body), "the server sends what is no JSON");
            fuzz::require(to_utf8(body, Encoding::utf8) == body, "the server sends what is no UTF-8");
        },
        {.jobs = 1, .pause = std::chrono::milliseconds(0)});
    if (fuzz::choice(bytes, 2) == 0) server.receive(std::string(initialize));
    cli::lsp::MessageReader reader;
    const std::size_t piece = fuzz::choice(bytes, 64) + 1;
    for (std::size_t at = 0; at < bytes.size() && !server.is_done(); at += piece) {
        reader.feed(bytes.substr(at, piece));
        while (auto received = reader.next()) server.receive(*received);
        while (server.waiting() > 0 && !server.is_done()) server.handle_next();
    }
    return 0;
}
