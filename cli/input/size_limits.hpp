//! How large files may be that are no programs, and programs unless --max-file-size says otherwise.
#pragma once

#include "analyzer/source/read.hpp"

#include <cstdint>

namespace maclint::cli {

inline constexpr std::uintmax_t mebibyte = std::uintmax_t{1} << 20U;

/// The largest programs, of moulds, have some 200 MB; beyond this somebody has mistaken the file.
inline constexpr std::uintmax_t usual_program_bytes = 1024 * mebibyte;

[[nodiscard]] constexpr SizeLimit program_limit(std::uintmax_t bytes) {
    return {bytes, "Leave it out, or raise --max-file-size."};
}

/// Written by hand, or by a script for some thousand controls.
inline constexpr SizeLimit configuration_limit{16 * mebibyte, "Split it by 'extends', or correct its name."};

/// An entry takes some 200 bytes: more than a million of them.
inline constexpr SizeLimit baseline_limit{256 * mebibyte, "Keep one for each folder, or correct its name."};

/// Written by hand. Each name is held against all patterns: of 1 MiB there are some 50,000.
inline constexpr SizeLimit ignore_file_limit{mebibyte, "What it names is checked."};

/// A .git that is a file, and what it leads to: a path and a word before it.
inline constexpr SizeLimit git_pointer_limit{mebibyte / 16, "Correct it."};

/// Other object folders, a path each.
inline constexpr SizeLimit git_list_limit{mebibyte, "Correct it, or leave --since out."};

} // namespace maclint::cli
