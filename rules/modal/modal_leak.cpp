//! Reads the states in which a program is left.
#include "rules/modal/modal_leak.hpp"

#include "rules/path.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {
namespace {

bool is_from_call(const ProgramAnalysis& analysis, const dataflow::ModalPart& part) {
    const dataflow::Origin& origin = analysis.data().origin(part.origin);
    return origin.kind == dataflow::Origin::Kind::effect &&
           std::holds_alternative<Call>(analysis.program().effects[origin.id].what);
}

Span span_of(const ProgramAnalysis& analysis, const dataflow::ModalPart& part) {
    return related_at(analysis, part.origin, {}).span;
}

std::optional<ModalLeak> leak_of(const ProgramAnalysis& analysis, GroupId group, const IsFault& is_fault) {
    std::optional<ModalLeak> last;
    bool elsewhere_right = false;
    for (const dataflow::ExitState& exit : analysis.facts().all<dataflow::ExitState>()) {
        if (exit.exit.kind == flow::ExitKind::alarm) continue;
        const dataflow::ModalValue value = analysis.data().modal(exit, group);
        if (value.unknown) return std::nullopt;
        for (const dataflow::ModalPart& part : value.parts) {
            // A path on which nothing sets the group, as when a word is ignored, puts nothing back, nor does
            // a called program.
            if (part.origin == 0 || is_from_call(analysis, part)) continue;
            const bool fault = is_fault(analysis.control().groups[group], group, exit, part);
            elsewhere_right |= !fault;
            if (fault && (!last || span_of(analysis, last->part).begin < span_of(analysis, part).begin))
                last = ModalLeak{group, part, &exit, true, {true, nullptr, {}}};
        }
    }
    if (!last) return std::nullopt;
    last->on_every_path = !elsewhere_right;
    if (last->exit->exit.kind == flow::ExitKind::returns) last->leak_use = leak_use_of(analysis, group);
    return last->leak_use.matters ? last : std::nullopt;
}

std::string words_for(flow::ExitKind kind) {
    switch (kind) {
    case flow::ExitKind::returns: return "the program returns here";
    case flow::ExitKind::ends: return "the program ends here";
    case flow::ExitKind::restarts: return "the program begins again here";
    default: return "the program runs off its last block here";
    }
}

/// A jump of which it is unknown whether it is taken: to blocks that run as a subprogram of this program. A
/// return then need not leave it.
bool may_return_within(const Program& program) {
    return std::ranges::any_of(program.effects, [&](const Effect& effect) {
        const auto* guarded = std::get_if<Guarded>(&effect.what);
        return guarded != nullptr &&
               std::holds_alternative<Unreadable>(program.expressions[guarded->condition].node);
    });
}

} // namespace

std::vector<ModalLeak> find_modal_leaks(const ProgramAnalysis& analysis, RestorePolicy restore_policy,
                                        const IsFault& is_fault) {
    std::vector<ModalLeak> leaks;
    const auto& groups = analysis.control().groups;
    for (std::size_t group = 0; group < groups.size(); ++group) {
        if (groups[group].restore_policy != restore_policy) continue;
        if (const auto leak = leak_of(analysis, static_cast<GroupId>(group), is_fault))
            leaks.push_back(*leak);
    }
    if (!leaks.empty() && may_return_within(analysis.program())) leaks.clear();
    return leaks;
}

std::optional<double> own_code(const ProgramAnalysis& analysis, const dataflow::ModalPart& part) {
    const dataflow::Origin& origin = analysis.data().origin(part.origin);
    if (origin.kind == dataflow::Origin::Kind::effect) {
        const Program& program = analysis.program();
        const Effect& effect = program.effects[origin.id];
        const auto* set = std::get_if<SetModal>(&effect.what);
        const auto* assign = std::get_if<Assign>(&effect.what);
        if (set == nullptr && assign == nullptr) return std::nullopt;
        const ExpressionId value = set != nullptr ? set->value : assign->value;
        if (!std::holds_alternative<Literal>(program.expressions[value].node)) return std::nullopt;
    }
    return analysis.data().table().number_of(part.symbol);
}

bool is_switched_on(const ProgramAnalysis& analysis, const ModalGroup& group,
                    const dataflow::ModalPart& part) {
    const auto code = own_code(analysis, part);
    return code && code != group.cancel && std::ranges::find(group.customary, *code) == group.customary.end();
}

std::string word_of(const ProgramAnalysis& analysis, GroupId group, const dataflow::ModalPart& part) {
    const auto code = own_code(analysis, part);
    const bool plain = analysis.data().origin(part.origin).kind == dataflow::Origin::Kind::run;
    return plain && code ? analysis.control().spell(group, *code)
                         : quoted(analysis.program(), span_of(analysis, part));
}

Span span_of(const ProgramAnalysis& analysis, const ModalLeak& leak) { return span_of(analysis, leak.part); }

void report_leak(const ProgramAnalysis& analysis, Reporter& reporter, const ModalLeak& leak,
                 std::vector<std::string> arguments) {
    report_leak(analysis, reporter, leak, leak.on_every_path ? "every-path" : "some-paths",
                std::move(arguments));
}

void report_leak(const ProgramAnalysis& analysis, Reporter& reporter, const ModalLeak& leak,
                 std::string_view message_id, std::vector<std::string> arguments) {
    Finding& finding = reporter.report(cause_at(analysis, leak.part.origin), span_of(analysis, leak),
                                       message_id, std::move(arguments));
    const flow::NodeId set = node_of(analysis, leak.part.origin);
    const flow::Exit& exit = leak.exit->exit;
    trace(finding, analysis, set,
          "the " + std::string(analysis.control().groups[leak.group].name) + " is set here");
    report_path_on(finding, analysis, set, exit.node);
    const Span end =
        exit.effect ? analysis.program().effects[*exit.effect].span : analysis.graph().nodes[exit.node].part;
    finding.related.push_back({analysis.source(), end, words_for(exit.kind)});
    if (leak.leak_use.program != nullptr)
        finding.related.push_back(
            {leak.leak_use.program->source(), leak.leak_use.block, "a caller moves so here"});
}

} // namespace maclint::rules
