//! Puts leaks into words.
#include "rules/modal/modal_leak.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/queries/modal/saved_state.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "rules/path.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <utility>

namespace maclint::rules {
namespace {

std::string words_for(flow::ExitKind kind) {
    switch (kind) {
    case flow::ExitKind::returns: return "the program returns here";
    case flow::ExitKind::ends: return "the program ends here";
    case flow::ExitKind::restarts: return "the program begins again here";
    default: return "the program runs off its last block here";
    }
}

} // namespace

std::string word_of(const ProgramAnalysis& analysis, GroupId group, const dataflow::ModalPart& part) {
    const auto code = queries::own_code(analysis, part);
    return queries::is_plain_origin(analysis, part.origin) && code
               ? analysis.control().spell(group, *code)
               : quoted(analysis.program(), queries::span_of_origin(analysis, part.origin));
}

std::string words_to_cancel(const ControlModel& control, GroupId id) {
    const ModalGroup& group = control.groups[id];
    if (!group.cancel_words.empty() || !group.cancel) return std::string(group.cancel_words);
    return control.spell(id, *group.cancel);
}

std::string capital_name(const ProgramAnalysis& analysis, GroupId group) {
    std::string name(analysis.control().groups[group].name);
    const bool small = !name.empty() && name.front() >= 'a' && name.front() <= 'z';
    if (small) name.front() = static_cast<char>(name.front() - 'a' + 'A');
    return name;
}

std::string subject_of(const ProgramAnalysis& analysis, const queries::ModalLeak& leak) {
    const bool by_call = queries::is_made_by_call(analysis, leak.part.origin);
    return capital_name(analysis, leak.group) + (by_call ? " set by '" : " '") +
           word_of(analysis, leak.group, leak.part) + "'";
}

std::string exit_text(const ProgramAnalysis& analysis, const queries::ModalLeak& leak) {
    const Span span = queries::span_of_exit(analysis, leak.exit->exit);
    const std::string line = "line " + line_number(analysis.file(), span.begin);
    if (leak.exit->exit.kind != flow::ExitKind::returns) return line;
    // A language may have a word beside its code: RET and M17.
    const std::string written = quoted(analysis.program(), span);
    const bool is_code = written.find_first_of("0123456789") != std::string::npos;
    const std::string_view usual = analysis.control().return_word;
    const bool is_usual = is_code || usual.find_first_of("0123456789") == std::string_view::npos;
    return "the " + (is_usual ? std::string(usual) : written) + " of " + line;
}

std::string cure_by_saving(const ProgramAnalysis& analysis, const queries::ModalLeak& leak) {
    const Program& program = analysis.program();
    const auto variable = analysis.control().variable_of(leak.group);
    if (!variable) return "Save it at the start, and put it back before " + exit_text(analysis, leak);
    const std::string letter(1, analysis.control().groups[leak.group].letter);
    const std::string before = " before " + exit_text(analysis, leak);
    if (const dataflow::Store* save = queries::find_save(analysis, leak.group)) {
        const std::string name = program.spell(save->variable);
        const Offset place = program.effects[save->effect].span.begin;
        return name + " holds the caller's since line " + line_number(analysis.file(), place) + ": write " +
               letter + name + before;
    }
    const auto free = queries::find_free_local(program);
    if (!free) return "Save " + *variable + " at the start, and put it back" + before;
    const std::string name = program.spell(*free);
    return "Add " + name + "=" + *variable + " at the start, and " + letter + name + before;
}

std::vector<std::string> variables_saved(const ProgramAnalysis& analysis,
                                         const std::vector<const dataflow::Store*>& saves) {
    std::vector<std::string> names;
    for (const dataflow::Store* save : saves) {
        const Span span = analysis.program().expressions[save->expression].span;
        std::string name = quoted(analysis.program(), span);
        if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
    }
    return names;
}

Cause block_cause(const ProgramAnalysis& analysis, const dataflow::ModalPart& part) {
    return {analysis, queries::is_plain_origin(analysis, part.origin)
                          ? queries::span_of_origin(analysis, part.origin)
                          : analysis.graph().nodes[queries::node_of_origin(analysis, part.origin)].part};
}

Finding& report_leak(const ProgramAnalysis& analysis, Reporter& reporter, const queries::ModalLeak& leak,
                     std::vector<std::string> arguments) {
    return report_leak(analysis, reporter, leak, cause_at(analysis, leak.part.origin),
                       leak.on_every_path ? "every-path" : "some-paths", std::move(arguments));
}

Finding& report_leak(const ProgramAnalysis& analysis, Reporter& reporter, const queries::ModalLeak& leak,
                     const Cause& cause, std::string_view message_id, std::vector<std::string> arguments) {
    Finding& finding = reporter.report(cause, queries::span_of_origin(analysis, leak.part.origin), message_id,
                                       std::move(arguments));
    const flow::NodeId set = queries::node_of_origin(analysis, leak.part.origin);
    const flow::Exit& exit = leak.exit->exit;
    trace(finding, analysis, set,
          "the " + std::string(analysis.control().groups[leak.group].name) + " is set here");
    report_path_on(finding, analysis, set, exit.node);
    finding.related.push_back(
        {analysis.source(), queries::span_of_exit(analysis, exit), words_for(exit.kind)});
    if (leak.leak_use.program != nullptr)
        finding.related.push_back(
            {leak.leak_use.program->source(), leak.leak_use.block, "a caller moves so here"});
    return finding;
}

} // namespace maclint::rules
