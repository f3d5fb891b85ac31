//! Starts of a program that lead to as many of its blocks as chance finds.
#pragma once

#include "tests/execution/told_world.hpp"

#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace maclint::test {

/// How a run is begun: what chance tells it, and what it is told instead.
struct ToldStart {
    std::uint64_t seed;
    std::vector<semantics::Content> told; ///< of each thing that may be told, see Tellable
};

/// Something that the program reads and that nothing in it may have set before.
struct Tellable {
    bool local;             ///< a variable that a caller may set
    Variable variable;      ///< of a local
    std::uint64_t question; ///< of others
    bool may_be_vacant;
    std::vector<double> compared; ///< with these the program compares it
};

/// The runs of a program.
class StartSearch {
  public:
    explicit StartSearch(const ProgramAnalysis& analysis);

    [[nodiscard]] RecordedRun run(const ProgramAnalysis& analysis, const ToldStart& start,
                                  const ChangedLines& changes, bool moved) const;
    /// Starts to be tried for a program that is changed in these lines: those that lead there first, and what
    /// is read there given and left out.
    [[nodiscard]] std::vector<ToldStart> starts_for(const ChangedLines& changes) const;

    /// The lines that some run leads to.
    [[nodiscard]] std::set<std::uint32_t> lines() const;
    /// Some run ended at a block that nobody can read.
    [[nodiscard]] bool meets_unreadable() const { return meets_unreadable_; }

  private:
    struct Found {
        ToldStart start;
        std::set<std::uint32_t> lines;
        std::set<std::uint32_t> last; ///< of the last blocks
    };
    void find_tellable(const ProgramAnalysis& analysis);
    void find_compared(const Program& program);
    void search(const ProgramAnalysis& analysis);
    [[nodiscard]] ToldStart any(std::uint64_t seed);
    [[nodiscard]] ToldStart varied(const Found& found, std::uint64_t seed);
    [[nodiscard]] semantics::Content content_for(const Tellable& what);
    [[nodiscard]] Tellable* tellable(const Program& program, ExpressionId id);
    [[nodiscard]] std::size_t below(std::size_t limit) { return engine_() % limit; }

    bool main_;
    bool meets_unreadable_ = false;
    std::vector<double> numbers_;
    std::vector<Tellable> tellable_;
    std::vector<std::vector<std::uint32_t>> read_on_; ///< lines on which each is read
    std::vector<Found> found_;
    std::vector<ToldStart> any_;
    std::mt19937 engine_{1};
};

} // namespace maclint::test
