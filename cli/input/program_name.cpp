//! Asks the table of extensions, and has one of others that no control reads.
#include "cli/input/program_name.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/text/letters.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

namespace maclint::cli {
namespace {

/// What stands beside programs: sources, drawings, papers. Nothing that somebody may call a program (.old).
constexpr auto others = std::to_array<std::string_view>(
    {".bmp",  ".c",   ".cc",   ".cpp", ".css", ".dll",  ".doc", ".docx",  ".dwg",  ".dxf",  ".exe",
     ".gif",  ".go",  ".gz",   ".hpp", ".htm", ".html", ".igs", ".java",  ".jpeg", ".jpg",  ".js",
     ".json", ".md",  ".odt",  ".pdf", ".png", ".py",   ".rs",  ".sarif", ".sh",   ".step", ".stl",
     ".stp",  ".svg", ".toml", ".ts",  ".xls", ".xlsx", ".xml", ".yaml",  ".yml",  ".zip"});

} // namespace

bool is_named_like_program(std::string_view path) { return has_nc_extension(path) && is_worth_a_note(path); }

bool is_named_like_other(std::string_view path) {
    const std::string extension = in_lower_case(platform::text_of(platform::path_of(path).extension()));
    return std::ranges::find(others, extension) != others.end();
}

} // namespace maclint::cli
