//! The words that shape a program.
#include "analyzer/dialect/sinumerik/keywords.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/near_names.hpp"
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

namespace {

/// No program can stand where a value does.
std::string_view word_meant_by(std::string_view capitals, WordKind kind) {
    for (const WordRow& row : words())
        if (row.kind == kind && is_typing_slip(capitals, row.name, false)) return row.name;
    return {};
}

} // namespace

std::string_view function_meant_by(std::string_view capitals) {
    return word_meant_by(capitals, WordKind::function);
}

std::string_view value_meant_by(std::string_view capitals) {
    return word_meant_by(capitals, WordKind::constant);
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
