//! Names the variables that do not make a circle.
#include "rules/machine/impossible_arc_sizes.hpp"

#include "rules/machine/impossible_arc_sizes_finder.hpp"
#include "rules/path.hpp"

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace maclint::rules {

void report_wrong_sizes(const MachineStep& at, Reporter& reporter) {
    const auto sizes = at.is_of_one_call ? std::nullopt : wrong_sizes(at.analysis, at.step);
    if (!sizes) return;
    const Program& program = at.analysis.program();
    const auto spelled = [&](ExpressionId read) {
        return program.spell(std::get<Load>(program.expressions[read].node).variable);
    };
    std::vector<std::string> words = {at.quoted_block()};
    if (sizes->second) {
        words.insert(words.end(), {spelled(*sizes->first), spelled(*sizes->second)});
    } else {
        words.push_back(sizes->first ? ", with " + spelled(*sizes->first) + " of " +
                                           number_word(sizes->tried) + " as with other numbers"
                                     : "");
    }
    Finding& finding =
        reporter.report(at.cause(), at.block(), sizes->second ? "sizes" : "never", std::move(words));
    finding.severity = Severity::warning;
    finding.alarm = {};
}

} // namespace maclint::rules
