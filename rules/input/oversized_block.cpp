//! MAC004: a block that is too long to be read.
#include "analyzer/program/model.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);

/// An expression of some 5 KiB.
const std::string& long_block() {
    static const std::string text = [] {
        std::string block = "O0004(LONG BLOCK)\n#100=1";
        for (int i = 0; i < 1000; ++i) block += "+#101";
        return block + "\nM30\n";
    }();
    return text;
}
} // namespace

extern const Rule oversized_block{
    .code = "MAC004",
    .name = "oversized-block",
    .summary = "A block is longer than maclint reads (4 KiB); it is skipped",
    .why = "No control takes a block of this length: what stands there is usually line noise from a serial "
           "transfer or a file whose line ends were lost. What the block does is unknown to all other rules.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"oversized", "Block of more than 4 KiB, which maclint skips.",
                  "Check the file for lost line ends, or divide the block."}},
    .bad = {{"fanuc", long_block()}},
    .good = {{"fanuc", R"nc(
O0004(SHORT BLOCKS)
G0 X1.5
G0 X3.
M30
)nc"}},
    .sources = {"maclint's own limit: parsing line noise costs the square of its length"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    for (const SyntaxError& syntax_error : file.syntax_errors)
        if (syntax_error.kind == SyntaxErrorKind::oversized_block)
            reporter.report({file, syntax_error.span}, syntax_error.span, "oversized", {});
}

} // namespace
} // namespace maclint::rules
