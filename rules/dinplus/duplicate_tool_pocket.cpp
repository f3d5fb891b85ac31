//! DIN117: a tool twice in the list.
#include "analyzer/queries/machine/tool_words.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <map>
#include <string>
#include <tuple>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule duplicate_tool_pocket{
    .code = "DIN117",
    .name = "duplicate-tool-pocket",
    .summary = "A place of the turret holds two tools",
    .why = "The control takes one of the two: it calculates with the tip of a tool that is not in the "
           "place.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"plain", "Place that is taken: {0} stands on line {1} already.",
                  "Give the tool another place."}},
    .bad = {{"dinplus", R"nc(
TURRET 1
T1 ID"ROUGH 80"
T1 ID"FINISH 35"
MACHINING
N10 T1
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
TURRET 1
T1 ID"ROUGH 80"
T1.1 ID"ROUGH 80 B"
T2 ID"FINISH 35"
MACHINING
N10 T1
N99 M30
END
)nc"}},
    .sources = {"SEED-003:2791", "SEED-003:3141-3150"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    for (const Program& program : file.programs) {
        std::map<std::tuple<std::size_t, double, std::string>, Span> places;
        for (const queries::ToolWord& tool : queries::listed_tools(program)) {
            const std::string edge(tool.edge == "0" ? "" : tool.edge); // the main edge needs no figure
            const auto [first, is_new] = places.emplace(std::tuple(tool.list, tool.number, edge), tool.span);
            if (is_new) continue;
            Finding& finding =
                reporter.report({file, tool.span}, tool.span, "plain",
                                {quoted(program, tool.span), line_number(file, first->second.begin)});
            finding.related.push_back({file.source, first->second, "the first one stands here"});
        }
    }
}

} // namespace
} // namespace maclint::rules
