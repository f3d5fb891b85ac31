//! Lowering of words: what the words of a block do together.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/dinplus/lexer.hpp"
#include "analyzer/dialect/dinplus/lowering.hpp"
#include "analyzer/dialect/numbers.hpp"

#include <algorithm>

namespace maclint::dinplus {
namespace {

/// Words that move axes in a block without a code of its own: the last motion goes on [l.10297].
constexpr std::string_view axes[] = {"X", "Z", "Y", "C", "B", "XK", "YK", "U", "V", "W"};

bool is_axis(std::string_view address) { return std::ranges::find(axes, address) != std::end(axes); }

} // namespace

/// The letters at the head of a word; small ones are no address.
std::string_view BlockLowering::address_of(const Node& node) const {
    const std::string_view written = text(node);
    const auto end = std::ranges::find_if_not(written, is_capital);
    return written.substr(0, static_cast<std::size_t>(end - written.begin()));
}

/// The number of a word that is no calculation.
std::optional<double> BlockLowering::number_of_word(const Node& node) const {
    if (kind_of(node) == Kind::literal_word)
        return read_number(text(node).substr(address_of(node).size())).value;
    const Node* value = kind_of(node) == Kind::word ? child(node, Field::value) : nullptr;
    return value == nullptr ? std::nullopt : plain_number(*value);
}

BlockLowering::NcWord BlockLowering::record_word(const Node& node) {
    NcWord word{address_of(node), &node, std::nullopt, std::nullopt};
    const std::string_view after = text(node).substr(word.address.size());
    bool incremental = after.starts_with('i');
    switch (kind_of(node)) {
    case Kind::literal_word: word.value = lower_expression(node); break;
    case Kind::letter_o_word: { // GO is G0
        std::string digits(text(node).substr(1));
        std::ranges::replace(digits, 'O', '0');
        word.address = word.address.substr(0, 1);
        incremental = false;
        word.value = number(digits, span(node));
        break;
    }
    case Kind::malformed_word: word.value = unreadable(span(node)); break;
    case Kind::empty_word:
    case Kind::lower_case_word: break;
    default:
        if (const Node* value = child(node, Field::value)) word.value = lower_expression(*value);
        break;
    }
    if (word.value) word.literal = literal_value(*word.value);
    if (!word.address.empty())
        builder_->add_word({word.address, written_value(word.value), incremental, span(node)});
    return word;
}

void BlockLowering::lower_words(std::span<const Node* const> nodes) {
    words_.clear();
    for (const Node* node : nodes) words_.push_back(record_word(*node));
    const std::span<const NcWord> words(words_);
    const Span all = join(span(*nodes.front()), span(*nodes.back()));

    computed_.clear();
    for (const NcWord& word : words)
        if (word.value && !word.literal) computed_.push_back(*word.value);
    builder_->add_values(computed_, all);
    if (open_->context == Context::machining) lower_commands(words, all);
}

void BlockLowering::lower_commands(std::span<const NcWord> words, Span span) {
    bool moves = false;
    bool at_rapid = true; // every code that moves does so at rapid traverse
    bool goes_on = true;  // no code but those that may stand beside a motion
    bool synchronises = false;
    for (const NcWord& word : words) {
        if (word.address != "G" && word.address != "M") continue;
        const CodeFact* fact = word.literal ? find_code(word.address.front(), *word.literal) : nullptr;
        const std::uint16_t traits = fact == nullptr ? 0 : fact->traits;
        moves |= (traits & Trait::moves) != 0;
        at_rapid &= (traits & Trait::moves) == 0 || (traits & approaches) != 0;
        synchronises |= (traits & Trait::synchronises) != 0;
        if (word.address == "G") goes_on &= (traits & (feed_word | speed_word)) != 0;
        if (word.value) lower_code(word, words);
    }
    for (const NcWord& word : words)
        if (word.address == "T" && word.value)
            effect({ToolChange{ToolChange::Kind::change}, this->span(*word.node)});
    if (goes_on)
        moves |= std::ranges::any_of(words, [](const NcWord& w) { return w.value && is_axis(w.address); });
    if (moves) effect({Motion{at_rapid && !goes_on}, span});
    if (synchronises) effect({Synchronise{}, span});
    for (const NcWord& word : words) {
        if (word.address != "M" || !word.literal) continue;
        if (const CodeFact* fact = find_code('M', *word.literal))
            lower_machine_function(fact->traits, word, words);
    }
}

/// What a G code, or an M code of a modal group, sets.
void BlockLowering::lower_code(const NcWord& code, std::span<const NcWord> words) {
    const char letter = code.address.front();
    const Span here = span(*code.node);
    if (!code.literal) { // G#l1
        if (letter == 'G') effect({SetModal{std::nullopt, *code.value, 'G'}, here});
        return;
    }
    const CodeFact* fact = find_code(letter, *code.literal);
    const std::uint16_t traits = fact == nullptr ? 0 : fact->traits;
    const ControlModel& control = *program_->control;
    if (fact == nullptr || (traits & sets_group) != 0) {
        if (const std::optional<GroupId> group = control.group_of(letter, *code.literal)) {
            if ((traits & off_by_word) != 0)
                set_by_word(*group, *fact, code, words);
            else
                effect({SetModal{*group, *code.value}, here});
        }
    }
    for (const NcWord& word : words) {
        if (!word.value) continue;
        if ((traits & feed_word) != 0 && word.address == "F")
            effect({SetModal{control.group_with(ModalRole::feed), *word.value}, span(*word.node)});
        if ((traits & speed_word) != 0 && word.address == "S")
            effect({SetModal{control.group_with(ModalRole::speed), *word.value}, span(*word.node)});
        if ((traits & block_words) != 0 && (word.address == "NS" || word.address == "NE"))
            effect({Reference{references::contour, *word.value}, span(*word.node)});
    }
    if ((traits & approaches) != 0) effect({ToolChange{ToolChange::Kind::approach}, here});
}

/// `G16 Q1` switches on, `G16 Q0` off.
void BlockLowering::set_by_word(GroupId group, const CodeFact& fact, const NcWord& code,
                                std::span<const NcWord> words) {
    const auto word = std::ranges::find(words, fact.off_letter, &NcWord::address);
    ExpressionId value = *code.value;
    if (word != words.end() && word->literal && *word->literal == fact.off_value)
        value = literal(*program_->control->groups[group].cancel, span(*word->node));
    else if (word != words.end() && word->value && !word->literal)
        value = unreadable(span(*word->node));
    effect({SetModal{group, value}, span(*code.node)});
}

void BlockLowering::lower_machine_function(std::uint16_t traits, const NcWord& code,
                                           std::span<const NcWord> words) {
    const Span here = span(*code.node);
    if ((traits & pauses) != 0) effect({Stop{Stop::Kind::pause, std::nullopt}, here});
    if ((traits & ends) != 0) effect({Stop{Stop::Kind::end, std::nullopt}, here});
    if ((traits & restarts) != 0) {
        const auto block = std::ranges::find(words, std::string_view("NS"), &NcWord::address);
        effect({Stop{Stop::Kind::restart, block == words.end() ? std::nullopt : block->value},
                block == words.end() ? here : join(here, span(*block->node))});
    }
}

} // namespace maclint::dinplus
