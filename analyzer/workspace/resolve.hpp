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
    [[nodiscard]] const std::vector<ProgramIndex>* candidates(const Program& caller, const Call& call) const;

    const std::deque<ProgramAnalysis>& programs_;
    std::unordered_map<std::int64_t, std::vector<ProgramIndex>> by_number_;
    std::unordered_map<std::string, std::vector<ProgramIndex>> by_name_;
};

} // namespace maclint
