//! The words that shape a program.
#include "analyzer/dialect/sinumerik/keywords.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/sinumerik/g_codes.hpp"
#include "analyzer/dialect/sinumerik/lexer.hpp"
#include "analyzer/dialect/sinumerik/words.hpp"

#include <algorithm>
#include <iterator>
#include <span>

namespace maclint::sinumerik {
namespace {

constexpr std::string_view openers[] = {"IF", "ELSE", "FOR", "WHILE", "LOOP", "REPEAT", "UNTIL"};
constexpr std::string_view closers[] = {"ENDIF", "ENDFOR", "ENDWHILE", "ENDLOOP"};
constexpr std::string_view jumps[] = {"GOTOF", "GOTOB", "GOTO", "GOTOC"};
constexpr std::string_view of_others[] = {"THEN", "ELSEIF", "ELSIF", "ELIF", "ENDW", "ENDREPEAT"};

std::string_view one_slip_from(std::span<const std::string_view> words, std::string_view written) {
    constexpr std::size_t shortest = 4;
    if (written.size() < shortest || std::ranges::find(words, written) != words.end()) return {};
    const auto word = std::ranges::find_if(
        words, [&](std::string_view known) { return edit_distance(written, known, 1) <= 1; });
    return word == words.end() ? std::string_view{} : *word;
}

/// An exchange of neighbours, a letter lost or doubled. Where the name can be no program, it may be as short
/// as SUPA and MCALL.
bool is_typing_slip(std::string_view written, std::string_view meant, bool may_be_program = true) {
    constexpr std::size_t shortest = 4;
    if (meant.size() < shortest || written == meant) return false;
    const auto at = static_cast<std::size_t>(std::ranges::mismatch(written, meant).in1 - written.begin());
    const std::string_view rest = written.substr(at), rest_meant = meant.substr(at);
    if (written.size() == meant.size())
        return rest.size() >= 2 && rest[0] == rest_meant[1] && rest[1] == rest_meant[0] &&
               rest.substr(2) == rest_meant.substr(2);
    if (meant.size() == shortest && may_be_program) return false; // too many names are as near
    // LIFT and ROTA are names of their own, no TLIFT and PROTA.
    const std::size_t shortest_with_a_loss = may_be_program ? 6 : 5;
    if (written.size() + 1 == meant.size())
        return at > 0 && meant.size() >= shortest_with_a_loss && rest == rest_meant.substr(1);
    return written.size() == meant.size() + 1 && at > 0 && rest[0] == written[at - 1] &&
           rest.substr(1) == rest_meant;
}

/// Words that stand at the head of a block without an `=` behind them.
bool is_command(const WordRow& row) {
    return row.kind == WordKind::procedure || row.name == "MCALL" || row.name == "PCALL";
}

/// What may stand behind DEF: a type, or the places that know the variable.
bool begins_definition(std::string_view word) {
    return word == "CHAN" || word == "NCK" || std::ranges::find(type_names, word) != std::end(type_names);
}

} // namespace

bool is_structural(std::string_view capitals) {
    const auto holds = [&](std::span<const std::string_view> words) {
        return std::ranges::find(words, capitals) != words.end();
    };
    return holds(openers) || holds(closers) || holds(of_others) ||
           !one_slip_from(closers, capitals).empty() || !one_slip_from(openers, capitals).empty();
}

std::string_view closer_meant_by(std::string_view capitals) {
    if (capitals == "ENDW") return "ENDWHILE"; // of other languages
    if (capitals == "ENDREPEAT") return "UNTIL";
    return one_slip_from(closers, capitals);
}
std::string_view opener_meant_by(std::string_view capitals) { return one_slip_from(openers, capitals); }
bool is_foreign_loop_word(std::string_view capitals) {
    const bool numbered = !capitals.empty() && is_digit(capitals.back());
    if (numbered) capitals.remove_suffix(1);
    return numbered && (capitals == "DO" || capitals == "END");
}
std::string_view bare_opener_meant_by(std::string_view capitals) {
    // A program may have any name, LOOK and LOOPS: what is typed in haste is another thing.
    static constexpr std::string_view bare[] = {"ELSE", "LOOP", "REPEAT"};
    const auto* word =
        std::ranges::find_if(bare, [&](std::string_view known) { return is_typing_slip(capitals, known); });
    return word == std::end(bare) ? std::string_view{} : *word;
}
std::string_view jump_meant_by(std::string_view capitals) { return one_slip_from(jumps, capitals); }

std::string_view declaration_meant_by(std::string_view capitals, std::string_view behind, bool at_the_begin) {
    const auto is_near = [&](std::string_view word) { return edit_distance(capitals, word, 1) <= 1; };
    const std::string_view type = behind.substr(0, behind.find('['));
    if (begins_definition(type)) return is_near("DEF") ? "DEF" : "";
    const bool is_name = behind.size() > 1 && begins_name(behind[0]) && begins_name(behind[1]);
    if (!is_name) return {};
    if (at_the_begin && is_near("PROC")) return "PROC";
    return is_typing_slip(capitals, "EXTERN") ? "EXTERN" : "";
}

std::string_view command_meant_by(std::string_view capitals, bool may_be_program) {
    for (const WordRow& row : words())
        if (is_command(row) && is_typing_slip(capitals, row.name, may_be_program)) return row.name;
    for (const GCodeRow& row : g_codes())
        if (std::ranges::none_of(row.name, is_digit) && is_typing_slip(capitals, row.name, may_be_program))
            return row.name;
    return {};
}

std::string_view cycle_meant_by(std::string_view capitals) {
    const auto number_of = [](std::string_view name) {
        return name.substr(std::min(name.find_first_of("0123456789"), name.size()));
    };
    // HOLE2 and POCKE3 may be programs of the shop.
    const auto may_be_meant = [&](const WordRow& row) {
        return row.kind == WordKind::cycle && number_of(row.name) == number_of(capitals) &&
               (row.name.starts_with("CYCLE") || capitals.size() >= row.name.size());
    };
    for (const WordRow& row : words())
        if (may_be_meant(row) && is_typing_slip(capitals, row.name)) return row.name;
    return {};
}

} // namespace maclint::sinumerik
