//! How large files may be that are no programs, and programs unless --max-file-size says otherwise.
#pragma once

#include "analyzer/source/read.hpp"

#include <cstddef>
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

/// Written by hand: those of large projects have less than 10 kB.
inline constexpr SizeLimit ignore_file_limit{mebibyte / 16, "What it names is checked."};

/// In the ignore files that hold in a folder. Each name in it is held against all of them.
inline constexpr std::size_t most_ignore_wildcards = 2000;

/// A .git that is a file, and what it leads to: a path and a word before it.
inline constexpr SizeLimit git_pointer_limit{mebibyte / 16, "Correct it."};

/// Other object folders, a path each.
inline constexpr SizeLimit git_list_limit{mebibyte, "Correct it, or leave --since out."};

} // namespace maclint::cli
