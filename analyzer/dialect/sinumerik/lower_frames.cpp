//! Lowering of frames and of synchronised actions.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/sinumerik/cycles.hpp"
#include "analyzer/dialect/sinumerik/lowering.hpp"
#include "analyzer/dialect/sinumerik/tables.hpp"
#include "analyzer/dialect/sinumerik/words.hpp"
#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <variant>

namespace maclint::sinumerik {
namespace {

/// Positions: where a block ends, and where the axis stands [SV].
bool is_position(std::string_view name) {
    constexpr std::string_view positions[] = {"$P_EP", "$AA_IM", "$AA_IW", "$AA_IB"};
    return std::ranges::find(positions, name) != std::end(positions);
}

constexpr double least_id = 1, last_id = 255; ///< of synchronised actions [PGA p.343]

} // namespace

// ---- frames

/// TRANS writes the shift and takes back all other parts of the frame; alone in its block it takes back all.
/// ATRANS adds to what is there [SEED-004:71-135].
void BlockLowering::lower_frame(std::string_view name, Span here) {
    const std::optional<FrameCode> code = frame_code(name);
    if (!code) return;
    const bool alone =
        std::ranges::count_if(items_, [](const Node* item) { return !is_head(kind_of(*item)); }) == 1;
    if (code->replaces)
        for (const GroupId group : frame_groups())
            if (alone || group != code->group) effect({SetModal{group, literal(0, here)}, here});
    if (!alone) effect({SetModal{code->group, literal(1, here)}, here});
    open_->writes_frames |= !alone;
}

/// The frame is calculated: `$P_PFRAME=CTRANS(X,10)`.
void BlockLowering::forget_frames(Span here) {
    for (const GroupId group : frame_groups()) effect({SetModal{group, changing("", here)}, here});
    open_->writes_frames = true;
}

/// Beginnings of loops, and what is stored in variables of the program: the first pass begins with the frame.
bool BlockLowering::leaves_frame(const Node& item) const {
    switch (kind_of(item)) {
    case Kind::for_statement:
    case Kind::loop_statement:
    case Kind::repeat_statement: return true;
    case Kind::assignment: {
        const Node* target = child(item, Field::left);
        return target != nullptr && variable_of(*target).has_value();
    }
    default: return false;
    }
}

/// `TRANS X10` and `ROT RPL=45` behind it: the shift is gone before anything has moved with it.
void BlockLowering::watch_frames(std::span<const Node* const> items) {
    const std::optional<NamedPlace> before = std::exchange(open_->frame, std::nullopt);
    if (std::ranges::all_of(items, [this](const Node* item) { return leaves_frame(*item); })) {
        open_->frame = before;
        return;
    }
    if (items.size() < 2 || kind_of(*items.front()) != Kind::command) return;
    const std::optional<FrameCode> code = frame_code(upper_text(*items.front()));
    if (!code) return;
    const Span here{span(*items.front()).begin, span(*items.back()).end};
    open_->frame = NamedPlace{upper_text(*items.front()), here};
    if (!code->replaces || !before) return;
    SyntaxError error{SyntaxErrorKind::frame_lost, before->span, std::string(program_->slice(before->span)),
                      std::string(program_->slice(here))};
    syntax_errors_.push_back(std::move(error));
}

// ---- distances

/// Where a jump may come in, or something else runs in between, nobody knows the distance mode.
void BlockLowering::watch_distance(std::span<const Node* const> items, const Block& head) {
    const auto leads_elsewhere = [](const Node* item) {
        const Kind kind = kind_of(*item);
        return kind != Kind::literal_word && kind != Kind::assignment && kind != Kind::command;
    };
    if (head.name || std::ranges::any_of(items, leads_elsewhere)) open_->incremental = false;
    for (const Node* item : items) {
        if (kind_of(*item) != Kind::literal_word) continue;
        const std::string word = in_capitals(without_blanks(text(*item)));
        if (word == "G91") open_->incremental = true;
        if (word == "G90") open_->incremental = false;
    }
}

/// The value, or what a number is added to or taken from: `$P_EP[X]-5`.
const syntax::Node* BlockLowering::without_number(const Node& value) const {
    if (kind_of(value) != Kind::binary) return &value;
    const Node* left = child(value, Field::left);
    const Node* right = child(value, Field::right);
    const Node* sign = child(value, Field::operation);
    if (left == nullptr || right == nullptr || sign == nullptr || kind_of(*right) != Kind::number)
        return &value;
    return text(*sign) == "+" || text(*sign) == "-" ? left : &value;
}

/// A position that was read is no distance: `G91 G1 X=$P_EP[X]`, `X=IC($P_EP[X])`.
void BlockLowering::check_distance(const Node& word, const Node& value) {
    const Node* read = &value;
    bool distance = open_->incremental;
    if (kind_of(value) == Kind::function_call) {
        const Node* function = child(value, Field::function);
        const Node* list = child(value, Field::arguments);
        if (function == nullptr || list == nullptr) return;
        distance = upper_text(*function) == "IC";
        read = only_child(*list);
    }
    if (read != nullptr) read = without_number(*read);
    if (!distance || read == nullptr || kind_of(*read) != Kind::system_variable) return;
    const Node* name = child(*read, Field::name);
    if (name == nullptr || !is_position(upper_text(*name))) return;
    report(SyntaxErrorKind::position_as_distance, span(word), std::string(text(*read)));
}

// ---- synchronised actions

/// Runs beside the program from here on, or with the next block: what it stores may change at any time. R
/// parameters are written `$R[1]` there, and are taken in here; all else that it stores in is the control's.
void BlockLowering::lower_action(const Node& node) {
    for_each_child(node, [this](const Node& part) {
        if (field_of(part) != Field::action && field_of(part) != Field::alternative) return;
        const Node* target = child(part, Field::left);
        if (target == nullptr) return;
        check_action_target(*target);
        if (const auto variable = variable_of(*target)) {
            const std::array in{*variable};
            builder_->add_exchange({}, in, span(part));
        }
    });
}

/// An action runs in time, R parameters and variables of the program are calculated ahead of it [PGA p.344].
void BlockLowering::check_action_target(const Node& target) {
    const std::string name = without_blanks(text(target));
    if (kind_of(target) == Kind::numbered_address && name.front() == 'R')
        return report(SyntaxErrorKind::action_on_local, span(target), "$R[" + name.substr(1) + "]");
    const Node* address = child(target, Field::address);
    if (kind_of(target) == Kind::indexed_address && address != nullptr && upper_text(*address) == "R")
        return report(SyntaxErrorKind::action_on_local, span(target), "$" + name);
    const Variable* variable = kind_of(target) == Kind::name ? variable_named(name) : nullptr;
    if (variable != nullptr) report(SyntaxErrorKind::action_on_local, span(target), "$AC_PARAM[1]");
}

std::optional<BlockLowering::ActionNumber>
BlockLowering::action_number(std::span<const Node* const> items) const {
    const bool acts = std::ranges::any_of(
        items, [](const Node* item) { return kind_of(*item) == Kind::synchronised_action; });
    if (!acts || kind_of(*items.front()) != Kind::assignment) return std::nullopt;
    const Node* name = child(*items.front(), Field::left);
    const Node* value = child(*items.front(), Field::right);
    if (name == nullptr || value == nullptr || kind_of(*value) != Kind::number) return std::nullopt;
    const std::string word = upper_text(*name);
    if (word != "ID" && word != "IDS") return std::nullopt;
    return ActionNumber{items.front(), read_number(text(*value)).value, word == "ID"};
}

void BlockLowering::check_action_number(const ActionNumber& action) {
    if (action.number < least_id || action.number > last_id)
        report(SyntaxErrorKind::action_number, span(*action.word), "1 to 255");
}

/// CANCEL, and every program that may hold one.
bool BlockLowering::may_cancel(const Node& item) const {
    const Kind kind = kind_of(item);
    if (kind != Kind::command && kind != Kind::call)
        return kind == Kind::indirect_call || kind == Kind::path_call || kind == Kind::iso_call ||
               kind == Kind::program_number || kind == Kind::repetition;
    const Node* name = child(item, Field::name);
    if (name == nullptr) return true;
    const std::string capitals = upper_text(*name);
    return capitals == "CANCEL" ||
           (find_word(capitals) == nullptr && !is_cycle_name(capitals) && !setting_of(capitals));
}

/// Those that run when the program returns, where it has moved since.
void BlockLowering::note_actions_left() {
    open_->left_at_return.clear();
    Offset last_move = 0;
    if (!open_->actions_left.empty())
        for_each_block(builder_->program(), [&](const BlockView& block) {
            const auto effects = builder_->program().effects_in(block.effects);
            const bool moves = block.moves || std::ranges::any_of(effects, [](const Effect& effect) {
                                   return std::holds_alternative<Motion>(effect.what);
                               });
            if (moves) last_move = block.span.begin;
        });
    for (const auto& [number, action] : open_->actions_left)
        if (action.begin < last_move) open_->left_at_return.push_back(action);
}

/// One that runs is replaced by the next of its number. Where something else may run between, or a jump comes
/// in, nobody knows whether it still runs.
void BlockLowering::watch_actions(std::span<const Node* const> items, const Block& head) {
    const auto may_end_them = [this](const Node* item) {
        const Kind kind = kind_of(*item);
        if (kind == Kind::command) {
            const WordRow* row = find_word(upper_text(*item));
            return row == nullptr || row->kind == WordKind::procedure;
        }
        return kind != Kind::literal_word && kind != Kind::assignment && kind != Kind::synchronised_action &&
               kind != Kind::definition;
    };
    if (head.name || std::ranges::any_of(items, may_end_them)) open_->actions.clear();
    if (std::ranges::any_of(items, [this](const Node* item) { return may_cancel(*item); }))
        open_->actions_left.clear();
    const auto action = action_number(items);
    if (!action) return;
    check_action_number(*action);
    if (action->ends_with_program) open_->actions_left.try_emplace(action->number, span(*action->word));
    const Span whole{span(*items.front()).begin, span(*items.back()).end};
    const auto [known, is_new] = open_->actions.try_emplace(action->number, whole);
    if (!is_new)
        report(SyntaxErrorKind::action_again, span(*action->word),
               std::string(program_->slice(known->second)));
}

} // namespace maclint::sinumerik
