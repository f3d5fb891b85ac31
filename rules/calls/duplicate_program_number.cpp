//! MAC453: two programs with one number.
#include "analyzer/dialect/number_limits.hpp"
#include "analyzer/program/model.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule duplicate_program_number{
    .code = "MAC453",
    .name = "duplicate-o-number",
    .summary = "Two programs have one number",
    .why = "A control stores one program under a number: it refuses the second, or the first is overwritten. "
           "In files of a folder it is told where the configuration says that the folder is complete, and "
           "where single numbers stand twice among files that bear their numbers as names.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"plain", "Program number used twice: '{0}' is there already, in line {1}.",
                  "Give one of the programs another number."},
                 {"other-file", "Program number used twice: '{0}' is in {1}, too.",
                  "Give one of the programs another number, or keep old versions in another folder."}},
    .bad = {{"fanuc", R"nc(
O1453(PLATE)
G90 G0 X0
M30
O1453(PLATE, SECOND SIDE)
G90 G0 X5.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O1453(PLATE)
G90 G0 X0
M30
O1454(PLATE, SECOND SIDE)
G90 G0 X5.
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "073", "PROGRAM NUMBER ALREADY IN USE"},
               {"FANUC 30i/0i-D", "073", "PROGRAM NUMBER ALREADY IN USE"}},
    .sources = {"GH-ALM"},
    .check = &check,
};

namespace {

/// The number is often written twice at the head of a file.
bool is_head_alone(const Program& program) {
    return std::ranges::all_of(program.items, [](const Item& item) {
        const auto* block = std::get_if<Block>(&item);
        return block != nullptr && block->words.count == 0 && block->effects.count == 0;
    });
}

/// Those of a file; cli/engine/same_numbers finds those of several.
void check(const ProgramFile& file, Reporter& reporter) {
    std::map<std::pair<std::string_view, std::int64_t>, const Program*> seen; // folder on the control, number
    for (const Program& program : file.programs) {
        if (!program.number || program.local || program.name_span.empty() || is_head_alone(program)) continue;
        if (number_limits(*program.control) == nullptr) continue;
        const auto [first, is_new] = seen.try_emplace({program.folder, *program.number}, &program);
        if (is_new) continue;
        Finding& finding = reporter.report({file, program.name_span}, program.name_span, "plain",
                                           {std::string(program.slice(program.name_span)),
                                            line_number(file, first->second->name_span.begin)});
        if (!program.control->assumed) continue;
        finding.severity = Severity::warning;
        finding.alarm = {};
    }
}

} // namespace
} // namespace maclint::rules
