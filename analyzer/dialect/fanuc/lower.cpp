//! Lowering of blocks and macro statements.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/fanuc/diagnose.hpp"
#include "analyzer/dialect/fanuc/find_faults.hpp"
#include "analyzer/dialect/fanuc/keywords.hpp"
#include "analyzer/dialect/fanuc/lowering.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/program/faults.hpp"

#include <algorithm>

namespace maclint::fanuc {
namespace {

/// Nodes at the head of a block that stand before what it does.
bool is_head(Kind kind) {
    switch (kind) {
    case Kind::tape_mark:
    case Kind::sequence_number:
    case Kind::computed_sequence_number:
    case Kind::program_number:
    case Kind::computed_program_number:
    case Kind::named_program: return true;
    default: return false;
    }
}

std::uint16_t skip_level(std::string_view mark) {
    const std::optional<std::int64_t> level = read_integer(mark);
    return static_cast<std::uint16_t>(1U << static_cast<unsigned>(level.value_or(1)));
}

} // namespace

std::optional<std::int64_t> number_of_variable(std::string_view written) {
    const bool has_decimals = written.find('.') < written.size() - 1;
    return has_decimals ? std::nullopt : read_integer(written);
}

void BlockLowering::lower(const syntax::Tree& tree, Span block, ProgramBuilder& builder) {
    begin_block(tree, block, builder);
    depth_reported_ = false;
    comparison_reported_ = false;
    const Node* node = nullptr;
    for_each_child(tree.nodes.front(), [&](const Node& child) {
        if (kind_of(child) == Kind::block) node = &child;
    });
    if (node == nullptr) return;
    items_.clear();
    for_each_child(*node, [this](const Node& child) { items_.push_back(&child); });
    check_tokens();
    Block lowered{};
    const std::span<const Node* const> content = take_head(lowered, items_);
    if (!content.empty() && kind_of(*content.front()) == Kind::bare_value) { // alarm 004
        if (std::optional<SyntaxError> cause = find_cause(program_->text, block))
            syntax_errors_.push_back(std::move(*cause));
        else
            report_unreadable(span(*content.front()), "an address before the number", faults::no_address);
    }
    check_numbers(content);
    check_block_numbers(content);
    check_row(content);
    lower_items(content);
    end_block(lowered);
}

/// Of `#1=2..5` the parser reads `#1=2.` and a number without address. Behind a blank it may be the same
/// number: blanks mean nothing.
void BlockLowering::check_numbers(std::span<const syntax::Node* const> items) {
    for (std::size_t i = 1; i < items.size(); ++i)
        if (kind_of(*items[i]) == Kind::bare_value && span(*items[i]).begin == span(*items[i - 1]).end)
            report_unreadable(span(*items[i]), "an address before the number",
                              text(*items[i]).front() == '.' ? faults::two_points : faults::no_address);
}

/// `M9 N80`: no jump finds the number there. Behind a macro call it is an argument.
void BlockLowering::check_block_numbers(std::span<const syntax::Node* const> items) {
    for (const Node* item : items) {
        if (kind_of(*item) == Kind::literal_word && calls_macro(text(*item))) return;
        if (kind_of(*item) != Kind::sequence_number) continue;
        refuse_form(span(*item), "the number at the head of a block", faults::block_number_misplaced);
    }
}

/// The 2 of `/ 2`.
bool BlockLowering::is_skip_level(const Node& node) const {
    return kind_of(node) == Kind::bare_value && text(node).size() == 1 && text(node) != "0";
}

/// Takes sequence number and skip marks off the front of a block; the rest is what it does.
std::span<const syntax::Node* const> BlockLowering::take_head(Block& block,
                                                              std::span<const Node* const> items) const {
    std::size_t taken = 0;
    for (; taken < items.size(); ++taken) {
        const Node& node = *items[taken];
        const Kind kind = kind_of(node);
        if (kind == Kind::skip) {
            const bool apart = taken + 1 < items.size() && is_skip_level(*items[taken + 1]);
            if (apart) ++taken;
            block.skip_levels |= skip_level(apart ? text(*items[taken]) : text(node));
        } else if (kind == Kind::sequence_number && !block.sequence_number) {
            block.sequence_number = read_integer(text(node));
            block.sequence_number_span = span(node);
        } else if (!is_head(kind)) {
            break;
        }
    }
    return items.subspan(taken);
}

/// Behind the code of a macro call all that stands in the block is an argument, N too [5.1].
bool BlockLowering::goes_on_with(std::span<const Node* const> words, const Node& next) const {
    if (is_word(kind_of(next))) return true;
    return kind_of(next) == Kind::sequence_number && std::ranges::any_of(words, [&](const Node* word) {
               return kind_of(*word) == Kind::literal_word && calls_macro(text(*word));
           });
}

/// Words in a row act together; statements act one after another; what stands after a `/` may be skipped.
void BlockLowering::lower_items(std::span<const Node* const> items) {
    for (std::size_t i = 0; i < items.size();) {
        const Kind kind = kind_of(*items[i]);
        if (kind == Kind::skip) {
            const Span mark = span(*items[i]);
            const std::size_t first = builder_->effect_count();
            lower_items(items.subspan(i + 1));
            if (builder_->effect_count() != first) guard(unreadable(mark), first, {mark.begin, block_.end});
            return;
        }
        std::size_t after = i;
        while (after < items.size() && goes_on_with(items.subspan(i, after - i), *items[after])) ++after;
        const std::size_t next = std::max(after, i + 1);
        const bool goes_on = next < items.size() && kind_of(*items[next]) == Kind::bare_value;
        goes_on_ = goes_on ? items[next - 1] : nullptr;
        if (kind == Kind::block_condition) {
            lower_block_condition(*items[i], items.subspan(i + 1));
            return;
        }
        if (next < items.size() && is_jump_for_do(*items[i], *items[next])) {
            lower_while(*items[i], items[next]);
            return;
        }
        if (!is_word(kind)) {
            lower_statement(*items[i++]);
            continue;
        }
        lower_words(items.subspan(i, after - i));
        i = after;
    }
}

void BlockLowering::lower_statement(const Node& node) {
    switch (kind_of(node)) {
    case Kind::assignment: lower_assignment(node); break;
    case Kind::goto_statement: lower_goto(node); break;
    case Kind::if_statement: lower_if(node); break;
    case Kind::while_statement: lower_while(node, nullptr); break;
    case Kind::do_statement: lower_loop_mark(node, RegionMark::Part::open); break;
    case Kind::end_statement: lower_loop_mark(node, RegionMark::Part::close); break;
    case Kind::output_statement: lower_output(node); break;
    case Kind::naming_statement: check_names(node); break;
    case Kind::foreign_keyword: divide_block_if(node); break;
    default: break; // numbers without address, names of variables, words of other dialects: nothing happens
    }
}

void BlockLowering::lower_assignment(const Node& node) {
    const Node* left = child(node, Field::left);
    const Node* right = child(node, Field::right);
    if (left == nullptr || right == nullptr) return;
    const ExpressionId value = goes_on_ == &node ? unreadable(span(*right)) : lower_expression(*right);
    store(*left, value, span(node));
}

void BlockLowering::store(const Node& target, ExpressionId value, Span span) {
    switch (kind_of(target)) {
    case Kind::variable:
        if (const std::optional<std::int64_t> number = number_of_variable(text(target))) {
            store_numbered(*number, this->span(target), value, span);
            return;
        }
        effect({Assign{StoreAt{numbered, unreadable(this->span(target))}, value}, span});
        return;
    case Kind::indirect_variable:
    case Kind::double_sharp: {
        const Node* index = child(target, Field::index);
        const ExpressionId at = index == nullptr ? unreadable(this->span(target)) : lower_expression(*index);
        effect({Assign{StoreAt{numbered, at}, value}, span});
        return;
    }
    case Kind::bracket: // [#_NAME]=
        for_each_child(target, [&](const Node& inner) { store(inner, value, span); });
        return;
    case Kind::named_variable:
    case Kind::foreign_variable: effect({Assign{named_variable(target), value}, span}); return;
    default: return;
    }
}

void BlockLowering::store_numbered(std::int64_t number, Span target, ExpressionId value, Span span) {
    const VariableRange* range = program_->control->families[numbered].find(number);
    if (range == nullptr) {
        effect({Assign{StoreAt{numbered, literal(static_cast<double>(number), target)}, value}, span});
        return;
    }
    if (range->meaning == Meaning::null) {
        report(SyntaxErrorKind::assignment_to_null, target, "");
        return;
    }
    const auto n = static_cast<std::int32_t>(number);
    switch (range->on_write) {
    case OnWrite::alarm: effect({Stop{Stop::Kind::alarm, value}, span}); return;
    case OnWrite::pause: effect({Stop{Stop::Kind::pause, value}, span}); return;
    case OnWrite::set_modal: effect({SetModal{range->group, value}, span}); return;
    case OnWrite::store:
    case OnWrite::forbidden: break;
    }
    if (range->meaning == Meaning::variable)
        effect({Assign{Variable{range->space, n}, value}, span});
    else
        effect({Assign{StoreMachine{numbered, n}, value}, span});
}

void BlockLowering::lower_goto(const Node& node) {
    const Node* target = child(node, Field::target);
    if (target == nullptr) return;
    if (kind_of(*target) == Kind::label) check_label(*target);
    const auto number_of = [&] {
        if (goes_on_ == &node) return unreadable(span(*target));
        const bool written = kind_of(*target) == Kind::number;
        return written ? number(text(*target), span(*target)) : lower_expression(*target);
    };
    effect({Jump{number_of()}, span(node)});
}

void BlockLowering::lower_if(const Node& node) {
    const Node* condition = child(node, Field::condition);
    if (condition == nullptr) return;
    const ExpressionId test = lower_condition(*condition, faults::if_form);
    Nodes consequences;
    for_each_child(node, [&](const Node& part) {
        if (field_of(part) == Field::consequence) consequences.push_back(&part);
    });
    check_consequences(node, consequences);
    if (consequences.empty() && child(node, Field::then) != nullptr) {
        open_block_if(node, test);
        return;
    }
    const std::size_t first = builder_->effect_count();
    lower_items(consequences);
    guard(test, first, span(node));
}

/// `IF [#1 EQ 2] THEN` with nothing behind it, where a control has blocks up to ELSE or ENDIF.
void BlockLowering::open_block_if(const Node& node, ExpressionId test) {
    const ControlModel& control = *program_->control;
    const Span whole = span(node);
    std::optional<std::size_t> refusal;
    if (!control.has_block_if) {
        const std::size_t before = syntax_errors_.size();
        refuse(SyntaxErrorKind::missing_construct, whole, "");
        if (syntax_errors_.size() == before) return;
        syntax_errors_.back().subject = "THEN";
        syntax_errors_.back().fault = faults::if_form;
        syntax_errors_.back().cure = in_place_of_block_if;
        if (!control.assumed) return;
        refusal = before;
    }
    block_ifs_.push_back({refusal});
    effect({RegionMark{RegionKind::choice, RegionMark::Part::open, std::nullopt, test}, whole});
}

bool BlockLowering::is_word_of_block_if(const Node& keyword) const {
    const std::string word = in_capitals(text(keyword));
    return word.starts_with("ELSE") || word == "ELSIF" || word == "ENDIF";
}

/// ELSE and ENDIF of an open IF; anywhere else they are words of another language.
bool BlockLowering::is_of_block_if(const Node& keyword) const {
    const std::string word = in_capitals(text(keyword));
    return !block_ifs_.empty() && (word == "ELSE" || word == "ENDIF");
}

void BlockLowering::divide_block_if(const Node& keyword) {
    if (!is_of_block_if(keyword)) return;
    const bool ends = to_capital(text(keyword).back()) == 'F';
    const auto part = ends ? RegionMark::Part::close : RegionMark::Part::middle;
    if (ends)
        block_ifs_.pop_back();
    else
        block_ifs_.back().has_else = true;
    effect({RegionMark{RegionKind::choice, part, std::nullopt, std::nullopt}, span(keyword)});
}

void BlockLowering::end_program() {
    for (const BlockIf& open : block_ifs_)
        if (open.refusal) // nothing speaks for a control that has it: THEN lacks its statement
            syntax_errors_[*open.refusal].answer = Answer::stops;
    block_ifs_.clear();
    codes_in_program_ = nullptr;
}

/// `[#1 LT 5] M99 P10`: a condition of what stands behind it, where a control has that before M99.
void BlockLowering::lower_block_condition(const Node& node, std::span<const Node* const> rest) {
    const Node* condition = first_child(node);
    if (condition == nullptr) return;
    const bool before_return = std::ranges::any_of(rest, [&](const Node* word) {
        return kind_of(*word) == Kind::literal_word && to_capital(text(*word).front()) == 'M' &&
               read_integer(text(*word)) == 99;
    });
    if (before_return)
        refuse(SyntaxErrorKind::condition_before_return, span(node), "");
    else if (std::ranges::find(items_, Kind::foreign_keyword, [](const Node* item) {
                 return kind_of(*item);
             }) == items_.end()) // the condition of an ELSEIF
        report_stray_condition(node);
    const ExpressionId test = lower_condition(*condition, faults::statement);
    const std::size_t first = builder_->effect_count();
    lower_items(rest);
    guard(before_return ? test : unreadable(span(node)), first,
          join(span(node), rest.empty() ? span(node) : span(*rest.back())));
}

/// `#1=[#2][#3]`: behind a calculation an operator is missing.
void BlockLowering::report_stray_condition(const Node& condition) {
    const std::vector<Token> tokens = tokens_of(program_->text, block_);
    if (std::optional<SyntaxError> missing = find_missing_operator(program_->text, tokens))
        syntax_errors_.push_back(std::move(*missing));
    else
        report(SyntaxErrorKind::unreadable, span(condition), "an address or IF before it");
}

/// `WHILE[#1GT2]GOTO3`: the number of the jump is likely that of the loop.
bool BlockLowering::is_jump_for_do(const Node& first, const Node& second) const {
    return kind_of(first) == Kind::while_statement && child(first, Field::loop) == nullptr &&
           kind_of(second) == Kind::goto_statement;
}

void BlockLowering::lower_while(const Node& node, const Node* jump_for_do) {
    const Node* condition = child(node, Field::condition);
    const Node* loop = child(node, Field::loop);
    RegionMark mark{RegionKind::while_loop, RegionMark::Part::open, std::nullopt, std::nullopt};
    if (condition != nullptr) mark.condition = lower_condition(*condition, faults::while_form);
    if (loop != nullptr) {
        mark.number = loop_number(*loop);
    } else {
        const Node* target = jump_for_do == nullptr ? nullptr : child(*jump_for_do, Field::target);
        const bool names_loop = target != nullptr && kind_of(*target) == Kind::number;
        if (names_loop) mark.number = read_integer(text(*target));
        std::string cure = names_loop ? "DO" + std::string(text(*target)) : "DO";
        if (jump_for_do != nullptr) cure += " in place of '" + std::string(text(*jump_for_do)) + "'";
        report(SyntaxErrorKind::loop_without_do, span(node), cure);
    }
    effect({mark, span(node)});
}

void BlockLowering::lower_loop_mark(const Node& node, RegionMark::Part part) {
    const RegionKind region_kind =
        part == RegionMark::Part::open ? RegionKind::endless_loop : RegionKind::while_loop;
    effect({RegionMark{region_kind, part, loop_number(node), std::nullopt}, span(node)});
}

/// m of DOm and ENDm, where it is written out.
std::optional<std::int64_t> BlockLowering::loop_number(const Node& mark) const {
    const Node* number = child(mark, Field::number);
    if (number == nullptr || kind_of(*number) != Kind::number) return std::nullopt;
    return read_integer(text(*number));
}

const syntax::Node* BlockLowering::child(const Node& node, Field field) const {
    for (syntax::NodeIndex i = node.first_child; i != syntax::no_node; i = tree_->nodes[i].next_sibling)
        if (field_of(tree_->nodes[i]) == field && kind_of(tree_->nodes[i]) != Kind::comment)
            return &tree_->nodes[i];
    return nullptr;
}

} // namespace maclint::fanuc
