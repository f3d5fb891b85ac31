//! What a run shows to the outside: words, moves, calls, alarms and what is left at the end.
#pragma once

#include "analyzer/execution/stepper.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace maclint::test {

/// Lines are those of the program before it was changed, from 1 on.
struct ChangedLines {
    std::string path;
    std::vector<std::uint32_t> lines;
    /// Lines that were added within the text of a line: the line, how many.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> added;

    [[nodiscard]] std::uint32_t before(std::uint32_t line) const;
    [[nodiscard]] bool holds(std::uint32_t line) const;
};

/// One thing that a run does, as a number that two runs have in common where they do the same.
struct Deed {
    std::uint64_t what;
    std::uint32_t line;
    friend bool operator==(const Deed& one, const Deed& other) { return one.what == other.what; }
};

struct RecordedRun {
    execution::Leaving how;
    std::vector<Deed> deeds; ///< values of words, modal codes at moves, calls with what they pass, alarms
    std::vector<std::uint32_t> blocks;  ///< lines of its file that are run, without the changed ones
    std::vector<double> codes_at_end;   ///< of the modal groups
    std::uint64_t variables_at_end = 0; ///< what all programs share
    bool touches_change = false;        ///< a changed line is run
};

/// Listens to one run.
class Recorder {
  public:
    /// `moved`: whether lines were added, as in the changed program.
    Recorder(const ChangedLines& changes, bool moved)
        : changes_(changes)
        , moved_(moved) {}

    void observe(execution::Stepper& stepper, const execution::Event& event);
    [[nodiscard]] RecordedRun finish(execution::Leaving how);

  private:
    /// How words and arguments of a program are spelled, by their expression, and its blocks by their place.
    struct Names {
        std::unordered_map<ExpressionId, std::string_view> addresses;
        std::unordered_map<Offset, const Block*> blocks;
    };

    void on(execution::Stepper& stepper, const execution::BlockBegins& event);
    void on(execution::Stepper& stepper, const execution::EffectBegins& event);
    void on(execution::Stepper& stepper, const execution::ValueTaken& event);
    void on(execution::Stepper& stepper, const execution::Stored& event);
    void on(execution::Stepper& stepper, const execution::CallBegins& event);
    void on(execution::Stepper& stepper, const execution::ProgramLeft& event);
    void on(execution::Stepper&, const auto&) {}

    [[nodiscard]] const Names& names_of(const ProgramAnalysis& analysis);
    void record_plain(const ProgramAnalysis& analysis, Span span);
    void record_words(const Program& program, const Block& block);
    void record_store(const Program& program, const Assign& assign, const execution::ValueTaken& event);
    void record_codes(execution::Stepper& stepper);
    void record(std::initializer_list<std::uint64_t> parts);

    const ChangedLines& changes_;
    bool moved_;
    RecordedRun run_{};
    std::uint32_t line_ = 0;    ///< of the block that is run
    std::uint64_t place_ = 0;   ///< of that block; 0 where it is changed
    bool moves_next_ = false;   ///< a plain block moves once its codes are set
    semantics::Content stored_; ///< the value of the assignment that is run
    std::unordered_map<const ProgramAnalysis*, Names> names_;
    std::map<std::pair<SpaceId, std::int32_t>, semantics::Content> shared_;
};

/// Mixes numbers into one.
[[nodiscard]] std::uint64_t mixed(std::initializer_list<std::uint64_t> parts);
[[nodiscard]] std::uint64_t mixed(std::string_view text);
[[nodiscard]] std::uint64_t mixed(semantics::Content content);

} // namespace maclint::test
