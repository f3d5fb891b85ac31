//! Taken from the model: expressions, effects, names of blocks.
#include "cli/lsp/mentions/mention.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/program/whole_number.hpp"
#include "cli/text/letters.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::cli::lsp {
namespace {

using Role = Mention::Role;

/// What stands on the left of `=`; nothing where the text has none.
std::optional<Span> target_of(const Program& program, Span assignment) {
    const std::string_view text = program.slice(assignment);
    const std::size_t sign = text.find('=');
    if (sign == std::string_view::npos || sign == 0) return std::nullopt;
    const std::size_t last = text.find_last_not_of(" \t", sign - 1);
    if (last == std::string_view::npos) return std::nullopt;
    const std::size_t blank = text.find_last_of(" \t", last); // FOR R1=1 TO 5
    const std::size_t first = blank == std::string_view::npos ? 0 : blank + 1;
    return Span{assignment.begin + static_cast<Offset>(first),
                assignment.begin + static_cast<Offset>(last + 1)};
}

class Visitor {
  public:
    Visitor(const Program& program, const std::function<void(const Mention&)>& visit)
        : program_(program)
        , visit_(visit) {}

    void visit_all() {
        tell(Role::declares, program_.name_span, ProgramName{});
        for (const Expression& expression : program_.expressions) look_at(expression);
        for (EffectId id = 0; id < program_.effects.size(); ++id) look_at(id);
        for (const auto& [variable, declaration] : program_.declarations)
            tell(Role::declares, declaration.span, variable);
        for (const Formal& formal : program_.formals) tell(Role::declares, formal.span, formal.variable);
        for (const Item& item : program_.items)
            if (const auto* block = std::get_if<Block>(&item); block != nullptr && block->name)
                tell(Role::declares, without_colon(block->name_span), *block->name);
    }

  private:
    void tell(Role role, Span span, Named named) {
        if (!span.empty() && is_in_text(named)) visit_({role, span, std::move(named)});
    }

    /// Some dialects keep values in variables of their own, whose names hold blanks.
    [[nodiscard]] bool is_in_text(const Named& named) const {
        const auto* variable = std::get_if<Variable>(&named);
        if (variable == nullptr || !program_.control->spaces[variable->space].named) return true;
        return program_.spell(*variable).find(' ') == std::string::npos;
    }

    [[nodiscard]] Span without_colon(Span span) const {
        while (!span.empty() && (program_.text[span.end - 1] == ':' || program_.text[span.end - 1] == ' '))
            --span.end;
        return span;
    }

    /// What a number of the family is.
    [[nodiscard]] std::optional<Named> numbered(FamilyId family, double number) const {
        constexpr double most = 1e9; // no control has as many
        if (number != std::floor(number) || std::abs(number) > most) return std::nullopt;
        const auto whole = static_cast<std::int32_t>(number);
        const VariableRange* range = program_.control->families[family].find(whole);
        if (range != nullptr && range->meaning == Meaning::variable) return Variable{range->space, whole};
        if (range != nullptr && range->meaning == Meaning::modal) return ModalValueName{range->group};
        return MachineValue{family, whole};
    }

    void look_at_index(Role role, Span span, FamilyId family, ExpressionId index) {
        if (const auto* literal = std::get_if<Literal>(&program_.expressions[index].node))
            if (auto named = numbered(family, literal->value)) tell(role, span, *std::move(named));
    }

    /// `#9` of `[#9]`.
    [[nodiscard]] Span without_brackets(Span span) const {
        constexpr std::string_view opening = "[( \t", closing = "]) \t";
        const auto is_one = [&](std::string_view of, Offset at) {
            return of.find(program_.text[at]) != std::string_view::npos;
        };
        const Offset begin = span.begin;
        while (!span.empty() && is_one(opening, span.begin)) ++span.begin;
        while (span.begin != begin && !span.empty() && is_one(closing, span.end - 1)) --span.end;
        return span;
    }

