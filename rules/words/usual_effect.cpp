//! A clause for each statement.
#include "rules/words/usual_effect.hpp"

namespace maclint {

TableText usual_effect(RowStatement says) {
    switch (says) {
    case RowStatement::needs: return "the code lacks what it works with";
    case RowStatement::takes_not:
    case RowStatement::takes_only: return "the manual lists no such word";
    case RowStatement::excludes: return "each says the same in its own way";
    case RowStatement::only_with: return "without it the word says nothing";
    case RowStatement::values: return no_other_value;
    case RowStatement::at_most: return "the control takes no more";
    case RowStatement::until: return "all between is data";
    case RowStatement::encloses:
    case RowStatement::names_none: return "the control does not find what it works with";
    case RowStatement::digits:
    case RowStatement::whole: return "it counts";
    case RowStatement::alone: return "it is programmed in a block of its own";
    case RowStatement::apart: return "the control takes one of them";
    case RowStatement::precedes: return "it acts on that block";
    case RowStatement::refused: return "the manual gives it no place there";
    case RowStatement::left_on: return "it stays so";
    }
    return {};
}

} // namespace maclint
