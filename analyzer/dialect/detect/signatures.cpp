//! The table of signatures, and the sums over it.
#include "analyzer/dialect/detect/signatures.hpp"

#include "analyzer/dialect/detect/shapes.hpp"

#include <algorithm>
#include <bit>
#include <iterator>

namespace maclint::detect {
namespace {

using enum Language;

/// Where a signature is looked for.
enum class In : std::uint8_t {
    words,   ///< lines of plain words, by shape
    code,    ///< any other code, by shape
    head,    ///< the beginning of the code
    inside,  ///< anywhere in the code
    line,    ///< the beginning of a line that does not begin with a letter
    comment, ///< the beginning of a comment in round brackets
    remark,  ///< after `;`
};

struct Signature {
    Language language;
    int points;
    int most; ///< times that count
    In in;
    std::string_view text;
    bool (*shape)(const Line&);
    std::string_view called; ///< in the note; empty: `text` in quotes
};

// clang-format off
constexpr Signature signatures[] = {
    // FANUC Custom Macro B: what the languages below do not share with it [fanuc-custom-macro.md 1-5]
    {fanuc,          4, 1, In::words,   "",           program_number,        "a program number"},
    {fanuc,          4, 1, In::code,    "",           program_number,        "a program number"},
    {fanuc,          2, 2, In::words,   "",           macro_call,            "a macro call"},
    {fanuc,          2, 2, In::code,    "",           macro_call,            "a macro call"},
    {fanuc,          2, 2, In::code,    "",           goto_after_condition, "IF and GOTO"},
    {fanuc,          2, 2, In::code,    "",           loop,                  "WHILE and DO"},
    {fanuc,          2, 1, In::head,    "#3000",      nullptr,               ""},
    {fanuc,          2, 1, In::head,    "DPRNT[",     nullptr,               ""},
    {fanuc,          2, 1, In::head,    "POPEN",      nullptr,               ""},

    // HEIDENHAIN DIN PLUS [dinplus.md 1-3, 6]
    {din_plus,       4, 2, In::code,    "",           section_word,          "a section word"},
    {din_plus,       1, 1, In::code,    "",           end_of_program_word,   "a section word"},
    {din_plus,       4, 2, In::line,    "#UNIT",      nullptr,               ""},
    {din_plus,       4, 2, In::head,    "UNIT ID",    nullptr,               ""},
    {din_plus,       4, 1, In::head,    "END_OF_UNIT", nullptr,              ""},
    {din_plus,       4, 1, In::line,    "[//]",       nullptr,               ""},
    {din_plus,       4, 1, In::line,    "%",          file_name,             "a file name after %"},
    {din_plus,       4, 2, In::code,    "",           variable_with_letter,  "a variable like #l1"},
    {din_plus,       4, 2, In::inside,  "#__",        nullptr,               "a transfer value like #__la"},
    {din_plus,       4, 2, In::code,    "",           named_variable,        "a variable like #_name"},
    {din_plus,       4, 2, In::head,    "L\"",        nullptr,               "a call like L\"name\""},
    {din_plus,       4, 2, In::inside,  "ID\"",       nullptr,               ""},
    {din_plus,       4, 2, In::inside,  "ID \"",      nullptr,               ""},
    {din_plus,       4, 1, In::words,   "",           tool_feed_and_speed_in_one_block,
                                                                             "tool, feed and speed in one block"},
    {din_plus,       2, 2, In::words,   "",           cycle_of_three_digits, "a cycle of three digits"},
    {din_plus,       2, 2, In::words,   "",           tool_change_point,     "G14 with Q"},
    {din_plus,       2, 2, In::words,   "",           c_axis_rapid_alone,    "G110 with C"},
    {din_plus,       2, 3, In::code,    "",           incremental_address,   "an incremental address like Zi"},
    {din_plus,       2, 3, In::code,    "",           address_of_two_letters, "an address of two letters"},
    {din_plus,       2, 2, In::code,    "",           unknown_coordinate,    "a coordinate '?'"},
    {din_plus,       2, 2, In::code,    "",           slide,                 "a slide code"},
    {din_plus,       4, 1, In::code,    "",           elided_number,         "a placeholder 'N..'"},
    {din_plus,       2, 1, In::head,    "THEN",       nullptr,               ""},
    {din_plus,       2, 1, In::head,    "ENDSWITCH",  nullptr,               ""},
    {din_plus,       2, 2, In::head,    "WINDOW",     nullptr,               ""},
    {din_plus,       2, 2, In::head,    "INPUT",      nullptr,               ""},
    {din_plus,       2, 2, In::head,    "PRINT",      nullptr,               ""},
    {din_plus,       1, 3, In::code,    "",           bracketed_remark,      "a remark in square brackets"},
    {din_plus,      -4, 1, In::comment, "",           words_in_round_brackets, ""},

    // HEIDENHAIN Klartext and DIN/ISO (TNC)
    {klartext,       4, 1, In::head,    "BEGIN PGM",  nullptr,               "BEGIN PGM"},
    {klartext,       4, 1, In::head,    "END PGM",    nullptr,               "END PGM"},
    {klartext,       2, 2, In::head,    "TOOL CALL",  nullptr,               ""},
    {klartext,       2, 1, In::head,    "TOOL DEF",   nullptr,               ""},
    {klartext,       2, 2, In::head,    "CYCL DEF",   nullptr,               ""},
    {klartext,       2, 1, In::head,    "CYCL CALL",  nullptr,               ""},
    {klartext,       2, 1, In::head,    "BLK FORM",   nullptr,               ""},
    {klartext,       2, 2, In::head,    "CALL LBL",   nullptr,               ""},
    {klartext,       2, 2, In::head,    "CALL PGM",   nullptr,               ""},
    {klartext,       2, 2, In::head,    "LBL ",       nullptr,               ""},
    {klartext,       2, 3, In::inside,  " FMAX",      nullptr,               ""},
    {klartext,       2, 3, In::code,    "",           klartext_function,     "a function FN"},
    {klartext,       2, 2, In::code,    "",           klartext_line,         "a block like L X+0"},
    {klartext,       1, 2, In::remark,  "",           remark,                "remarks after ';'"},
    {heidenhain_iso, 2, 3, In::code,    "",           ends_in_star,          "blocks that end in '*'"},

    // SINUMERIK [sinumerik.md 1-5]
    {sinumerik,      4, 1, In::line,    "%_N_",       nullptr,               ""},
    {sinumerik,      4, 1, In::line,    "%MPF",       nullptr,               ""},
    {sinumerik,      4, 1, In::line,    "%SPF",       nullptr,               ""},
    {sinumerik,      4, 1, In::line,    ";$PATH",     nullptr,               ""},
    {sinumerik,      4, 1, In::line,    "; $PATH",    nullptr,               ""},
    {sinumerik,      4, 1, In::head,    "DEF REAL",   nullptr,               ""},
    {sinumerik,      4, 1, In::head,    "DEF INT",    nullptr,               ""},
    {sinumerik,      4, 1, In::head,    "DEF STRING", nullptr,               ""},
    {sinumerik,      4, 1, In::head,    "DEF BOOL",   nullptr,               ""},
    {sinumerik,      4, 1, In::head,    "DEF AXIS",   nullptr,               ""},
    {sinumerik,      4, 1, In::head,    "DEF CHAR",   nullptr,               ""},
    {sinumerik,      4, 1, In::head,    "DEF CHAN",   nullptr,               ""},
    {sinumerik,      4, 1, In::head,    "DEF NCK",    nullptr,               ""},
    {sinumerik,      4, 1, In::code,    "",           macro_definition,      "a macro definition"},
    {sinumerik,      4, 1, In::head,    "DEF FRAME",  nullptr,               ""},
    {sinumerik,      4, 1, In::head,    "PROC ",      nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "ENDPROC",    nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "EXTERN ",    nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "MSG",        nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "WORKPIECE",  nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "STOPRE",     nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "ENDFOR",     nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "ENDLOOP",    nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "REPEATB ",   nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "SETMS",      nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  "GOTOF ",     nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  "GOTOB ",     nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  "CYCLE8",     nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  "CYCLE9",     nullptr,               ""},
    {sinumerik,      1, 4, In::inside,  "$P_",        nullptr,               ""},
    {sinumerik,      1, 4, In::inside,  "$A_",        nullptr,               ""},
    {sinumerik,      1, 4, In::inside,  "$AA_",       nullptr,               ""},
    {sinumerik,      1, 4, In::inside,  "$TC_",       nullptr,               ""},
    {sinumerik,      1, 4, In::inside,  "$MC_",       nullptr,               ""},
    {sinumerik,      1, 4, In::inside,  "$MN_",       nullptr,               ""},
    {sinumerik,      2, 2, In::code,    "",           array_element,         "arrays with names"},
    {sinumerik,      2, 2, In::head,    "MCALL ",     nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  "MSG(\"",     nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  "LIMS=",      nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  " CR=",       nullptr,               ""},
    {sinumerik,      1, 4, In::inside,  "DIAMON",     nullptr,               ""},
    {sinumerik,      1, 4, In::inside,  "SUPA",       nullptr,               ""},
    {sinumerik,      4, 1, In::inside,  "T=\"",       nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  "=AC",        nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  "=IC",        nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  "=DC",        nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  " RND=",      nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  " RNDM=",     nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  " CHF=",      nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  " CHR=",      nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  " RP=",       nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  "SPOS=",      nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  "ADIS=",      nullptr,               ""},
    {sinumerik,      1, 4, In::inside,  "DIAMOF",     nullptr,               ""},
    {sinumerik,      2, 2, In::inside,  "WALIMON",    nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "TRANS ",     nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "ATRANS",     nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "AROT ",      nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "ASCALE",     nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "AMIRROR",    nullptr,               ""},
    {sinumerik,      2, 2, In::head,    "UNTIL ",     nullptr,               ""},
    {sinumerik,      1, 4, In::code,    "",           r_parameter,           "R parameters"},
    {sinumerik,      1, 2, In::remark,  "",           remark,                "remarks after ';'"},

    // LinuxCNC [linuxcnc.org/docs: G-code overview, O-codes, G-codes, M-codes]
    {linuxcnc,       4, 2, In::code,    "",           o_word,                "an o-word"},
    {linuxcnc,       4, 2, In::inside,  "#<",         nullptr,               "a named parameter"},
    {linuxcnc,       1, 1, In::inside,  " ENDSUB",    nullptr,               ""},
    {linuxcnc,       1, 1, In::inside,  " ENDWHILE",  nullptr,               ""},
    {linuxcnc,       4, 1, In::inside,  "EXISTS[",    nullptr,               ""},
    {linuxcnc,       4, 1, In::words,   "",           tolerance_of_g64,      "G64 with P"},
    {linuxcnc,       2, 2, In::words,   "",           probing_move,          "G38 with a digit after the point"},
    {linuxcnc,       2, 2, In::words,   "",           offset_by_l20,         "G10 L20"},
    {linuxcnc,       1, 2, In::words,   "",           digital_output,        "M62 to M68 with P"},
    {linuxcnc,       2, 2, In::comment, "MSG,",       nullptr,               "an active comment"},
    {linuxcnc,       2, 2, In::comment, "DEBUG,",     nullptr,               "an active comment"},
    {linuxcnc,       2, 2, In::comment, "PRINT,",     nullptr,               "an active comment"},
    {linuxcnc,       2, 2, In::comment, "LOG,",       nullptr,               "an active comment"},
    {linuxcnc,       2, 2, In::comment, "LOGOPEN,",   nullptr,               "an active comment"},
    {linuxcnc,       2, 2, In::comment, "PROBEOPEN",  nullptr,               "an active comment"},
    {linuxcnc,       1, 2, In::remark,  "",           remark,                "remarks after ';'"},

    // 3D printers (Marlin and relatives)
    {printer,        3, 1, In::words,   "",           extruder_zero,         "G92 with E"},
    {printer,        2, 3, In::words,   "",           heater,                "a heater"},
    {printer,        1, 3, In::words,   "",           extrusion,             "moves with E"},
    {printer,        2, 2, In::remark,  "LAYER",      nullptr,               ""},
    {printer,        2, 2, In::remark,  "FLAVOR:",    nullptr,               ""},
    {printer,        1, 2, In::remark,  "",           remark,                "remarks after ';'"},

    {grbl,           3, 2, In::code,    "",           setting,               "a command of the $ kind"},
    {grbl,           1, 2, In::remark,  "",           remark,                "remarks after ';'"},

    // Wire erosion (AccuteX and relatives)
    {wire_erosion,   2, 3, In::line,    "//",         nullptr,               "remarks after '//'"},
    {wire_erosion,   2, 3, In::code,    "",           condition_row,         "a row of cutting conditions"},
    {wire_erosion,   1, 2, In::remark,  "",           remark,                "remarks after ';'"},

    // Okuma OSP
    {okuma,          4, 1, In::code,    "",           osp_file_name,         "a file name $….MIN%"},
    {okuma,          3, 2, In::head,    "CALL O",     nullptr,               ""},
    {okuma,          3, 2, In::head,    "MODIN O",    nullptr,               ""},
    {okuma,          2, 3, In::code,    "",           osp_variable,          "a variable VC"},
    {okuma,          2, 2, In::inside,  "VZOF",       nullptr,               ""},
    {okuma,          2, 1, In::head,    "NOEX",       nullptr,               ""},
    {okuma,          2, 2, In::words,   "",           work_offset_by_g15,    "G15 with H"},

    // LNC [T: its macro functions and messages]
    {lnc,            2, 2, In::inside,  "R_SKIP[",    nullptr,               ""},
    {lnc,            2, 2, In::inside,  "R_BIT[",     nullptr,               ""},
    {lnc,            2, 2, In::inside,  "W_BIT[",     nullptr,               ""},
    {lnc,            2, 2, In::inside,  "R_G53G59_COOR[", nullptr,           ""},
    {lnc,            2, 2, In::inside,  "W_G53G59_COOR[", nullptr,           ""},
    {lnc,            2, 2, In::inside,  "R_MACH_COOR[", nullptr,             ""},
    {lnc,            1, 2, In::inside,  "ALARM",      nullptr,               ""},

    // SYNTEC [T: its MACRO files]
    {syntec,         4, 1, In::line,    "%@MACRO",    nullptr,               ""},
    {syntec,         2, 2, In::inside,  ":=",         nullptr,               ""},
    {syntec,         2, 2, In::head,    "END_IF",     nullptr,               ""},
    {syntec,         2, 2, In::head,    "END_WHILE",  nullptr,               ""},
    {syntec,         2, 2, In::head,    "END_REPEAT", nullptr,               ""},
    {syntec,         2, 2, In::line,    "@",          nullptr,               "a variable @"},
    {syntec,         1, 2, In::inside,  "ALARM",      nullptr,               ""},

    // FAGOR 8055/8065 [T: high-level blocks]
    {fagor,          2, 2, In::line,    "$IF",        nullptr,               ""},
    {fagor,          2, 2, In::line,    "$GOTO",      nullptr,               ""},
    {fagor,          2, 2, In::line,    "$WHILE",     nullptr,               ""},
    {fagor,          2, 2, In::line,    "$FOR",       nullptr,               ""},
    {fagor,          2, 2, In::inside,  "V.E.",       nullptr,               ""},
    {fagor,          2, 2, In::inside,  "V.A.",       nullptr,               ""},
    {fagor,          2, 2, In::inside,  "V.G.",       nullptr,               ""},

    // FADAL [T: macro lines begin with #]
    {fadal,          2, 1, In::line,    "#CLEAR",     nullptr,               ""},
    {fadal,          2, 1, In::line,    "#V",         fadal_variable,               "a macro line #V"},
    {fadal,          2, 1, In::line,    "#R",         fadal_variable,               "a macro line #R"},
    {fadal,          2, 1, In::line,    "#IF",        nullptr,               ""},
    {fadal,          2, 1, In::line,    "#GOTO",      nullptr,               ""},
    {fadal,          2, 1, In::line,    "#PRINT",     nullptr,               ""},

    {fagor,          6, 1, In::line,    "%",          fagor_head,            "a head like %NAME,MX,"},
    {fagor,          2, 3, In::comment, "",           fagor_statement,       "a statement in round brackets"},
    {fagor,          3, 2, In::code,    "",           fagor_register,        "a parameter like P1=K5"},
    {fagor,          1, 3, In::comment, "",           fagor_parameter,       "a parameter like (P1=5)"},

    // Denford [T: directives of its simulator]
    {denford,        6, 2, In::line,    "[",          open_directive,        "a directive like [BILLET"},

    // TRAUB TX8 [T: L parameters]
    {traub,          2, 3, In::code,    "",           assigns_l,             "a parameter like L1="},
    {traub,          2, 3, In::code,    "",           value_of_l,            "the value of a parameter L"},

    // Citizen, Star, Tsugami, Mitsubishi: programs of several paths in one file [T]
    {several_paths, 12, 2, In::line,    "$",          path_mark,             "a path mark like $1"},
    {several_paths,  6, 2, In::code,    "",           path_wait,             "a wait like !L1"},
    {several_paths,  1, 4, In::words,   "",           citizen_cycle,         "a cycle like G650"},
    {several_paths,  1, 1, In::words,   "",           tool_in_hundreds,      "a tool like T200"},

    // SINUMERIK in ISO mode [T: G290 and G291 switch the language]
    {sinumerik_iso, 24, 1, In::words,   "",           language_switch,       "G290 or G291"},

    // Cincinnati Acramatic [T: type II blocks, alignment blocks]
    {acramatic,      4, 1, In::comment, "ID,PROG",    nullptr,               "a block like (ID,PROG"},
    {acramatic,      3, 1, In::comment, "PGM,",       nullptr,               "a block like (PGM,"},
    {acramatic,      3, 2, In::comment, "CLS,",       nullptr,               "a block like (CLS,"},
    {acramatic,      3, 2, In::comment, "DFC,",       nullptr,               "a block like (DFC,"},
    {acramatic,      3, 2, In::comment, "DFS,",       nullptr,               "a block like (DFS,"},
    {acramatic,      3, 2, In::comment, "URT,",       nullptr,               "a block like (URT,"},
    {acramatic,      1, 2, In::comment, "MSG,",       nullptr,               "a block like (MSG,"},
    {acramatic,      2, 2, In::line,    ":",          alignment_block,       "an alignment block like :10 G0"},

    // Mazak Mazatrol, printed [T]
    {mazatrol,       4, 1, In::inside,  "INITIAL-Z",  nullptr,               ""},
    {mazatrol,       4, 1, In::inside,  "ATC MODE",   nullptr,               ""},
    {mazatrol,       4, 1, In::inside,  "MAZATROL",   nullptr,               ""},
    {mazatrol,       2, 3, In::head,    "UNO.",       nullptr,               ""},
    {mazatrol,       2, 3, In::head,    "SNO.",       nullptr,               ""},
    {mazatrol,       2, 3, In::head,    "UNO ",       nullptr,               ""},
    {mazatrol,       2, 3, In::head,    "SNO ",       nullptr,               ""},
    {mazatrol,       2, 2, In::head,    "FIG PTN",    nullptr,               ""},

    {hobby,          2, 2, In::remark,  "",           remark,                "remarks after ';'"},
    {hobby,          4, 1, In::remark,  "CATIA APT",  nullptr,               ""},
};
// clang-format on

/// Characters without which a line has none of the shape, in capitals.
struct Needed {
    bool (*shape)(const Line&);
    std::string_view characters;
};
constexpr Needed needed[] = {
    {macro_call, "G6P"},
    {goto_after_condition, "IFT"},
    {loop, "WHILEDO["},
    {variable_with_letter, "#"},
    {named_variable, "#_"},
    {incremental_address, "I"},
    {unknown_coordinate, "?"},
    {slide, "$"},
    {bracketed_remark, "["},
    {elided_number, "N."},
    {ends_in_star, "*"},
    {klartext_function, "FN:"},
    {array_element, "[]="},
    {macro_definition, "DEFINAS"},
    {r_parameter, "R="},
    {o_word, "O"},
    {setting, "$"},
    {osp_file_name, "$.MIN%"},
    {osp_variable, "VC="},
    {condition_row, "="},
    {end_of_program_word, "END"},
    {tool_feed_and_speed_in_one_block, "TGFS"},
    {cycle_of_three_digits, "G"},
    {tool_change_point, "G14Q"},
    {c_axis_rapid_alone, "G10C"},
    {tolerance_of_g64, "G64P"},
    {probing_move, "G38."},
    {offset_by_l20, "G10L2"},
    {digital_output, "M6P"},
    {extrusion, "GE"},
    {extruder_zero, "G92E"},
    {heater, "M1S"},
    {work_offset_by_g15, "G15H"},
    {path_wait, "!L"},
    {assigns_l, "L="},
    {value_of_l, "L"},
    {citizen_cycle, "G"},
    {tool_in_hundreds, "T0"},
    {language_switch, "G29"},
    {fagor_parameter, "P="},
    {fagor_register, "P="},
    {words_in_round_brackets, "("},
};

/// How common characters are in NC texts, the commonest first; all others are rare.
constexpr std::string_view by_frequency = "0#1OG TNI2EF()359[]4AR=86SLPMC-7DHXUB:Y+Q.KZ*,W/V;<%J>";

/// The rarest character of a text that is not empty.
char rarest_of(std::string_view text) {
    return std::ranges::max(text, {}, [](char c) { return by_frequency.find(c); });
}

constexpr std::size_t place_count = static_cast<std::size_t>(In::remark) + 1;
constexpr std::size_t all_bits = 64;

/// The rows of `signatures` that look at one place, filed by a character that must be there: of few lines
/// more than a dozen are asked.
class Place {
  public:
    explicit Place(In in) {
        std::array<std::size_t, std::size(signatures)> file{};
        for (std::size_t row = 0; row < std::size(signatures); ++row) {
            if (signatures[row].in != in) continue;
            file[row] = file_of(signatures[row]);
            rows_[count_++] = static_cast<std::uint8_t>(row);
            if (file[row] < all_bits) filed_ |= std::uint64_t{1} << file[row];
        }
        const auto by_file = [&](std::uint8_t row) { return file[row]; };
        const auto all = std::span(rows_).first(count_);
        std::ranges::stable_sort(all, {}, by_file);
        for (std::size_t i = 0; i < begins_.size(); ++i)
            begins_[i] =
                static_cast<std::uint8_t>(std::ranges::lower_bound(all, i, {}, by_file) - all.begin());
    }

