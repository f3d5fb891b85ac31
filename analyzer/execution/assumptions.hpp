//! What the decisions on a path say of the values they were about, and whether they can all be so.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/execution/search_work.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

namespace maclint::execution {

/// Grows with every decision; what two paths have in common they share. Two decisions are about the same when
/// their symbols are equal: whoever adds one sees to it that equal symbols are equal values on the path.
class Assumptions {
  public:
    using Id = std::uint32_t;
    static constexpr Id none = 0;

    /// `vacant_equals_zero` is the control's. The work must outlive this.
    Assumptions(bool vacant_equals_zero, SearchWork& work)
        : vacant_equals_zero_(vacant_equals_zero)
        , work_(work) {}

    /// All of `known`, and that the comparison of `left` with `right` is true; for a vacancy test `right` is
    /// not looked at. Nothing when these cannot all be so: #1EQ50 was true, and so is #1NE50. Comparisons of
    /// a value with whole numbers alone are taken to speak of whole numbers: those who count through the
    /// cases of a variable, #7EQ1, #7EQ2 …, mean them. Not of a value that `may_be_fraction`. Each of `known`
    /// that is looked at counts as work; where the limit is met, nothing is added to them.
    [[nodiscard]] std::optional<Id> add(Id known, Operation operation, const dataflow::Value& left,
                                        const dataflow::Value& right);

    /// A comparison that turned out true; for a vacancy test `right` is not looked at.
    struct Found {
        Operation operation;
        dataflow::Value left, right;
    };
    /// All of `known`, and that one at least of these is true. No later decision makes all of them false.
    [[nodiscard]] Id add_one_of(Id known, std::vector<Found> alternatives);

    void may_be_fraction(dataflow::SymbolId value) { fractions_.insert(value); }

    /// A value that something is assumed of.
    struct Assumption {
        dataflow::SymbolId subject;
        dataflow::SymbolId other; ///< of the other side; for a vacancy test that of the subject
        Operation operation;
        double number; ///< of the other side, where that is a constant
        bool with_number;
        Id earlier;
        std::uint32_t one_of =
            0; ///< one more than a place in a list of alternatives: it says that, and no more
        std::uint32_t count = 1; ///< how many are assumed with it
    };
    [[nodiscard]] const Assumption& operator[](Id id) const { return all_[id - 1]; }
    /// How many are assumed with the last of them.
    [[nodiscard]] std::size_t count(Id last) const { return last == none ? 0 : (*this)[last].count; }
    /// Those of which the assumption says that one is true; empty: it says something else.
    [[nodiscard]] std::span<const Assumption> alternatives(const Assumption& assumption) const;

  private:
    /// What the comparison says, of which value; nothing where it is decided, or nothing is known of a side.
    struct Made {
        Assumption assumption;
        const dataflow::Value* subject;
    };
    [[nodiscard]] static std::optional<Made> make(Id known, Operation operation, const dataflow::Value& left,
                                                  const dataflow::Value& right);
    [[nodiscard]] Id put(Assumption assumption);
    [[nodiscard]] bool is_known(const Assumption& now) const;
    [[nodiscard]] bool leaves_alternatives(Id last) const;
    [[nodiscard]] bool contradicts(const Assumption& now, const dataflow::Value& subject) const;
    [[nodiscard]] bool shows_set(const Assumption& last, dataflow::SymbolId subject) const;
    [[nodiscard]] bool leaves_no_number(const Assumption& now, const dataflow::Value& subject) const;

    bool vacant_equals_zero_;
    SearchWork& work_;
    std::vector<Assumption> all_;
    /// Values of which one comparison at least is true, and what each of these says.
    struct OneOf {
        std::vector<Found> found;
        std::vector<Assumption> said;
    };
    std::vector<OneOf> one_of_;
    std::unordered_set<dataflow::SymbolId> fractions_;
};

} // namespace maclint::execution
