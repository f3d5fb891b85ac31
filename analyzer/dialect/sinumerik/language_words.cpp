//! All words with what they are; what some mean stands in rows, that of cycles and functions in their tables.
#include "analyzer/dialect/sinumerik/language_words.hpp"

#include "analyzer/dialect/sinumerik/cycles.hpp"
#include "analyzer/dialect/sinumerik/functions.hpp"
#include "analyzer/dialect/sinumerik/system_variables.hpp"
#include "analyzer/dialect/sinumerik/words.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace maclint::sinumerik {
namespace {

struct Meaning {
    std::string_view word, what, source;
};

// clang-format off
constexpr Meaning meanings[] = {
    {"ACTBLOCNO", "shows the block numbers of the program itself",                  "T"},
    {"AP",        "angle of a polar position",                                      "T"},
    {"AR",        "angle of an arc",                                                "T"},
    {"CALL",      "calls the program of a name",                                    "T"},
    {"CASE",      "jumps by a value: CASE (value) OF 1 GOTOF …, DEFAULT GOTOF …",   "CNCWIKI-LOGIC, T"},
    {"CHF",       "length of a chamfer",                                            "T"},
    {"CHR",       "width of a chamfer",                                             "T"},
    {"CR",        "radius of an arc",                                               "T"},
    {"DEF",       "declares a variable of the program",                             "T"},
    {"DEFAULT",   "jumps where no value of CASE fits",                              "CNCWIKI-LOGIC, T"},
    {"DISPLOF",   "shows the caller's block while the program runs",                "T"},
    {"ELSE",      "what is done where the condition of IF does not hold",           "SEED-004:509"},
    {"ENDFOR",    "end of FOR",                                                     "SEED-004:521"},
    {"ENDIF",     "end of IF",                                                      "SEED-004:511"},
    {"ENDLABEL",  "end of a part that REPEAT runs again",                           "T"},
    {"ENDLOOP",   "end of LOOP",                                                    "SEED-004:521"},
    {"ENDPROC",   "end of the program",                                             "T"},
    {"ENDWHILE",  "end of WHILE",                                                   "SEED-004:521"},
    {"EXTCALL",   "calls a program that lies outside of the control's memory",      "T"},
    {"EXTERN",    "declares the parameters of a program that lies elsewhere",       "T"},
    {"FOR",       "FOR variable = first TO last … ENDFOR",                          "SEED-004:521"},
    {"GOTO",      "jump to a label or block, forward at first, then backward",      "T"},
    {"GOTOB",     "jump backward to a label or block",                              "SEED-004:560"},
    {"GOTOC",     "GOTO without an alarm where the label is missing",               "T"},
    {"GOTOF",     "jump forward to a label or block",                               "SEED-004:560"},
    {"GOTOS",     "jump to the beginning of the program",                           "T"},
    {"IF",        "IF condition … ELSE … ENDIF, or a jump where the condition holds", "SEED-004:509"},
    {"ISOCALL",   "calls a program in the language of another control",             "T"},
    {"LIMS",      "greatest speed of the spindle",                                  "T"},
    {"LOOP",      "repeated up to ENDLOOP without an end of its own",               "SEED-004:521"},
    {"MCALL",     "calls the program after each move; alone it ends that",          "SEED-004:460"},
    {"MSG",       "shows a message",                                                "SEED-004:478"},
    {"PCALL",     "calls a program by its path",                                    "T"},
    {"PROC",      "name and parameters of the program",                             "T"},
    {"REPEAT",    "repeated up to UNTIL; with labels: runs a part again",           "SEED-004:521"},
    {"REPEATB",   "runs one block again",                                           "T"},
    {"RET",       "back to the caller",                                             "T"},
    {"RND",       "radius of a rounded corner",                                     "T"},
    {"RP",        "radius of a polar position",                                     "T"},
    {"SAVE",      "gives the caller its modal G codes and frame back",              "T"},
    {"SBLOF",     "no stop between the blocks in single block mode",                "T"},
    {"SETAL",     "shows an alarm",                                                 "T"},
    {"SPOS",      "turns the spindle to an angle",                                  "T"},
    {"STOPRE",    "waits until the blocks before are done; look-ahead stops here",  "CNCWIKI-LOGIC"},
    {"TURN",      "whole circles of a helix",                                       "T"},
    {"UNTIL",     "end of REPEAT, where the condition holds",                       "SEED-004:521"},
    {"VAR",       "the parameter is the variable of the caller",                    "T"},
    {"WHILE",     "repeated while the condition holds, up to ENDWHILE",             "SEED-004:521"},
};
// clang-format on
static_assert(std::ranges::is_sorted(meanings, {}, &Meaning::word));

WordUse use_of(WordKind kind) {
    switch (kind) {
    case WordKind::keyword: return WordUse::keyword;
    case WordKind::function: return WordUse::function;
    case WordKind::cycle: return WordUse::cycle;
    case WordKind::address: return WordUse::address;
    case WordKind::attribute: return WordUse::attribute;
    case WordKind::constant: return WordUse::constant;
    case WordKind::part: return WordUse::part;
    case WordKind::procedure:
    case WordKind::command: break;
    }
    return WordUse::statement;
}

LanguageWord word_of(const WordRow& row) {
    LanguageWord word{row.name, use_of(row.kind), "", ""};
    const auto* const meaning = std::ranges::lower_bound(meanings, row.name, {}, &Meaning::word);
    if (meaning != std::end(meanings) && meaning->word == row.name) {
        word.what = meaning->what;
        word.source = meaning->source;
    } else if (const CycleRow* cycle = find_cycle(row.name)) {
        word.what = cycle->what;
        word.source = "T";
    } else if (const FunctionRow* function = find_function(row.name)) {
        word.what = what_it_computes(function->operation);
        word.source = "T";
    }
    return word;
}

std::vector<LanguageWord> all_words() {
    std::vector<LanguageWord> all;
    for (const WordRow& row : words()) all.push_back(word_of(row));
    return all;
}

// SEED-004:460, 547-563; T
constexpr NamePlace name_places[] = {
    {NamePlace::Names::program, "CALL", "CALL \""},  {NamePlace::Names::program, "EXTCALL", "EXTCALL \""},
    {NamePlace::Names::program, "MCALL", "MCALL"},   {NamePlace::Names::block, "GOTO", "GOTO"},
    {NamePlace::Names::block, "GOTOF", "GOTOF"},     {NamePlace::Names::block, "GOTOB", "GOTOB"},
    {NamePlace::Names::block, "GOTOC", "GOTOC"},     {NamePlace::Names::block, "REPEAT", "REPEAT"},
    {NamePlace::Names::block, "REPEATB", "REPEATB"},
};

/// Units, returns, lengths of tools, turned coordinates and canned cycles of FANUC and its like, which here
/// have other names or none [T].
constexpr std::string_view foreign_codes[] = {"G20", "G21", "G28", "G30", "G43", "G44", "G49", "G52", "G68",
                                              "G69", "G73", "G76", "G80", "G81", "G82", "G83", "G84", "G85",
                                              "G86", "G87", "G88", "G89", "G92", "G98", "G99"};
static_assert(std::ranges::is_sorted(foreign_codes));

std::string_view name_of(SystemType type) {
    switch (type) {
    case SystemType::integer: return "INT";
    case SystemType::real: return "REAL";
    case SystemType::truth: return "BOOL";
    case SystemType::character: return "CHAR";
    case SystemType::text: return "STRING";
    case SystemType::axis: return "AXIS";
    case SystemType::frame: return "FRAME";
    }
    return {};
}

std::string about_system_variable(std::string_view name) {
    const auto variable = find_system_variable(name);
    if (!variable) return {};
    std::string about(name_of(variable->type));
    if (variable->indices > 0)
        about +=
            ", with " + std::to_string(variable->indices) + (variable->indices == 1 ? " index" : " indices");
    if (const std::string_view held = held_by_read_only(name); !held.empty())
        about += "; " + std::string(held) + ", can only be read";
    if (is_kept_for_programs(name)) about += "; holds what programs store in it";
    if (is_main_run_variable(name)) about += "; a read waits until the blocks before it have run";
    return about;
}

} // namespace

LanguageTables language_words() {
    static const std::vector<LanguageWord> all = all_words();
    static const std::vector<BroughtCycle> cycles = brought_cycles();
    return {all, name_places, cycles, &about_system_variable, foreign_codes};
}

} // namespace maclint::sinumerik
