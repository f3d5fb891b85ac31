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
constexpr std::array<SourceRow, 138> rows{{
    {"SEED-001",
     "Joni Nieminen, Parametriohjelmointi FANUC 21i-MB -ohjauksessa, thesis, Tampere 2005: macro "
     "programming on a FANUC 21i-MB, with programs that were run on the machine. Lines of its text"},
    {"SEED-002",
     "Article in Hungarian on the development of macro programs for the NCT 104-M, a FANUC look-alike. "
     "Lines of its text"},
    {"SEED-003",
     "HEIDENHAIN, user's manual smart.Turn and DIN programming for CNC PILOT 640 and MANUALplus 620, "
     "Finnish, edition 01/2022. Lines of its text"},
    {"MAN-PB129",
     "FANUC Series 16i/18i/160i/180i-PB, operator's manual B-63684EN/01, page 129"},
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
    {"NCT-185",
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
    {"SINHA-INT",
     "S. K. Sinha, CNC Programming Using Fanuc Custom Macro B, chapter on real and integer values"},
    {"CNCWIKI-ARG",
     "Articles of a CNC encyclopedia on the web: macro calls with G65, G66 and G67 and their "
     "arguments; logical operators; custom macro B; subprograms"},
    {"CNCWIKI-CALL",
     "Articles of a CNC encyclopedia on the web: macro calls with G65, G66 and G67 and their "
     "arguments; logical operators; custom macro B; subprograms"},
    {"CNCWIKI-LOGIC",
     "Articles of a CNC encyclopedia on the web: macro calls with G65, G66 and G67 and their "
     "arguments; logical operators; custom macro B; subprograms"},
    {"CNCWIKI-MACB",
     "Articles of a CNC encyclopedia on the web: macro calls with G65, G66 and G67 and their "
     "arguments; logical operators; custom macro B; subprograms"},
    {"CNCWIKI-SUB",
     "Articles of a CNC encyclopedia on the web: macro calls with G65, G66 and G67 and their "
     "arguments; logical operators; custom macro B; subprograms"},
    {"CSDN-PS",
     "Articles in Chinese on FANUC P/S alarms and on macro variables, written after the manuals"},
    {"CSDN-VAR",
     "Articles in Chinese on FANUC P/S alarms and on macro variables, written after the manuals"},
    {"IMD-0M",
     "Questions and answers of an automation forum: alarm 114 and its comparisons; brackets on a 0-MC; "
     "alarm SR5010 of a 0i-TD; the greatest Z of a probing cycle"},
    {"IMD-114",
     "Questions and answers of an automation forum: alarm 114 and its comparisons; brackets on a 0-MC; "
     "alarm SR5010 of a 0i-TD; the greatest Z of a probing cycle"},
    {"IMD-5010",
     "Questions and answers of an automation forum: alarm 114 and its comparisons; brackets on a 0-MC; "
     "alarm SR5010 of a 0i-TD; the greatest Z of a probing cycle"},
    {"IMD-MAXZ",
     "Questions and answers of an automation forum: alarm 114 and its comparisons; brackets on a 0-MC; "
     "alarm SR5010 of a 0i-TD; the greatest Z of a probing cycle"},
    {"TENC-SYS",
     "Articles in Chinese on the web: the chapter on G65 of the 0i manual; system variables in use"},
    {"CNCCI",
     "Article on the web on macro alarms for dangerous situations"},
    {"ZAPP-ARG",
     "Pages of a consultant on macro programming: argument letters and their variables"},
    {"IMD-IO",
     "Article of an automation forum on the inputs and outputs of FANUC controls that a program "
     "reaches: #1000 to #1015 can only be read (industrialmonitordirect.com, "
     "accessing-fanuc-user-interface-io-without-modifying-pmc-ladder)"},
    {"TENC-G65",
     "Article in Chinese after the manual of the FANUC 0i: macro calls with G65 "
     "(cloud.tencent.com/developer/article/2004204)"},
    {"CPH-M98",
     "Guide on the web to subprogram calls with M98 (cncprogramminghub.com)"},
    {"ZAPP-ALM",
     "Pages of a consultant on macro programming: alarms and timers (zappettiniconsulting.com/wiki)"},
    {"ZAPP-HAAS",
     "Pages of a consultant on macro programming: system variables of Haas, new numbers beside the old "
     "ones (zappettiniconsulting.com/wiki/haas-system-variables)"},
    {"ZAPP-MATH",
     "Pages of a consultant on macro programming: operators and functions "
     "(zappettiniconsulting.com/wiki/macro-arithmetic)"},
    {"MITSU-389",
     "Mitsubishi M700V, programming manual, page 389: modal values in an interruption macro"},
    {"ISORP",
     "Linter of the macro-executor extension for Visual Studio Code by iSorp, open source: what "
     "another linter reports"},
    {"GH-ALM",
     "Alarm list of the FANUC 30i generation in a public macro interpreter. It is not a manual, and "
     "single entries of it are shifted"},
    {"CSDN-CYC",
     "Articles in Chinese on the canned cycles of FANUC mills, with the words of each, written after "
     "the manuals"},
    {"CSDN-CYC2",
     "Articles in Chinese on the canned cycles of FANUC mills, with the words of each, written after "
     "the manuals"},
    {"F15-71",
     "FANUC Series 15i/150i-MA, operator's manual (programming), the page of that number in its public "
     "copy"},
    {"F15-104",
     "FANUC Series 15i/150i-MA, operator's manual (programming), the page of that number in its public "
     "copy"},
    {"F15-315",
     "FANUC Series 15i/150i-MA, operator's manual (programming), the page of that number in its public "
     "copy"},
    {"F15-402",
     "FANUC Series 15i/150i-MA, operator's manual (programming), the page of that number in its public "
     "copy"},
    {"F15-586",
     "FANUC Series 15i/150i-MA, operator's manual (programming), the page of that number in its public "
     "copy"},
    {"F15-779",
     "FANUC Series 15i/150i-MA, operator's manual (programming), the page of that number in its public "
     "copy"},
    {"F16C-147",
     "FANUC Series 16/18/160/180-C for machining centers, operator's manual, the page of that number "
     "in its public copy"},
    {"F16C-293",
     "FANUC Series 16/18/160/180-C for machining centers, operator's manual, the page of that number "
     "in its public copy"},
    {"F16C-365",
     "FANUC Series 16/18/160/180-C for machining centers, operator's manual, the page of that number "
     "in its public copy"},
    {"F16C-375",
     "FANUC Series 16/18/160/180-C for machining centers, operator's manual, the page of that number "
     "in its public copy"},
    {"F16D-141",
     "FANUC Series 16i/18i/160i/180i-PB, descriptions B-63682EN/01, page 117"},
    {"F0iA-618",
     "FANUC Series 0i-A, connection manual (function), the page of that number in its public copy"},
    {"F30-231",
     "FANUC Series 30i/31i/32i-A, user's manual for machining centers, the page of that number in its "
     "public copy"},
    {"F30C-99",
     "FANUC Series 30i/31i/32i-A, user's manual common to lathes and machining centers B-63944EN/02, "
     "page 65"},
    {"F30L-49",
     "FANUC Series 30i/31i/32i-A, user's manual for lathes B-63944EN-1/02, page 27"},
    {"F30D-155",
     "FANUC Series 30i/300i/300is-A, descriptions B-63942EN/02, page 125"},
    {"F30T-4",
     "FANUC A-79976E, Series 30i/31i, specifying a tilted working plane by the direction of the tool, "
     "page 4"},
    {"GSK-86",
     "GSK 980MDc, a FANUC look-alike, user manual, page 67: further work offsets"},
    {"CNCWIKI-G28",
     "Article of a CNC encyclopedia on the web: return to reference points with G28, G29 and G30"},
    {"CNCFORUM-G051",
     "Article of a CNC forum on smooth interpolation with G05.1, written after the manual"},
    {"HELM-G721",
     "Article of a machinist's site on copies of figures with G72.1, written after the manual"},
    {"YSZNH",
     "Translated list of G codes of FANUC mills on the web, with their words"},
    {"VERICUT",
     "Control file of a simulator for the FANUC 30i-M, public: which codes it knows, with which words"},
    {"SWANSC",
     "List of M codes of a machine builder on the web"},
    {"GTUTOR",
     "Lessons on CNC programs on the web: subprograms with M98 and M99"},
    {"ERRLIB-49",
     "Public library of error messages: alarm PS0049 of the FANUC 30i/31i/32i-B"},
    {"NCT-40",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"NCT-52",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"NCT-53",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"NCT-78",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"NCT-85",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"NCT-102",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"NCT-114",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"NCT-117",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"NCT-159",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"NCT-161",
     "NCT 99M/2000M, programmer's manual, the page of that number"},
    {"H99",
     "Haas, VF series operator's manual 96-8000, June 1999, the page of that number "
     "(easymanua.ls/haas/vf-series/manual/309596?p=185)"},
    {"H07",
     "Haas, mill operator's manual 96-8000 rev R, June 2007, the page of that number of the file "
     "(easymanua.ls/haas/mill/manual?p=91)"},
    {"H10",
     "Haas, mill operator's manual 96-8000 of about 2010, the page of that number of the file "
     "(easymanua.ls/haas/96-8000/manual?p=217; manualshive.com/en/manual/haas/96-8000/575891?page=102)"},
    {"HNGC",
     "Haas, mill operator's manual of the Next Generation Control, 2023, the page of that number, as a "
     "public repository quotes it"},
    {"HDIY",
     "Haas, interactive operator's manuals of mills and lathes on the web, classic and Next Generation "
     "Control, the page of that name (staging-diy.haascnc.com/g77-back-bore-canned-cycle-group-09-1)"},
    {"HCODES",
     "Pages on the web that restate the Haas mill manual code by code "
     "(gcodes.net/haas-g107-cylindrical-mapping)"},
    {"HELMAN",
     "Pages of a machinist on the web on Haas codes and addresses (helmancnc.com)"},
    {"HLIST",
     "List of the G codes of Haas mills with their groups, in Spanish, in a public repository "
     "(github.com/sebarenzi/cncinfo, codigosg.md)"},
    {"HGLIST",
     "List of the G codes of Haas lathes with their groups in the source of a public editor"},
    {"HDESC",
     "Descriptions of Haas mill codes in a public repository whose name the index does not tell"},
    {"HPASTE",
     "Appendix of a CAM book with codes of Haas mills and their words (pastebin.com/prSjxEWB)"},
    {"HCAMV",
     "Notes of a public program reader on M97 and M99 in Haas style (docs.rs, camv-rnd)"},
    {"HSCHOOL",
     "Course paper on the M codes of Haas machines (scribd.com/document/673999731)"},
    {"HUK",
     "Haas (UK), page on programmable offsets with G10 "
     "(haas.co.uk/resources/better-techniques/control-features/programmable-offsets)"},
    {"HBAR",
     "Haas, operator's manual of the bar feeder, the page of that number of the file "
     "(manualshive.com/en/manual/haas/bar-feeder/575871?page=37)"},
    {"MIYANO",
     "Miyano, service manual of the BNC-34T with a FANUC T control: G codes of system A and their "
     "groups"},
    {"GEDIT",
     "Notes on FANUC syntax in the public repository NC-PB/gEdit, written after B-63944GE/02 and "
     "B-63944GE-1/02: G code systems A, B and C side by side, words"},
    {"MAN30i-57",
     "FANUC Series 30i/31i/32i-A, user's manual for lathes B-63944EN-1/02, page 35 (57 of the file): "
     "G92, "
     "https://www.cncmanuals.com/fanuc/740/30i-300i-300is-model-a-31i-310i-310is-model-a-and-a5-32i-320i-320is-model-a-users-manual/page/57"},
    {"MAN16TB-285",
     "FANUC Series 16i/18i/160i/180i-TB, operator's manual B-63524EN/01, page 285: G10 of tool "
     "offsets, http://cncmanuals.com/fanuc/150/series-16i-18i-160i-180i-tb-operators-manual/page/311"},
    {"F0iTC-29",
     "FANUC Series 0i-TC, operator's manual B-64114EN/01, page 29, as copied on a public page: "
     "addresses that take a decimal point"},
    {"CSCH-B",
     "G codes of FANUC 30i lathes in system B, "
     "https://cncschool.pl/library/codes/ge_fanuc30i_300i_300is_lathe_system_codeb.php"},
    {"CSDN-T",
     "G codes of FANUC lathes and their groups, in Chinese, "
     "https://blog.csdn.net/garyye/article/details/4067247"},
    {"MACHINEMFG",
     "Commands of FANUC lathes with their words, https://www.machinemfg.com/fanuc-cnc-lathe-commands/"},
    {"BLOG-MRC",
     "G76 and notes on multiple repetitive cycles, "
     "http://cncprograming.blogspot.com/2011/07/multiple-thread-cutting-cycle-g76.html"},
    {"BLOG-FIX",
     "G90, G92 and G94 and their numbers in system B, "
     "http://cncprograming.blogspot.com/2011/07/fixed-cycles-for-turning.html"},
    {"BLOG-DRILL",
     "G83 and G87 of lathes, http://cncprograming.blogspot.com/2011/08/drilling-cycle-g83-or-g87.html"},
    {"HELMAN-G92",
     "Taper threads by G92, https://www.helmancnc.com/taper-threading-with-g92-threading-cycle/"},
    {"CNCFORUM-G75",
     "G75 in one and in two blocks, by series, "
     "https://en.cncforum.net/t/g75-cycle-grooving-and-parting-off/99"},
    {"CNCWIKI-G74",
     "G74 and G75 of lathes, https://cnc.wiki/en/g74-g75-lathe-grooving"},
    {"FSIM",
     "Modal groups of a public FANUC simulator"},
    {"REF-MOD",
     "Modal group table of the custom macro reference"},
    {"TENC-G74",
     "Article in Chinese on G74 of FANUC lathes and what makes its alarms, "
     "https://cloud.tencent.com/developer/article/2035679"},
    {"SZGH-67",
     "SZGH-CNC1000MDb, a FANUC look-alike, user manual, page 54: tool offset with G45 to G48"},
    {"IMD-UI",
     "Article of the same forum: interface signals of FANUC, #1000 to #1015 and #1100 to #1115"},
    {"SEED-004",
     "Article in Slovenian on programming of the SINUMERIK 840D. Lines of its text"},
    {"NCP19",
     "Siemens, SINUMERIK ONE, 840D sl, 828D, NC programming, programming manual 12/2019, "
     "6FC5398-2EP40-0BA0, the page of that number"},
    {"NCP23",
     "The same manual in German, 01/2023, A5E48764001A, the page of that number"},
    {"JP06",
     "Siemens, SINUMERIK 840D, programming manual, job planning, 03/2006, the page of that number"},
    {"JP10",
     "Siemens, SINUMERIK 828D, programming manual, job planning, 07/2010, 6FC5398-2BP40-0BA0, the page "
     "of that number"},
    {"JP11",
     "Siemens, SINUMERIK 840D sl, 828D, programming manual, job planning, in German, 02/2011, the page "
     "of that number"},
    {"PGA",
     "Siemens, SINUMERIK 840D, programming guide, advanced, 04/2000, the page of that number"},
    {"FUND04",
     "Siemens, SINUMERIK 840D, programming guide, fundamentals, 10/2004, the page of that number"},
    {"FUND06",
     "Siemens, SINUMERIK 840Di sl, programming manual, fundamentals, 11/2006, the page of that number"},
    {"BF11",
     "Siemens, SINUMERIK 840D sl, 828D, function manual, basic functions, 09/2011, the page of that "
     "number"},
    {"K2",
     "Siemens, SINUMERIK 840D, description of functions, axes, coordinate systems and frames (K2), "
     "08/2005, the page of that number"},
    {"T808",
     "Siemens, SINUMERIK 808D, programming and operating manual, turning, 01/2017, the page of that "
     "number"},
    {"O802",
     "Siemens, SINUMERIK 802D sl, operation and programming, nibbling, 06/2006, the page of that number"},
    {"MD",
     "Siemens, SINUMERIK 840D sl, descriptions of the machine data, 05/2017, the number of the datum"},
    {"SV",
     "Siemens, SINUMERIK 840D sl, list of the system variables, 05/2017"},
    {"HLS",
     "Vocabulary and syntax tests of a public editor package for SINUMERIK, "
     "github.com/deathaxe/sublime-s840d"},
    {"NCI",
     "Public interpreter of SINUMERIK programs, its tables and tests, which cite the manual, "
     "github.com/CEAD-group/nc-gcode-interpreter"},
    {"POL",
     "List of 17 alarms in a public repository of SINUMERIK programs"},
    {"HELM",
     "helmancnc.com, articles on programming of SINUMERIK controls"},
    {"CW",
     "cnc.wiki, articles on SINUMERIK controls"},
    {"SCYC",
     "Public copy of cycles as Siemens delivered them before SINUMERIK Operate"},
    {"T",
     "Experience of those who wrote the rule. No document at hand confirms it; a correction with a "
     "document is welcome"},
    {"maclint's own",
     "maclint itself: its comments, options and limits"},
}};
// clang-format on

/// nullptr: the source is no key.
const SourceRow* row_of(std::string_view source) {
    const auto is_key = [&](const SourceRow& row) {
        const std::string_view rest = source.substr(std::min(source.size(), row.key.size()));
        return source.starts_with(row.key) && (rest.empty() || rest.front() == ':' || rest.front() == ' ');
    };
    const auto row = std::ranges::find_if(rows, is_key);
    return row == rows.end() ? nullptr : &*row;
}

} // namespace

