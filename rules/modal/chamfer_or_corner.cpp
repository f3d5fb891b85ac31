//! MAC529: a chamfer or a corner that the control cannot make.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/modal/chamfer_or_corner_words_finder.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule chamfer_or_corner{
    .code = "MAC529",
    .name = "chamfer-or-corner",
    .summary = "A chamfer or corner stands where the control cannot make it",
    .why = "The control makes a chamfer or a radius between two straight moves along the axes. Without the "
           "second one, beside a taper, or where compensation begins, it stops.",
    .severity = Severity::error,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .messages =
        {{"several", "More than one chamfer or radius: {0} stand in one block, which has one corner.",
          "Leave one of them."},
         {"unknown_word", "Word '{0}' after a comma: a chamfer is ,C, a radius ,R, an angle ,A.",
          "Correct its letter."},
         {"taper", "Chamfer or radius beside a taper: '{0}' stands where two axes move.",
          "Move one axis there, or write it with a comma."},
         {"compensation", "Chamfer or radius in the block where compensation changes: '{0}' beside {1}.",
          "Write {1} in the move before."},
         {"no_move", "Chamfer or radius without a second move: no axis moves in the block after '{0}'.",
          "Let the next move follow at once."},
         {"short",
          "Chamfer or radius without room: '{0}' is larger than one of the two moves that it stands between.",
          "Make it smaller, or the move longer."},
         {"no_end",
          "Angle without an end: '{0}' stands alone, and the next block has neither a position nor an angle.",
          "Write the end point and the angle of the second line in the next block."},
         {"rapid", "Chamfer or radius before a rapid move: after '{0}' the control wants a straight cut.",
          "Write G1 in the next block, or remove '{0}'."}},
    .bad = {{"fanuc", R"nc(
O9529(PLATE)
G17 G90 G54 G0 X0 Y0
G1 Z-2. F150.
G1 X30. ,C2.
M9
G0 Z50.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9529(PLATE)
G17 G90 G54 G0 X0 Y0
G1 Z-2. F150.
G1 X30. ,C2.
Y20.
G0 Z50.
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "053", "TOO MANY ADDRESS COMMANDS", true, "several unknown_word"},
               {"FANUC 30i/0i-D", "053", "TOO MANY ADDRESS COMMANDS", true, "several"},
               {"FANUC 30i/0i-D", "054", "NO TAPER ALLOWED AFTER CHF/CNR", true, "taper"},
               {"FANUC 30i/0i-D", "039", "CHF/CNR NOT ALLOWED IN G41,G42", true, "compensation"},
               {"FANUC 16i/18i/21i", "051", "MISSING MOVE AFTER CHF/CNR", true, "no_move"},
               {"FANUC 30i/0i-D", "051", "MISSING MOVE AFTER CNR/CHF", true, "no_move"},
               {"FANUC 16i/18i/21i", "055", "MISSING MOVE VALUE IN CHF/CNR", true, "short"},
               {"FANUC 30i/0i-D", "055", "MISSING MOVE VALUE IN CHF/CNR", true, "short"},
               {"FANUC 16i/18i/21i", "052", "CODE IS NOT G01 AFTER CHF/CNR", true, "rapid"},
               {"FANUC 30i/0i-D", "052", "CODE IS NOT G01 AFTER CHF/CNR", true, "rapid"}},
    .sources = {"GH-ALM", "T: parameters 3405 and 3453 switch commas"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for_each_impossible_corner(analysis, [&](const ImpossibleCorner& corner) {
        Finding& finding = reporter.report({analysis, corner.word.span}, corner.word.span, corner.why,
                                           {corner.words, corner.code});
        if (!analysis.control().assumed && corner.why != "no_end") return;
        finding.severity = Severity::warning;
    });
}

} // namespace
} // namespace maclint::rules
