//! The rows of the cycles.
#include "analyzer/dialect/sinumerik/cycles.hpp"

#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/sinumerik/word_list.hpp"

#include <algorithm>
#include <iterator>

namespace maclint::sinumerik {
namespace {

using enum CycleUse;

// Names: HLS. What they are for: T. Counts of places: public programs.
// clang-format off
constexpr CycleRow rows[] = {
    {"CYCLE4071", grinding, "a grinding stroke",                   "", "", ""},
    {"CYCLE4072", grinding, "a grinding stroke",                   "", "", ""},
    {"CYCLE4073", grinding, "a grinding stroke",                   "", "", ""},
    {"CYCLE4074", grinding, "a grinding stroke",                   "", "", ""},
    {"CYCLE4075", grinding, "a grinding stroke",                   "", "", ""},
    {"CYCLE4077", grinding, "a grinding stroke",                   "", "", ""},
    {"CYCLE4078", grinding, "a grinding stroke",                   "", "", ""},
    {"CYCLE4079", grinding, "a grinding stroke",                   "", "", ""},
    {"CYCLE435",  grinding, "position of the dresser",             "", "", ""},
    {"CYCLE495",  grinding, "dressing to a contour",               "", "", ""},
    {"CYCLE60",   milling,  "engraving",                           "", "", ""},
    {"CYCLE61",   milling,  "a face",                              "", "16", ""},
    {"CYCLE62",   contour,  "the contour",                         "", "4", ""},
    {"CYCLE63",   milling,  "a contour or pocket",                 "", "26", ""},
    {"CYCLE64",   milling,  "holes before a contour pocket",       "", "", ""},
    {"CYCLE70",   milling,  "a thread",                            "", "", ""},
    {"CYCLE71",   milling,  "a face, older",                       "", "", "T"},
    {"CYCLE72",   milling,  "a path",                              "", "", ""},
    {"CYCLE750",  other,    "",                                    "", "", ""},
    {"CYCLE751",  other,    "",                                    "", "", ""},
    {"CYCLE752",  other,    "",                                    "", "", ""},
    {"CYCLE753",  other,    "",                                    "", "", ""},
    {"CYCLE754",  other,    "",                                    "", "", ""},
    {"CYCLE755",  other,    "",                                    "", "", ""},
    {"CYCLE756",  other,    "",                                    "", "", ""},
    {"CYCLE757",  other,    "",                                    "", "", ""},
    {"CYCLE758",  other,    "",                                    "", "", ""},
    {"CYCLE759",  other,    "",                                    "", "", ""},
    {"CYCLE76",   milling,  "a rectangular spigot",                "", "", ""},
    {"CYCLE77",   milling,  "a round spigot",                      "", "", ""},
    {"CYCLE78",   milling,  "a hole and its thread",               "", "", ""},
    {"CYCLE79",   milling,  "a polygon",                           "", "", ""},
    {"CYCLE800",  setting,  "swivelled plane",                     "", "0 16", ""},
    {"CYCLE801",  pattern,  "a grid or frame of positions",        "_SPCA _SPCO _STA _DIS1 _DIS2 _NUM1 _NUM2", "7", "SCYC"},
    {"CYCLE802",  pattern,  "positions",                           "", "23", ""},
    {"CYCLE81",   drilling, "centring",                            "RTP RFP SDIS DP DPR", "5 9", "SCYC"},
    {"CYCLE82",   drilling, "holes",                               "RTP RFP SDIS DP DPR DTB", "6 9 14", "SCYC"},
    {"CYCLE83",   drilling, "deep holes",                          "RTP RFP SDIS DP DPR FDEP FDPR DAM DTB DTS FRF VARI _AXN _MDEP _VRT _DTD _DIS1", "20", "SCYC"},
    {"CYCLE830",  drilling, "deep holes, newer",                   "", "", ""},
    {"CYCLE832",  setting,  "speed or accuracy of the path",       "", "", ""},
    {"CYCLE84",   drilling, "tapping",                             "RTP RFP SDIS DP DPR DTB SDAC MPIT PIT POSS SST SST1 _AXN _PTAB _TECHNO _VARI _DAM _VRT", "24", "SCYC"},
    {"CYCLE840",  drilling, "tapping with a compensating chuck",   "RTP RFP SDIS DP DPR DTB SDR SDAC ENC MPIT PIT", "", "T"},
    {"CYCLE85",   drilling, "reaming",                             "RTP RFP SDIS DP DPR DTB FFR RFF", "", "SEED-004:504, T"},
    {"CYCLE86",   drilling, "boring",                              "RTP RFP SDIS DP DPR DTB SDIR RPA RPO RPAP POSS", "14", "T"},
    {"CYCLE87",   drilling, "boring with a stop",                  "", "", "T"},
    {"CYCLE88",   drilling, "boring with a dwell and a stop",      "", "", "T"},
    {"CYCLE89",   drilling, "boring with a dwell",                 "", "", "T"},
    {"CYCLE899",  milling,  "an open slot",                        "", "", ""},
    {"CYCLE90",   milling,  "a thread, older",                     "", "", "T"},
    {"CYCLE92",   turning,  "parting off",                         "", "17", ""},
    {"CYCLE93",   turning,  "a groove, older",                     "", "", "T"},
    {"CYCLE930",  turning,  "a groove",                            "", "26", ""},
    {"CYCLE94",   turning,  "an undercut, older",                  "", "", "T"},
    {"CYCLE940",  turning,  "an undercut",                         "", "22", ""},
    {"CYCLE95",   turning,  "a contour, older",                    "", "", ""},
    {"CYCLE951",  turning,  "a corner",                            "", "19", ""},
    {"CYCLE952",  turning,  "a contour",                           "", "33 34", ""},
    {"CYCLE96",   turning,  "the undercut of a thread",            "", "", "T"},
    {"CYCLE961",  measuring, "measuring",                          "", "", "T"},
    {"CYCLE97",   turning,  "a thread, older",                     "", "", "T"},
    {"CYCLE971",  measuring, "measuring",                          "", "", "T"},
    {"CYCLE973",  measuring, "measuring",                          "", "", "T"},
    {"CYCLE974",  measuring, "measuring",                          "", "", "T"},
    {"CYCLE976",  measuring, "measuring",                          "", "", "T"},
    {"CYCLE977",  measuring, "measuring",                          "", "", "T"},
    {"CYCLE978",  measuring, "measuring",                          "", "", "T"},
    {"CYCLE979",  measuring, "measuring",                          "", "", "T"},
    {"CYCLE98",   turning,  "a chain of threads",                  "", "", ""},
    {"CYCLE982",  measuring, "measuring",                          "", "", "T"},
    {"CYCLE99",   turning,  "a thread",                            "", "29", ""},
    {"CYCLE994",  measuring, "measuring",                          "", "", "T"},
    {"CYCLE995",  measuring, "measuring",                          "", "", "T"},
    {"CYCLE996",  measuring, "measuring",                          "", "", "T"},
    {"CYCLE997",  measuring, "measuring",                          "", "", "T"},
    {"CYCLE998",  measuring, "measuring",                          "", "", "T"},
    {"HOLES1",    pattern,  "a row of positions",                  "SPCA SPCO STA1 FDIS DBH NUM", "6 11", "SCYC"},
    {"HOLES2",    pattern,  "a circle of positions",               "CPA CPO RAD STA1 INDA NUM", "6 11", "SCYC"},
    {"LONGHOLE",  milling,  "long holes on a circle",              "", "", ""},
    {"POCKET3",   milling,  "a rectangular pocket",                "", "29", ""},
    {"POCKET4",   milling,  "a round pocket",                      "", "25", ""},
    {"SLOT1",     milling,  "slots",                               "", "31", ""},
    {"SLOT2",     milling,  "slots along a circle",                "", "", ""},
};
// clang-format on
static_assert(std::ranges::is_sorted(rows, {}, &CycleRow::name));

// T: alarm 61815. POCKET1 and POCKET2 of older controls have no row: shops name programs so.
constexpr std::string_view off_compensation[] = {
    "CYCLE71",  "CYCLE76", "CYCLE77", "CYCLE81", "CYCLE82", "CYCLE83", "CYCLE84",
    "CYCLE840", "CYCLE85", "CYCLE86", "CYCLE87", "CYCLE88", "CYCLE89", "CYCLE90",
    "LONGHOLE", "POCKET1", "POCKET2", "POCKET3", "POCKET4", "SLOT1",   "SLOT2"};
static_assert(std::ranges::is_sorted(off_compensation));

constexpr std::uint8_t of_path[] = {10, 12, 21, 24,
                                    30, 51, 59}; // exact stop, acceleration, compression, directions
// T: the first deletes or writes frames; the second could switch a transformation, in older versions.
constexpr CycleSettings settings[] = {{"CYCLE800", {}, true, false}, {"CYCLE832", of_path, false, true}};

} // namespace

const CycleRow* find_cycle(std::string_view capitals) {
    const auto* row = std::ranges::lower_bound(rows, capitals, {}, &CycleRow::name);
    return row != std::end(rows) && row->name == capitals ? row : nullptr;
}

const CycleSettings* find_settings(std::string_view capitals) {
    const auto* row = std::ranges::find(settings, capitals, &CycleSettings::cycle);
    return row == std::end(settings) ? nullptr : row;
}

bool is_cycle_name(std::string_view capitals) {
    constexpr std::string_view stem = "CYCLE";
    if (find_cycle(capitals) != nullptr) return true;
    return capitals.size() > stem.size() && capitals.starts_with(stem) &&
           std::ranges::all_of(capitals.substr(stem.size()), is_digit);
}

std::vector<BroughtCycle> brought_cycles() {
    std::vector<BroughtCycle> cycles;
    for (const CycleRow& row : rows) {
        BroughtCycle& cycle = cycles.emplace_back();
        cycle = {row.name, {}, std::ranges::binary_search(off_compensation, row.name)};
        for_each_word(row.older_parameters,
                      [&](std::string_view parameter) { cycle.parameters.push_back(parameter); });
    }
    for (const std::string_view name : off_compensation)
        if (find_cycle(name) == nullptr) cycles.push_back({name, {}, true});
    return cycles;
}

} // namespace maclint::sinumerik
