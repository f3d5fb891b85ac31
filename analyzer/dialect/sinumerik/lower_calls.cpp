//! Lowering of definitions, of names that stand for programs, and of calls.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/sinumerik/cycles.hpp"
#include "analyzer/dialect/sinumerik/keywords.hpp"
#include "analyzer/dialect/sinumerik/lowering.hpp"
#include "analyzer/dialect/sinumerik/macros.hpp"
#include "analyzer/dialect/sinumerik/tables.hpp"
#include "analyzer/dialect/sinumerik/words.hpp"
#include "analyzer/program/whole_number.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace maclint::sinumerik {
namespace {

VariableType kind_of_type(std::string_view name) {
    if (name == "REAL") return VariableType::number;
    if (name == "INT" || name == "CHAR") return VariableType::integer;
    return name == "BOOL" ? VariableType::truth : VariableType::text; // STRING, AXIS, FRAME: no numbers
}

/// A cycle leaves variables as they are, and all modes that it has no settings for. Others that are named so
/// may do anything: they are the machine's.
CallKindId kind_of_cycle(std::string_view capitals) {
    const CycleRow* row = find_cycle(capitals);
    return row == nullptr || row->use == CycleUse::other ? calls::by_name : calls::cycle;
}

} // namespace

// ---- definitions

/// "STRING" of `STRING[20]`.
std::string_view BlockLowering::type_name(const Node& type) const {
    const std::string written = upper_text(type);
    const auto* row =
        std::ranges::find_if(type_names, [&](std::string_view name) { return written.starts_with(name); });
    return row == std::end(type_names) ? std::string_view{} : *row;
}

void BlockLowering::lower_program_definition(const Node& node) {
    builder_->set_definition(span(node));
    if (const Node* name = child(node, Field::name)) check_program_name(*name);
    if (const Node* list = child(node, Field::parameters))
        for_each_child(*list, [this](const Node& part) {
            if (kind_of(part) == Kind::parameter) lower_parameter(part);
        });
    for_each_child(node, [this](const Node& part) {
        if (kind_of(part) == Kind::attribute && upper_text(part) == "SAVE") save_modes(span(part));
    });
}

/// On return the codes are in force again that were at the call [BF11 p.793]. Of groups that no rule asks a
/// program to put back nothing is kept.
void BlockLowering::save_modes(Span here) {
    const auto& groups = program_->control->groups;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const auto group = static_cast<GroupId>(i);
        if (!is_put_back_by_save(group)) continue;
        const std::string name = "SAVE " + std::string(groups[i].name); // no name of a program holds a blank
        const Variable kept{spaces::local, builder_->number_of_name(spaces::local, name)};
        effect({Assign{kept, add({LoadModal{group}, here})}, here});
        open_->saved.emplace_back(group, kept);
    }
}

void BlockLowering::go_back(std::optional<ExpressionId> label, Span here) {
    for (const auto& [group, kept] : open_->saved) effect({SetModal{group, add({Load{kept}, here})}, here});
    effect({Return{std::nullopt, label}, here});
    note_actions_left();
}

/// A parameter that is left out arrives as 0, unless it has a default [NCP19 p.494].
void BlockLowering::lower_parameter(const Node& node) {
    const Node* type = child(node, Field::type);
    const Node* name = child(node, Field::name);
    if (type == nullptr || name == nullptr) return;
    const std::string capitals = upper_text(*name);
    check_taken(*name);
    const Variable variable{spaces::parameter, builder_->number_of_name(spaces::parameter, capitals)};
    const bool reference = child(node, Field::reference) != nullptr;
    const Node* size = child(node, Field::size);
    const std::string_view written = type_name(*type);
    builder_->add_formal({variable, capitals, reference ? Passing::by_reference : Passing::by_value,
                          span(*name), written, size != nullptr, child(node, Field::value) != nullptr});
    if (size != nullptr) return define_array(*name, *size, written);
    Declaration declaration{kind_of_type(written), std::nullopt, span(*name), written};
    if (const Node* value = child(node, Field::value))
        declaration.initial = literal_value(lower_expression(*value));
    builder_->declare(variable, declaration);
    open_->variables.emplace(capitals, variable);
}

