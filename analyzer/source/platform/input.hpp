//! Open files and standard input, read byte by byte as they are.
#pragma once

#include "analyzer/source/platform/files.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace maclint::platform {

struct Portion {
    std::size_t count; ///< 0: the end
    int error;         ///< as errno has it, or 0
};

/// A file that is open for reading and closes itself.
class OpenFile {
  public:
    /// Nothing hangs here: a pipe may be open before anybody writes to it.
    explicit OpenFile(const std::string& path);
    [[nodiscard]] static OpenFile standard_input() { return OpenFile(StandardInput{}); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile();

    /// Why it could not be opened, as errno has it, or 0.
    [[nodiscard]] int error() const { return error_; }
    [[nodiscard]] FileKind kind() const { return kind_; }
    [[nodiscard]] std::uintmax_t size() const { return size_; }

    /// The next bytes, as many as there are and fit. Nothing: none came in that time, and what is no pipe has
    /// that time only once. People at a terminal may take longer.
    [[nodiscard]] std::optional<Portion> read_some(std::span<char> bytes, std::chrono::milliseconds patience);

  private:
    struct StandardInput {};
    explicit OpenFile(StandardInput /*which*/);

    int descriptor_ = -1;
    int error_ = 0;
    FileKind kind_ = FileKind::missing;
    std::uintmax_t size_ = 0;
    bool never_waits_ = false;              ///< a file of a disk: its bytes are there
    std::chrono::milliseconds waited_ = {}; ///< for the bytes of a file that is no pipe
};

/// Whether bytes or the end come from the open file in that time. People at a terminal may take longer.
[[nodiscard]] bool comes_in_time(int descriptor, std::chrono::milliseconds patience);

} // namespace maclint::platform
