//! MAC302: a jump to an alarm, where a block one digit away is never reached.
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/queries/paths/unreached_regions.hpp"
#include "analyzer/queries/structure/sequence_numbers.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule goto_suspicious_target{
    .code = "MAC302",
    .name = "goto-suspicious-target",
    .summary = "A jump leads to an alarm, and no path to a block whose number has one digit more or less",
    .why =
        "A digit is missing or too many: every run ends in the alarm, and the blocks that should have run, "
        "often the end of the macro, never do.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"plain",
                  "Jump to an alarm: '{0}' leads to line {1}, and nothing leads to N{2} on line {3}.",
                  "Jump to N{2} if that was meant."}},
    .bad = {{"fanuc", R"nc(
O9302(DEPTH, Z)
IF[#26EQ#0]GOTO6
#33=0
N70 #33=#33+2.
G90 G0 Z-#33
IF[#33GE#26]GOTO6
GOTO70
N60 G0 Z50.
G69
M99
N6 #3000=1(Z MISSING)
)nc"}},
    .good = {{"fanuc", R"nc(
O9302(DEPTH, Z)
IF[#26EQ#0]GOTO6
#33=0
N70 #33=#33+2.
G90 G0 Z-#33
IF[#33GE#26]GOTO60
GOTO70
N60 G0 Z50.
G69
M99
N6 #3000=1(Z MISSING)
)nc"}},
    .sources = {"SEED-002:518-525"},
    .check = &check,
};

namespace {

/// The jumps that lead to an alarm, by the number that they name.
class JumpsToAlarms {
  public:
    explicit JumpsToAlarms(const ProgramAnalysis& analysis) {
        for (const flow::ResolvedJump& jump : analysis.graph().jumps) {
            const auto* number = jump.label ? std::get_if<std::int64_t>(&*jump.label) : nullptr;
            if (number != nullptr && jump.target && analysis.data().reached(jump.node) &&
                queries::ends_in_alarm(analysis, jump.node, true))
                jumps_[*number].push_back(&jump);
        }
    }

    /// The last one before the region whose number lacks a digit, or has one too many, to lead there.
    [[nodiscard]] const flow::ResolvedJump* beside(const queries::UnreachedRegion& region) const {
        const flow::ResolvedJump* found = nullptr;
        for (const std::int64_t number : queries::numbers_a_digit_away(*region.number)) {
            const auto jumps = jumps_.find(number);
            if (jumps == jumps_.end()) continue;
            for (const flow::ResolvedJump* jump : jumps->second)
                if (jump->node < region.first && (found == nullptr || jump->node > found->node)) found = jump;
        }
        return found;
    }

  private:
    std::map<std::int64_t, std::vector<const flow::ResolvedJump*>> jumps_;
};

/// The program works, and then always comes to an alarm.
bool ends_by_mistake(const ProgramAnalysis& analysis) {
    const dataflow::AlarmEnd& end = analysis.summary().alarm_end;
    return end.in_text && end.works;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    std::optional<JumpsToAlarms> jumps; // most programs have no such region
    for (const queries::UnreachedRegion& region : queries::unreached_regions(analysis)) {
        const bool is_end = region.leaves && ends_by_mistake(analysis);
        if (!region.number || region.is_alarm || region.is_explained || (!region.work && !is_end)) continue;
        if (!jumps) jumps.emplace(analysis);
        const flow::ResolvedJump* jump = jumps->beside(region);
        if (jump == nullptr) continue;
        const Span span = analysis.program().effects[jump->jump].span;
        const auto line = [&](Span of) { return line_number(analysis.file(), of.begin); };
        reporter
            .report({analysis, region.text}, span, "plain",
                    {quoted(analysis.program(), span), line(jump->target->block),
                     std::to_string(*region.number), line(region.head)})
            .related.push_back({analysis.source(), region.head, "no path leads here"});
    }
}

} // namespace
} // namespace maclint::rules
