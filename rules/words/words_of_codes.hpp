//! The words that chapters list for the codes of a section.
#pragma once

#include "analyzer/program/model.hpp"

#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint {

class WordsOfCodes {
  public:
    /// `section`: the kind of a section, or unknown_section. Of an assumed control: what one of those takes
    /// that may be meant.
    WordsOfCodes(const ControlModel& control, std::string_view section);

    /// No chapter tells of the language's codes.
    [[nodiscard]] bool empty() const { return words_.empty(); }
    /// Whether a chapter has the code that the word is.
    [[nodiscard]] bool know(const Word& code) const;
    /// Whether the code takes an address, or nobody knows what it takes.
    [[nodiscard]] bool may_take(const Word& code, std::string_view address) const;
    [[nodiscard]] bool may_take(char letter, double code, std::string_view address) const;

  private:
    bool is_assumed_;
    std::map<std::pair<char, double>, std::vector<std::string_view>> words_;
};

} // namespace maclint
