//! Finds the program that a call means: the nearest one wins, several equally near mean unknown.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace maclint {

class CallResolver {
  public:
    explicit CallResolver(const std::deque<ProgramAnalysis>& programs);
    [[nodiscard]] CallSite resolve(const ProgramAnalysis& caller, EffectId effect) const;

    /// Whether only the running program knows which program it calls.
    [[nodiscard]] static bool is_computed(const Program& program, const Call& call);

  private:
    /// The nearest programs, seen from somewhere.
    struct Nearest {
        std::size_t steps = static_cast<std::size_t>(-1);
        std::size_t all = 0; ///< programs looked at, near or far
        std::shared_ptr<Candidates> programs;

        void consider(ProgramIndex program, std::size_t steps_to_it);
    };
    /// All programs of a number or a name.
    struct ProgramsByName {
        std::unordered_map<std::string_view, Nearest> below; ///< a folder, as seen from it; no local programs
        std::unordered_map<const ProgramFile*, Nearest> in_file, local; ///< only the file sees local ones
    };
    template<class Name>
    using Index = std::map<std::pair<std::string_view, Name>, ProgramsByName>; // by language too

    void add(ProgramsByName& programs_by_name, const ProgramAnalysis& analysis);
    [[nodiscard]] const ProgramsByName* programs_named(const ProgramAnalysis& caller, const Call& call) const;

    Index<std::int64_t> by_number_;
    Index<std::string> by_name_;
};

} // namespace maclint
