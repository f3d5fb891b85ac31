//! Turns irregularities into findings.
#include "rules/irregular.hpp"

#include "analyzer/source/encoding.hpp"

namespace maclint {

void report_irregular(const ProgramFile& file, Irregular kind, Reporter& reporter) {
    for (const Irregularity& irregularity : file.irregularities) {
        if (irregularity.kind != kind) continue;
        const bool cure = !irregularity.cure.empty() && reporter.has_message("cure");
        reporter.report(
            file, irregularity.span, cure ? "cure" : "plain",
            {to_utf8(irregularity.subject, detect_encoding(irregularity.subject)), irregularity.cure});
    }
}

} // namespace maclint
