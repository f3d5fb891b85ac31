//! Puts leaks into words.
#include "rules/modal/modal_leak.hpp"

#include "analyzer/queries/exits.hpp"
#include "analyzer/queries/modal_parts.hpp"
#include "analyzer/queries/origins.hpp"
#include "rules/path.hpp"
#include "rules/trace.hpp"

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

void report_leak(const ProgramAnalysis& analysis, Reporter& reporter, const queries::ModalLeak& leak,
                 std::vector<std::string> arguments) {
    report_leak(analysis, reporter, leak, leak.on_every_path ? "every-path" : "some-paths",
                std::move(arguments));
}

void report_leak(const ProgramAnalysis& analysis, Reporter& reporter, const queries::ModalLeak& leak,
                 std::string_view message_id, std::vector<std::string> arguments) {
    Finding& finding = reporter.report(cause_at(analysis, leak.part.origin),
                                       queries::span_of_origin(analysis, leak.part.origin), message_id,
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
}

} // namespace maclint::rules
