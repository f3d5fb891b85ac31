//! The sequence numbers that stand near one which is missing.
#pragma once

#include "analyzer/queries/structure/sequence_numbers.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace maclint::rules {

/// Those of one program, whose blocks are read when a first number is missing.
class NearbyNumbers {
  public:
    explicit NearbyNumbers(const ProgramAnalysis& analysis)
        : analysis_(&analysis) {}

    /// "N4001 (line 4), N5 (line 56) and N8 (line 70)"; empty: the program has no numbers.
    [[nodiscard]] std::string operator()(std::int64_t number);

  private:
    const ProgramAnalysis* analysis_;
    std::optional<std::vector<queries::SequenceNumber>> numbers_;
};

} // namespace maclint::rules
