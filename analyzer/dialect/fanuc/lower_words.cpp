//! Lowering of NC words: what the words of a block that stand side by side do together.
#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/dialect/fanuc/lowering.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/program/own_codes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace maclint::fanuc {
namespace {

/// "X", or ",X" after a comma, with static lifetime.
std::string_view address_text(char letter, bool comma) {
    static constexpr std::string_view words = ",A,B,C,D,E,F,G,H,I,J,K,L,M,N,O,P,Q,R,S,T,U,V,W,X,Y,Z";
    if (letter < 'A' || letter > 'Z') return comma ? "," : "@";
    const auto at = static_cast<std::size_t>(letter - 'A') * 2;
    return comma ? words.substr(at, 2) : words.substr(at + 1, 1);
}

/// Gives I, J and K their place: a letter that does not follow the last one in the alphabet begins a new set
/// (5.3, 5.4).
class SetCounter {
  public:
    std::optional<std::int32_t> argument_of(char letter) {
        if (letter <= last_) ++set_;
        last_ = letter;
        constexpr int sets = 10;
        if (set_ >= sets) return std::nullopt;
        return 4 + 3 * set_ + (letter - 'I');
    }

  private:
    int set_ = 0;
    char last_ = 0;
};

/// G65, G66, G66.1
bool is_macro_call(double code) { return code == 65 || code == 66 || code == 66.1; }

/// `(SUB/HOLES.NC)`: Haas and Mach take it behind M98 and G65 for the file to call [T: Haas Mill Operator's
/// Manual, M98].
bool names_a_file(std::string_view comment) {
    comment = comment.substr(1, comment.size() - (is_closed(comment) ? 2 : 1));
    const std::size_t dot = comment.rfind('.');
    if (comment.find_first_of(" \t") != std::string_view::npos || dot == std::string_view::npos) return false;
    const std::string_view extension = comment.substr(dot + 1);
    return dot != 0 && !extension.empty() && std::ranges::all_of(extension, is_letter);
}

} // namespace

BlockLowering::NcWord BlockLowering::record_word(const Node& node) {
    if (kind_of(node) == Kind::program_name) return {0, false, &node, std::nullopt, std::nullopt};
    NcWord word{0, false, &node, std::nullopt, std::nullopt};
    const Node* inner = &node;
    if (kind_of(node) == Kind::comma_word) {
        word.comma = true;
        if (const Node* below = first_child(node)) inner = below;
    }
    const std::string_view written = text(*inner);
    std::size_t letter = 0;
    if (written.size() > 1 && written[0] == '&') letter = 1;
    word.letter = written.empty() ? '@' : to_capital(written[letter]);
    bool incremental = false;
    if (kind_of(*inner) == Kind::literal_word || kind_of(*inner) == Kind::sequence_number) {
        std::size_t digits = letter + 1;
        while (digits < written.size() && (written[digits] == ' ' || written[digits] == '\t')) ++digits;
        const Span whole = span(*inner);
        word.value =
            number(written.substr(letter + 1), {whole.begin + static_cast<Offset>(digits), whole.end});
    } else if (kind_of(*inner) == Kind::letter_o_word) {
        std::string digits(written.substr(letter + 1)); // GO1 is G01
        std::ranges::replace_if(
            digits, [](char c) { return c == 'O' || c == 'o'; }, '0');
        word.value = number(digits, span(*inner));
    } else if (kind_of(*inner) == Kind::malformed_word) {
        word.value = unreadable(span(*inner));
    } else if (const Node* value = child(*inner, Field::value)) {
        incremental = child(*inner, Field::incremental) != nullptr;
        if (incremental) check_increment({span(*inner).begin, span(*inner).begin + 1});
        word.value = lower_expression(*value);
    }
    if (&node == goes_on_) word.value = unreadable(span(node));
    if (word.value) word.literal = literal_value(*word.value);
    builder_->add_word(
        {address_text(word.letter, word.comma), written_value(word.value), incremental, span(node)});
    return word;
}

void BlockLowering::lower_words(std::span<const Node* const> nodes) {
    words_.clear();
    for (const Node* node : nodes) words_.push_back(record_word(*node));
    const std::span<const NcWord> words(words_);
    const Span all = join(span(*nodes.front()), span(*nodes.back()));

    // A macro call takes every word after it as its own, up to a second one, which no block may hold.
    const auto calls_macro = [](const NcWord& word) {
        return word.letter == 'G' && !word.comma && word.literal && is_macro_call(*word.literal);
    };
    auto call = std::ranges::find_if(words, calls_macro);
    if (call != words.begin()) lower_usual_words({words.begin(), call}, all);
    while (call != words.end()) {
        const auto next = std::find_if(call + 1, words.end(), calls_macro);
        lower_macro_call({call, next}, join(span(*call->node), span(*(next - 1)->node)));
        call = next;
    }
}

