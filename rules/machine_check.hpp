//! Rules on what the machine is doing: what such a rule is shown, and the pass over a program that they
//! share.
#pragma once

#include "analyzer/machine/states.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/rule.hpp"

#include <set>
#include <span>
#include <string>
#include <vector>

namespace maclint {

/// One block with the states around it, and what the program does elsewhere.
struct MachineStep {
    const ProgramAnalysis& analysis;
    const machine::Step& step;
    const machine::Habits& habits;
    std::set<Offset>& told; ///< causes of which the rule has spoken in this program
    bool is_of_one_call;    ///< calculated words are what they are for that

    [[nodiscard]] const machine::State& before() const { return step.before; }
    [[nodiscard]] const machine::State& after() const { return step.after; }
    [[nodiscard]] const MachineWords& letters() const { return *analysis.control().machine_words; }
    /// The block without blanks around it.
    [[nodiscard]] Span block() const { return step.block.span; }
    /// The block from its first word to its last, for a message.
    [[nodiscard]] std::string quoted_block() const;
    /// The word of the letter, or the block where none stands.
    [[nodiscard]] Span place_of(char letter) const;
    [[nodiscard]] bool cuts() const {
        return step.move == machine::Move::feed || step.move == machine::Move::cycle;
    }
    /// The code of the group under which it does nothing ("G49"); nothing where it has none.
    [[nodiscard]] std::optional<double> off(ModalRole role) const;
    /// Whether the group is surely on, by a code of this program.
    [[nodiscard]] bool is_on(const machine::State& state, ModalRole role) const;
    /// The code in force, as it is written.
    [[nodiscard]] std::string spelled(const machine::State& state, ModalRole role) const;
    /// Whether the rule has not yet spoken of what was set there; from now on it has.
    [[nodiscard]] bool is_first_of(const machine::Known& set) const { return told.insert(set.block).second; }
    [[nodiscard]] Cause cause() const { return {analysis, step.block.span}; }
    /// The block that set something, up to a comment in it.
    [[nodiscard]] Span block_of(const machine::Known& set) const;
    /// What the programs that the block calls do; those that nobody has are left out.
    [[nodiscard]] std::vector<const machine::Left*> called() const;
    /// A remark at the block that set something.
    [[nodiscard]] RelatedLocation at(const machine::Known& set, std::string text) const;
    /// "line 12": of the block that set something.
    [[nodiscard]] std::string line_of(const machine::Known& set) const;
};

/// The findings of the machine checks among the rules.
[[nodiscard]] std::vector<Finding> check_machine(const ProgramAnalysis& analysis,
                                                 std::span<const Rule* const> rules);

} // namespace maclint
