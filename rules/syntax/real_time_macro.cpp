//! MAC128: what a real-time macro cannot do.
#include "analyzer/program/faults.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

#include <iterator>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule real_time_macro{
    .code = "MAC128",
    .name = "real-time-macro",
    .summary = "A statement behind // that real-time macros do not have",
    .why = "The control runs such statements beside the program, and knows fewer words there: axes move by "
           "G91 alone, conditions are ZONCE, ZEDGE and ZWHILE. It stops at any other.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"plain", "Real-time macro: the control stops at '{0}'."},
                 {"cure", "Real-time macro: the control stops at '{0}'; expected {1}."}},
    .bad = {{"fanuc", R"nc(
O9128(LIGHT)
//1 ZONCE[#RV[0]EQ1]G90 G01 X10. F100
M30
)nc"},
            {"fanuc", R"nc(
O9128(LIGHT)
//1 IF[#RV[0]EQ1]THEN #RV[1]=2
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9128(LIGHT)
//1 ZONCE[#RV[0]EQ1]#RV[1]=2
//2 ZEDGE[#RV[1]EQ2]G91 G01 X10. F100
M30
)nc"}},
    .alarms = {{"FANUC 30i/0i-D", "402", "ILLEGAL TOKEN FOR RTM", true, "real-time-token"},
               {"FANUC 30i/0i-D", "403", "ACCESS TO RTM PROTECT VAR", true, "real-time-variable"},
               {"FANUC 30i/0i-D", "407", "DOULE SLASH IN RTM MODE", true, "real-time-slashes"},
               {"FANUC 30i/0i-D", "408", "G90 IS NOT PERMITTED", true, "real-time-absolute"},
               {"FANUC 30i/0i-D", "412", "ILLEGAL G CODE", true, "real-time-code"},
               {"FANUC 30i/0i-D", "413", "ILLEGAL ADDRESS", true, "real-time-address"},
               {"FANUC 30i/0i-D", "420", "CONSTANT NUMBER P", true, "real-time-program"},
               {"FANUC 30i/0i-D", "421", "ILLEGAL ARGUMENT G54", true, "real-time-repeat"},
               {"FANUC 30i/0i-D", "422", "ILLEGAL ARGUMENT G54", true, "real-time-argument"}},
    .sources = {"GH-ALM", "T: words and codes that there are"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::unreadable, reporter,
                        {.faults = {std::begin(faults::of_real_time), std::end(faults::of_real_time)}});
}

} // namespace
} // namespace maclint::rules
