//! What a program stores in a variable itself is no argument any more: such variables get no letter.
#include "cli/lsp/features/inlay_hints.hpp"

#include "analyzer/program/tables.hpp"
#include "cli/lsp/features/read_document.hpp"
#include "cli/lsp/mentions/place.hpp"

#include <algorithm>
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

} // namespace

Json inlay_hints(Session& session, const Json& params) {
    Json hints = Json::array();
    const auto text = read_document(session, params);
    if (text == nullptr) return hints;
    const Span wanted = text->lines.span(member(params, "range"));
    for (const Program& program : text->programs().programs)
        if (goes_back(program)) add_letters(*text, program, wanted, hints);
    return hints;
}

} // namespace maclint::cli::lsp