void BlockLowering::lower_definition(const Node& node) {
    const Node* type = child(node, Field::type);
    if (type == nullptr) return;
    for_each_child(node, [&](const Node& part) {
        if (kind_of(part) == Kind::declarator) lower_declarator(part, *type);
    });
}

/// What EXTERN says of a program's parameters.
void BlockLowering::lower_external(const Node& node) {
    const Node* name = child(node, Field::name);
    if (name == nullptr) return;
    ExternalDeclaration declared{upper_text(*name), {}, span(node)};
    if (const Node* list = child(node, Field::parameters))
        for_each_child(*list, [&](const Node& part) {
            const Node* type = child(part, Field::type);
            if (kind_of(part) != Kind::parameter || type == nullptr) return;
            const bool reference = child(part, Field::reference) != nullptr;
            declared.parameters.push_back({type_name(*type),
                                           reference ? Passing::by_reference : Passing::by_value,
                                           child(part, Field::size) != nullptr});
        });
    builder_->add_external(std::move(declared));
}

void BlockLowering::lower_macro_definition(const Node& node) {
    const Node* name = child(node, Field::name);
    if (name == nullptr) return;
    const std::string capitals = upper_text(*name);
    open_->macros.insert(capitals);
    give_name(capitals);
    const Node* body = child(node, Field::body);
    GivenWord word = read_macro(capitals, body == nullptr ? std::string_view{} : text(*body));
    if (open_->is_for_all) builder_->give_word(word);
    open_->words.insert_or_assign(capitals, std::move(word));
}

/// The name of a macro that nothing stands beside does what its words do; beside others it may be anything.
bool BlockLowering::lower_macro(std::string_view capitals, Span here) {
    const auto known = open_->words.find(capitals);
    if (known == open_->words.end() || !known->second.is_known) return false;
    const GivenWord& word = known->second;
    if (word.only_switches()) return true;
    if (std::ranges::count_if(items_, [](const Node* item) { return !is_head(kind_of(*item)); }) != 1)
        return false;
    if (word.changes_tool) effect({ToolChange{}, here});
    for (const auto& [group, code] : word.sets) effect({SetModal{group, literal(code, here)}, here});
    if (word.moves) effect({Motion{}, here});
    return true;
}

void BlockLowering::give_name(std::string capitals) {
    if (open_->is_for_all) builder_->give_name(std::move(capitals));
}

void BlockLowering::define_array(const Node& name, const Node& size, std::string_view type) {
    Array array{{}, type, span(name)};
    bool gap = true; // between commas nothing stands yet
    for_each_below(size, [&](const Node& part) {
        if (!part.named) {
            if (text(part) == "," && std::exchange(gap, true)) array.sizes.emplace_back();
        } else if (!is_remark(part)) {
            gap = false;
            const auto number = literal_value(lower_expression(part));
            const auto places = number ? whole_number(*number) : std::nullopt;
            array.sizes.push_back(places ? std::optional(static_cast<std::int32_t>(std::min<std::int64_t>(
                                               *places, std::numeric_limits<std::int32_t>::max())))
                                         : std::nullopt);
        }
    });
    if (gap) array.sizes.emplace_back();
    give_name(upper_text(name));
    builder_->add_array({upper_text(name), type, array.sizes});
    open_->arrays.insert_or_assign(upper_text(name), std::move(array));
}

/// What is defined is 0 before anything is stored in it, or the value beside its name [NCP19 p.409].
void BlockLowering::lower_declarator(const Node& node, const Node& type) {
    const Node* name = child(node, Field::name);
    if (name == nullptr) return;
    check_taken(*name);
    check_initial_values(node);
    const std::string capitals = upper_text(*name);
    const Node* value = child(node, Field::value);
    std::optional<ExpressionId> initial;
    if (value != nullptr)
        initial =
            kind_of(*value) == Kind::value_list ? lower_all(*value, span(*value)) : lower_expression(*value);
    const std::string_view written = type_name(type);
    if (const Node* size = child(node, Field::size)) {
        define_array(*name, *size, written);
        if (initial) evaluate(*initial, span(node));
        return;
    }
    note_length_of_text(capitals, type);
    if (value != nullptr) {
        check_stored(written, *value);
        check_length_of_text(capitals, *value);
    }
    const Variable variable{spaces::local, builder_->number_of_name(spaces::local, capitals)};
    Declaration declaration{kind_of_type(written), std::nullopt, span(*name), written};
    if (initial) declaration.initial = literal_value(*initial);
    builder_->declare(variable, declaration);
    open_->variables.emplace(capitals, variable);
    give_name(capitals);
    if (open_->is_for_all) builder_->add_array({capitals, written, {}}); // of no dimension
    if (initial && !declaration.initial) effect({Assign{variable, *initial}, span(node)});
}

