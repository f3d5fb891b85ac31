//! Which variables a store through an index may mean.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/semantics/range.hpp"

#include <optional>
#include <unordered_map>
#include <vector>

namespace maclint::dataflow {

/// The numbers that an index may be.
struct IndexReach {
    semantics::Range numbers;
    bool locals = true; ///< those of local variables, too
};

/// What the indices of one program reach.
class IndexReaches {
  public:
    explicit IndexReaches(const Program& program)
        : program_(program) {}

    /// `known` is the range of the index. Where that has no end on one side, the custom of the family's
    /// programmers (IndexCustom) counts as well.
    [[nodiscard]] IndexReach of(FamilyId family, ExpressionId index, const semantics::Range& known);

  private:
    /// A variable that assignments set, and the least number in the sums that they store; steps left
    /// out. 0 where a block may set it that nobody can read.
    struct Base {
        Variable variable;
        double number;
    };

    void collect_bases();
    void collect_overwritten();
    /// The least number that the variable has in an index there; 0: nothing is known.
    [[nodiscard]] double base_of(Variable variable, Offset at);

    const Program& program_;
    std::optional<std::vector<Base>> bases_; ///< sorted; nothing: nobody has asked
    /// Where every run of the program first sets a variable: from there on no argument is in it.
    std::unordered_map<Variable, Offset, VariableHash> overwritten_;
};

} // namespace maclint::dataflow
