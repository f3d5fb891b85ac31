//! Puts misplaced saves into words.
#include "rules/modal/misplaced_save.hpp"

#include "analyzer/program/tables.hpp"
#include "rules/modal/restore_from_wrong_variable_finder.hpp"
#include "rules/path.hpp"
#include "rules/trace.hpp"

#include <string>
#include <string_view>

namespace maclint::rules {

void report_misplaced_saves(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (analysis.is_main()) return;
    using Kind = MisplacedSave::Kind;
    const Program& program = analysis.program();
    for (const MisplacedSave& misplaced : find_misplaced_saves(analysis)) {
        const Span word = program.effects[misplaced.write->effect].span;
        const Span save = program.effects[misplaced.save->effect].span;
        const bool is_twice = misplaced.kind == Kind::twice;
        const std::string_view message = is_twice                         ? "twice"
                                         : misplaced.kind == Kind::beside ? "beside"
                                                                          : "unchanged";
        const Span shown = is_twice ? save : word;
        Finding& finding = reporter.report({analysis, misplaced.write->effect}, shown, message,
                                           {quoted(program, shown), quoted(program, misplaced.other),
                                            std::string(analysis.control().groups[misplaced.group].name),
                                            line_number(analysis.file(), save.begin)});
        finding.severity = Severity::warning; // no alarm comes of it
        trace(finding, analysis, misplaced.save->node, {analysis.source(), save, "it is saved here"},
              misplaced.write->node, "and put back here");
        finding.related.push_back(
            {analysis.source(), misplaced.other, is_twice ? "the other save" : "the other code"});
    }
}

} // namespace maclint::rules
