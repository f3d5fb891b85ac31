//! Names the reason, and for a guard that repeats another what nothing tests.
#include "rules/numbers/condition_words.hpp"

#include "analyzer/queries/argument_names.hpp"
#include "rules/path.hpp"

#include <algorithm>
#include <utility>

namespace maclint::rules {
namespace {

/// " (nothing tests #25 (Y), #26 (Z))": one of them may have been meant.
std::string words_for_untested(const ProgramAnalysis& analysis) {
    constexpr std::size_t most = 3;
    const auto untested = queries::untested_arguments(analysis);
    std::string words;
    for (std::size_t i = 0; i < std::min(untested.size(), most); ++i)
        words += (i == 0 ? " (nothing tests " : ", ") + queries::with_letter(analysis.program(), untested[i]);
    if (untested.size() > most) words += " …";
    return words.empty() ? words : words + ")";
}

std::string_view message_for(queries::Reason::Kind kind) {
    using Kind = queries::Reason::Kind;
    switch (kind) {
    case Kind::itself: return "itself";
    case Kind::number: return "number";
    case Kind::test: return "tested";
    case Kind::same_test: return "repeated";
    case Kind::unknown: break;
    }
    return "decided";
}

} // namespace

ConditionWords words_for(const ProgramAnalysis& analysis, const dataflow::Condition& condition,
                         const std::optional<queries::GuardBefore>& guard, std::string outcome) {
    const Program& program = analysis.program();
    const queries::Reason reason = queries::reason_for(analysis, condition, guard);
    ConditionWords words{message_for(reason.kind),
                         {quoted(program, program.expressions[condition.expression].span), std::move(outcome),
                          line_number(analysis.file(), reason.since.begin)},
                         {}};
    if (reason.variable) {
        words.arguments.push_back(program.spell(*reason.variable));
        words.arguments.push_back(number_word(reason.number));
    }
    if (!reason.earlier) return words;
    words.arguments.push_back(quoted(program, reason.since));
    words.arguments.push_back(words_for_untested(analysis));
    words.earlier = RelatedLocation{analysis.source(), reason.since, "this test comes before it"};
    return words;
}

} // namespace maclint::rules
