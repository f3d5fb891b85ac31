//! Names the reason, and for a guard that repeats another what nothing tests.
#include "rules/numbers/condition_words.hpp"

#include "analyzer/queries/values/argument_names.hpp"
#include "rules/path.hpp"

#include <algorithm>

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

std::string_view message_for(Reason::Kind kind) {
    using Kind = Reason::Kind;
    switch (kind) {
    case Kind::itself: return "itself";
    case Kind::same_sides: return "same-sides";
    case Kind::number: return "number";
    case Kind::test: return "tested";
    case Kind::same_test: return "repeated";
    case Kind::unknown: break;
    }
    return "decided";
}

} // namespace

ConditionWords ConditionMessages::words_for(const dataflow::Condition& condition,
                                            const std::optional<queries::GuardBefore>& guard) {
    const Program& program = analysis_.program();
    const Reason reason = reason_for(analysis_, condition, guard);
    const std::string outcome = (guard ? guard->makes : condition.truth.can_hold) ? "always" : "never";
    const Span span = program.expressions[condition.expression].span;
    ConditionWords words{span,
                         message_for(reason.kind),
                         outcome,
                         {quoted(program, span), outcome, line_number(analysis_.file(), reason.since.begin)},
                         {}};
    if (reason.variable) {
        words.arguments.push_back(program.spell(*reason.variable));
        words.arguments.push_back(number_word(reason.number));
    }
    if (!reason.earlier) return words;
    words.arguments.push_back(quoted(program, reason.since));
    if (!untested_) untested_ = words_for_untested(analysis_);
    words.arguments.push_back(*untested_);
    words.earlier = RelatedLocation{analysis_.source(), reason.since, "this test comes before it"};
    return words;
}

} // namespace maclint::rules
