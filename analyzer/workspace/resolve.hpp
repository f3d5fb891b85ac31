//! Finds the program that a call means: the nearest one wins, several equally near mean unknown.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <deque>
#include <string>
#include <unordered_map>
#include <vector>

namespace maclint {

class CallResolver {
  public:
    explicit CallResolver(const std::deque<ProgramAnalysis>& programs);
    [[nodiscard]] CallSite resolve(const ProgramAnalysis& caller, EffectId effect) const;

  private:
    using Names = std::unordered_map<std::string, std::vector<ProgramIndex>>;

    [[nodiscard]] std::vector<ProgramIndex> candidates(const ProgramAnalysis& caller, const Call& call) const;

    const std::deque<ProgramAnalysis>& programs_;
    std::unordered_map<std::int64_t, std::vector<ProgramIndex>> by_number_;
    Names by_name_;                                       ///< but for local programs
    std::unordered_map<const ProgramFile*, Names> local_; ///< of every file
};

} // namespace maclint
