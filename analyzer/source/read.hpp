//! Reading files and standard input whole: not more than was asked for, and without waiting for ever.
#pragma once

#include "analyzer/source/source.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>

namespace maclint {

/// The most bytes that are read of a file.
struct SizeLimit {
    std::uintmax_t bytes;
    std::string_view cure; ///< what to do about a file that has more: "Leave it out."
};

/// One byte less than an Offset can hold, so that lines and columns, which count from 1, fit as well.
inline constexpr std::uintmax_t largest_source = std::numeric_limits<Offset>::max() - 1;

/// Reads a file or a pipe. Folders, devices, what is larger than the limit, and what keeps the system waiting
/// for more than some seconds are refused.
[[nodiscard]] std::variant<Source, InputError> read_file(std::string path, const SizeLimit& limit);

/// The same of what must be no pipe: nobody is waited for.
[[nodiscard]] std::variant<Source, InputError> read_regular_file(std::string path, const SizeLimit& limit);

/// Up to so many bytes from the beginning of a regular file; none where there is no such file or it cannot be
/// read.
[[nodiscard]] std::string beginning_of_file(const std::string& path, std::size_t most);

/// Reads standard input to its end; `path` is what findings will name.
[[nodiscard]] std::variant<Source, InputError> read_standard_input(std::string path, const SizeLimit& limit);

} // namespace maclint
