//! One NC file as it was read: its bytes, their encoding, and lines and columns for any byte of it.
#pragma once

#include "analyzer/source/encoding.hpp"
#include "analyzer/source/line_index.hpp"
#include "analyzer/source/span.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

namespace maclint {

/// Why a file could not be read, in words for the user: what is wrong, then the cure.
struct InputError {
    std::string path;
    std::string message;
};

/// An immutable file. Copies share the bytes, which stay where they are, so a view of them is good as long as
/// any copy lives. Everything here may be called from several threads.
class Source {
  public:
    /// Reads a file or a pipe. Directories, devices and files of 4 GiB or more are refused.
    [[nodiscard]] static std::variant<Source, InputError> read_file(std::string path);
    /// Reads standard input to its end; `path` is what findings will name.
    [[nodiscard]] static std::variant<Source, InputError> read_standard_input(std::string path);
    /// Takes bytes that somebody else read, fewer than 4 GiB.
    [[nodiscard]] static Source from_bytes(std::string path, std::string bytes);

    /// The same bytes in an encoding that somebody knows better than their look tells.
    [[nodiscard]] Source read_as(Encoding encoding) const;

    /// As the user gave it.
    [[nodiscard]] const std::string& path() const;
    /// The whole file, byte order mark and tape leader included; in UTF-8 where it is stored in Shift-JIS or
    /// GBK. All offsets are into these.
    [[nodiscard]] std::string_view bytes() const;
    /// The bytes of the file as they are stored. Its lines are the same.
    [[nodiscard]] std::string_view stored_bytes() const;
    [[nodiscard]] Encoding stored_encoding() const;
    [[nodiscard]] std::string_view bytes(Span span) const;
    [[nodiscard]] Offset size() const;
    /// Of `bytes`: UTF-8 or Windows-1252.
    [[nodiscard]] Encoding encoding() const;
    [[nodiscard]] bool has_byte_order_mark() const;

    /// Where `offset` is for a reader. Costs at most a look at 1 KiB once the lines have been counted.
    [[nodiscard]] Position position(Offset offset) const;
    /// Line ends plus one.
    [[nodiscard]] std::uint32_t line_count() const;
    /// The line (from 1) without its line end.
    [[nodiscard]] Span line_span(std::uint32_t line) const;
    [[nodiscard]] std::string_view line_text(std::uint32_t line) const;
    /// The byte at a line and a UTF-16 column, both from 1.
    [[nodiscard]] Offset offset_at(std::uint32_t line, std::uint32_t column) const;

    /// A slice of this file as valid UTF-8.
    [[nodiscard]] std::string to_utf8(std::string_view slice) const;

  private:
    struct Contents;
    explicit Source(std::shared_ptr<const Contents> contents);

    std::shared_ptr<const Contents> contents_;
};

} // namespace maclint
