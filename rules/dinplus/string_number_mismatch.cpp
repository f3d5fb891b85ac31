//! DIN305: texts where numbers belong, numbers where texts belong.
#include "analyzer/program/model.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule string_number_mismatch{
    .code = "DIN305",
    .name = "string-number-mismatch",
    .summary = "A text is stored or passed where a number belongs, or a number where a text belongs",
    .why = "Only #x, ID and AT hold texts, and a number becomes one by STRING. Nothing else converts: "
           "the control stops.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"text", "Text for a number: '{0}', where {1} takes numbers alone.",
                  "Use #x1 to #x20 for texts, in a call ID or AT."},
                 {"number", "Number for a text: '{0}', where {1} takes texts alone.",
                  "Make a text of it with STRING( )."},
                 {"mixed", "Text in a calculation: '{0}' takes text and number together.",
                  "Make a text of the number with STRING( ), or use numbers alone."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 #l1="A"
N11 #x1=5
N12 PRINT("a",#l1,#x1)
N99 M30
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 #x2="A"+5
N11 PRINT(#x2)
N99 M30
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 L"WRITE" LA"ABC"
N99 M30
SUBPROGRAM "WRITE"
N20 PRINT("n",#__la)
RETURN
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 #l1=5
N11 #x1="A"+STRING(#l1)
N12 PRINT("a",#l1,#x1)
N99 M30
END
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 L"WRITE" ID"ABC"
N99 M30
SUBPROGRAM "WRITE"
N20 PRINT("n",#__id)
RETURN
END
)nc"}},
    .sources = {"SEED-003:18959", "SEED-003:19004-19027", "SEED-003:19436", "SEED-003:19940"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::text_for_number, reporter, {.with_cure = "text"});
    report_syntax_error(file, SyntaxErrorKind::number_for_text, reporter, {.with_cure = "number"});
    report_syntax_error(file, SyntaxErrorKind::text_in_calculation, reporter, {.without = "mixed"});
}

} // namespace
} // namespace maclint::rules
