//! Runs a program and a changed one from many starts, and says whether they do the same.
#pragma once

#include "tests/execution/recorded_run.hpp"
#include "tests/support/analysed.hpp"

#include <memory>
#include <string>
#include <vector>

namespace maclint::test {

/// What all runs together show.
struct Comparison {
    bool values = false;       ///< some run does other things: values of words, codes at moves, calls, alarms
    bool codes_at_end = false; ///< some run that returns leaves other modal codes behind
    bool variables_at_end = false; ///< or other numbers in variables that programs share
    bool blocks = false;           ///< some run takes other blocks on its way
    bool reachable = true;         ///< some path leads to a changed line
    bool unreadable = false;       ///< some run of the unchanged program ends at a block that nobody can read
    std::size_t runs = 0;
    std::size_t touching = 0; ///< runs in which a changed line is run, and that come to an end
    std::size_t lines = 0,
                led_to = 0; ///< that some path of the unchanged program leads to; those that some run does
    std::uint32_t line = 0; ///< of the first thing that differs; 0: something at the end

    [[nodiscard]] bool same() const { return !values && !codes_at_end && !variables_at_end; }
};

/// The runs of one program, kept to be compared with those of several changed ones.
class RunsOf {
  public:
    /// `files`: the program's own first, then those that it calls or that call it.
    explicit RunsOf(std::vector<NamedText> files);
    ~RunsOf();
    RunsOf(const RunsOf&) = delete;
    RunsOf& operator=(const RunsOf&) = delete;

    /// The same programs, but for the text of the first file; with further ones.
    [[nodiscard]] Comparison compare(const std::string& text, const std::vector<NamedText>& added,
                                     const ChangedLines& changes);

  private:
    struct Kept;
    std::vector<NamedText> files_;
    std::unique_ptr<Workspace> workspace_;
    std::unique_ptr<Kept> kept_;
};

} // namespace maclint::test
