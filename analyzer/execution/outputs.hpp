//! What a run gives to the machine and to variables: its words, values and how it ends.
#pragma once

#include "analyzer/execution/stepper.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace maclint::execution {

/// What leaves a program: an address, or nothing where it has none, and the bits of a number.
struct Given {
    std::string_view what;
    std::uint64_t value;
    friend bool operator==(const Given&, const Given&) = default;
};

/// The words of programs, read once for many runs.
class WordTexts {
  public:
    struct OfProgram {
        std::unordered_map<Offset, std::vector<Given>> literal_words; ///< by the begin of their block
        std::unordered_map<ExpressionId, std::string_view> addresses; ///< of words with computed values
    };
    [[nodiscard]] const OfProgram& of(const Program& program);

  private:
    std::unordered_map<const Program*, OfProgram> programs_;
};

/// Collects what a run gives, as its observer. Two runs with the same outputs have done the same. Some things
/// leave no output: numbers of blocks, jumps, tests, and assignments of what a variable holds already. A
/// vacant word, argument or printed value leaves none either, as the control passes over it. In a local
/// variable 0 and vacant count as the same.
class Outputs {
  public:
    /// Must outlive the outputs.
    explicit Outputs(WordTexts& texts)
        : texts_(&texts) {}

    void observe(const Stepper& stepper, const Event& event);

    friend bool operator==(const Outputs& a, const Outputs& b) {
        return a.given_ == b.given_ && a.left_ == b.left_ && a.changed() == b.changed();
    }
    /// Whether the machine was given nothing in this run that it was not given in the other one, in the same
    /// order, whatever was stored.
    [[nodiscard]] bool gives_no_more_than(const Outputs& other) const;
    /// Whether the machine was given the same as far as the shorter run goes.
    [[nodiscard]] bool begins_like(const Outputs& other) const;

  private:
    WordTexts* texts_;
    struct Stored {
        Content before, now; ///< of the program's own locals 0 for vacant
    };
    /// The variables, by space and number, that hold something else than before.
    [[nodiscard]] std::vector<std::pair<std::uint64_t, Content>> changed() const;

    std::vector<Given> given_; ///< to the machine
    std::map<std::uint64_t, Stored> stored_;
    std::optional<Leaving> left_; ///< how the run ended
};

} // namespace maclint::execution
