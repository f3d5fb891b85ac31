//! MAC471: a file named after another program than the one in it.
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/number_limits.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/source/source.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule file_and_number_differ{
    .code = "MAC471",
    .name = "file-and-number-differ",
    .summary = "The file's name and the number in it name two programs",
    .why = "Who copies a program as the beginning of another one easily leaves its number: read in, it takes "
           "the place of the old program, and a call finds the wrong one.",
    .severity = Severity::note,
    .precision = Precision::medium,
    .on_by_default = false,
    .off_reason = "copies of a program often keep its number on purpose.",
    .messages = {{"plain",
                  "File named {1} holds program '{0}': read in, it is another program than its name says.",
                  "Give both the same number."}},
    .bad = {{"fanuc", R"nc(
O1001(PLATE)
G90 G0 X0
M30
)nc",
             false, "O1002.nc"}},
    .good = {{"fanuc", R"nc(
O1002(PLATE)
G90 G0 X0
M30
)nc",
              false, "O1002.nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

/// 1001 for "parts/O1001.nc". A name that holds more is no number, and controls write four digits at least:
/// O1.nc is a name that somebody made up.
std::optional<std::int64_t> number_in_name(std::string_view path) {
    std::string_view name = path.substr(path.rfind('/') + 1);
    name = name.substr(0, name.find('.'));
    constexpr std::size_t shortest = 5;
    if (name.size() < shortest || (name.front() != 'O' && name.front() != 'o')) return std::nullopt;
    name.remove_prefix(1);
    return std::ranges::all_of(name, is_digit) ? read_integer(name) : std::nullopt;
}

void check(const ProgramFile& file, Reporter& reporter) {
    if (file.programs.size() != 1 || number_limits(*file.control) == nullptr) return;
    const Program& program = file.programs.front();
    const auto named = number_in_name(file.source->path());
    if (!named || !program.number || program.name_span.empty() || *program.number == *named) return;
    reporter.report({file, program.name_span}, program.name_span, "plain",
                    {std::string(program.slice(program.name_span)), "O" + std::to_string(*named)});
}

} // namespace
} // namespace maclint::rules
