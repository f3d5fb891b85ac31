//! The rows of the G groups, and the codes sorted by name.
#include "analyzer/dialect/sinumerik/g_codes.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/sinumerik/word_list.hpp"

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

namespace maclint::sinumerik {
namespace {

/// A group with its codes in the order of their numbers, blanks between them: "-" for a number that no code
/// has, "G505-G599" for a run of codes.
struct GroupText {
    std::uint8_t number;
    std::string_view what;
    bool modal;
    std::string_view reset;
    std::string_view codes;
};

// Members: NCI (ggroups.json). Numbers of groups and codes after a reset: MD20150, which is followed where
// the two disagree (53 and 56). Words: ours.
// clang-format off
constexpr GroupText texts[] = {
    {  1, "motion mode",                          true,  "G1",        "G0 G1 G2 G3 CIP ASPLINE BSPLINE CSPLINE POLY G33 G331 G332 "
                                                                        "OEMIPO1 OEMIPO2 CT G34 G35 INVCW INVCCW G335 G336"},
    {  2, "motion or dwell of one block",         false, "",          "G4 G63 G74 G75 REPOSL REPOSQ REPOSH REPOSA REPOSQA REPOSHA G147 "
                                                                        "G247 G347 G148 G248 G348 G5 G7"},
    {  3, "frame, limits or pole of one block",   false, "",          "TRANS ROT SCALE MIRROR ATRANS AROT ASCALE AMIRROR - G25 G26 G110 "
                                                                        "G111 G112 G58 G59 ROTS AROTS"},
    {  4, "preprocessing memory",                 true,  "STARTFIFO", "STARTFIFO STOPFIFO FIFOCTRL"},
    {  5, "group 5",                              true,  "",          ""},
    {  6, "plane",                                true,  "G17",       "G17 G18 G19"},
    {  7, "radius compensation",                  true,  "G40",       "G40 G41 G42"},
    {  8, "settable work offset",                 true,  "G500",      "G500 G54 G55 G56 G57 G505-G599"},
    {  9, "suppression of offsets for one block", false, "",          "G53 SUPA G153 SUPD"},
    { 10, "exact stop or continuous path",        true,  "G60",       "G60 G64 G641 G642 G643 G644 G645"},
    { 11, "exact stop of one block",              false, "",          "G9"},
    { 12, "end of a block at exact stop",         true,  "G601",      "G601 G602 G603"},
    { 13, "units",                                true,  "G71",       "G70 G71 G700 G710"},
    { 14, "distance mode",                        true,  "G90",       "G90 G91"},
    { 15, "feed mode",                            true,  "G94",       "G93 G94 G95 G96 G97 G931 G961 G971 G942 G952 G962 G972 G973"},
    { 16, "feed at curves",                       true,  "CFC",       "CFC CFTCP CFIN"},
    { 17, "approach of the contour",              true,  "NORM",      "NORM KONT KONTT KONTC"},
    { 18, "path around outside corners",          true,  "G450",      "G450 G451"},
    { 19, "beginning of a spline",                true,  "BNAT",      "BNAT BTAN BAUTO"},
    { 20, "end of a spline",                      true,  "ENAT",      "ENAT ETAN EAUTO"},
    { 21, "acceleration",                         true,  "BRISK",     "BRISK SOFT DRIVE"},
    { 22, "kind of tool offset",                  true,  "CUT2D",     "CUT2D CUT2DF CUT3DC CUT3DF CUT3DFS CUT3DFF CUT3DCC CUT3DCCD "
                                                                        "CUT2DD CUT2DFD CUT3DCD CUT3DFD"},
    { 23, "collision check of the contour",       true,  "CDOF",      "CDOF CDON CDOF2"},
    { 24, "feedforward control",                  true,  "FFWOF",     "FFWOF FFWON"},
    { 25, "reference of the tool's direction",    true,  "ORIWKS",    "ORIWKS ORIMKS"},
    { 26, "point of return to the contour",       true,  "RMI",       "RMB RMI RME RMN"},
    { 27, "turn of the tool at outside corners",  true,  "ORIC",      "ORIC ORID"},
    { 28, "working area limits",                  true,  "WALIMON",   "WALIMON WALIMOF"},
    { 29, "radius or diameter",                   true,  "DIAMOF",    "DIAMOF DIAMON DIAM90 DIAMCYCOF"},
    { 30, "block compression",                    true,  "COMPOF",    "COMPOF COMPON COMPCURV COMPCAD COMPSURF"},
    { 31, "codes of the maker, 31",               true,  "",          "G810 G811 G812 G813 G814 G815 G816 G817 G818 G819"},
    { 32, "codes of the maker, 32",               true,  "",          "G820 G821 G822 G823 G824 G825 G826 G827 G828 G829"},
    { 33, "online tool offset",                   true,  "FTOCOF",    "FTOCOF FTOCON"},
    { 34, "smooth turn of the tool",              true,  "OSOF",      "OSOF OSC OSS OSSE OSD OST"},
    { 35, "punching and nibbling",                true,  "SPOF",      "SPOF SON PON SONS PONS"},
    { 36, "delay of punching",                    true,  "PDELAYON",  "PDELAYON PDELAYOF"},
    { 37, "course of the feed",                   true,  "FNORM",     "FNORM FLIN FCUB"},
    { 38, "group 38",                             true,  "",          ""},
    { 39, "accuracy of the contour",              true,  "CPRECOF",   "CPRECOF CPRECON"},
    { 40, "hold of the radius compensation",      true,  "CUTCONOF",  "CUTCONOF CUTCONON"},
    { 41, "retraction from threads",              true,  "LFOF",      "LFOF LFON"},
    { 42, "tool carrier",                         true,  "TCOABS",    "TCOABS TCOFR TCOFRZ TCOFRY TCOFRX"},
    { 43, "side of a smooth approach",            true,  "G140",      "G140 G141 G142 G143"},
    { 44, "steps of a smooth approach",           true,  "G340",      "G340 G341"},
    { 45, "axes that the path is measured by",    true,  "SPATH",     "SPATH UPATH"},
    { 46, "plane of the retraction",              true,  "LFTXT",     "LFTXT LFWP LFPOS"},
    { 47, "programming language",                 true,  "G290",      "G290 G291"},
    { 48, "approach under radius compensation",   true,  "G462",      "G460 G461 G462"},
    { 49, "motion from point to point",           true,  "CP",        "CP PTP PTPG0 PTPWOC"},
    { 50, "angles of the tool's direction",       true,  "ORIEULER",  "ORIEULER ORIRPY ORIVIRT1 ORIVIRT2 ORIAXPOS ORIRPY2"},
    { 51, "turn between directions of the tool",  true,  "ORIVECT",   "ORIVECT ORIAXES ORIPATH ORIPLANE ORICONCW ORICONCCW ORICONIO "
                                                                        "ORICONTO ORICURVE ORIPATHS"},
    { 52, "frame turned to the workpiece",        true,  "PAROTOF",   "PAROTOF PAROT"},
    { 53, "frame turned to the tool",             true,  "TOROTOF",   "TOROTOF TOROT TOROTZ TOROTY TOROTX TOFRAME TOFRAMEZ TOFRAMEY "
                                                                        "TOFRAMEX"},
    { 54, "turn about the tool",                  true,  "ORIROTA",   "ORIROTA ORIROTR ORIROTT ORIROTC"},
    { 55, "rapid traverse",                       true,  "RTLION",    "RTLION RTLIOF"},
    { 56, "account of tool wear",                 true,  "TOWSTD",    "TOWSTD TOWMCS TOWWCS TOWBCS TOWTCS TOWKCS"},
    { 57, "slow down at corners",                 true,  "FENDNORM",  "FENDNORM G62 G621"},
    { 58, "group 58",                             true,  "",          ""},
    { 59, "dynamics",                             true,  "DYNNORM",   "DYNNORM DYNPOS DYNROUGH DYNSEMIFIN DYNFINISH DYNPREC"},
    { 60, "working area limits of the workpiece", true,  "WALCS0",    "WALCS0 WALCS1 WALCS2 WALCS3 WALCS4 WALCS5 WALCS6 WALCS7 WALCS8 "
                                                                        "WALCS9 WALCS10"},
    { 61, "smooth directions of the tool",        true,  "ORISOF",    "ORISOF ORISON"},
    { 62, "point of return for one block",        false, "",          "RMBBL RMIBL RMEBL RMNBL"},
    { 63, "group 63",                             true,  "",          ""},
    { 64, "grinding frame",                       true,  "",          ""},
};
// clang-format on
static_assert(std::ranges::is_sorted(texts, {}, &GroupText::number));

/// "G505-G599" of group 8, whose first code has this number in the group.
constexpr int first_of_run = 505, last_of_run = 599;
constexpr std::string_view run_of_offsets = "G505-G599";

struct Tables {
    std::deque<std::string> names; ///< of the runs
    std::vector<GCodeRow> codes;
    std::vector<GGroupRow> groups;

