//! MAC520: a tool that works with the length offset of another tool.
#include "rules/machine_check.hpp"
#include "rules/path.hpp"

namespace maclint::rules {

namespace {
void check(const MachineStep& at, Reporter& reporter);
}

extern const Rule offset_of_another_tool{
    .code = "MAC520",
    .name = "offset-of-another-tool",
    .summary = "A tool gets an offset that is not the one that this program pairs with its tools",
    .why = "The control counts with the length of another tool: this one stops above the work, or runs into "
           "it as far "
           "as the two differ.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"another",
                  "Offset of another tool: {0} stands where {1} is in the spindle; the other tools of this "
                  "program have {2}.",
                  "Write {3}, or allow it where that offset is meant."}},
    .bad = {{"fanuc", R"nc(
O9520(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H1 Z50.
G1 Z-5. F200.
G0 Z50.
T2 M6
S1200 M3
G0 X25. Y25.
G43 H1 Z50.
G1 Z-12. F100.
G0 Z50.
T3 M6
S900 M3
G0 X45. Y25.
G43 H3 Z50.
G1 Z-12. F100.
G0 Z50.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9520(PLATE)
G90 G17 G54
T1 M6
S3000 M3
G0 X0 Y0
G43 H21 Z50.
G1 Z-5. F200.
G0 Z50.
T2 M6
S1200 M3
G0 X25. Y25.
G43 H22 Z50.
G1 Z-12. F100.
G43 H32 Z-13. (THE SECOND EDGE)
G0 Z50.
M30
)nc"}},
    .sources = {"T"},
    .check = MachineCheck{&check},
};

namespace {

/// T0303 of T0301 and 3: the last two figures are the offset's.
std::string with_last_figures(const std::string& word, const std::string& offset) {
    constexpr std::size_t figures = 2;
    if (word.size() <= figures || offset.size() > figures) return word.substr(0, 1) + offset;
    return word.substr(0, word.size() - figures) + std::string(figures - offset.size(), '0') + offset;
}

void check(const MachineStep& at, Reporter& reporter) {
    const machine::Known& tool = at.after().tool;
    const machine::Known& offset = at.after().length_offset;
    if (!tool.is_known() || !offset.is_known() || offset.block != at.block().begin || offset.value <= 0)
        return;
    if (at.habits.has_several_offsets(tool.value)) return;
    const std::optional<double> usual = at.habits.difference_beside(tool.value);
    if (!usual || offset.value - tool.value == *usual) return;
    // A number that no rule of the program gives to any tool is one of its own.
    const double owner = offset.value - *usual;
    const bool is_own_number = offset.value == tool.value;
    if (at.habits.tools() < 3 && is_own_number) return; // the other tool has the wrong one
    if (at.habits.tools() < 3 && !at.habits.has_tool(owner)) return;
    const bool is_in_tool_word = at.letters().length_offset == 0; // T0301 of a lathe
    const char letter = is_in_tool_word ? at.letters().tool : at.letters().length_offset;
    const std::string pairs = *usual == 0 ? "their own number" : "their number and " + number_word(*usual);
    const Span place = at.place_of(letter);
    const std::string written(at.analysis.program().slice(place)), meant = number_word(tool.value + *usual);
    reporter
        .report({at.analysis, place}, place, "another",
                {written, at.letters().tool + number_word(tool.value), pairs,
                 is_in_tool_word ? with_last_figures(written, meant) : letter + meant})
        .related.push_back(at.at(tool, "the tool is changed here"));
}

} // namespace
} // namespace maclint::rules
