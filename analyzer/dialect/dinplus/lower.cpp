//! Lowering of blocks and statements.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/dinplus/channels.hpp"
#include "analyzer/dialect/dinplus/diagnose.hpp"
#include "analyzer/dialect/dinplus/keywords.hpp"
#include "analyzer/dialect/dinplus/lowering.hpp"
#include "analyzer/dialect/dinplus/sections.hpp"
#include "analyzer/dialect/numbers.hpp"

#include <algorithm>
#include <array>

namespace maclint::dinplus {
namespace {

using Part = RegionMark::Part;

/// `/159`: a digit each; a bare `/` is level 1.
std::uint16_t skip_levels(std::string_view mark) {
    unsigned levels = 0;
    for (const char c : mark)
        if (c >= '0' && c <= '9') levels |= 1U << static_cast<unsigned>(c - '0');
    return static_cast<std::uint16_t>(levels == 0 ? 2 : levels);
}

} // namespace

void BlockLowering::lower(const syntax::Tree& tree, Span block, OpenProgram& program) {
    begin_block(tree, block, program.builder);
    open_ = &program;
    const Node* node = nullptr;
    for_each_below(tree.nodes.front(), [&](const Node& child) {
        if (kind_of(child) == Kind::block) node = &child;
    });
    Block lowered{};
    check_tokens();
    if (node != nullptr) {
        items_.clear();
        for_each_child(*node, [this](const Node& child) { items_.push_back(&child); });
        const std::span<const Node* const> items = take_head(lowered, items_);
        check_alone(items);
        check_then(items);
        lower_items(items);
    }
    if (!program.effects) program.builder.drop_effects();
    end_block(lowered);
}

void BlockLowering::add_unreadable(const Block& head, OpenProgram& program) {
    program.builder.begin_block();
    add_names_in(head.span, program);
    program.builder.end_block(head);
}

void BlockLowering::add_unreadable_return(const Block& head, OpenProgram& program) {
    program.builder.begin_block();
    add_names_in(head.span, program);
    program.builder.add_effect({Return{}, head.span});
    program.builder.end_block(head);
}

/// What the words of a block may do that could not be read. The IF before it may have found its THEN.
void BlockLowering::add_names_in(Span block, OpenProgram& program) {
    program.waiting_if.reset();
    program.declares_something_unreadable |= program.declares;
    if (program.effects) program.builder.add_unreadable(names_in(program, block), block);
}

/// Takes slides, skip mark and block number off the front of a block; the rest is what it does.
std::span<const syntax::Node* const> BlockLowering::take_head(Block& block,
                                                              std::span<const Node* const> items) const {
    std::size_t taken = 0;
    for (; taken < items.size() && is_head(kind_of(*items[taken])); ++taken) {
        const Node& node = *items[taken];
        if (kind_of(node) == Kind::slide) {
            block.channels |= channels_in(text(node));
        } else if (kind_of(node) == Kind::skip) {
            block.skip_levels |= skip_levels(text(node));
        } else if (kind_of(node) == Kind::block_number && !block.sequence_number) {
            block.sequence_number = read_integer(text(node));
            if (block.sequence_number) block.sequence_number_span = span(node);
        }
    }
    return items.subspan(taken);
}

/// Words in a row act together, statements one after another.
void BlockLowering::lower_items(std::span<const Node* const> items) {
    for (std::size_t i = 0; i < items.size();) {
        if (!is_word(kind_of(*items[i]))) {
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
    const auto condition = [&](Field field) -> std::optional<ExpressionId> {
        const Node* value = child(node, field);
        return value == nullptr ? std::nullopt : std::optional(lower_expression(*value));
    };
    const auto mark = [&](RegionKind region_kind, Part part, std::optional<ExpressionId> test = {}) {
        lower_region_mark(node, region_kind, part, test);
    };
    switch (kind_of(node)) {
    case Kind::assignment: lower_assignment(node); break;
    case Kind::declaration:
        if (const Node* name = child(node, Field::name)) {
            declare(*name);
            initialise(*name, span(node));
        }
        break;
    case Kind::call: lower_call(node); break;
    case Kind::if_statement: mark(RegionKind::choice, Part::open, condition(Field::condition)); break;
    case Kind::then_statement: mark(RegionKind::choice, Part::begin); break;
    case Kind::else_statement: mark(RegionKind::choice, Part::middle); break;
    case Kind::endif_statement: mark(RegionKind::choice, Part::close); break;
    case Kind::while_statement: mark(RegionKind::while_loop, Part::open, condition(Field::condition)); break;
    case Kind::endwhile_statement: mark(RegionKind::while_loop, Part::close); break;
    case Kind::switch_statement: {
        const ExpressionId value = condition(Field::value).value_or(unreadable(span(node)));
        evaluate(value, span(node));
        open_->selections.push_back(value);
        mark(RegionKind::selection, Part::open);
        break;
    }
    case Kind::case_statement: lower_case(node); break;
    case Kind::default_statement: mark(RegionKind::selection, Part::middle); break;
    case Kind::break_statement: mark(RegionKind::selection, Part::leave); break;
    case Kind::endswitch_statement:
        if (!open_->selections.empty()) open_->selections.pop_back();
        mark(RegionKind::selection, Part::close);
        break;
    case Kind::unit_start:
        for_each_child(node, [this](const Node& parameter) { (void)record_word(parameter); });
        mark(RegionKind::unit, Part::open);
        break;
    case Kind::unit_end: mark(RegionKind::unit, Part::close); break;
    case Kind::return_statement: effect({Return{condition(Field::value), std::nullopt}, span(node)}); break;
    case Kind::output_statement: lower_output(node); break;
    case Kind::unknown_statement: lower_unknown(node); break;
    default: break; // values without address, what the parser marked as no statement
    }
}

void BlockLowering::lower_region_mark(const Node& node, RegionKind region_kind, Part part,
                                      std::optional<ExpressionId> condition) {
    effect({RegionMark{region_kind, part, std::nullopt, condition}, span(node)});
}

/// A branch is taken when the value of the SWITCH equals that of the CASE.
void BlockLowering::lower_case(const Node& node) {
    const Node* value = child(node, Field::value);
    const ExpressionId right = value == nullptr ? unreadable(span(node)) : lower_expression(*value);
    const ExpressionId left = open_->selections.empty() ? unreadable(span(node)) : open_->selections.back();
    const std::array operands{left, right};
    const ExpressionId test = apply(Operation::equal, operands, span(node));
    lower_region_mark(node, RegionKind::selection, Part::middle, test);
}

void BlockLowering::evaluate(ExpressionId value, Span span) {
    const std::array values{value};
    builder_->add_values(values, span);
}

void BlockLowering::lower_call(const Node& node) {
    Call call{std::monostate{}, calls::local, {}, std::nullopt};
    if (const Node* name = child(node, Field::name)) {
        const Kind kind = kind_of(*name);
        if (kind == Kind::string || kind == Kind::unclosed_string || kind == Kind::typographic_string)
            call.program = Text{characters(*name)};
        else
            call.program = lower_expression(*name);
    }
    std::vector<Argument> arguments;
    for_each_child(node, [&](const Node& part) {
        if (!is_word(kind_of(part))) return;
        const NcWord word = record_word(part);
        if (!word.value) return;
        if (word.address == "V") {
            if (word.literal && *word.literal != 0) call.kind = calls::external;
        } else if (word.address == "Q") {
            call.repeat = word.value;
        } else if (const std::optional<Variable> formal = transfer_variable(word.address)) {
            arguments.push_back({*formal, *word.value, word.address, span(part)});
        }
    });
    call.arguments = builder_->add_arguments(arguments);
    effect({call, span(node)});
}

/// INPUT stores in its last argument and stops the look-ahead [l.19617]; PRINT and WINDOW read theirs.
void BlockLowering::lower_output(const Node& node) {
    const Node* function = child(node, Field::function);
    const Node* list = child(node, Field::arguments);
    if (function == nullptr || list == nullptr) return;
    Nodes arguments;
    for_each_child(*list, [&](const Node& argument) { arguments.push_back(&argument); });
    const bool input = upper_text(*function) == "INPUT";
    const Node* target = input && arguments.size() > 1 ? arguments.back() : nullptr;
    if (target != nullptr) arguments.pop_back();
    std::vector<ExpressionId> out;
    for (const Node* argument : arguments) out.push_back(lower_expression(*argument));
    const std::optional<Variable> variable = target == nullptr ? std::nullopt : variable_of(*target);
    const std::span in = variable ? std::span(&*variable, 1) : std::span<const Variable>();
    builder_->add_exchange(out, in, span(node));
    if (target != nullptr && !variable) store_elsewhere(*target, unreadable(span(*target)), span(node));
    if (input) effect({Synchronise{}, span(node)});
}

/// The control stops here; what the author meant may have opened or closed something.
void BlockLowering::lower_unknown(const Node& node) {
    const Node* keyword = child(node, Field::keyword);
    if (keyword == nullptr) return;
    const std::string capitals = capitals_of(text(*keyword));
    const std::string meant = meant_by(capitals);
    if (meant == capitals) // a section word in the wrong place
        report(SyntaxErrorKind::not_alone, span(*keyword), "");
    else
        report(SyntaxErrorKind::unknown_keyword, span(*keyword), meant);
    builder_->add_unreadable({{}, {}, true, meant == "RETURN"}, span(node));
}

// ---- the tree

const syntax::Node* BlockLowering::child(const Node& node, Field field) const {
    for (syntax::NodeIndex i = node.first_child; i != syntax::no_node; i = tree_->nodes[i].next_sibling)
        if (field_of(tree_->nodes[i]) == field) return &tree_->nodes[i];
    return nullptr;
}

/// A text without its quotes.
Span BlockLowering::characters(const Node& text) const {
    const std::string_view written = this->text(text);
    const Offset quote = kind_of(text) == Kind::typographic_string ? 3 : 1;
    Span inside = span(text);
    inside.begin += std::min(quote, inside.length());
    if (kind_of(text) == Kind::unclosed_string) return inside;
    const Offset close = written.ends_with('"') ? 1 : quote;
    inside.end -= std::min(close, inside.length());
    return inside;
}

} // namespace maclint::dinplus
