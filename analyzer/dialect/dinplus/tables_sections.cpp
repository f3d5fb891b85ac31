//! Sections: what each holds, and the words that begin them.
#include "analyzer/dialect/dinplus/tables.hpp"
#include "analyzer/dialect/dinplus/tables_parts.hpp"

#include <algorithm>
#include <string>

namespace maclint::dinplus {
namespace {

using Role = SectionKind::Role;
using Use = SectionWord::Use;

// The seed prints the words in translation; the English ones are those of the control [dinplus.md 2.2, 2.4].
// clang-format off
constexpr SectionWord words[] = {
    {"PROGRAM HEAD",       "PROGRAM HEAD",       Use::english,    "l.2692"},
    {"PROGRAMMKOPF",       "PROGRAM HEAD",       Use::german,     "l.2692"},
    {"OHJELMAN OTSIKKO",   "PROGRAM HEAD",       Use::translated, "l.2657"},
    {"CHUCKING EQUIPMENT", "CHUCKING EQUIPMENT", Use::english,    "l.2756"},
    {"CLAMPING DEVICE",    "CHUCKING EQUIPMENT", Use::older,      "CNC PILOT 4290"},
    {"SPANNMITTEL",        "CHUCKING EQUIPMENT", Use::german,     "l.2756"},
    {"KIINNITYSLAITE",     "CHUCKING EQUIPMENT", Use::translated, "l.2658"},
    {"TURRET",             "TURRET",             Use::english,    "l.2791"},
    {"REVOLVER",           "TURRET",             Use::german,     "l.2791"},
    {"REVOLVERI",          "TURRET",             Use::translated, "l.2120"},
    {"REVOLEVRI",          "TURRET",             Use::translated, "l.2659"},
    {"MAGAZINE",           "MAGAZINE",           Use::english,    "l.2807"},
    {"MAGAZIN",            "MAGAZINE",           Use::german,     "l.2807"},
    {"MAKASIINI",          "MAGAZINE",           Use::translated, "l.2660"},
    {"MANUAL TOOL",        "MANUAL TOOL",        Use::english,    "l.2815"},
    {"HANDWERKZEUG",       "MANUAL TOOL",        Use::german,     "l.2815"},
    {"CONTOUR",            "CONTOUR",            Use::english,    "l.2823"},
    {"CONTOUR GROUP",      "CONTOUR",            Use::english,    "l.2823"},
    {"KONTUR",             "CONTOUR",            Use::german,     "l.2823"},
    {"KONTURGRUPPE",       "CONTOUR",            Use::german,     "l.2823"},
    {"MUOTO",              "CONTOUR",            Use::translated, "l.2925"},
    {"MUOTORYHMÄ",         "CONTOUR",            Use::translated, "l.2663"},
    {"BLANK",              "BLANK",              Use::english,    "l.2838"},
    {"ROHTEIL",            "BLANK",              Use::german,     "l.2838"},
    {"AIHIO",              "BLANK",              Use::translated, "l.2664"},
    {"FINISHED",           "FINISHED",           Use::english,    "l.2842"},
    {"FINISHED PART",      "FINISHED",           Use::older,      "CNC PILOT 640, 12/2017"},
    {"FERTIGTEIL",         "FINISHED",           Use::german,     "l.2842"},
    {"VALMISOSA",          "FINISHED",           Use::translated, "l.2665"},
    {"AUXIL_BLANK",        "AUXIL_BLANK",        Use::english,    "l.2846"},
    {"HILFSROHTEIL",       "AUXIL_BLANK",        Use::german,     "l.2846"},
    {"APUAIHIO",           "AUXIL_BLANK",        Use::translated, "l.2667"},
    {"AUXIL_CONTOUR",      "AUXIL_CONTOUR",      Use::english,    "l.2850"},
    {"AUXILIARY CONTOUR",  "AUXIL_CONTOUR",      Use::older,      "CNC PILOT 4290"},
    {"HILFSKONTUR",        "AUXIL_CONTOUR",      Use::german,     "l.2850"},
    {"APUMUOTO",           "AUXIL_CONTOUR",      Use::translated, "l.2666"},
    {"FACE_C",             "FACE_C",             Use::english,    "l.2854"},
    {"FRONT",              "FACE_C",             Use::older,      "CNC PILOT 4290"},
    {"STIRN",              "FACE_C",             Use::german,     "l.2643"},
    {"OTSAPINTA",          "FACE_C",             Use::translated, "l.2669"},
    {"REAR_C",             "REAR_C",             Use::english,    "l.2854"},
    {"REAR SIDE",          "REAR_C",             Use::older,      "CNC PILOT 4290"},
    {"RUECKSEITE",         "REAR_C",             Use::german,     "l.2854"},
    {"TAKAPINTA",          "REAR_C",             Use::translated, "l.2670"},
    {"LATERAL_C",          "LATERAL_C",          Use::english,    "l.2862"},
    {"SURFACE",            "LATERAL_C",          Use::older,      "CNC PILOT 4290"},
    {"MANTEL",             "LATERAL_C",          Use::german,     "l.2862"},
    {"VAIPPA",             "LATERAL_C",          Use::translated, "l.2671"},
    {"VAIPPAPINTA",        "LATERAL_C",          Use::translated, "l.2690"},
    {"FACE_Y",             "FACE_Y",             Use::english,    "l.2870"},
    {"FRONT_Y",            "FACE_Y",             Use::older,      "l.2870"},
    {"STIRN_Y",            "FACE_Y",             Use::german,     "l.2870"},
    {"OTSAPINTA Y",        "FACE_Y",             Use::translated, "l.2673"},
    {"REAR_Y",             "REAR_Y",             Use::english,    "l.2870"},
    {"RUECKSEITE_Y",       "REAR_Y",             Use::german,     "l.2870"},
    {"TAKAPINTA Y",        "REAR_Y",             Use::translated, "l.2674"},
    {"LATERAL_Y",          "LATERAL_Y",          Use::english,    "l.2880"},
    {"SURFACE Y",          "LATERAL_Y",          Use::older,      "l.2880"},
    {"MANTEL_Y",           "LATERAL_Y",          Use::german,     "l.2880"},
    {"VAIPPA Y",           "LATERAL_Y",          Use::translated, "l.2675"},
    {"MACHINING",          "MACHINING",          Use::english,    "l.2935"},
    {"BEARBEITUNG",        "MACHINING",          Use::german,     "l.2935"},
    {"KONEISTUS",          "MACHINING",          Use::translated, "l.2677"},
    {"END",                "END",                Use::english,    "l.2939"},
    {"ENDE",               "END",                Use::german,     "l.2939"},
    {"LOPPU",              "END",                Use::translated, "l.2678"},
    {"LOPPUUN",            "END",                Use::translated, "l.2166"},
    {"SUBPROGRAM",         "SUBPROGRAM",         Use::english,    "l.2943"},
    {"UNTERPROGRAMM",      "SUBPROGRAM",         Use::german,     "l.2943"},
    {"ALIOHJELMA",         "SUBPROGRAM",         Use::translated, "l.2680"},
    {"CONST",              "CONST",              Use::english,    "l.2951"},
    {"VAR",                "VAR",                Use::english,    "l.2976"},
    {"ASSIGNMENT",         "ASSIGNMENT",         Use::english,    "l.2999"},
    {"ZUORDNUNG",          "ASSIGNMENT",         Use::german,     "l.2999"},
    {"LUISTIJÄRJESTELY",   "ASSIGNMENT",         Use::translated, "l.2686"},
    {"OSOITUS",            "ASSIGNMENT",         Use::translated, "l.25948"},
};
// clang-format on

} // namespace

std::vector<SectionKind> section_kinds() {
    // clang-format off
    return {
        {"PROGRAM HEAD",       Role::information, false, "l.2692"},
        {"CHUCKING EQUIPMENT", Role::information, false, "l.2756"},
        {"TURRET",             Role::information, false, "l.2791"},
        {"MAGAZINE",           Role::information, false, "l.2807"},
        {"MANUAL TOOL",        Role::information, false, "l.2815"},
        {"CONST",              Role::information, false, "l.2951"},
        {"VAR",                Role::information, false, "l.2976"},
        {"CONTOUR",            Role::contour,     false, "l.2823"},
        {"BLANK",              Role::contour,     false, "l.2838"},
        {"FINISHED",           Role::contour,     false, "l.2842"},
        {"AUXIL_BLANK",        Role::contour,     false, "l.2846"},
        {"AUXIL_CONTOUR",      Role::contour,     false, "l.2850"},
        {"FACE_C",             Role::contour,     false, "l.2854"},
        {"REAR_C",             Role::contour,     false, "l.2854"},
        {"LATERAL_C",          Role::contour,     false, "l.2862"},
        {"FACE_Y",             Role::contour,     false, "l.2870"},
        {"REAR_Y",             Role::contour,     false, "l.2870"},
        {"LATERAL_Y",          Role::contour,     false, "l.2880"},
        {"ASSIGNMENT",         Role::machining,   false, "l.2999"},
        {"MACHINING",          Role::machining,   true,  "l.2223, l.2622, l.2937"},
        {"SUBPROGRAM",         Role::subprogram,  false, "l.2943"},
        {"END",                Role::end,         true,  "l.2941"},
    };
    // clang-format on
}

std::span<const SectionWord> section_words() { return words; }

const SectionWord* find_section_word(std::string_view word) {
    std::string plain;
    for (const char c : word) {
        const bool blank = c == ' ' || c == '_' || c == '\t';
        if (!blank)
            plain += c;
        else if (!plain.empty() && plain.back() != ' ')
            plain += ' ';
    }
    while (!plain.empty() && plain.back() == ' ') plain.pop_back();
    const auto same = [](char a, char b) { return a == b || (a == '_' && b == ' '); };
    const auto* found = std::ranges::find_if(
        words, [&](const SectionWord& row) { return std::ranges::equal(row.word, plain, same); });
    return found == std::end(words) ? nullptr : found;
}

} // namespace maclint::dinplus
