//! Lowering of blocks and macro statements.
#include "analyzer/dialect/fanuc/diagnose.hpp"
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

BlockLowering::BlockLowering(const syntax::Tree& tree, Span block, const CodeTable& codes, Program& program,
                             std::vector<Irregularity>& irregularities)
    : tree_(tree)
    , block_(block)
    , program_(program)
    , codes_(codes)
    , irregularities_(irregularities) {}

void BlockLowering::lower() {
    const Node* node = nullptr;
    for_each_child(tree_.nodes.front(), [&](const Node& child) {
        if (kind_of(child) == Kind::block) node = &child;
    });
    if (node == nullptr) return;
    check_tokens();

    Block block{};
    block.span = block_;
    block.words.first = static_cast<Id>(program_.words.size());
    Nodes items = children(*node);
    take_head(block, items);
    constexpr std::size_t usually_enough = 8;
    Effects effects;
    effects.reserve(usually_enough);
    lower_items(items, effects);
    block.words.count = static_cast<Id>(program_.words.size()) - block.words.first;
    block.effects = {static_cast<Id>(program_.effects.size()), static_cast<Id>(effects.size())};
    std::ranges::move(effects, std::back_inserter(program_.effects));
    program_.items.emplace_back(block);
}

/// Takes sequence number and skip marks off the front of a block.
void BlockLowering::take_head(Block& block, Nodes& items) const {
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
    items.erase(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(taken));
}

