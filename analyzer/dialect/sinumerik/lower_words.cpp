//! Lowering of words: addresses with their values, codes, and what is stored.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/sinumerik/g_codes.hpp"
#include "analyzer/dialect/sinumerik/lowering.hpp"
#include "analyzer/dialect/sinumerik/tables.hpp"
#include "analyzer/dialect/sinumerik/words.hpp"
#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/whole_number.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace maclint::sinumerik {
namespace {

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
constexpr std::string_view axes = "XYZABCUVW";
constexpr std::string_view targets = "XYZABCUVWIJK"; ///< a whole circle has its centre alone

/// The address in capitals, alive as long as the tables; empty where it is none of theirs.
std::string_view lasting(std::string_view capitals) {
    if (capitals.size() == 1 && is_capital(capitals.front()))
        return letters.substr(static_cast<std::size_t>(capitals.front() - 'A'), 1);
    const WordRow* row = find_word(capitals);
    return row == nullptr ? std::string_view{} : row->name;
}

} // namespace

void BlockLowering::evaluate(ExpressionId value, Span here) {
    const std::array values{value};
    if (!literal_value(value)) builder_->add_values(values, here);
}

/// `$AA_IW[LOADER]`, `FA[LOADER]=100`: what stands there may be an axis, whose name the machine gives.
void BlockLowering::evaluate_axes(const Node& index, Span here) {
    const bool around = std::exchange(names_axes_, true);
    evaluate(lower_all(index, here), here);
    names_axes_ = around;
}

void BlockLowering::add_word(std::string_view address, std::optional<ExpressionId> value, Span here) {
    const std::string_view name = lasting(address);
    if (!name.empty()) builder_->add_word({name, written_value(value), false, here});
}

/// `I=AC(20)`: the centre of an arc from the program's zero; without AC it counts from the start of the arc.
bool BlockLowering::add_absolute_centre(std::string_view address, const Node& target, Span here) {
    constexpr std::string_view centres = "IJK";
    const Node* given = parent_of(target);
    const Node* value = given == nullptr ? nullptr : child(*given, Field::right);
    if (centres.find(address.front()) == std::string_view::npos || value == nullptr ||
        kind_of(*value) != Kind::function_call)
        return false;
    const Node* function = child(*value, Field::function);
    const Node* list = child(*value, Field::arguments);
    const Node* place = list == nullptr ? nullptr : only_child(*list);
    if (function == nullptr || upper_text(*function) != "AC" || place == nullptr) return false;
    const auto number = literal_value(lower_expression(*place));
    if (number) builder_->add_word({lasting(address), Literal{*number, true}, false, here, true});
    return number.has_value();
}

/// Axes move where no code takes their words for something else.
void BlockLowering::add_motion() {
    if (moves_ && !stays_) effect({Motion{}, block_});
}

void BlockLowering::lower_word(const Node& node) {
    const std::string_view written = text(node);
    const std::string address(1, to_capital(written.front()));
    const Span here = span(node);
    const ExpressionId value = lower_number(written.substr(1), here);
    add_word(address, value, here);
    switch (address.front()) {
    case 'G': lower_code(code_name(written), here); break;
    case 'M':
        if (const auto number = literal_value(value)) lower_function_of_machine(*number, here);
        break;
    default:
        moves_ |= targets.find(address.front()) != std::string_view::npos;
        set_value(address.front(), value, here);
        break;
    }
}

/// Whether the code takes the words beside it for itself: G4 F2 is a dwell, G26 S2000 a limit.
bool BlockLowering::takes_words(const Node& item) const {
    std::optional<SettingOfCode> setting;
    if (kind_of(item) == Kind::literal_word && to_capital(text(item).front()) == 'G')
        setting = setting_of(code_name(text(item)));
    if (kind_of(item) == Kind::command) setting = setting_of(upper_text(item));
    return setting && setting->takes_axes;
}

/// `G2 X10 Y0 R5`, as other controls write a radius; beside their G81 it is something else.
void BlockLowering::report_radius_of_another_control(const Node& word, const Node* block) {
    bool moves = false, is_foreign = false;
    if (block != nullptr)
        for_each_child(*block, [&](const Node& item) {
            if (kind_of(item) != Kind::literal_word && kind_of(item) != Kind::assignment) return;
            const char letter = to_capital(text(item).front());
            moves |= axes.find(letter) != std::string_view::npos;
            if (kind_of(item) == Kind::literal_word && letter == 'G')
                is_foreign |= !setting_of(code_name(text(item)));
        });
    const Span here = span(word);
    if (!moves || is_foreign) return report_expected(here, "an = and a value behind the R parameter");
    std::string cure = "CR=";
    cure.append(text(word).substr(1));
    report(SyntaxErrorKind::missing_equals, here, std::move(cure));
}

/// Feed and speed.
void BlockLowering::set_value(char letter, ExpressionId value, Span here) {
    if (stays_ || (letter != 'F' && letter != 'S')) return;
    const ModalRole role = letter == 'F' ? ModalRole::feed : ModalRole::speed;
    effect({SetModal{program_->control->group_with(role), value}, here});
}

/// A G code of no group is a macro or a call of the machine's maker [MD10715]: nobody knows what it does.
void BlockLowering::lower_code(std::string_view name, Span here) {
    if (name == "G290") open_->foreign_language = false;
    if (name == "G291") open_->foreign_language = true;
    const std::optional<SettingOfCode> setting = setting_of(name);
    if (!setting) {
        if (!open_->macros.contains(name)) builder_->add_unknown_name({std::string(name), here, {}, false});
        return call_anything(here);
    }
    moves_ |= setting->moves;
    lower_frame(name, here);
    if (setting->sets) effect({SetModal{setting->sets->group, literal(setting->sets->code, here)}, here});
}

