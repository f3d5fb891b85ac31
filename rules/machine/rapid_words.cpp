//! Says what shows that there is material, or which block lifts the tool too late.
#include "rules/machine/rapid_words.hpp"

#include "analyzer/machine/late_lifts.hpp"
#include "analyzer/machine/rapid_through_work.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "rules/path.hpp"

#include <set>
#include <string_view>

namespace maclint::rules {
namespace {

std::string_view message_of(machine::RapidThroughWork::Evidence evidence) {
    switch (evidence) {
        using enum machine::RapidThroughWork::Evidence;
    case cut_later: return "cut-later";
    case cut_less_deep: return "cut-less-deep";
    case not_lifted: break;
    }
    return "not-lifted";
}

/// But for blocks that begin in `told`, of which something is said already.
void report_late_lifts(const ProgramAnalysis& analysis, const std::set<Offset>& told, Reporter& reporter) {
    const auto called = [&](EffectId call) -> const machine::States* {
        const CallSite* site = analysis.call_at(call);
        const ProgramAnalysis* program = site == nullptr ? nullptr : queries::called_program(analysis, *site);
        return program == nullptr || site->in_cycle ? nullptr : &program->machine();
    };
    for (const machine::LateLift& late :
         machine::find_late_lifts(analysis.program(), analysis.graph(), analysis.machine(), called)) {
        if (told.contains(late.block.begin)) continue;
        reporter
            .report({analysis, late.block}, late.block, "late-lift",
                    {quoted(analysis.program(), late.block), number_word(late.z),
                     line_number(analysis.file(), late.lift.begin)})
            .related.push_back({analysis.source(), late.lift, "the tool is lifted here"});
    }
}

} // namespace

void report_rapid_moves(const ProgramAnalysis& analysis, Reporter& reporter) {
    std::set<Offset> told;
    for (const machine::RapidThroughWork& rapid :
         machine::rapid_moves_through_work(analysis.program(), analysis.machine())) {
        told.insert(rapid.block.begin);
        reporter
            .report({analysis, rapid.block}, rapid.block, message_of(rapid.evidence),
                    {quoted(analysis.program(), rapid.block), number_word(rapid.z),
                     line_number(analysis.file(), rapid.cut.begin)})
            .related.push_back({analysis.source(), rapid.cut, "this block cuts there"});
    }
    report_late_lifts(analysis, told, reporter);
}

} // namespace maclint::rules