    Tables() {
        for (const GroupText& text : texts) add(text);
        std::ranges::sort(codes, {}, &GCodeRow::name);
    }

    void add(const GroupText& text) {
        GGroupRow group{text.number, text.what, text.modal, 0};
        std::uint8_t member = 1;
        for_each_word(text.codes, [&](std::string_view code) {
            if (code == text.reset) group.reset = member;
            if (code == run_of_offsets)
                add_run(text.number, member);
            else if (code != "-")
                codes.push_back({code, text.number, member});
            ++member;
        });
        groups.push_back(group);
    }

    void add_run(std::uint8_t group, std::uint8_t member) {
        for (int code = first_of_run; code <= last_of_run; ++code, ++member) {
            names.push_back("G" + std::to_string(code));
            codes.push_back({names.back(), group, member});
        }
    }
};

const Tables& tables() {
    static const Tables all;
    return all;
}

} // namespace

const GCodeRow* find_g_code(std::string_view capitals) {
    const std::span<const GCodeRow> codes = g_codes();
    const auto row = std::ranges::lower_bound(codes, capitals, {}, &GCodeRow::name);
    return row != codes.end() && row->name == capitals ? &*row : nullptr;
}

const GCodeRow* find_member(int group, double member) {
    const std::span<const GCodeRow> codes = g_codes();
    const auto row = std::ranges::find_if(
        codes, [&](const GCodeRow& code) { return code.group == group && code.member == member; });
    return row != codes.end() ? &*row : nullptr;
}

std::span<const GCodeRow> g_codes() { return tables().codes; }
std::span<const GGroupRow> g_groups() { return tables().groups; }

std::string code_name(std::string_view written) {
    std::string name(1, to_capital(written.front()));
    std::string_view digits = written.substr(1);
    while (!digits.empty() && !is_digit(digits.front())) digits.remove_prefix(1);
    while (digits.size() > 1 && digits.front() == '0' && is_digit(digits[1])) digits.remove_prefix(1);
    if (digits.ends_with(".0") || digits.ends_with('.')) digits = digits.substr(0, digits.find('.'));
    return name.append(digits);
}

} // namespace maclint::sinumerik