void BlockLowering::lower_macro_call(std::span<const NcWord> words, Span span) {
    const NcWord& code = words.front();
    Call call{std::monostate{}, calls::g65, {}, std::nullopt};
    if (code.literal == 66) call.kind = calls::g66;
    if (code.literal == 66.1) call.kind = calls::g66_1;
    for (const NcWord& word : words.subspan(1)) {
        if (word.letter == 'P' && word.value) call.program = *word.value;
        if (word.letter == 'L' && word.value) call.repeat = word.value;
        if (word.letter == 0) call.program = Text{this->span(*word.node)};
    }
    call.arguments = arguments_from(words.subspan(1));
    if (std::holds_alternative<std::monostate>(call.program)) report_missing_program(code, words);
    if (const auto extra = macro_a_of(words)) check_lacking(*extra, span, program_->slice(span));
    effect({call, span});
}

Slice BlockLowering::arguments_from(std::span<const NcWord> words) {
    arguments_.clear();
    SetCounter sets;
    for (const NcWord& word : words) {
        if (word.comma || !word.value || word.letter < 'A' || word.letter > 'Z') continue;
        std::int32_t local = local_of_letter[static_cast<std::size_t>(word.letter - 'A')];
        if (local == 0) continue;
        if (word.letter >= 'I' && word.letter <= 'K') {
            const std::optional<std::int32_t> variable = sets.argument_of(word.letter);
            if (!variable) continue;
            local = *variable;
        }
        arguments_.push_back({Variable{spaces::local, local}, *word.value, address_text(word.letter, false),
                              span(*word.node)});
    }
    return builder_->add_arguments(arguments_);
}

/// Order of a block's words: modal codes, F and S, the move, then what stops, calls or ends.
void BlockLowering::lower_usual_words(std::span<const NcWord> words, Span span) {
    std::uint16_t traits = 0;
    const CodeTable& codes = this->codes();
    for (const NcWord& word : words) {
        if (word.comma || !word.literal) continue;
        if (word.letter == 'G') traits |= codes.g_code(*word.literal).traits;
        if (word.letter == 'M') traits |= codes.m_code(*word.literal);
    }
    const bool own_words = (traits & no_words) != 0;
    bool moves = false;
    computed_.clear();
    for (const NcWord& word : words) {
        if (word.comma || !word.value) continue;
        const Span here = this->span(*word.node);
        if (word.letter == 'G') {
            if (!word.literal) {
                effect({SetModal{std::nullopt, *word.value, word.letter}, here});
                continue;
            }
            if (*word.literal == 52) set_local_offset(words, span);
            const Code code = codes.g_code(*word.literal);
            if (code.group != no_group) effect({SetModal{code.group, *word.value}, here});
        } else if (word.letter == 'F' && !own_words) {
            effect({SetModal{codes_.feed, *word.value}, here});
        } else if (word.letter == 'S' && !own_words && (traits & limits_speed) == 0) {
            effect({SetModal{codes_.speed, *word.value}, here});
        } else if (word.letter == 'M' && word.literal && codes.m_group(*word.literal) != no_group) {
            effect({SetModal{codes.m_group(*word.literal), *word.value}, here});
        } else {
            moves |= codes_.is_axis(word.letter);
            if (!word.literal) computed_.push_back(*word.value);
        }
    }
    if ((traits & may_call) != 0) {
        if (!lower_own_macro(words, span)) lower_possible_call(words, span);
    } else
        builder_->add_values(computed_, span);
    if (moves && (traits & (no_axes | no_words)) == 0)
        effect({Motion{(traits & without_feed) != 0, (traits & to_reference) != 0}, span});
    if ((traits & synchronises) != 0) {
        const bool limited = std::ranges::any_of(words, [](const NcWord& word) {
            return word.letter == 'P' && !word.comma && word.literal.value_or(1) > 0;
        });
        effect({Synchronise{(traits & limits_ahead) != 0 && limited}, span});
    }
    for (const NcWord& word : words) {
        const bool lathe_tool = word.letter == 'T' && codes_.tool_changes_at_once;
        const bool calls = codes.tool_calls_program && !own_words && own_call(word) != nullptr;
        if (lathe_tool && !word.comma && word.value && !own_words && !calls)
            effect({ToolChange{}, this->span(*word.node)});
        if (calls && word.letter == tool_letter) lower_own_subprogram(word, this->span(*word.node));
        if (word.letter == 'M' && !word.comma && word.literal) lower_machine_function(word, words, span);
    }
}

/// A macro that a G code of the shop's own may call: what it does is unknown. A word may tell it which local
/// variable of the caller to set: G310 R8178 P28.
void BlockLowering::lower_possible_call(std::span<const NcWord> words, Span span) {
    constexpr double last_local = 33;
    std::vector<Variable> set;
    for (const NcWord& word : words) {
        const bool whole = program_->slice(this->span(*word.node)).find('.') == std::string_view::npos;
        if (word.literal && whole && word.letter != 'G' && *word.literal >= 1 && *word.literal <= last_local)
            set.push_back({spaces::local, static_cast<std::int32_t>(*word.literal)});
    }
    if (!set.empty()) builder_->add_exchange({}, set, span);
    effect({Call{unreadable(span), calls::g65, arguments_from(words), std::nullopt}, span});
}

