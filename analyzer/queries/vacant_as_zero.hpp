//! Whether a program does the same with a vacant variable as with 0.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/execution/environment.hpp"
#include "analyzer/execution/outputs.hpp"
#include "analyzer/execution/stepper.hpp"
#include "analyzer/queries/feasible_paths.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace maclint::queries {

/// Runs a program from tests on, with a variable vacant and with 0, in many states.
class VacancyTrials {
  public:
    explicit VacancyTrials(const ProgramAnalysis& analysis);
    VacancyTrials(const VacancyTrials&) = delete;
    VacancyTrials& operator=(const VacancyTrials&) = delete;
    ~VacancyTrials() = default;

    /// What it means that a run with the variable vacant ends in an alarm of a program where the one with 0
    /// does not: that it is alike, that it is where nothing else was done before, that it is not.
    enum class Refused : std::uint8_t { is_alike, at_once, is_different };

    /// Whether the runs in which the variable is vacant gave the machine the same blocks and values as those
    /// with 0, all else alike. Nothing: no run tells, or enough has been run. States that the program never
    /// comes to the test in are tried as well.
    [[nodiscard]] std::optional<bool> are_alike(const dataflow::Comparison& test, Variable variable,
                                                Refused refused);

  private:
    struct Trial {
        execution::Outputs outputs;
        bool is_refused;    ///< it ended in an alarm of a program
        bool is_broken_off; ///< it ended before the program did
    };
    struct Local {
        Variable variable;
        bool may_be_vacant; ///< at the test
    };
    [[nodiscard]] execution::Environment environment();
    [[nodiscard]] semantics::Content content_of(std::string_view question) const;
    [[nodiscard]] double number_of(std::string_view question) const;
    [[nodiscard]] Trial run(const dataflow::Comparison& test, Variable variable, std::uint64_t number,
                            semantics::Content content);

    const ProgramAnalysis& analysis_;
    WithoutAssignment unset_;
    std::vector<double> numbers_; ///< that unknowns get
    std::vector<Local> locals_;   ///< that the program reads
    execution::WordTexts texts_;
    std::size_t blocks_ = 0; ///< so many have been run
    // Of the trial that runs:
    std::uint64_t number_ = 0;
    Variable variable_{};
    semantics::Content content_; ///< of the variable, where programs share it
    execution::Outputs outputs_;
    execution::Environment environment_;
    std::optional<execution::Stepper> stepper_; ///< after the first test that is tried
};

} // namespace maclint::queries