// ---- names

/// A name alone, or with arguments: a code, a procedure, a cycle, or a program of the shop. The tables say
/// which; a name that they do not know is a program.
void BlockLowering::lower_named(const Node& name, const Node* arguments, const Node& whole) {
    const std::string capitals = upper_text(name);
    const Span here = span(whole);
    if (kind_of(name) == Kind::malformed_name) return; // told as it is met
    if (lower_macro(capitals, here)) return;
    if (open_->macros.contains(capitals)) return call_anything(here);
    if (arguments == nullptr && setting_of(capitals)) return lower_code(capitals, here);
    if (variable_named(capitals) != nullptr) return;
    const WordRow* row = find_word(capitals);
    if (is_cycle_name(capitals)) {
        call_program(span(name), arguments, kind_of_cycle(capitals), here);
        return forget_settings_of(capitals, here);
    }
    if (row == nullptr) {
        if (arguments == nullptr && is_foreign_loop_word(capitals)) {
            report(SyntaxErrorKind::foreign_keyword, here, "WHILE, FOR or LOOP with the word that ends it");
            return builder_->add_unreadable({{}, {}, true, false}, here);
        }
        if (report_value_behind_address(capitals, arguments != nullptr, here)) return;
        if (arguments == nullptr && (report_letter_o(capitals, here) || report_slip(capitals, here))) return;
        note_misspelt_word(capitals, span(name), arguments != nullptr);
        return call_program(span(name), arguments, calls::by_name, here);
    }
    switch (row->kind) {
    case WordKind::procedure: return lower_procedure(capitals, arguments, here);
    default:
        for (const ExpressionId value : values_of(arguments)) evaluate(value, here);
        return;
    }
}

/// A cycle may have set them otherwise. Frames and transformations it switches off, where there are any.
void BlockLowering::forget_settings_of(std::string_view cycle, Span here) {
    const CycleSettings* settings = find_settings(cycle);
    if (settings == nullptr) return;
    if (settings->frames && open_->writes_frames) forget_frames(here);
    std::vector<GroupId> groups;
    for (const std::uint8_t number : settings->groups)
        if (const auto group = row_of_g_group(number)) groups.push_back(*group);
    if (settings->transformation && open_->transforms) groups.push_back(coupling_code("TRAFOOF")->group);
    for (const GroupId group : groups) effect({SetModal{group, changing("", here)}, here});
}

/// Variables that stand alone as arguments may be results: READ(STATE, …).
void BlockLowering::lower_procedure(std::string_view name, const Node* arguments, Span whole) {
    if (name == "RET" || name == "RETB") {
        std::optional<ExpressionId> label; // RET("N100"): back to a block of the caller
        if (arguments != nullptr) label = nobody_knows(whole);
        return go_back(label, whole);
    }
    if (name == "SETAL" && arguments != nullptr) check_alarm_number(*arguments);
    if (const FunctionRow* row = find_function(name); row != nullptr && arguments != nullptr)
        check_arguments(*row, whole, *arguments);
    constexpr std::string_view of_values[] = {"CANCEL", "MSG", "SETAL", "TRACYL", "TRANSMIT"};
    const bool takes_axes = std::ranges::find(of_values, name) == std::end(of_values);
    std::vector<ExpressionId> values;
    if (arguments != nullptr)
        for_each_child(*arguments, [&](const Node& value) { // RELEASE(LOADER)
            const bool around = std::exchange(names_axes_, takes_axes && kind_of(value) == Kind::name);
            values.push_back(lower_expression(value));
            names_axes_ = around;
        });
    std::vector<Variable> in;
    constexpr std::string_view without_results[] = {"MSG", "SETAL", "WAITM", "WAITE", "WAITMC", "WAITP"};
    if (std::ranges::find(without_results, name) == std::end(without_results))
        for (const ExpressionId value : values)
            if (const auto* load = std::get_if<Load>(&expression(value).node)) in.push_back(load->variable);
    if (!values.empty()) builder_->add_exchange(values, in, whole);
    if (const auto coupling = coupling_code(name)) {
        effect({SetModal{coupling->group, literal(coupling->code, whole)}, whole});
        open_->transforms |= coupling->group == coupling_code("TRAFOOF")->group;
    }
    if (name == "STOPRE") effect({Synchronise{}, whole});
    if (name == "CALLPATH" || name == "EXTCALL" || name == "EXECSTRING") call_anything(whole);
}