    void look_at(const Expression& expression) {
        const Span span = without_brackets(expression.span);
        if (const auto* load = std::get_if<Load>(&expression.node))
            tell(Role::reads, span, load->variable);
        else if (const auto* at = std::get_if<LoadAt>(&expression.node))
            look_at_index(Role::reads, span, at->family, at->index);
        else if (const auto* modal = std::get_if<LoadModal>(&expression.node))
            tell(Role::reads, span, ModalValueName{modal->group});
        else if (const auto* machine = std::get_if<LoadMachine>(&expression.node))
            tell(Role::reads, span, MachineValue{machine->family, machine->number});
        else if (const auto* name = std::get_if<BlockName>(&expression.node))
            tell(Role::reads, without_colon(span), *name);
    }

    void look_at(EffectId id) {
        const Effect& effect = program_.effects[id];
        if (const auto* assign = std::get_if<Assign>(&effect.what)) look_at_store(*assign, effect.span);
        if (const auto* call = std::get_if<Call>(&effect.what)) look_at_call(id, *call);
    }

    void look_at_store(const Assign& assign, Span span) {
        const auto target = target_of(program_, span);
        if (!target) return;
        if (const auto* variable = std::get_if<Variable>(&assign.target))
            tell(Role::stores, *target, *variable);
        else if (const auto* at = std::get_if<StoreAt>(&assign.target))
            look_at_index(Role::stores, *target, at->family, at->index);
        else if (const auto* machine = std::get_if<StoreMachine>(&assign.target))
            tell(Role::stores, *target, MachineValue{machine->family, machine->number});
    }

    void look_at_call(EffectId id, const Call& call) {
        if (const auto* text = std::get_if<Text>(&call.program))
            tell(Role::reads, text->characters, ProgramName{id});
        if (const auto* expression = std::get_if<ExpressionId>(&call.program))
            tell(Role::reads, program_.expressions[*expression].span, ProgramName{id});
        std::uint32_t place = 0;
        for (const Argument& argument : program_.arguments_of(call))
            tell(Role::stores, argument.span, ArgumentName{id, place++});
    }

    const Program& program_;
    const std::function<void(const Mention&)>& visit_;
};

/// "12" of "T0012", "DRILL" of `T="DRILL"`.
std::string tool_in(const Program& program, const Word& word) {
    if (const auto* literal = std::get_if<Literal>(&word.value))
        if (const auto number = whole_number(literal->value)) return std::to_string(*number);
    const std::string_view text = program.slice(word.span);
    const std::size_t begin = std::min(text.find_first_not_of("Tt= \t\"[("), text.size());
    const std::size_t last = text.find_last_not_of(" \t\"])");
    return last == std::string_view::npos || last < begin
               ? std::string()
               : in_upper_case(text.substr(begin, last + 1 - begin));
}

const VariableSpace& space_of(const Program& program, Variable variable) {
    return program.control->spaces[variable.space];
}

} // namespace

void for_each_mention(const Program& program, const std::function<void(const Mention&)>& visit) {
    Visitor(program, visit).visit_all();
}

void for_each_tool(const Program& program, const std::function<void(const Mention&)>& visit) {
    const auto tool = addresses_named(program, "T");
    const auto holds_tool = [&](const WordSummary& words) { return !words.addresses.common(tool).empty(); };
    for_each_block_with_words(
        program, holds_tool,
        [&](const BlockView& /*block*/, std::span<const Word> words, const auto& /*summary*/) {
            for (const Word& word : words)
                if (word.address == "T" && word.has_value())
                    visit({Role::reads, word.span, ToolName{tool_in(program, word)}});
        });
}

bool is_shared(const Program& program, const Named& named) {
    if (const auto* variable = std::get_if<Variable>(&named))
        return space_of(program, *variable).scope != Scope::frame;
    return std::holds_alternative<MachineValue>(named) || std::holds_alternative<ModalValueName>(named);
}

bool name_the_same(const Program& one, const Named& a, const Program& other, const Named& b) {
    if (a.index() != b.index() || std::holds_alternative<ProgramName>(a)) return false;
    if (&one == &other) return a == b;
    if (one.control->language != other.control->language) return false;
    return is_shared(one, a) && a == b;
}

} // namespace maclint::cli::lsp