    /// Hands the rows that may look for something in a line with the characters to `ask`.
    template<class Ask>
    void for_each_row(std::uint64_t characters, const Ask& ask) const {
        for (std::uint64_t left = characters & filed_; left != 0; left &= left - 1)
            ask_file(static_cast<std::size_t>(std::countr_zero(left)), ask);
        ask_file(all_bits, ask);
    }

  private:
    /// The last bits of the character; `all_bits` where none is needed.
    static std::size_t file_of(const Signature& signature) {
        if (!signature.text.empty())
            return last_bits_of(signature.in == In::inside ? rarest_of(signature.text)
                                                           : signature.text.front());
        const auto* const row = std::ranges::find(needed, signature.shape, &Needed::shape);
        return row == std::end(needed) ? all_bits : last_bits_of(rarest_of(row->characters));
    }

    template<class Ask>
    void ask_file(std::size_t file, const Ask& ask) const {
        for (std::size_t i = begins_[file]; i < begins_[file + 1]; ++i) ask(rows_[i]);
    }

    std::array<std::uint8_t, std::size(signatures)> rows_{};
    std::size_t count_ = 0;
    std::array<std::uint8_t, all_bits + 2> begins_{}; ///< of each file in `rows_`
    std::uint64_t filed_ = 0;                         ///< characters under which rows are filed
};

struct Index {
    std::vector<Place> places;
    std::array<std::uint64_t, std::size(signatures)> characters{}; ///< that the line must hold

