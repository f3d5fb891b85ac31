//! Guesses that rules make, with their names, and which of them are off.
#pragma once

#include "analyzer/source/exemption.hpp"
#include "rules/example.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

struct Finding;
struct Rule;

/// A guess by which a rule is silent although what it says is true. It is tried: its program raises the rule
/// without it, and nothing with it.
struct RuleExemption {
    const Exemption* exemption;
    std::string_view name; ///< "waits-for-others"; no other of the rule's has it
    std::string_view why;  ///< a sentence: what is held back, and what the author is taken to mean
    Example wanted_by;     ///< a program that is right, in which the rule would speak
};

/// An exemption and whose it is.
struct NamedExemption {
    const Rule* rule;
    std::size_t index; ///< in Rule::exemptions

    [[nodiscard]] const RuleExemption& record() const;
    /// "MAC319/waits-for-others".
    [[nodiscard]] std::string name() const;
    friend bool operator==(const NamedExemption&, const NamedExemption&) = default;
};

/// Those of all rules, in their order.
[[nodiscard]] const std::vector<NamedExemption>& all_exemptions();
/// "MAC319/waits-for-others", also with another name of the rule, in any case. Nothing: there is none.
[[nodiscard]] std::optional<NamedExemption> find_exemption(std::string_view name);
/// Those that hold the finding back; empty: none does.
[[nodiscard]] std::vector<NamedExemption> withheld_by(const Finding& finding);

/// What becomes of findings that exemptions hold back.
enum class Withheld : std::uint8_t { dropped, listed };

struct ExemptionChoice {
    std::vector<NamedExemption> without = {}; ///< these are off
    Withheld withheld = Withheld::dropped;
};

} // namespace maclint