/// Words in a row act together; statements act one after another; what stands behind a `/` may be skipped.
void BlockLowering::lower_items(std::span<const Node* const> items, Effects& effects) {
    for (std::size_t i = 0; i < items.size();) {
        const Kind kind = kind_of(*items[i]);
        if (kind == Kind::skip) {
            const Span mark = span(*items[i]);
            Effects rest;
            lower_items(items.subspan(i + 1), rest);
            if (!rest.empty())
                effects.push_back(guarded(unreadable(mark), std::move(rest), {mark.begin, block_.end}));
            return;
        }
        if (!is_word(kind)) {
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
    switch (kind_of(node)) {
    case Kind::assignment: lower_assignment(node, effects); break;
    case Kind::goto_statement: lower_goto(node, effects); break;
    case Kind::if_statement: lower_if(node, effects); break;
    case Kind::while_statement: lower_while(node, effects); break;
    case Kind::do_statement: lower_loop_mark(node, Structure::Part::open, effects); break;
    case Kind::end_statement: lower_loop_mark(node, Structure::Part::close, effects); break;
    case Kind::output_statement: lower_output(node, effects); break;
    default: break; // numbers without address, names of variables, words of other dialects: nothing happens
    }
}

void BlockLowering::lower_assignment(const Node& node, Effects& effects) {
    const Node* left = child(node, Field::left);
    const Node* right = child(node, Field::right);
    if (left == nullptr || right == nullptr) return;
    const ExpressionId value = lower_expression(*right);
    store(*left, value, span(node), effects);
}

void BlockLowering::store(const Node& target, ExpressionId value, Span span, Effects& effects) {
    switch (kind_of(target)) {
    case Kind::variable:
        if (const std::optional<std::int64_t> number = read_integer(text(target))) {
            store_numbered(*number, this->span(target), value, span, effects);
            return;
        }
        effects.push_back({Assign{StoreAt{numbered, unreadable(this->span(target))}, value}, span});
        return;
    case Kind::indirect_variable:
    case Kind::double_sharp: {
        const Node* index = child(target, Field::index);
        const ExpressionId at = index == nullptr ? unreadable(this->span(target)) : lower_expression(*index);
        effects.push_back({Assign{StoreAt{numbered, at}, value}, span});
        return;
    }
    case Kind::bracket: // [#_NAME]=
        for_each_child(target, [&](const Node& inner) { store(inner, value, span, effects); });
        return;
    case Kind::named_variable:
    case Kind::foreign_variable: effects.push_back({Assign{named_place(target), value}, span}); return;
    default: return;
    }
}

void BlockLowering::store_numbered(std::int64_t number, Span target, ExpressionId value, Span span,
                                   Effects& effects) {
    const VariableRange* range = program_.control->families[numbered].find(number);
    if (range == nullptr) {
        effects.push_back(
            {Assign{StoreAt{numbered, literal(static_cast<double>(number), target)}, value}, span});
        return;
    }
    if (range->meaning == Meaning::null) {
        report(Irregular::assignment_to_null, target, "");
        return;
    }
    const auto n = static_cast<std::int32_t>(number);
    switch (range->on_write) {
    case OnWrite::alarm: effects.push_back({Stop{Stop::Kind::alarm, value}, span}); return;
    case OnWrite::pause: effects.push_back({Stop{Stop::Kind::pause, value}, span}); return;
    case OnWrite::set_modal: effects.push_back({SetModal{range->group, value}, span}); return;
    case OnWrite::store:
    case OnWrite::forbidden: break;
    }
    if (range->meaning == Meaning::place)
        effects.push_back({Assign{Place{range->space, n}, value}, span});
    else
        effects.push_back({Assign{StoreMachine{numbered, n}, value}, span});
}

void BlockLowering::lower_goto(const Node& node, Effects& effects) {
    const Node* target = child(node, Field::target);
    if (target == nullptr) return;
    effects.push_back({Jump{lower_expression(*target)}, span(node)});
}

void BlockLowering::lower_if(const Node& node, Effects& effects) {
    const Node* condition = child(node, Field::condition);
    if (condition == nullptr) return;
    const ExpressionId test = lower_condition(*condition);
    Nodes consequences;
    for_each_child(node, [&](const Node& part) {
        if (field_of(part) == Field::consequence) consequences.push_back(&part);
    });
    Effects inner;
    lower_items(consequences, inner);
    effects.push_back(guarded(test, std::move(inner), span(node)));
}

Effect BlockLowering::guarded(ExpressionId condition, Effects inner, Span span) {
    const Slice slice{static_cast<Id>(program_.effects.size()), static_cast<Id>(inner.size())};
    std::ranges::move(inner, std::back_inserter(program_.effects));
    return {Guarded{condition, slice}, span};
}

void BlockLowering::lower_while(const Node& node, Effects& effects) {
    const Node* condition = child(node, Field::condition);
    const Node* loop = child(node, Field::loop);
    Structure structure{Construct::while_loop, Structure::Part::open, std::nullopt, std::nullopt};
    if (condition != nullptr) structure.condition = lower_condition(*condition);
    if (loop != nullptr) {
        if (const Node* number = child(*loop, Field::number);
            number != nullptr && kind_of(*number) == Kind::number)
            structure.number = read_integer(text(*number));
    } else {
        report(Irregular::loop_without_do, span(node), "DO");
    }
    effects.push_back({structure, span(node)});
}

void BlockLowering::lower_loop_mark(const Node& node, Structure::Part part, Effects& effects) {
    const Construct construct =
        part == Structure::Part::open ? Construct::endless_loop : Construct::while_loop;
    Structure structure{construct, part, std::nullopt, std::nullopt};
    if (const Node* number = child(node, Field::number);
        number != nullptr && kind_of(*number) == Kind::number)
        structure.number = read_integer(text(*number));
    effects.push_back({structure, span(node)});
}

void BlockLowering::lower_output(const Node& node, Effects& effects) {
    Exchange exchange;
    for_each_child(node, [&](const Node& part) {
        if (kind_of(part) != Kind::output_variable) return;
        if (const Node* variable = child(part, Field::variable))
            exchange.out.push_back(lower_expression(*variable));
    });
    effects.push_back({std::move(exchange), span(node)});
}

const syntax::Node* BlockLowering::child(const Node& node, Field field) const {
    for (syntax::NodeIndex i = node.first_child; i != syntax::no_node; i = tree_.nodes[i].next_sibling)
        if (field_of(tree_.nodes[i]) == field && kind_of(tree_.nodes[i]) != Kind::comment)
            return &tree_.nodes[i];
    return nullptr;
}

BlockLowering::Nodes BlockLowering::children(const Node& node) const {
    constexpr std::size_t usually_enough = 8;
    Nodes found;
    found.reserve(usually_enough);
    for_each_child(node, [&](const Node& child) { found.push_back(&child); });
    return found;
}

const syntax::Node* BlockLowering::only_child(const Node& node) const {
    const Node* only = nullptr;
    bool several = false;
    for_each_child(node, [&](const Node& child) {
        several = only != nullptr;
        only = &child;
    });
    return several ? nullptr : only;
}

Span BlockLowering::span(const Node& node) const {
    return {block_.begin + node.span.begin, block_.begin + node.span.end};
}

std::string_view BlockLowering::text(const Node& node) const { return program_.slice(span(node)); }

std::string BlockLowering::upper_text(const Node& node) const {
    std::string upper(text(node));
    for (char& c : upper)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return upper;
}

void BlockLowering::report(Irregular kind, Span span, std::string cure) {
    irregularities_.push_back({kind, span, std::string(program_.slice(span)), std::move(cure)});
}

/// What is wrong with single nodes of a block that the parser could read. Nearly all blocks are sound, and
/// one look at their nodes shows it.
void BlockLowering::check_tokens() {
    bool has_foreign_words = false;
    bool has_empty_words = false;
    int brackets = 0;
    for (const Node& node : tree_.nodes) {
        switch (kind_of(node)) {
        case Kind::symbolic_operator:
        case Kind::foreign_keyword: has_foreign_words = true; break;
        case Kind::empty_word: has_empty_words = true; break;
        case Kind::bracket:
        case Kind::argument_list:
        case Kind::condition: ++brackets; break;
        default: break;
        }
    }
    if (has_foreign_words) check_words();
    if (brackets > program_.control->limits.bracket_levels) check_depth(tree_.nodes.front(), 0);
    if (has_empty_words) check_parenthesis_for_value();
}

/// Operators and keywords of other languages.
void BlockLowering::check_words() {
    std::vector<bool> in_condition(tree_.nodes.size(), false);
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
        const Node& node = tree_.nodes[i];
        const Kind kind = kind_of(node);
        const bool here = in_condition[i] || kind == Kind::condition || kind == Kind::compound_condition ||
                          kind == Kind::unbracketed_condition;
        for (syntax::NodeIndex c = node.first_child; c != syntax::no_node; c = tree_.nodes[c].next_sibling)
            in_condition[c] = here;
        if (kind == Kind::symbolic_operator && here) {
            static constexpr std::pair<std::string_view, std::string_view> words[] = {
                {"=", "EQ"},  {"==", "EQ"}, {"<", "LT"},  {">", "GT"},  {"<=", "LE"},
                {"=<", "LE"}, {">=", "GE"}, {"=>", "GE"}, {"<>", "NE"}, {"!=", "NE"}};
            const auto* word =
                std::ranges::find(words, text(node), &std::pair<std::string_view, std::string_view>::first);
            report(Irregular::symbolic_comparison, span(node),
                   word == std::end(words) ? "" : std::string(word->second));
        } else if (kind == Kind::foreign_keyword) {
            static constexpr std::pair<std::string_view, std::string_view> meant[] = {
                {"THN", "THEN"}, {"ENDW", "END"}, {"ENDWHILE", "END"}};
            const auto* word = std::ranges::find(meant, upper_text(node),
                                                 &std::pair<std::string_view, std::string_view>::first);
            report(Irregular::unknown_keyword, span(node),
                   word == std::end(meant) ? "" : std::string(word->second));
        }
    }
}

/// `X(#1+2)`: an address without value, and a comment that would make one. Such a block parses.
void BlockLowering::check_parenthesis_for_value() {
    if (std::optional<Irregularity> found = find_parenthesis_as_bracket(program_.text, block_))
        irregularities_.push_back(std::move(*found));
}

/// Reports the first bracket of the block that opens one level too many.
void BlockLowering::check_depth(const Node& node, int depth) {
    if (depth_reported_) return;
    const Kind kind = kind_of(node);
    if (kind == Kind::bracket || kind == Kind::argument_list || kind == Kind::condition) {
        if (++depth > program_.control->limits.bracket_levels) {
            depth_reported_ = true;
            const Offset begin = span(node).begin;
            report(Irregular::bracket_depth, {begin, begin + 1}, "");
            return;
        }
    }
    for (syntax::NodeIndex i = node.first_child; i != syntax::no_node; i = tree_.nodes[i].next_sibling)
        check_depth(tree_.nodes[i], depth);
}

} // namespace maclint::fanuc
