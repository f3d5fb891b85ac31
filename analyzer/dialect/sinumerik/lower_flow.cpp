//! Lowering of loops, branches and jumps.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/sinumerik/diagnose.hpp"
#include "analyzer/dialect/sinumerik/lowering.hpp"

#include <algorithm>
#include <array>

namespace maclint::sinumerik {

using Part = RegionMark::Part;

/// With a jump behind it IF stands alone; any other is closed by ENDIF.
void BlockLowering::lower_if(const Node& node) {
    const Node* test = child(node, Field::condition);
    const ExpressionId condition = test == nullptr ? unreadable(span(node)) : lower_expression(*test);
    if (const Node* jump = child(node, Field::jump))
        lower_guarded_jump(condition, *jump, span(node));
    else
        mark(node, RegionKind::choice, Part::open, condition);
}

void BlockLowering::lower_guarded_jump(ExpressionId condition, const Node& jump, Span whole) {
    const std::size_t first = builder_->effect_count();
    if (kind_of(jump) == Kind::restart_statement)
        effect({Stop{Stop::Kind::restart, std::nullopt}, span(jump)});
    else
        lower_jump(jump);
    guard(condition, first, whole);
}

/// FOR stores its start, tests before each pass, and counts up by 1 at ENDFOR [NCI].
void BlockLowering::lower_for(const Node& node) {
    const Node* counter = child(node, Field::counter);
    const Node* first = child(node, Field::first);
    const Node* last = child(node, Field::last);
    std::optional<Variable> variable;
    std::optional<ExpressionId> condition = nobody_knows(span(node));
    if (counter != nullptr && first != nullptr && last != nullptr) {
        const ExpressionId start = lower_expression(*first);
        store(*counter, start, span(node));
        if (const auto unknown = open_->unknown.find(upper_text(*counter)); unknown != open_->unknown.end())
            unknown->second.is_read = true; // the loop asks for it
        const ExpressionId end = lower_expression(*last);
        const auto from = literal_value(start), to = literal_value(end);
        if (from && to && *from > *to) report(SyntaxErrorKind::empty_counting, span(node), "");
        variable = variable_of(*counter);
        if (variable) {
            const std::array operands{add({Load{*variable}, span(*counter)}), end};
            condition = apply(Operation::less_equal, operands, span(node));
        }
    }
    open_->counters.push_back(variable);
    mark(node, RegionKind::counting_loop, Part::open, condition);
}

void BlockLowering::end_for(const Node& node) {
    if (!open_->counters.empty()) {
        if (const std::optional<Variable> counter = open_->counters.back()) {
            const std::array operands{add({Load{*counter}, span(node)}), literal(1, span(node))};
            effect({Assign{*counter, apply(Operation::add, operands, span(node))}, span(node)});
        }
        open_->counters.pop_back();
    }
    mark(node, RegionKind::counting_loop, Part::close, {});
}

/// A row of jumps, each under its condition. Without DEFAULT it falls to the next block [NCI 4.1.5.3].
void BlockLowering::lower_case(const Node& node) {
    const Node* selected = child(node, Field::value);
    if (selected == nullptr) return;
    case_values_.clear();
    for_each_child(node, [&](const Node& arm) {
        const Kind kind = kind_of(arm);
        if (kind != Kind::case_arm && kind != Kind::default_arm) return;
        const Node* jump = nullptr;
        for_each_child(arm, [&](const Node& part) {
            if (kind_of(part) == Kind::goto_statement) jump = &part;
        });
        if (jump == nullptr) return;
        if (kind == Kind::default_arm) return lower_jump(*jump);
        const Node* value = child(arm, Field::value);
        if (value != nullptr) check_arm(arm, *value);
        const std::array operands{lower_expression(*selected),
                                  value == nullptr ? unreadable(span(arm)) : lower_expression(*value)};
        lower_guarded_jump(apply(Operation::equal, operands, span(arm)), *jump, span(arm));
    });
}

void BlockLowering::check_arm(const Node& arm, const Node& value) {
    if (const Node* again = child(arm, Field::again))
        report(SyntaxErrorKind::malformed_case, span(*again), "it once, behind the value of CASE");
    const std::string written = without_blanks(text(value));
    const bool known = std::ranges::find(case_values_, written) != case_values_.end();
    if (known)
        report(SyntaxErrorKind::value_twice, span(arm), "");
    else
        case_values_.push_back(written);
}

void BlockLowering::lower_jump(const Node& node) {
    const Node* direction = child(node, Field::direction);
    const std::string word = direction == nullptr ? "GOTO" : upper_text(*direction);
    Jump jump{jump_target(node), LabelSearch::forward_then_backward, MissingLabel::alarm};
    if (word == "GOTOF") jump.search = LabelSearch::forward;
    if (word == "GOTOB") jump.search = LabelSearch::backward;
    if (word == "GOTOC") jump.missing = MissingLabel::skip;
    const Node* target = child(node, Field::target);
    const bool both_ways = jump.search == LabelSearch::forward_then_backward;
    if (both_ways && target != nullptr && kind_of(*target) == Kind::name)
        open_->both_ways.push_back({upper_text(*target), span(node)});
    effect({jump, span(node)});
}

/// A label, a block number, or a text that gives one [NCI, HLS].
ExpressionId BlockLowering::jump_target(const Node& node) {
    const Node* target = child(node, Field::target);
    if (target == nullptr) return unreadable(span(node));
    const Span here = span(*target);
    if (upper_text(*target) == "DEFAULT") { // a word of CASE, and so no label
        report(SyntaxErrorKind::malformed_case, here, "the jump behind DEFAULT, as in DEFAULT GOTOF");
        return nobody_knows(here);
    }
    switch (kind_of(*target)) {
    case Kind::block_number:
    case Kind::main_block_number:
    case Kind::number: {
        const auto number = read_integer(text(*target));
        return number ? literal(static_cast<double>(*number), here) : unreadable(here);
    }
    case Kind::label: return label_named(label_in(text(*target)), here);
    case Kind::name:
    case Kind::axis_name:
        if (variable_named(upper_text(*target)) != nullptr || open_->macros.contains(upper_text(*target)))
            return nobody_knows(here);
        return label_named(text(*target), here);
    case Kind::string: {
        std::string_view name = text(*target);
        name.remove_prefix(1);
        name.remove_suffix(1);
        return label_named(name, here);
    }
    case Kind::concatenation: return lower_expression(*target);
    default: evaluate(lower_expression(*target), here); return nobody_knows(here);
    }
}

/// `N40` in a text is the number of a block.
ExpressionId BlockLowering::label_named(std::string_view name, Span here) {
    const std::string capitals = in_capitals(name);
    const bool number = capitals.size() > 1 && (capitals[0] == 'N' || capitals[0] == ':') &&
                        std::all_of(capitals.begin() + 1, capitals.end(), is_digit);
    if (number)
        if (const auto value = read_integer(name.substr(1)))
            return literal(static_cast<double>(*value), here);
    return add({builder_->block_name(capitals), here});
}

/// To the start of the program where the machine asks for it, else on with the next block [NCI].
void BlockLowering::restart_on_request(const Node& node) {
    lower_guarded_jump(nobody_knows(span(node)), node, span(node));
}

/// REPEAT of a part of the program; what it does is written when all labels are known.
void BlockLowering::lower_repetition(const Node& node) {
    for (const Field field : {Field::first, Field::last})
        if (const Node* name = child(node, field))
            if (kind_of(*name) == Kind::name && !open_->macros.contains(upper_text(*name)))
                open_->repeated.push_back({upper_text(*name), span(*name)});
    repeat_part(node, in_capitals(text(node)).starts_with("REPEATB"));
}

void BlockLowering::repeat_part(const Node& node, bool is_one_block) {
    for (const Node* item : items_) { // P=COUNT-1
        const Node* left = kind_of(*item) == Kind::assignment ? child(*item, Field::left) : nullptr;
        const Node* right = left == nullptr ? nullptr : child(*item, Field::right);
        if (right == nullptr || upper_text(*left) != "P") continue;
        passes_ = kind_of(*right) == Kind::number ? lower_expression(*right) : nobody_knows(span(*right));
    }
    const auto passes = passes_ ? literal_value(*passes_) : std::nullopt;
    if (passes && *passes < 1) report(SyntaxErrorKind::passes_out_of_range, expression(*passes_).span, "1");
    Repetition part{
        static_cast<ItemId>(program_->items.size()), span(node), {}, {}, {}, is_one_block, false, passes_};
    for (const Field field : {Field::first, Field::last}) {
        const Node* name = child(node, field);
        if (name == nullptr) continue;
        const auto number = kind_of(*name) == Kind::block_number ? read_integer(text(*name)) : std::nullopt;
        part.names_numbers |= kind_of(*name) != Kind::name || open_->macros.contains(upper_text(*name));
        (field == Field::first ? part.first : part.last) = upper_text(*name);
        if (number)
            part.labels.emplace_back(*number);
        else if (kind_of(*name) == Kind::name)
            part.labels.emplace_back(builder_->block_name(upper_text(*name)));
    }
    open_->repetitions.push_back(std::move(part));
    open_->writes_frames = true; // it may stand behind, where nothing is known yet
}

ExpressionId BlockLowering::nobody_knows(Span here) { return changing("", here); }

} // namespace maclint::sinumerik
