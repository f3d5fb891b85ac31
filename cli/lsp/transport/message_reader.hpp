//! Cuts the bytes of a stream into messages by their Content-Length (base protocol of LSP 3.17).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace maclint::cli::lsp {

/// What came is no message: "what. Cure."
struct TransportFault {
    std::string message;
};

/// The body of a message, or one fault for all bytes up to the next message.
using Received = std::variant<std::string, TransportFault>;

class MessageReader {
  public:
    /// A program of 100 MB takes some 120 MB in a message; beyond this nobody means it. Bytes.
    static constexpr std::size_t most_body = std::size_t{512} << 20U;
    /// Those that a client sends have two lines. Bytes.
    static constexpr std::size_t most_head = 4096;

    void feed(std::string_view bytes);
    /// The next message or fault; nothing: more bytes are wanted.
    [[nodiscard]] std::optional<Received> next();

  private:
    enum class Head : std::uint8_t { incomplete, read, wrong };
    [[nodiscard]] bool skip_lost();
    [[nodiscard]] Head read_head();
    Head refuse(std::size_t bytes, std::string why);
    [[nodiscard]] std::optional<Received> take_body();

    std::string buffer_;
    std::optional<std::size_t> wanted_; ///< bytes of the body whose head was read
    std::size_t skipped_ = 0;           ///< bytes that are still to be passed over
    bool lost_ = false;                 ///< the next head has to be searched
    std::string fault_;                 ///< of the last head
};

/// A message with its head, as it is sent.
[[nodiscard]] std::string framed(std::string_view body);

} // namespace maclint::cli::lsp
