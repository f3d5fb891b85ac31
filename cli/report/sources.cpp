//! The rows of docs/sources.md; a test holds both together.
#include "cli/report/sources.hpp"

#include <algorithm>
#include <array>

namespace maclint::cli {
namespace {

struct SourceRow {
    std::string_view key;
    std::string_view document;
};

// clang-format off
constexpr std::array<SourceRow, 30> rows{{
    {"SEED-001",
     "Joni Nieminen, Parametriohjelmointi FANUC 21i-MB -ohjauksessa, thesis, Tampere 2005: "
     "macro programming on a FANUC 21i-MB, with programs that were run on the machine. Lines "
     "of its text"},
    {"SEED-002",
     "Article in Hungarian on the development of macro programs for the NCT 104-M, a FANUC "
     "look-alike. Lines of its text"},
    {"SEED-003",
     "HEIDENHAIN, user's manual smart.Turn and DIN programming for CNC PILOT 640 and "
     "MANUALplus 620, Finnish, edition 01/2022. Lines of its text"},
    {"MAN-PB278",
     "FANUC Series 16i/18i/160i/180i-PB, operator's manual B-63684EN/01, page 278"},
    {"MAN-16C287",
     "FANUC Series 16/18/160/180-C for lathe, operator's manual, page 287"},
    {"NCT-9",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"NCT-171",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"NCT-173",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"NCT-174",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"NCT-188",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"MAN-AINANO",
     "FANUC A-78962EN, 16i/18i/21i-TB additional manual, section 7, notes on using custom macros"},
    {"HAAS-LA",
     "Haas, mill operator's manual 96-8000, chapter on look-ahead in macros"},
    {"HAAS-118",
     "Haas, mill operator's manual 96-8000, page 118: expressions of macros"},
    {"MITSU-326",
     "Mitsubishi M700V, programming manual, page 326"},
    {"RW-9",
     "Rockwell 9/Series CNC, operation and programming manual, nesting of subprograms"},
    {"INTELITEK-M99",
     "intelitek proMILL, manual, return from a subprogram with M99"},
    {"SINHA-EXP",
     "S. K. Sinha, CNC Programming Using Fanuc Custom Macro B, chapter on macro expressions"},
    {"CNCWIKI-CALL",
     "Articles of a CNC encyclopedia on the web: macro calls with G65, G66 and G67; logical "
     "operators; custom macro B; subprograms"},
    {"CNCWIKI-LOGIC",
     "Articles of a CNC encyclopedia on the web: macro calls with G65, G66 and G67; logical "
     "operators; custom macro B; subprograms"},
    {"CNCWIKI-MACB",
     "Articles of a CNC encyclopedia on the web: macro calls with G65, G66 and G67; logical "
     "operators; custom macro B; subprograms"},
    {"CNCWIKI-SUB",
     "Articles of a CNC encyclopedia on the web: macro calls with G65, G66 and G67; logical "
     "operators; custom macro B; subprograms"},
    {"CSDN-PS",
     "Articles in Chinese on FANUC P/S alarms and on macro variables, written after the "
     "manuals"},
    {"CSDN-VAR",
     "Articles in Chinese on FANUC P/S alarms and on macro variables, written after the "
     "manuals"},
    {"IMD-114",
     "Questions and answers of an automation forum: alarm 114 and its comparisons; the "
     "greatest Z of a probing cycle"},
    {"IMD-MAXZ",
     "Questions and answers of an automation forum: alarm 114 and its comparisons; the "
     "greatest Z of a probing cycle"},
    {"ZAPP-ARG",
     "Pages of a consultant on macro programming: argument letters and their variables"},
    {"ISORP",
     "Linter of the macro-executor extension for Visual Studio Code by iSorp, open source: "
     "what another linter reports"},
    {"GH-ALM",
     "Alarm list of the FANUC 30i generation in a public macro interpreter. It is not a "
     "manual, and single entries of it are shifted"},
    {"T",
     "Experience of those who wrote the rule. No document at hand confirms it; a correction "
     "with a document is welcome"},
    {"maclint's own",
     "maclint itself: its comments, options and limits"},
}};
// clang-format on

} // namespace

std::string_view document_of(std::string_view source) {
    const auto is_key = [&](const SourceRow& row) {
        const std::string_view rest = source.substr(std::min(source.size(), row.key.size()));
        return source.starts_with(row.key) && (rest.empty() || rest.front() == ':' || rest.front() == ' ');
    };
    const auto row = std::ranges::find_if(rows, is_key);
    return row == rows.end() ? std::string_view() : row->document;
}

} // namespace maclint::cli
