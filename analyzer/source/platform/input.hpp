//! Open files and standard input, read byte by byte as they are.
#pragma once

#include "analyzer/source/platform/files.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace maclint::platform {

inline constexpr int standard_input = 0;

/// A file that is open for reading and closes itself.
class OpenFile {
  public:
    /// Nothing hangs here: a pipe may be open before anybody writes to it.
    explicit OpenFile(const std::string& path);
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    ~OpenFile();

    /// Why it could not be opened, as errno has it, or 0.
    [[nodiscard]] int error() const { return error_; }
    [[nodiscard]] int descriptor() const { return descriptor_; }
    [[nodiscard]] FileKind kind() const { return kind_; }
    [[nodiscard]] std::uintmax_t size() const { return size_; }

  private:
    int descriptor_ = -1;
    int error_ = 0;
    FileKind kind_ = FileKind::missing;
    std::uintmax_t size_ = 0;
};

struct Portion {
    std::size_t count; ///< 0: the end
    int error;         ///< as errno has it, or 0
};

/// The next bytes of an open file, as many as there are and fit.
[[nodiscard]] Portion read_some(int descriptor, std::span<char> bytes);

/// Whether bytes or the end come from the open file in that time. People at a terminal may take longer.
[[nodiscard]] bool comes_in_time(int descriptor, std::chrono::milliseconds patience);

} // namespace maclint::platform