void BlockLowering::lower_function_of_machine(double number, Span here) {
    using namespace functions;
    if (number == program_stop || number == optional_stop)
        effect({Stop{Stop::Kind::pause, std::nullopt}, here});
    if (number == end || number == end_and_back) effect({Stop{Stop::Kind::end, std::nullopt}, here});
    if (number == end_of_subprogram) go_back({}, here);
    if (number == tool_change) effect({ToolChange{}, here});
}

void BlockLowering::lower_assignment(const Node& node) {
    const Node* left = child(node, Field::left);
    const Node* right = child(node, Field::right);
    if (left == nullptr || right == nullptr) return;
    check_stored(type_of_value(*left), *right);
    if (kind_of(*left) == Kind::indexed_name) check_stored_values(*left, *right);
    if (kind_of(*left) == Kind::name) check_length_of_text(upper_text(*left), *right);
    const ExpressionId value =
        kind_of(*right) == Kind::value_list ? lower_all(*right, span(*right)) : lower_expression(*right);
    store(*left, value, span(node));
}

/// A variable, or a word whose address needs its `=`.
void BlockLowering::store(const Node& target, ExpressionId value, Span whole) {
    if (const std::optional<Variable> variable = variable_of(target))
        return effect({Assign{*variable, value}, whole});
    switch (kind_of(target)) {
    case Kind::address:
    case Kind::numbered_address: { // X1=10, S2=500: a numbered axis or spindle is no axis that is known
        const std::string address = upper_text(target);
        if (address == "G") { // the code is a calculation
            effect({SetModal{std::nullopt, changing("", whole)}, whole});
            break;
        }
        evaluate(value, whole);
        if (kind_of(target) == Kind::address) {
            if (!add_absolute_centre(address, target, whole)) add_word(address, value, whole);
            set_value(address.front(), value, whole);
            const bool axis = axes.find(address.front()) != std::string_view::npos;
            moves_ |= axis;
            if (const Node* given = parent_of(target); axis && given != nullptr)
                if (const Node* right = child(*given, Field::right)) check_distance(*given, *right);
        }
        if (address == "M") call_anything(whole);
        break;
    }
    case Kind::indexed_address: {
        const Node* address = child(target, Field::address);
        const Node* index = child(target, Field::index);
        if (address == nullptr || index == nullptr) break;
        const std::string letter = upper_text(*address);
        if (letter == "G") return set_group_by_number(*index, value, whole);
        if (letter == "R") {
            const Expression read = expression(lower_r(*index, span(target)));
            if (const auto* load = std::get_if<Load>(&read.node))
                return effect({Assign{load->variable, value}, whole});
            if (const auto* at = std::get_if<LoadAt>(&read.node))
                return effect({Assign{StoreAt{at->family, at->index}, value}, whole});
        }
        evaluate_axes(*index, whole);
        evaluate(value, whole);
        break;
    }
    case Kind::name:
        note_unknown(target, false);
        set_rounding(upper_text(target), value, whole);
        set_other_feed(upper_text(target), whole);
        add_word(upper_text(target), value, whole);
        moves_ |= upper_text(target) == "AP" || upper_text(target) == "RP"; // a pole's angle and radius
        evaluate(value, whole);
        break;
    case Kind::indexed_name:
        lower_index(target, whole);
        evaluate(value, whole);
        if (const Node* name = child(target, Field::name)) {
            const std::string capitals = upper_text(*name);
            if (capitals == "POS" || capitals == "POSA") {
                moves_ = true;
                add_word(capitals, value, whole);
            }
        }
        break;
    case Kind::system_variable: {
        if (upper_text(target).starts_with("$P_PFRAME")) forget_frames(whole);
        check_may_be_stored(target);
        const Expression read = expression(lower_system_variable(target));
        if (const auto* owned = std::get_if<LoadMachine>(&read.node))
            return effect({Assign{StoreMachine{owned->family, owned->number}, value}, whole});
        evaluate(value, whole);
        break;
    }
    default: evaluate(value, whole); break;
    }
}

/// FZ=0.1, of a tooth; FB=100, for the block: there is a feed, whichever.
void BlockLowering::set_other_feed(std::string_view name, Span whole) {
    if (name == "FZ" || name == "FB")
        effect({SetModal{program_->control->group_with(ModalRole::feed), changing("", whole)}, whole});
}

/// RNDM=5: all corners behind it, until RNDM=0 [SEED-004:150-164].
void BlockLowering::set_rounding(std::string_view name, ExpressionId value, Span whole) {
    const auto rounding = name == "RNDM" ? coupling_code(name) : std::nullopt;
    if (!rounding) return;
    const auto radius = literal_value(value);
    const ExpressionId on = radius ? literal(*radius == 0 ? 0 : 1, whole) : changing("", whole);
    effect({SetModal{rounding->group, on}, whole});
}

/// `G[14]=OLD`: the number of the group, and of its member [SV].
void BlockLowering::set_group_by_number(const Node& index, ExpressionId value, Span whole) {
    const Node* number = only_child(index);
    const auto group = number == nullptr ? std::nullopt : literal_value(lower_expression(*number));
    if (!group) return effect({SetModal{std::nullopt, changing("", whole)}, whole});
    if (const auto row = row_of_g_group(whole_number(*group).value_or(0)))
        return effect({SetModal{*row, value}, whole});
    evaluate(value, whole);
}

} // namespace maclint::sinumerik