void BlockLowering::lower_machine_function(const NcWord& word, std::span<const NcWord> words, Span span) {
    const auto value_of = [&](char letter) -> std::optional<ExpressionId> {
        const auto found = std::ranges::find_if(
            words, [&](const NcWord& w) { return w.letter == letter && !w.comma && w.value.has_value(); });
        return found == words.end() ? std::nullopt : found->value;
    };
    const Span here = this->span(*word.node);
    if (own_call(word) != nullptr) return lower_own_subprogram(word, here);
    if (*word.literal == 0 || *word.literal == 1) effect({Stop{Stop::Kind::pause, std::nullopt}, here});
    if (*word.literal == 2 || *word.literal == 30) effect({Stop{Stop::Kind::end, std::nullopt}, here});
    if (*word.literal == 6) effect({ToolChange{}, here});
    if (*word.literal == 98) lower_subprogram_call(calls::m98, word, words, span);
    if (*word.literal == 198) lower_subprogram_call(calls::m198, word, words, span);
    if (*word.literal == 99) lower_return(value_of('P'), span);
    if (*word.literal == 97) // Haas
        if (const std::optional<ExpressionId> label = value_of('P')) lower_local_call(*label, span);
}

/// `M99 P10` is a jump where it stays in its program.
void BlockLowering::lower_return(std::optional<ExpressionId> label, Span span) {
    if (label && return_jumps_in_program(*program_->control))
        effect({Jump{*label}, span});
    else
        effect({Return{std::nullopt, label}, span});
}

/// The blocks from a label to M99 run as a subprogram of this program. They may run, reading goes on here,
/// and what they have done by then is not known.
void BlockLowering::lower_local_call(ExpressionId label, Span span) {
    const std::size_t first = builder_->effect_count();
    effect({Jump{label}, span});
    guard(unreadable(span), first, span);
    effect({Call{unreadable(span), calls::m98, {}, std::nullopt}, span});
}

/// Whether the digits of `P51002` are repeats and a program number of four digits.
bool BlockLowering::holds_repeats(const NcWord& program) const {
    if (!program_word_holds_repeats(*program_->control)) return false;
    if (program_->number && *program_->number > 9999) return false; // longer numbers are in use here
    constexpr double longest = 99'999'999;
    return program.literal && *program.literal > 9999 && *program.literal <= longest &&
           std::floor(*program.literal) == *program.literal && std::fmod(*program.literal, 10000) != 0;
}

void BlockLowering::lower_subprogram_call(CallKindId kind, const NcWord& code, std::span<const NcWord> words,
                                          Span span) {
    Call call{std::monostate{}, kind, {}, std::nullopt};
    const NcWord* program = nullptr;
    std::optional<ExpressionId> label;
    for (const NcWord& word : words) {
        if (word.comma) continue;
        if (word.letter == 0) call.program = Text{this->span(*word.node)};
        if (word.letter == 'P' && word.value) program = &word;
        if (word.letter == 'L' && word.value) call.repeat = word.value;
        if (word.letter == 'Q' && word.value) label = word.value;
    }
    if (program != nullptr && !call.repeat && holds_repeats(*program)) {
        const Span where = expression(*program->value).span;
        call.program = literal(std::fmod(*program->literal, 10000), where);
        call.repeat = literal(std::floor(*program->literal / 10000), where);
    } else if (program != nullptr) {
        call.program = *program->value;
    }
    const bool names_program = !std::holds_alternative<std::monostate>(call.program);
    if (!names_program && label) { // M98 Q100: from N100 of this program
        lower_local_call(*label, span);
        return;
    }
    if (!names_program) report_missing_program(code, words);
    effect({call, span});
}

/// At the P, where one stands there without its number.
void BlockLowering::report_missing_program(const NcWord& code, std::span<const NcWord> words) {
    const auto names_one = [&](const Node& node) {
        return is_remark(node) && node.span.begin > code.node->span.begin && names_a_file(text(node));
    };
    const auto empty = std::ranges::find_if(
        words, [](const NcWord& word) { return word.letter == 'P' && !word.comma && !word.value; });
    Span place = span(*code.node);
    if (empty != words.end())
        place = {span(*empty->node).begin, span(*empty->node).begin + 1};
    else if (std::ranges::any_of(tree_->nodes, names_one))
        return;
    syntax_errors_.push_back(
        {SyntaxErrorKind::call_without_program, place, std::string(text(*code.node)), "P"});
}

/// `G52 X0 Y0 Z0` ends the shift; any other value may begin one.
void BlockLowering::set_local_offset(std::span<const NcWord> words, Span span) {
    if (codes_.local_offset == no_group) return;
    bool named = false;
    bool shifts = false;
    for (const NcWord& word : words) {
        if (word.comma || !codes_.is_axis(word.letter) || !word.value) continue;
        named = true;
        shifts |= !word.literal || *word.literal != 0;
    }
    if (!named) return;
    effect({SetModal{codes_.local_offset, literal(shifts ? 52 : 0, span)}, span});
}

} // namespace maclint::fanuc
