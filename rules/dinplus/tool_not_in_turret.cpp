//! DIN118: a tool that the list does not hold.
#include "analyzer/queries/machine/tool_words.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <set>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule tool_not_in_turret{
    .code = "DIN118",
    .name = "tool-not-in-turret",
    .summary = "A tool is called that the list of the program does not hold",
    .why = "The place is empty or holds a tool that the control knows nothing of: it comes to the part "
           "with the wrong length.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"plain", "Tool that is not in the list: {0} has no line behind TURRET.",
                  "Add its line, or correct the number."}},
    .bad = {{"dinplus", R"nc(
TURRET 1
T1 ID"ROUGH 80"
T2 ID"FINISH 35"
MACHINING
N10 T1
N11 G0 X60 Z2
N12 T9
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
TURRET 1
T1 ID"ROUGH 80"
T2 ID"FINISH 35"
MACHINING
N10 T1
N11 G0 X60 Z2
N12 T2.1
N99 M30
END
)nc"}},
    .sources = {"SEED-003:2791", "SEED-003:3141-3150"},
    .check = &check,
};

namespace {

/// The numbers that the lists of the file hold: subprograms call the tools of their main program.
std::set<double> listed_in(const ProgramFile& file) {
    std::set<double> numbers;
    for (const Program& program : file.programs)
        for (const queries::ToolWord& tool : queries::listed_tools(program)) numbers.insert(tool.number);
    return numbers;
}

void check(const ProgramFile& file, Reporter& reporter) {
    const std::set<double> listed = listed_in(file);
    if (listed.empty()) return; // the tools of the machine are meant
    for (const Program& program : file.programs)
        for (const queries::ToolWord& tool : queries::called_tools(program))
            if (tool.number != 0 && !listed.contains(tool.number))
                reporter.report({file, tool.span}, tool.span, "plain", {quoted(program, tool.span)})
                    .same_cause = number_word(tool.number);
}

} // namespace
} // namespace maclint::rules
