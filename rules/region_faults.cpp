//! Puts faults in the pairing of regions into words.
#include "rules/region_faults.hpp"

#include "rules/path.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint {
namespace {

std::string_view message_for(flow::Imbalance kind) {
    switch (kind) {
    case flow::Imbalance::never_closed: return "never-closed";
    case flow::Imbalance::never_opened: return "never-opened";
    case flow::Imbalance::nested_too_deep: return "nested";
    default: return "crossed";
    }
}

} // namespace

void report_nesting_fault(const ProgramAnalysis& analysis, const flow::RegionFault& fault,
                          Reporter& reporter) {
    const Program& program = analysis.program();
    const Span span = program.effects[fault.effect].span;
    std::vector<std::string> arguments{quoted(program, span)};
    const bool crossed = fault.what == flow::Imbalance::crossed;
    if (crossed) arguments.push_back(quoted(program, program.effects[*fault.other].span));
    if (fault.other)
        arguments.push_back(line_number(analysis.file(), program.effects[*fault.other].span.begin));
    Finding& finding =
        reporter.report({analysis, fault.effect}, span, message_for(fault.what), std::move(arguments));
    if (fault.other)
        finding.related.push_back(
            related_at_effect(analysis, *fault.other, crossed ? "this is still open" : "this is open here"));
}

} // namespace maclint
