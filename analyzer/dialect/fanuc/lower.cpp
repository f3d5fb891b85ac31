//! Lowering of blocks and macro statements.
#include "analyzer/dialect/fanuc/diagnose.hpp"
#include "analyzer/dialect/fanuc/keywords.hpp"
#include "analyzer/dialect/fanuc/lowering.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/dialect/numbers.hpp"

#include <algorithm>

namespace maclint::fanuc {
namespace {

bool is_word(Kind kind) {
    switch (kind) {
    case Kind::literal_word:
    case Kind::word:
    case Kind::comma_word:
    case Kind::empty_word:
    case Kind::malformed_word:
    case Kind::letter_o_word:
    case Kind::program_name: return true;
    default: return false;
    }
}

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
    const Node* node = nullptr;
    for_each_child(tree.nodes.front(), [&](const Node& child) {
        if (kind_of(child) == Kind::block) node = &child;
    });
    if (node == nullptr) return;
    check_tokens();
    items_.clear();
    for_each_child(*node, [this](const Node& child) { items_.push_back(&child); });
    Block lowered{};
    const std::span<const Node* const> content = take_head(lowered, items_);
    if (!content.empty() && kind_of(*content.front()) == Kind::bare_value) { // alarm 004
        if (std::optional<SyntaxError> cause = find_cause(program_->text, block))
            syntax_errors_.push_back(std::move(*cause));
        else
            report(SyntaxErrorKind::unreadable, span(*content.front()), "an address before the number");
    }
    lower_items(content);
    end_block(lowered);
}

/// Takes sequence number and skip marks off the front of a block; the rest is what it does.
std::span<const syntax::Node* const> BlockLowering::take_head(Block& block,
                                                              std::span<const Node* const> items) const {
    std::size_t taken = 0;
    for (; taken < items.size(); ++taken) {
        const Node& node = *items[taken];
        const Kind kind = kind_of(node);
        if (kind == Kind::skip) {
            block.skip_levels |= skip_level(text(node));
        } else if (kind == Kind::sequence_number && !block.sequence_number) {
            block.sequence_number = read_integer(text(node));
            block.sequence_number_span = span(node);
        } else if (!is_head(kind)) {
            break;
        }
    }
    return items.subspan(taken);
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
        if (!is_word(kind)) {
            lower_statement(*items[i++]);
            continue;
        }
        std::size_t after = i;
        while (after < items.size() && is_word(kind_of(*items[after]))) ++after;
        lower_words(items.subspan(i, after - i));
        i = after;
    }
}

void BlockLowering::lower_statement(const Node& node) {
    switch (kind_of(node)) {
    case Kind::assignment: lower_assignment(node); break;
    case Kind::goto_statement: lower_goto(node); break;
    case Kind::if_statement: lower_if(node); break;
    case Kind::while_statement: lower_while(node); break;
    case Kind::do_statement: lower_loop_mark(node, RegionMark::Part::open); break;
    case Kind::end_statement: lower_loop_mark(node, RegionMark::Part::close); break;
    case Kind::output_statement: lower_output(node); break;
    default: break; // numbers without address, names of variables, words of other dialects: nothing happens
    }
}

void BlockLowering::lower_assignment(const Node& node) {
    const Node* left = child(node, Field::left);
    const Node* right = child(node, Field::right);
    if (left == nullptr || right == nullptr) return;
    const ExpressionId value = lower_expression(*right);
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
    effect({Jump{lower_expression(*target)}, span(node)});
}

void BlockLowering::lower_if(const Node& node) {
    const Node* condition = child(node, Field::condition);
    if (condition == nullptr) return;
    const ExpressionId test = lower_expression(*condition);
    Nodes consequences;
    for_each_child(node, [&](const Node& part) {
        if (field_of(part) == Field::consequence) consequences.push_back(&part);
    });
    if (consequences.empty() && child(node, Field::then) != nullptr)
        syntax_errors_.push_back(
            {SyntaxErrorKind::missing_construct, span(node), "THEN", std::string(in_place_of_block_if)});
    const std::size_t first = builder_->effect_count();
    lower_items(consequences);
    guard(test, first, span(node));
}