    Index() {
        for (std::size_t i = 0; i < place_count; ++i) places.emplace_back(static_cast<In>(i));
        for (std::size_t i = 0; i < std::size(signatures); ++i) {
            characters[i] = characters_of(signatures[i].text);
            for (const Needed& row : needed)
                if (row.shape == signatures[i].shape) characters[i] |= characters_of(row.characters);
        }
    }
};

const Index& by_place() {
    static const Index index;
    return index;
}

struct Extension {
    std::string_view extension;
    Language language;
    int points;
};

// clang-format off
constexpr Extension extensions[] = {
    {"ncs",   din_plus,       6}, // dinplus.md 1.1
    {"h",     klartext,       2},
    {"i",     heidenhain_iso, 2},
    {"mpf",   sinumerik,      6}, // sinumerik.md 1
    {"spf",   sinumerik,      6},
    {"arc",   sinumerik,      6},
    {"cpf",   sinumerik,      6},
    {"ngc",   linuxcnc,       4},
    {"gcode", printer,        2},
    {"gcode", hobby,          2},
    {"min",   okuma,          4},
};

constexpr std::array<std::string_view, language_count> names = {
    "FANUC",    "HEIDENHAIN DIN PLUS", "HEIDENHAIN Klartext", "HEIDENHAIN DIN/ISO", "SINUMERIK",
    "LinuxCNC", "a 3D printer",        "GRBL",                "wire erosion",       "OKUMA OSP",
    "LNC",        "SYNTEC",    "FAGOR",     "FADAL", "Denford", "TRAUB", "CITIZEN or another lathe of several paths",
    "SINUMERIK in ISO mode", "Acramatic", "MAZATROL",
    "G-code for LinuxCNC, GRBL, a 3D printer or the like"};
// clang-format on

bool holds(const Signature& signature, const Line& line) {
    if (signature.shape != nullptr && signature.text.empty()) return signature.shape(line);
    switch (signature.in) {
    case In::head: return line.code().starts_with(signature.text);
    case In::inside: return line.code().find(signature.text) != std::string_view::npos;
    case In::line:
        return line.whole().starts_with(signature.text) &&
               (signature.shape == nullptr || signature.shape(line));
    case In::comment: return line.comment().starts_with(signature.text);
    case In::remark: return line.remark().starts_with(signature.text);
    case In::words:
    case In::code: break;
    }
    return false;
}

/// The character at the head of a text, as a bit; none of an empty one.
std::uint64_t head_of(std::string_view text) { return text.empty() ? 0 : character_bit(text.front()); }

/// The characters under which the rows of a place are filed that may concern the line; none where it has
/// nothing that they look at.
std::uint64_t offered(In in, const Line& line) {
    switch (in) {
    case In::words: return line.is_plain() && !line.words().empty() ? line.characters() : 0;
    case In::code:
    case In::inside: return line.is_plain() ? 0 : line.characters();
    case In::head: return line.is_plain() ? 0 : head_of(line.code());
    case In::line: return is_capital(line.whole().front()) ? 0 : head_of(line.whole());
    case In::comment: return head_of(line.comment());
    case In::remark: return head_of(line.remark());
    }
    return 0;
}

std::string spell(const Signature& signature) {
    if (!signature.called.empty()) return std::string(signature.called);
    std::string quoted = "'";
    quoted += trim(signature.text);
    quoted += '\'';
    return quoted;
}

int extension_points(std::string_view extension, Language language) {
    const auto* row = std::ranges::find_if(extensions, [&](const Extension& candidate) {
        return candidate.extension == extension && candidate.language == language;
    });
    return row == std::end(extensions) ? 0 : row->points;
}

} // namespace

std::string_view name_of(Language language) { return names[static_cast<std::size_t>(language)]; }

Evidence::Evidence(std::string_view extension)
    : extension_(extension) {
    static_assert(std::size(signatures) <= most_signatures);
}

void Evidence::add(const Line& line, std::size_t number) {
    const Index& index = by_place();
    const auto ask = [&](std::uint8_t row) {
        if ((index.characters[row] & ~line.characters()) != 0) return;
        Sighting& sighting = sightings_[row];
        if (sighting.times == signatures[row].most || !holds(signatures[row], line)) return;
        if (sighting.times++ == 0) sighting.line = static_cast<std::uint32_t>(number);
    };
    for (std::size_t i = 0; i < place_count; ++i)
        if (const std::uint64_t characters = offered(static_cast<In>(i), line))
            index.places[i].for_each_row(characters, ask);
}

int Evidence::points(Language language) const { return points()[static_cast<std::size_t>(language)]; }

std::array<int, language_count> Evidence::points() const {
    std::array<int, language_count> sums{};
    for (std::size_t i = 0; i < std::size(signatures); ++i)
        sums[static_cast<std::size_t>(signatures[i].language)] += signatures[i].points * sightings_[i].times;
    for (std::size_t i = 0; i < language_count; ++i)
        sums[i] += extension_points(extension_, static_cast<Language>(i));
    return sums;
}

Language Evidence::verdict() const {
    const auto sums = points();
    std::size_t best = 0; // fanuc
    int most = std::max(sums[best], enough - 1);
    for (std::size_t i = 1; i < language_count; ++i) {
        if (sums[i] <= most) continue;
        best = i;
        most = sums[i];
    }
    const auto verdict = static_cast<Language>(best);
    const bool is_both = verdict == sinumerik_iso && sums[static_cast<std::size_t>(sinumerik)] >= enough;
    return is_both ? sinumerik : verdict; // it switches in between
}

std::vector<Evidence::Seen> Evidence::seen_in_code(Language language) const {
    std::vector<Seen> seen;
    for (std::size_t i = 0; i < std::size(signatures); ++i) {
        const Signature& signature = signatures[i];
        const bool in_code = signature.in != In::comment && signature.in != In::remark;
        if (signature.language == language && in_code && sightings_[i].times != 0)
            seen.push_back({spell(signature), sightings_[i].line});
    }
    return seen;
}

std::string Evidence::reason(Language language) const {
    const Signature* best = nullptr;
    std::uint32_t line = 0;
    for (std::size_t i = 0; i < std::size(signatures); ++i) {
        const Signature& signature = signatures[i];
        if (signature.language != language || sightings_[i].times == 0) continue;
        if (best != nullptr && best->points >= signature.points) continue;
        best = &signature;
        line = sightings_[i].line;
    }
    if (best == nullptr || extension_points(extension_, language) > best->points)
        return "extension ." + std::string(extension_);
    return spell(*best) + " on line " + std::to_string(line);
}

} // namespace maclint::detect
