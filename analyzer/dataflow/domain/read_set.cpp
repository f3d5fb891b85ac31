//! A walk over the tree of an expression.
#include "analyzer/dataflow/domain/read_set.hpp"

#include "analyzer/program/overloaded.hpp"

#include <variant>

namespace maclint::dataflow {
namespace {

void collect(const Program& program, ExpressionId id, ReadSet& set) {
    std::visit(overloaded{
                   [](const Literal&) {},
                   [](const Text&) {},
                   [](const BlockName&) {},
                   [](const Vacant&) {},
                   [&](const Load& load) { set.variables.push_back(load.variable); },
                   [&](const Apply& apply) {
                       if (apply.operation == Operation::unknown) set.closed = false;
                       for (const ExpressionId operand : program.operands_of(apply))
                           collect(program, operand, set);
                   },
                   [&](const auto&) { set.closed = false; },
               },
               program.expressions[id].node);
}

} // namespace

ReadSet variables_of(const Program& program, ExpressionId expression) {
    ReadSet set{{}, true};
    collect(program, expression, set);
    return set;
}

} // namespace maclint::dataflow
