//! What a shop tells of one machine: its own codes, the programs that they call, the codes that it lacks.
#pragma once

#include "analyzer/program/shop_demands.hpp"
#include "analyzer/program/tables.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace maclint::cli {

/// Why a word is wrong, a sentence without its full stop: "'6051x' is no parameter …".
struct WrongWord {
    std::string message;
};

class MachineFacts {
  public:
    [[nodiscard]] bool empty() const {
        return codes_.empty() && letters_.empty() && axes_.empty() && !options_ && !calculator_input_ &&
               demands_ == nullptr;
    }

    /// "G310", several in a row as "M50-M59": codes of the machine's own. There are no others of the letter.
    [[nodiscard]] std::optional<WrongWord> add_codes(std::string_view word);
    /// "G51", "G68-G69": codes whose option is not fitted.
    [[nodiscard]] std::optional<WrongWord> add_missing(std::string_view word);
    /// "scaling": an option that is fitted. Codes of the control's other options are not.
    [[nodiscard]] std::optional<WrongWord> add_option(std::string_view word, const ControlModel& control);
    /// That the machine has some of the options, or none of them.
    void list_options();
    /// "XYZA": the letters of all axes.
    [[nodiscard]] std::optional<WrongWord> set_axes(std::string_view letters);
    /// Whether a length without a point is one in millimetres or inches.
    void set_calculator_input(bool value) { calculator_input_ = value; }
    /// What the shop asks of programs for it.
    void set_demands(ShopDemands demands) {
        demands_ = std::make_shared<const ShopDemands>(std::move(demands));
    }
    /// "G81" that calls "O9010"; "T": any T word does.
    [[nodiscard]] std::optional<WrongWord> add_call(std::string_view code, std::string_view program);
    /// Parameter 6050 of 81: G81 calls O9010. 0: it calls nothing. "6001#5" of 1: T calls O9000.
    [[nodiscard]] std::optional<WrongWord> add_parameter(std::string_view number, double value);
    /// "G81=O9010", "6050=81", as the command line writes them.
    [[nodiscard]] std::optional<WrongWord> add_assignment(std::string_view word);

    /// The control with these facts beside what it has been told before.
    void apply_to(ControlModel& control) const;

  private:
    void add(OwnCode code);
    void add_missing_options(const ControlModel& control);
    std::vector<OwnCode> codes_; ///< by letter and number, each once
    std::string letters_;        ///< whose codes are all told
    std::string axes_;           ///< empty: not told
    std::optional<std::vector<std::string>> options_;
    std::optional<bool> calculator_input_;
    std::shared_ptr<const ShopDemands> demands_; ///< nullptr: not told
};

} // namespace maclint::cli