// ---- calls

std::vector<ExpressionId> BlockLowering::values_of(const Node* list) {
    std::vector<ExpressionId> values;
    if (list != nullptr)
        for_each_child(*list, [&](const Node& value) { values.push_back(lower_expression(value)); });
    return values;
}

/// Commas keep the places of arguments that are left out [NCP19 p.494].
std::vector<Argument> BlockLowering::arguments_of(const Node* list) {
    std::vector<Argument> arguments;
    std::uint32_t place = 0;
    if (list == nullptr) return arguments;
    for_each_below(*list, [&](const Node& part) {
        if (!part.named) {
            place += text(part) == "," ? 1U : 0U;
        } else if (!is_remark(part)) {
            const ExpressionId value = lower_expression(part);
            arguments.push_back(
                {ArgumentPosition{place}, value, text(part), span(part), Passing::as_declared});
        }
    });
    return arguments;
}

/// A call may write `SUB`, `_N_SUB`, `SUB_SPF` or `_N_SUB_SPF` [NCP23 p.490]: programs bear all four names.
void BlockLowering::call_program(Span name, const Node* arguments, CallKindId kind, Span whole) {
    Call call{Text{name}, kind, {}, passes_};
    call.arguments = builder_->add_arguments(arguments_of(arguments));
    effect({call, whole});
}

/// Nobody knows which program runs, or which blocks.
void BlockLowering::call_anything(Span whole) {
    Call call{nobody_knows(whole), calls::by_name, {}, std::nullopt};
    call.arguments = builder_->add_arguments({});
    effect({call, whole});
}

void BlockLowering::lower_modal_call(const Node& node) {
    const Node* program = child(node, Field::program);
    if (program == nullptr) // MCALL alone ends it [SEED-004:460-474]
        return effect({SetModal{modal_call_group(), literal(0, span(node))}, span(node)});
    const Node* name = kind_of(*program) == Kind::call ? child(*program, Field::name) : program;
    const Node* arguments = kind_of(*program) == Kind::call ? child(*program, Field::arguments) : nullptr;
    if (name == nullptr) return;
    const std::string capitals = upper_text(*name);
    if (find_word(capitals) == nullptr) note_misspelt_word(capitals, span(*name), arguments != nullptr);
    call_program(span(*name), arguments, calls::modal, span(node));
}

/// CALL "NAME", PCALL /_N_WKS_DIR/…, ISOCALL, CALL BLOCK first TO last.
void BlockLowering::lower_other_call(const Node& node) {
    const Node* program = child(node, Field::program);
    const bool blocks = child(node, Field::first) != nullptr;
    if (kind_of(node) == Kind::indirect_call && program != nullptr && !blocks) {
        if (kind_of(*program) == Kind::program_number)
            return call_program(span(*program), nullptr, calls::by_name, span(node));
        const Span whole = span(*program);
        if (kind_of(*program) == Kind::string && whole.length() > 2)
            return call_program({whole.begin + 1, whole.end - 1}, nullptr, calls::by_name, span(node));
    }
    if (program != nullptr && kind_of(*program) != Kind::path && kind_of(*program) != Kind::program_number)
        evaluate(lower_expression(*program), span(node));
    for (const ExpressionId value : values_of(child(node, Field::arguments))) evaluate(value, span(node));
    if (blocks && program == nullptr) return repeat_part(node, false);
    call_anything(span(node));
}

} // namespace maclint::sinumerik
