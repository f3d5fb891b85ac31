//! DIN119: an edge of a tool that there is none of.
#include "analyzer/queries/machine/tool_words.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule tool_edge_range{
    .code = "DIN119",
    .name = "tool-edge-range",
    .summary = "The edge of a tool is none of 0 to 9",
    .why = "The figure behind the point is the edge: two figures name none, and the control refuses the "
           "tool.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain",
                  "Edge that does not exist: {0} has '{1}' behind the point, where one figure stands.",
                  "Write one figure, as in T12.2."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 T12.10
N11 G0 X60 Z2
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 T12.1
N11 G0 X60 Z2
N99 M30
END
)nc"}},
    .sources = {"SEED-003:3141-3150"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    for (const Program& program : file.programs)
        for (const auto& tools : {queries::listed_tools(program), queries::called_tools(program)})
            for (const queries::ToolWord& tool : tools)
                if (tool.edge.size() > 1)
                    reporter.report({file, tool.span}, tool.span, "plain",
                                    {quoted(program, tool.span), std::string(tool.edge)});
}

} // namespace
} // namespace maclint::rules