std::string_view document_of(std::string_view source) {
    const SourceRow* row = row_of(source);
    return row == nullptr ? std::string_view() : row->document;
}

std::string source_sentence(std::string_view source) {
    constexpr std::string_view experience = "T", by_line = ". Lines of its text";
    if (source == experience || source.starts_with("T:"))
        return "T (experience, not confirmed)" + std::string(source.substr(experience.size()));
    const SourceRow* row = row_of(source);
    if (row == nullptr) return std::string(source);
    std::string_view place = source.substr(row->key.size());
    place.remove_prefix(std::min(place.find_first_not_of(": "), place.size()));
    std::string sentence(row->document);
    if (row->document.ends_with(by_line)) {
        sentence.resize(sentence.size() - by_line.size());
        const bool is_number = place.find_first_not_of("0123456789,- ") == std::string_view::npos;
        const bool is_one = place.find_first_of("-,") == std::string_view::npos;
        if (!place.empty() && is_number)
            sentence += (is_one ? ", line " : ", lines ") + std::string(place) + " of its text";
        else if (!place.empty())
            sentence += ", " + std::string(place);
    } else if (!place.empty()) {
        sentence += ", " + std::string(place);
    }
    return sentence + " (" + std::string(source) + ")";
}

} // namespace maclint::cli
