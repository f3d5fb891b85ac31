//! What a shop tells of one machine: its own codes, the programs that they call, the codes that it lacks.
#pragma once

#include "analyzer/program/tables.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace maclint::cli {

/// Why a word is wrong, a sentence without its full stop: "'6051x' is no parameter …".
struct WrongWord {
    std::string message;
};

class MachineFacts {
  public:
    [[nodiscard]] bool empty() const { return codes_.empty() && letters_.empty(); }

    /// "G310", several in a row as "M50-M59": codes of the machine's own. There are no others of the letter.
    [[nodiscard]] std::optional<WrongWord> add_codes(std::string_view word);
    /// "G51", "G68-G69": codes whose option is not fitted.
    [[nodiscard]] std::optional<WrongWord> add_missing(std::string_view word);
    /// "G81" that calls "O9010".
    [[nodiscard]] std::optional<WrongWord> add_call(std::string_view code, std::string_view program);
    /// Parameter 6050 of 81: G81 calls O9010. 0: it calls nothing.
    [[nodiscard]] std::optional<WrongWord> add_parameter(std::string_view number, double value);
    /// "G81=O9010", "6050=81", as the command line writes them.
    [[nodiscard]] std::optional<WrongWord> add_assignment(std::string_view word);

    /// The control with these facts beside what it has been told before.
    void apply_to(ControlModel& control) const;

  private:
    void add(OwnCode code);
    std::vector<OwnCode> codes_; ///< by letter and number, each once
    std::string letters_;        ///< whose codes are all told
};

} // namespace maclint::cli
