//! MAC340: words of loops and choices that do not pair.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/structure/region_faults.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule region_words_unpaired{
    .code = "MAC340",
    .name = "region-words-unpaired",
    .summary = "A loop or choice lacks the word that closes it, or the one that opens it",
    .why =
        "The control does not find where the branch or the loop ends: it stops with an alarm, or runs blocks "
        "that were not meant.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::paired_words},
    .messages = {{"never-closed", "Missing {1}: '{0}' is never closed.", "Add {1} after its last block."},
                 {"never-opened", "{1} without {2}: '{0}' belongs to none.", "Remove it, or add the {2}."},
                 {"divides-nothing", "Branch without its beginning: '{0}' belongs to no {2}.",
                  "Remove it, or add the {2}."},
                 {"crossed", "Crossed blocks: '{0}' ends while '{2}' of line {3}, inside it, is still open.",
                  "End that first."},
                 {"divided-twice", "Second {1}: '{0}' divides the {2} of line {3} once more.",
                  "Remove one of the two, or close the {2} before it."}},
    .bad = {{"sinumerik", R"nc(
IF R1>60
G0 X100
M30
)nc"},
            {"sinumerik", R"nc(
FOR R1=1 TO 5
G0 X=R1
ENDWHILE
ENDFOR
M30
)nc"}},
    .good = {{"sinumerik", R"nc(
IF R1>60
G0 X100
ELSE
G0 X0
ENDIF
M30
)nc"}},
    .alarms = {{"SINUMERIK", "12640", "invalid nesting of control structures", false},
               {"SINUMERIK", "12641", "control structures nested deeper than the limit", false}},
    .sources = {"JP11 p.107", "NCI 4.1.7"},
    .check = &check,
};

namespace {

using Part = RegionMark::Part;

const RegionWords* words_for(const ControlModel& control, RegionKind kind) {
    const auto row = std::ranges::find(control.region_words, kind, &RegionWords::region_kind);
    return row == control.region_words.end() ? nullptr : &*row;
}

void report(const ProgramAnalysis& analysis, const flow::RegionFault& fault, const RegionWords& words,
            Reporter& reporter) {
    const Program& program = analysis.program();
    const Span span = program.effects[fault.effect].span;
    const bool divides = std::get<RegionMark>(program.effects[fault.effect].what).part != Part::close;
    std::vector<std::string> arguments{quoted(program, span), std::string(words.close)};
    std::string_view message = "never-closed";
    if (fault.what == flow::Imbalance::never_opened) {
        message = divides ? "divides-nothing" : "never-opened";
        arguments.emplace_back(words.open);
    } else if (fault.what == flow::Imbalance::crossed) {
        message = "crossed";
        const Span other = program.effects[*fault.other].span;
        arguments.push_back(quoted(program, other));
        arguments.push_back(line_number(analysis.file(), other.begin));
    }
    Finding& finding = reporter.report({analysis, fault.effect}, span, message, std::move(arguments));
    // Programs with a closing word too many have run on machines [language.md 11.5].
    if (fault.what == flow::Imbalance::never_opened) finding.severity = Severity::warning;
    if (fault.what == flow::Imbalance::crossed)
        finding.related.push_back(related_at_effect(analysis, *fault.other, "this is still open"));
}

/// ELSE stands once in a choice.
void report_divided_twice(const ProgramAnalysis& analysis, const flow::Region& region, Reporter& reporter) {
    const Program& program = analysis.program();
    const RegionWords* words = words_for(analysis.control(), region.region_kind);
    std::size_t divided = 0;
    for (const EffectId part : region.parts) {
        const auto& mark = std::get<RegionMark>(program.effects[part].what);
        if (mark.part != Part::middle || mark.condition || ++divided < 2 || words == nullptr) continue;
        const Span span = program.effects[part].span;
        reporter.report({analysis, part}, span, "divided-twice",
                        {quoted(program, span), quoted(program, span), std::string(words->open),
                         line_number(analysis.file(), program.effects[region.open].span.begin)});
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const flow::Region& region : analysis.regions().all)
        report_divided_twice(analysis, region, reporter);
    for (const RegionKind kind : {RegionKind::choice, RegionKind::while_loop})
        for (const flow::RegionFault& fault : queries::nesting_faults(analysis, kind)) {
            const auto& mark = std::get<RegionMark>(program.effects[fault.effect].what);
            if (const RegionWords* words = words_for(analysis.control(), mark.region_kind))
                report(analysis, fault, *words, reporter);
        }
}

} // namespace
} // namespace maclint::rules