void BlockLowering::lower_while(const Node& node) {
    const Node* condition = child(node, Field::condition);
    const Node* loop = child(node, Field::loop);
    RegionMark mark{RegionKind::while_loop, RegionMark::Part::open, std::nullopt, std::nullopt};
    if (condition != nullptr) mark.condition = lower_expression(*condition);
    if (loop != nullptr)
        mark.number = loop_number(*loop);
    else
        report(SyntaxErrorKind::loop_without_do, span(node), "DO");
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

void BlockLowering::lower_output(const Node& node) {
    Exchange exchange;
    for_each_child(node, [&](const Node& part) {
        if (kind_of(part) != Kind::output_variable) return;
        if (const Node* variable = child(part, Field::variable))
            exchange.out.push_back(lower_expression(*variable));
    });
    effect({std::move(exchange), span(node)});
}

const syntax::Node* BlockLowering::child(const Node& node, Field field) const {
    for (syntax::NodeIndex i = node.first_child; i != syntax::no_node; i = tree_->nodes[i].next_sibling)
        if (field_of(tree_->nodes[i]) == field && kind_of(tree_->nodes[i]) != Kind::comment)
            return &tree_->nodes[i];
    return nullptr;
}

/// What is wrong with single nodes of a block that the parser could read. Nearly all blocks are sound, and
/// one look at their nodes shows it.
void BlockLowering::check_tokens() {
    bool has_foreign_words = false;
    bool has_empty_words = false;
    int brackets = 0;
    for (const Node& node : tree_->nodes) {
        switch (kind_of(node)) {
        case Kind::symbolic_operator:
        case Kind::foreign_keyword: has_foreign_words = true; break;
        case Kind::empty_word: has_empty_words = true; break;
        case Kind::variable: check_number_of(node); break;
        case Kind::malformed_word: // alarms 006 and 007
            report(SyntaxErrorKind::unreadable, span(node),
                   "a number with at most one sign and one decimal point");
            break;
        case Kind::computed_sequence_number: // [1.3]
            report(SyntaxErrorKind::unreadable, span(node), "the digits of a sequence number");
            break;
        case Kind::computed_program_number: // [1.2]
            report(SyntaxErrorKind::unreadable, span(node), "the digits of a program number");
            break;
        case Kind::double_sharp: // [2.3]
            if (const Node* index = child(node, Field::index))
                report(SyntaxErrorKind::unreadable, span(node), "'#[" + std::string(text(*index)) + "]'");
            break;
        case Kind::bracket:
        case Kind::argument_list:
        case Kind::condition: ++brackets; break;
        default: break;
        }
    }
    if (has_foreign_words) check_words();
    if (brackets > program_->control->limits.bracket_levels) check_depth(tree_->nodes.front(), 0);
    if (has_empty_words) check_parenthesis_for_value();
}

/// `#504.`, `#30003.036`
void BlockLowering::check_number_of(const Node& variable) {
    const std::string_view written = text(variable);
    const std::size_t point = written.find('.');
    if (point == std::string_view::npos) return;
    if (point + 1 == written.size())
        report(SyntaxErrorKind::point_in_variable_number, span(variable),
               std::string(written.substr(0, point)));
    else if (!has_variables_with_decimals(*program_->control))
        report(SyntaxErrorKind::fraction_in_variable_number, span(variable), "");
}

/// Operators and keywords of other languages.
void BlockLowering::check_words() {
    std::vector<bool> in_condition(tree_->nodes.size(), false);
    for (std::size_t i = 0; i < tree_->nodes.size(); ++i) {
        const Node& node = tree_->nodes[i];
        const Kind kind = kind_of(node);
        const bool here = in_condition[i] || kind == Kind::condition || kind == Kind::compound_condition ||
                          kind == Kind::unbracketed_condition;
        for (syntax::NodeIndex c = node.first_child; c != syntax::no_node; c = tree_->nodes[c].next_sibling)
            in_condition[c] = here;
        if (kind == Kind::symbolic_operator && here)
            report(SyntaxErrorKind::symbolic_comparison, span(node),
                   std::string(comparison_word(text(node))));
        else if (kind == Kind::symbolic_operator) // [3: comparisons give no value]
            report(SyntaxErrorKind::unreadable, span(node),
                   "a calculation, because only IF and WHILE compare");
        else if (kind == Kind::foreign_keyword)
            syntax_errors_.push_back(unknown_word(program_->text, span(node)));
    }
}

/// `X(#1+2)`: an address without value, and a comment that would make one. Such a block parses.
void BlockLowering::check_parenthesis_for_value() {
    if (std::optional<SyntaxError> found = find_parenthesis_as_bracket(program_->text, block_))
        syntax_errors_.push_back(std::move(*found));
}

/// Reports the first bracket of the block that opens one level too many.
void BlockLowering::check_depth(const Node& node, int depth) {
    if (depth_reported_) return;
    const Kind kind = kind_of(node);
    if (kind == Kind::bracket || kind == Kind::argument_list || kind == Kind::condition) {
        if (++depth > program_->control->limits.bracket_levels) {
            depth_reported_ = true;
            const Offset begin = span(node).begin;
            report(SyntaxErrorKind::bracket_depth, {begin, begin + 1}, "");
            return;
        }
    }
    for (syntax::NodeIndex i = node.first_child; i != syntax::no_node; i = tree_->nodes[i].next_sibling)
        check_depth(tree_->nodes[i], depth);
}

} // namespace maclint::fanuc
