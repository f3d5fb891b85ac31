//! Which words of a block a row can be wrong about.
#include "rules/words/row_index.hpp"

namespace maclint {

bool RowIndex::Entry::can_be_wrong(syntax::AddressSet any, syntax::AddressSet all) const {
    switch (row->row->says) {
    case RowStatement::needs: return !all.meets(words);
    case RowStatement::takes_not:
    case RowStatement::values:
    case RowStatement::whole:
    case RowStatement::digits: return any.meets(maybe_words);
    case RowStatement::excludes: return any.meets(maybe_words) && any.meets(maybe_others);
    case RowStatement::only_with: return any.meets(maybe_words) && !all.meets(others);
    case RowStatement::takes_only: return !any.without(words).empty();
    case RowStatement::at_most:
    case RowStatement::names_none:
    case RowStatement::encloses: return any.meets(maybe_words);
    case RowStatement::until:
    case RowStatement::alone:
    case RowStatement::apart:
    case RowStatement::precedes:
    case RowStatement::refused:
    case RowStatement::left_on: return true;
    }
    return true;
}

} // namespace maclint
