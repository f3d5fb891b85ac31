//! Lowering of blocks and statements.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/sinumerik/diagnose.hpp"
#include "analyzer/dialect/sinumerik/lowering.hpp"
#include "analyzer/dialect/sinumerik/tables.hpp"

#include <algorithm>
#include <array>

namespace maclint::sinumerik {

using Part = RegionMark::Part;

void BlockLowering::lower(const syntax::Tree& tree, Span block, OpenProgram& program) {
    begin_block(tree, block, program.builder);
    open_ = &program;
    if (program.foreign_language && !ends_foreign_language(block)) return lower_foreign();
    moves_ = stays_ = false;
    passes_.reset();
    const Node* node = nullptr;
    for_each_below(tree.nodes.front(), [&](const Node& child) {
        if (kind_of(child) == Kind::block) node = &child;
    });
    Block lowered{};
    if (node != nullptr) {
        check_tokens();
        items_.clear();
        for_each_child(*node, [this](const Node& child) { items_.push_back(&child); });
        const std::span<const Node* const> items = take_head(lowered, items_);
        if (lower_misspelt_declaration(items)) return end_block(lowered);
        check_alone(items, lowered);
        check_length(items);
        check_functions(items);
        watch_actions(items, lowered);
        note_first_code(items);
        if (lowered.name) open_->frame.reset();
        watch_frames(items);
        watch_distance(items, lowered);
        for (const Node* item : items) // P3 stands behind the call that it repeats
            if (kind_of(*item) == Kind::literal_word && to_capital(text(*item).front()) == 'P')
                passes_ = lower_number(text(*item).substr(1), span(*item));
        stays_ = std::ranges::any_of(items, [this](const Node* item) { return takes_words(*item); });
        for (const Node* item : items) lower_item(*item);
        add_motion();
    }
    end_block(lowered);
}

bool BlockLowering::ends_foreign_language(Span block) const {
    return in_capitals(program_->slice(block)).find("G290") != std::string::npos;
}

/// A block of another language may do anything.
void BlockLowering::lower_foreign() {
    builder_->add_unreadable({{}, {}, true, true}, block_);
    end_block({});
}

void BlockLowering::add_unreadable(const Block& head, OpenProgram& program) {
    static const syntax::Tree none;
    begin_block(none, head.span, program.builder);
    open_ = &program;
    pass_over_names(head.span, declares_program(program_->text, head.span));
    builder_->add_unreadable(names_in(program, head.span), head.span);
    builder_->end_block(head);
}

/// Takes skip mark, block number and label off the front of a block; the rest is what it does.
std::span<const syntax::Node* const> BlockLowering::take_head(Block& block,
                                                              std::span<const Node* const> items) {
    std::size_t taken = 0;
    for (; taken < items.size() && is_head(kind_of(*items[taken])); ++taken) {
        const Node& node = *items[taken];
        const std::string_view written = text(node);
        switch (kind_of(node)) {
        case Kind::skip: { // `/` is level 0 [HLS]
            const unsigned level = written.size() > 1 ? static_cast<unsigned>(written[1] - '0') : 0U;
            block.skip_levels |= static_cast<std::uint16_t>(1U << level);
            break;
        }
        case Kind::label: take_label(block, node); break;
        default:
            if (block.sequence_number) break;
            block.sequence_number = read_integer(written.substr(1));
            if (block.sequence_number) block.sequence_number_span = span(node);
            break;
        }
    }
    return items.subspan(taken);
}

void BlockLowering::take_label(Block& block, const Node& node) {
    if (block.name) return;
    const std::string_view written = text(node);
    const std::string_view name = label_in(written);
    block.name = builder_->block_name(in_capitals(name));
    block.name_span = span(node);
    open_->labels.push_back({in_capitals(name), span(node)});
}

void BlockLowering::lower_item(const Node& node) {
    switch (kind_of(node)) {
    case Kind::literal_word: lower_word(node); break;
    case Kind::program_number: call_program(span(node), nullptr, calls::by_name, span(node)); break;
    case Kind::assignment: lower_assignment(node); break;
    case Kind::command:
        if (const Node* name = child(node, Field::name)) lower_named(*name, nullptr, node);
        break;
    case Kind::call:
        if (const Node* name = child(node, Field::name))
            lower_named(*name, child(node, Field::arguments), node);
        break;
    case Kind::indexed_command:
        for_each_child(node, [this](const Node& indexed) {
            if (const Node* index = child(indexed, Field::index))
                evaluate(lower_all(*index, span(indexed)), span(indexed));
        });
        break;
    case Kind::unassigned_word:
        if (const Node* value = child(node, Field::value)) evaluate(lower_expression(*value), span(node));
        break;
    case Kind::remark:
    case Kind::foreign_comment:
    case Kind::empty_word:
    case Kind::malformed_word: // told as they are met
    case Kind::block_number: break;
    default: lower_statement(node); break;
    }
}

void BlockLowering::lower_statement(const Node& node) {
    const auto condition = [&]() -> std::optional<ExpressionId> {
        const Node* value = child(node, Field::condition);
        return value == nullptr ? std::nullopt : std::optional(lower_expression(*value));
    };
    switch (kind_of(node)) {
    case Kind::definition: lower_definition(node); break;
    case Kind::macro_definition: lower_macro_definition(node); break;
    case Kind::program_definition: lower_program_definition(node); break;
    case Kind::if_statement: lower_if(node); break;
    case Kind::else_statement: mark(node, RegionKind::choice, Part::middle, {}); break;
    case Kind::endif_statement: mark(node, RegionKind::choice, Part::close, {}); break;
    case Kind::while_statement: mark(node, RegionKind::while_loop, Part::open, condition()); break;
    case Kind::endwhile_statement: mark(node, RegionKind::while_loop, Part::close, {}); break;
    case Kind::for_statement: lower_for(node); break;
    case Kind::endfor_statement: end_for(node); break;
    case Kind::loop_statement: mark(node, RegionKind::endless_loop, Part::open, {}); break;
    case Kind::endloop_statement: mark(node, RegionKind::endless_loop, Part::close, {}); break;
    case Kind::repeat_statement: mark(node, RegionKind::until_loop, Part::open, {}); break;
    case Kind::until_statement: mark(node, RegionKind::until_loop, Part::close, condition()); break;
    case Kind::repetition: lower_repetition(node); break;
    case Kind::case_statement: lower_case(node); break;
    case Kind::goto_statement: lower_jump(node); break;
    case Kind::restart_statement: restart_on_request(node); break;
    case Kind::synchronised_action: lower_action(node); break;
    case Kind::modal_call: lower_modal_call(node); break;
    case Kind::indirect_call:
    case Kind::path_call:
    case Kind::iso_call: lower_other_call(node); break;
    case Kind::then_statement:
    case Kind::elseif_statement: builder_->add_unreadable({{}, {}, true, false}, span(node)); break;
    case Kind::external_declaration: lower_external(node); break;
    default: break; // REDEF
    }
}

/// Definitions stand before the first block that does something [T808 p.126].
void BlockLowering::note_first_code(std::span<const Node* const> items) {
    const auto defines = [](Kind kind) {
        return kind == Kind::definition || kind == Kind::external_declaration;
    };
    const auto does_nothing = [&](const Node* item) {
        const Kind kind = kind_of(*item);
        return defines(kind) || kind == Kind::redefinition || kind == Kind::macro_definition ||
               kind == Kind::program_definition;
    };
    if (items.empty()) return;
    const bool comes_first =
        defines(kind_of(*items.front())) || kind_of(*items.front()) == Kind::program_definition;
    if (!open_->first_code.empty() && comes_first)
        report(SyntaxErrorKind::late_definition, span(*items.front()),
               std::string(program_->slice(open_->first_code)));
    const bool has_remark = std::ranges::any_of(items, [](const Node* item) {
        return kind_of(*item) == Kind::remark || kind_of(*item) == Kind::foreign_comment;
    });
    if (open_->first_code.empty() && !has_remark && !std::ranges::all_of(items, does_nothing))
        open_->first_code = block_;
}

void BlockLowering::mark(const Node& node, RegionKind region_kind, Part part,
                         std::optional<ExpressionId> condition) {
    effect({RegionMark{region_kind, part, std::nullopt, condition}, span(node)});
}

const syntax::Node* BlockLowering::child(const Node& node, Field field) const {
    for (syntax::NodeIndex i = node.first_child; i != syntax::no_node; i = tree_->nodes[i].next_sibling)
        if (field_of(tree_->nodes[i]) == field) return &tree_->nodes[i];
    return nullptr;
}

} // namespace maclint::sinumerik
