//! Chooses the message, and says which kind is read.
#include "rules/numbers/mixed_positions.hpp"

#include "analyzer/queries/values/positions.hpp"
#include "rules/numbers/ratio_as_length_mixed_finder.hpp"
#include "rules/path.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::rules {
namespace {

std::string_view message_of(MixedPosition::Kind kind) {
    using enum MixedPosition::Kind;
    switch (kind) {
    case sibling: return "sibling";
    case target: return "target";
    case machine_move: return "machine-move";
    case difference: break;
    }
    return "difference";
}

} // namespace

void report_mixed_positions(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const MixedPosition& found : find_mixed_positions(analysis)) {
        const bool by_kind =
            found.kind == MixedPosition::Kind::sibling || found.kind == MixedPosition::Kind::difference;
        const std::string what = by_kind ? std::string(queries::position_read(program, found.position)->what)
                                         : quoted(program, program.expressions[found.position].span);
        std::vector<std::string> words = {quoted(program, found.place), what};
        if (found.kind == MixedPosition::Kind::sibling) words.push_back(quoted(program, found.other));
        Finding& finding =
            reporter.report({analysis, found.place}, found.place, message_of(found.kind), std::move(words));
        if (!found.other.empty())
            finding.related.push_back({analysis.source(), found.other, "the other kind is read here"});
    }
}

} // namespace maclint::rules
