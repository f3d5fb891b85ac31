//! Lowering of blocks and statements.
#include "analyzer/dialect/dinplus/keywords.hpp"
#include "analyzer/dialect/dinplus/lowering.hpp"
#include "analyzer/dialect/dinplus/sections.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/words.hpp"

#include <algorithm>
#include <array>

namespace maclint::dinplus {
namespace {

using Part = Structure::Part;

/// `/159`: a digit each; a bare `/` is level 1.
std::uint16_t skip_levels(std::string_view mark) {
    unsigned levels = 0;
    for (const char c : mark)
        if (c >= '0' && c <= '9') levels |= 1U << static_cast<unsigned>(c - '0');
    return static_cast<std::uint16_t>(levels == 0 ? 2 : levels);
}

} // namespace

BlockLowering::BlockLowering(const syntax::Tree& tree, Span block, Program& program,
                             Surroundings& surroundings, std::vector<Irregularity>& irregularities)
    : tree_(tree)
    , block_(block)
    , program_(program)
    , around_(surroundings)
    , irregularities_(irregularities) {}

void BlockLowering::lower() {
    const Node* node = nullptr;
    for (const Node* child : children(tree_.nodes.front()))
        if (kind_of(*child) == Kind::block) node = child;
    Block block{};
    block.span = block_;
    block.words.first = static_cast<Id>(program_.words.size());
    Effects effects;
    if (node != nullptr) {
        check_tokens();
        Nodes items = named_children(*node);
        take_head(block, items);
        check_alone(items);
        check_then(items);
        lower_items(items, effects);
    }
    if (!around_.effects) effects.clear();
    block.words.count = static_cast<Id>(program_.words.size()) - block.words.first;
    block.effects = {static_cast<Id>(program_.effects.size()), static_cast<Id>(effects.size())};
    std::ranges::move(effects, std::back_inserter(program_.effects));
    program_.items.emplace_back(block);
}

/// Takes slides, skip mark and block number off the front of a block.
void BlockLowering::take_head(Block& block, Nodes& items) const {
    std::size_t taken = 0;
    for (; taken < items.size() && is_head(kind_of(*items[taken])); ++taken) {
        const Node& node = *items[taken];
        if (kind_of(node) == Kind::skip) {
            block.skip_levels |= skip_levels(text(node));
        } else if (kind_of(node) == Kind::block_number && !block.sequence_number) {
            block.sequence_number = read_integer(text(node));
            if (block.sequence_number) block.sequence_number_span = span(node);
        }
    }
    items.erase(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(taken));
}

/// Words in a row act together, statements one after another.
void BlockLowering::lower_items(std::span<const Node* const> items, Effects& effects) {
    for (std::size_t i = 0; i < items.size();) {
        if (!is_word(kind_of(*items[i]))) {
            lower_statement(*items[i++], effects);
            continue;
        }
        std::size_t behind = i;
        while (behind < items.size() && is_word(kind_of(*items[behind]))) ++behind;
        lower_words(items.subspan(i, behind - i), effects);
        i = behind;
    }
}

void BlockLowering::lower_statement(const Node& node, Effects& effects) {
    const auto condition = [&](Field field) -> std::optional<ExpressionId> {
        const Node* value = child(node, field);
        return value == nullptr ? std::nullopt : std::optional(lower_expression(*value));
    };
    const auto structure = [&](Construct construct, Part part, std::optional<ExpressionId> test = {}) {
        lower_structure(node, construct, part, test, effects);
    };
    switch (kind_of(node)) {
    case Kind::assignment: lower_assignment(node, effects); break;
    case Kind::declaration:
        if (const Node* name = child(node, Field::name)) initialise(*name, span(node), effects);
        break;
    case Kind::call: lower_call(node, effects); break;
    case Kind::if_statement: structure(Construct::choice, Part::open, condition(Field::condition)); break;
    case Kind::then_statement: structure(Construct::choice, Part::begin); break;
    case Kind::else_statement: structure(Construct::choice, Part::middle); break;
    case Kind::endif_statement: structure(Construct::choice, Part::close); break;
    case Kind::while_statement:
        structure(Construct::while_loop, Part::open, condition(Field::condition));
        break;
    case Kind::endwhile_statement: structure(Construct::while_loop, Part::close); break;
    case Kind::switch_statement: {
        const ExpressionId value = condition(Field::value).value_or(unreadable(span(node)));
        evaluate(value, span(node), effects);
        around_.selections.push_back(value);
        structure(Construct::selection, Part::open);
        break;
    }
    case Kind::case_statement: lower_case(node, effects); break;
    case Kind::default_statement: structure(Construct::selection, Part::middle); break;
    case Kind::break_statement: structure(Construct::selection, Part::leave); break;
    case Kind::endswitch_statement:
        if (!around_.selections.empty()) around_.selections.pop_back();
        structure(Construct::selection, Part::close);
        break;
    case Kind::unit_start:
        for (const Node* parameter : named_children(node)) (void)record_word(*parameter);
        structure(Construct::unit, Part::open);
        break;
    case Kind::unit_end: structure(Construct::unit, Part::close); break;
    case Kind::return_statement:
        effects.push_back({Return{condition(Field::value), std::nullopt}, span(node)});
        break;
    case Kind::output_statement: lower_output(node, effects); break;
    case Kind::unknown_statement: lower_unknown(node, effects); break;
    default: break; // values without address, what the parser marked as no statement
    }
}

void BlockLowering::lower_structure(const Node& node, Construct construct, Part part,
                                    std::optional<ExpressionId> condition, Effects& effects) {
    effects.push_back({Structure{construct, part, std::nullopt, condition}, span(node)});
}

/// A branch is taken when the value of the SWITCH equals that of the CASE.
void BlockLowering::lower_case(const Node& node, Effects& effects) {
    const Node* value = child(node, Field::value);
    const ExpressionId right = value == nullptr ? unreadable(span(node)) : lower_expression(*value);
    const ExpressionId left = around_.selections.empty() ? unreadable(span(node)) : around_.selections.back();
    const std::array operands{left, right};
    const ExpressionId test = apply(Operation::equal, operands, span(node));
    lower_structure(node, Construct::selection, Part::middle, test, effects);
}

void BlockLowering::evaluate(ExpressionId value, Span span, Effects& effects) {
    effects.push_back({Values{{static_cast<Id>(program_.operands.size()), 1}}, span});
    program_.operands.push_back(value);
}

void BlockLowering::lower_call(const Node& node, Effects& effects) {
    Call call{std::monostate{}, calls::local, {}, std::nullopt};
    if (const Node* name = child(node, Field::name)) {
        const Kind kind = kind_of(*name);
        if (kind == Kind::string || kind == Kind::unclosed_string || kind == Kind::typographic_string)
            call.program = Text{characters(*name)};
        else
            call.program = lower_expression(*name);
    }
    std::vector<Argument> arguments;
    for (const Node* part : named_children(node)) {
        if (!is_word(kind_of(*part))) continue;
        const NcWord word = record_word(*part);
        if (!word.value) continue;
        if (word.address == "V") {
            if (word.literal && *word.literal != 0) call.kind = calls::external;
        } else if (word.address == "Q") {
            call.repeat = word.value;
        } else if (const std::optional<Place> formal = transfer_place(word.address)) {
            arguments.push_back({*formal, *word.value, word.address, span(*part)});
        }
    }
    call.arguments = {static_cast<Id>(program_.arguments.size()), static_cast<Id>(arguments.size())};
    std::ranges::move(arguments, std::back_inserter(program_.arguments));
    effects.push_back({call, span(node)});
}

/// INPUT stores in its last argument and stops the look-ahead [l.19617]; PRINT and WINDOW read theirs.
void BlockLowering::lower_output(const Node& node, Effects& effects) {
    const Node* function = child(node, Field::function);
    const Node* list = child(node, Field::arguments);
    if (function == nullptr || list == nullptr) return;
    const Nodes arguments = named_children(*list);
    const bool input = upper_text(*function) == "INPUT";
    Exchange exchange;
    for (const Node* argument : arguments) {
        if (input && argument == arguments.back() && arguments.size() > 1) {
            if (const std::optional<Place> place = place_of(*argument)) exchange.in.push_back(*place);
        } else {
            exchange.out.push_back(lower_expression(*argument));
        }
    }
    effects.push_back({std::move(exchange), span(node)});
    if (input) effects.push_back({Synchronise{}, span(node)});
}

/// The control stops here; what the author meant may have opened or closed something.
void BlockLowering::lower_unknown(const Node& node, Effects& effects) {
    const Node* keyword = child(node, Field::keyword);
    if (keyword == nullptr) return;
    const std::string capitals = capitals_of(text(*keyword));
    const std::string meant = meant_by(capitals);
    report(Irregular::unknown_keyword, span(*keyword), meant);
    UnreadableBlock block{{}, {}, true, meant == "RETURN"};
    effects.push_back({std::move(block), span(node)});
}

// ---- the tree

const syntax::Node* BlockLowering::child(const Node& node, Field field) const {
    for (syntax::NodeIndex i = node.first_child; i != syntax::no_node; i = tree_.nodes[i].next_sibling)
        if (field_of(tree_.nodes[i]) == field) return &tree_.nodes[i];
    return nullptr;
}

BlockLowering::Nodes BlockLowering::children(const Node& node) const {
    Nodes found;
    for (syntax::NodeIndex i = node.first_child; i != syntax::no_node; i = tree_.nodes[i].next_sibling)
        found.push_back(&tree_.nodes[i]);
    return found;
}

BlockLowering::Nodes BlockLowering::named_children(const Node& node) const {
    Nodes found;
    for (const Node* below : children(node)) {
        const Kind kind = kind_of(*below);
        const bool comment = kind == Kind::comment || kind == Kind::unclosed_comment ||
                             kind == Kind::description_mark || kind == Kind::foreign_comment;
        if (below->named && !comment) found.push_back(below);
    }
    return found;
}

Span BlockLowering::span(const Node& node) const {
    return {block_.begin + node.span.begin, block_.begin + node.span.end};
}

std::string_view BlockLowering::text(const Node& node) const { return program_.slice(span(node)); }

std::string BlockLowering::upper_text(const Node& node) const { return in_capitals(text(node)); }

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

void BlockLowering::report(Irregular kind, Span span, std::string cure) {
    irregularities_.push_back({kind, span, std::string(program_.slice(span)), std::move(cure)});
}

} // namespace maclint::dinplus
