//! What a program stores in a variable itself is no argument any more: such variables get no letter.
#include "cli/lsp/features/inlay_hints.hpp"

#include "analyzer/program/tables.hpp"
#include "cli/lsp/features/read_document.hpp"
#include "cli/lsp/meanings/known_values.hpp"
#include "cli/lsp/mentions/place.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

namespace maclint::cli::lsp {
namespace {

constexpr int parameter_kind = 2; ///< InlayHintKind of LSP

bool goes_back(const Program& program) {
    return std::ranges::any_of(
        program.effects, [](const Effect& effect) { return std::holds_alternative<Return>(effect.what); });
}

void add_letters(const ReadText& text, const Program& program, Span wanted, Json& hints) {
    std::unordered_set<Variable, VariableHash> stored;
    std::vector<std::pair<Span, Variable>> reads;
    for_each_mention(program, [&](const Mention& mention) {
        const auto* variable = std::get_if<Variable>(&mention.named);
        if (variable == nullptr) return;
        if (mention.role != Mention::Role::reads)
            stored.insert(*variable);
        else if (wanted.begin <= mention.span.end && mention.span.begin <= wanted.end)
            reads.emplace_back(mention.span, *variable);
    });
    std::ranges::sort(reads, {}, [](const auto& read) { return read.first.begin; });
    for (const auto& [span, variable] : reads) {
        const auto letter = stored.contains(variable) ? std::nullopt : program.control->letter_of(variable);
        if (!letter || program.spell(variable).find(*letter) != std::string::npos) continue; // #__la says it
        hints.push_back({{"position", text.lines.position(span.end)},
                         {"label", std::string(1, *letter)},
                         {"kind", parameter_kind},
                         {"paddingLeft", true}});
    }
}

/// Jumps in the range whose label is calculated.
std::vector<EffectId> computed_jumps(const Program& program, Span wanted) {
    std::vector<EffectId> jumps;
    for (EffectId id = 0; id < program.effects.size(); ++id) {
        const Effect& effect = program.effects[id];
        const auto* jump = std::get_if<Jump>(&effect.what);
        if (jump == nullptr || effect.span.end < wanted.begin || wanted.end < effect.span.begin) continue;
        const auto& target = program.expressions[jump->target].node;
        if (!std::holds_alternative<Literal>(target) && !std::holds_alternative<BlockName>(target))
            jumps.push_back(id);
    }
    return jumps;
}

/// "N10 N20" behind `GOTO#1`.
void add_targets(Session& session, const std::shared_ptr<const ReadText>& text, Span wanted, Json& hints) {
    constexpr std::size_t most = 8;
    std::unique_ptr<const KnownValues> values;
    for (std::size_t place = 0; place < text->programs().programs.size(); ++place) {
        const Program& program = text->programs().programs[place];
        for (const EffectId jump : computed_jumps(program, wanted)) {
            if (values == nullptr) values = KnownValues::of(session, text);
            if (values == nullptr) return;
            const auto numbers = values->targets_of(place, jump);
            if (numbers.empty() || numbers.size() > most) continue;
            std::string label;
            for (const std::int64_t number : numbers)
                label += (label.empty() ? "N" : " N") + std::to_string(number);
            const Span target = program.expressions[std::get<Jump>(program.effects[jump].what).target].span;
            hints.push_back({{"position", text->lines.position(target.end)},
                             {"label", std::move(label)},
                             {"paddingLeft", true}});
        }
    }
}

} // namespace

Json inlay_hints(Session& session, const Json& params) {
    Json hints = Json::array();
    const auto text = read_document(session, params);
    if (text == nullptr) return hints;
    const Span wanted = text->lines.span(member(params, "range"));
    for (const Program& program : text->programs().programs)
        if (goes_back(program)) add_letters(*text, program, wanted, hints);
    add_targets(session, text, wanted, hints);
    return hints;
}

} // namespace maclint::cli::lsp
