//! What the fuzz targets share: an input as text, and the end of a run that showed a defect.
#pragma once

#include "analyzer/source/encoding.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

/// What libFuzzer calls with each input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace maclint::fuzz {

[[noreturn]] inline void fail(const std::string& what) {
    std::fprintf(stderr, "DEFECT: %s\n", what.c_str());
    std::abort();
}

inline void require(bool holds, const char* what) {
    if (!holds) fail(what);
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Chooses between ways to run, the same for the same input.
inline std::size_t choice(std::string_view text, std::size_t ways) {
    std::uint32_t hash = 2166136261U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    return hash % ways;
}

/// A text for people or programs is valid UTF-8 and holds nothing that steers a terminal.
inline void require_harmless(std::string_view text, const std::string& name) {
    if (to_utf8(text, Encoding::utf8) != text) fail(name + " is no UTF-8");
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        if (printable(line) != line) fail(name + " holds raw characters: " + printable(line));
        begin = end + 1;
    }
}

} // namespace maclint::fuzz
