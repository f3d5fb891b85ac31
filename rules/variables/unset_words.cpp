//! Lists of variables and numbers as a sentence has them.
#include "rules/variables/unset_words.hpp"

#include "rules/listed.hpp"
#include "rules/path.hpp"

#include <span>
#include <vector>

namespace maclint::rules {
namespace {

std::vector<std::string> all_as_written(const ProgramAnalysis& analysis,
                                        std::span<const ExpressionId> expressions) {
    std::vector<std::string> words;
    for (const ExpressionId expression : expressions) words.push_back(as_written(analysis, expression));
    return words;
}

} // namespace

std::string as_written(const ProgramAnalysis& analysis, ExpressionId expression) {
    std::string name = quoted(analysis.program(), analysis.program().expressions[expression].span);
    while (name.size() > 2 && (name.front() == '[' || name.front() == '('))
        name = name.substr(1, name.size() - 2);
    return name;
}

std::string_view message_of(const ProgramAnalysis& analysis, const queries::UnsetReads& reads) {
    const bool vacant = queries::may_hold_vacant(analysis.program(), reads.first.read->variable);
    switch (reads.kind) {
    case queries::Unset::as_tested: return "as-tested";
    case queries::Unset::by_callers: return "by-callers";
    case queries::Unset::unless_by_callers: return "unless-by-callers";
    case queries::Unset::always: return !vacant ? "undefined" : analysis.is_main() ? "main" : "called";
    case queries::Unset::as_argument: return vacant ? "not-passed" : "undefined-not-passed";
    case queries::Unset::in_some_cases: break;
    }
    if (!vacant) return "undefined-some-paths";
    if (reads.missing.subjects.empty()) return "some-paths";
    return reads.missing.numbers.empty() ? "depends" : "cases";
}

std::string names_of(const ProgramAnalysis& analysis, const queries::UnsetReads& reads) {
    std::string first = as_written(analysis, reads.first.read->expression);
    if (reads.others.empty()) return first;
    if (reads.others.size() == 1)
        return first + " and " + as_written(analysis, reads.others.front()->expression);
    return first + " and " + std::to_string(reads.others.size()) + " others";
}

std::string words_for_cases(const ProgramAnalysis& analysis, const queries::MissingCase& missing) {
    std::string subjects = listed(all_as_written(analysis, missing.subjects), " and ");
    if (missing.numbers.empty()) return subjects;
    return subjects + " = " + listed(all_as_written(analysis, missing.numbers), " or ");
}

} // namespace maclint::rules
