//! Sets of the variables that a program names, and what its expressions and stores do to them where the flow
//! is followed backwards.
#pragma once

#include "analyzer/dataflow/domain/small_vector.hpp"
#include "analyzer/flow/graph.hpp"
#include "analyzer/program/model.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace maclint::dataflow {

/// As bits: bit n is the n-th variable that the program names.
using VariableSet = SmallVector<std::uint64_t, 2>;

class VariableSets {
  public:
    /// The references must outlive the sets.
    VariableSets(const Program& program, const flow::Graph& graph);

    [[nodiscard]] VariableSet none() const { return VariableSet(variables_.size() / word_bits + 1, 0); }
    /// True of a variable that the program does not name: nothing is known of it.
    [[nodiscard]] bool holds(const VariableSet& set, Variable variable) const {
        const auto place = places_.find(program_.meant_by(variable));
        return place == places_.end() || (set[place->second / word_bits] & bit(place->second)) != 0;
    }
    /// In the order in which the program names them.
    [[nodiscard]] std::vector<Variable> members(const VariableSet& set) const;

    void add(Variable variable, VariableSet& set) const {
        const auto place = places_.find(program_.meant_by(variable));
        if (place != places_.end()) set[place->second / word_bits] |= bit(place->second);
    }
    static void add_all(VariableSet& to, const VariableSet& from) {
        for (std::size_t i = 0; i < to.size(); ++i) to[i] |= from[i];
    }
    /// Those in the spaces that are wanted.
    template<class Wanted>
    void add_if(VariableSet& set, const Wanted& wanted) const {
        for (std::size_t place = 0; place < variables_.size(); ++place)
            if (wanted(variables_[place].space)) set[place / word_bits] |= bit(place);
    }
    /// What the expression reads; an index may mean any variable of its family.
    void add_reads(std::optional<ExpressionId> id, VariableSet& set) const;

    /// From after the store to before it.
    void go_back_over(flow::NodeId node, const Assign& store, VariableSet& set) const;

  private:
    static constexpr std::size_t word_bits = 64;
    [[nodiscard]] static std::uint64_t bit(std::size_t place) {
        return std::uint64_t{1} << place % word_bits;
    }
    void replace(flow::NodeId node, Variable variable, VariableSet& set) const;
    [[nodiscard]] bool reaches(FamilyId family, SpaceId id) const;

    const Program& program_;
    const flow::Graph& graph_;
    std::vector<Variable> variables_;
    std::unordered_map<Variable, std::size_t, VariableHash> places_; ///< of the variables in that list
};

} // namespace maclint::dataflow
