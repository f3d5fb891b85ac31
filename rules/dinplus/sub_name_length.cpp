//! DIN509: the name of a subprogram is too long.
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule sub_name_length{
    .code = "DIN509",
    .name = "sub-name-length",
    .summary = "The name of a subprogram has more characters than it may have",
    .why = "The name of an external subprogram has at most 16 figures and letters, that of a local one "
           "40: a longer one is not found.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .messages = {{"cure", "Long name: '{0}', where {1} characters are the most.",
                  "Give the subprogram a shorter one."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 L"FACE_AND_CENTRE_DRILL" V1
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 L"FACE_CENTRE" V1
N99 M30
END
)nc"}},
    .sources = {"SEED-003:2945", "SEED-003:19927"},
    .check = SyntaxErrorKind::long_program_name,
};

} // namespace maclint::rules
