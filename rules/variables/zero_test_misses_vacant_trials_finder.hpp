//! Whether a program does the same when a test takes a vacant variable for 0.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/execution/environment.hpp"
#include "analyzer/execution/outputs.hpp"
#include "analyzer/execution/stepper.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace maclint::rules {

/// Runs a program from tests on, with a variable vacant, and with one that the test takes for 0, in many
/// states.
class VacancyTrials {
  public:
    explicit VacancyTrials(const ProgramAnalysis& analysis);
    VacancyTrials(const VacancyTrials&) = delete;
    VacancyTrials& operator=(const VacancyTrials&) = delete;
    ~VacancyTrials() = default;

    /// What it means that a run with the variable vacant ends in an alarm of a program where one would not in
    /// which the test takes it for 0: that it is alike, that it is where nothing else was done before, that
    /// it is not.
    enum class Refused : std::uint8_t { is_alike, at_once, is_different };

    /// Whether the machine is given the same blocks and values, however the test turns out for the vacant
    /// variable. Nothing: no run tells, or enough has been run. States that the program never comes to the
    /// test in are tried as well.
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
    enum class Taken : std::uint8_t { for_vacant, for_zero };
    [[nodiscard]] Trial run(const dataflow::Comparison& test, Variable variable, std::uint64_t number,
                            Taken taken);
    void observe(execution::Stepper& stepper, const execution::Event& event);

    const ProgramAnalysis& analysis_;
    queries::WithoutAssignment unset_;
    std::vector<double> numbers_; ///< that unknowns get
    std::vector<Local> locals_;   ///< that the program reads
    execution::WordTexts texts_;
    std::size_t blocks_ = 0; ///< that have been run
    // Of the trial that runs:
    std::uint64_t number_ = 0;
    Variable variable_{};
    ExpressionId test_ = 0;      ///< behind which the variable is vacant again
    semantics::Content content_; ///< of the variable until then
    execution::Outputs outputs_;
    execution::Environment environment_;
    std::optional<execution::Stepper> stepper_; ///< after the first test that is tried
};

} // namespace maclint::rules
