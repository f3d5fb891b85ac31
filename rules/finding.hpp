//! What a rule says: a place, a message and how the control gets there.
#pragma once

#include "analyzer/source/source.hpp"
#include "analyzer/source/span.hpp"
#include "rules/cause.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

struct Rule;
struct RuleRow;

/// note = style or portability; warning = likely wrong; error = the control will raise an alarm or the
/// program cannot mean what it says.
enum class Severity : std::uint8_t { note, warning, error };

/// A place with a sentence about it: a related location or a step of a path.
struct RelatedLocation {
    std::shared_ptr<const Source> source;
    Span span;
    std::string text; ///< UTF-8, starts lower case, no full stop: "N20 is here, inside DO1 … END1"
};

/// Replace the bytes of `span` by `text`.
struct Edit {
    std::shared_ptr<const Source> source;
    Span span;
    std::string text; ///< UTF-8, whatever the encoding of the source
};

/// Safe: the program does what it did, or what its text says that it was to do. Unsafe: somebody who knows
/// the program should look at it first.
enum class Applicability : std::uint8_t { safe, unsafe };
/// As reports write it.
[[nodiscard]] std::string_view name_of(Applicability applicability);

/// A change that mends a finding: all of its edits, or none.
struct Fix {
    std::string title; ///< UTF-8, an instruction without its full stop: "Remove the comment"
    Applicability applicability;
    std::vector<Edit> edits; ///< in the order of files and text; none of which touch each other
};

/// Some of a rule's exemptions: bit i is the one with that index.
using ExemptionBits = std::uint32_t;

/// Whether the control can take the paths that a finding shows.
enum class Proof : std::uint8_t {
    path,    ///< it can, or none is shown
    gave_up, ///< the search met its bound: the finding counts for less
    no_path, ///< it cannot: there is no finding
};

/// `text` with {0}, {1} … replaced.
[[nodiscard]] std::string fill(std::string_view text, const std::vector<std::string>& arguments);

struct Finding {
    const Rule* rule;
    const RuleRow* row = nullptr; ///< that found it, of a rule that has rows
    Cause cause;
    Severity severity; ///< the rule's, or what the configuration made of it
    std::shared_ptr<const Source> source;
    Span span;
    std::string_view message_id;        ///< one of the rule's messages
    std::vector<std::string> arguments; ///< for {0}, {1} … of the message, UTF-8
    std::vector<RelatedLocation> related;
    std::vector<RelatedLocation>
        path; ///< in execution order, the finding's own place last; empty: no data flow involved
    std::vector<Fix> fixes; ///< the best first: each alone mends it, with its repeats as far as it can
    Proof proof = Proof::path;
    /// Each of these holds it back: it does not count, and is there because somebody wants to see it.
    ExemptionBits withheld = 0;
    /// Findings of one rule in one file that have the same words here are one finding in reports; empty: it
    /// stands alone.
    std::string same_cause = {};
    std::vector<RelatedLocation> repeats = {}; ///< the other places of that cause, in text order
    /// It only keeps what yields to it from being told.
    bool is_silent = false;
    std::string_view alarm = {}; ///< number of the alarm that the control raises here; empty: none known

    /// Adds the fix after those that are there, unless it changes nothing, or the same bytes twice.
    void offer(Fix offered);
    /// Takes in a finding of the same cause that stands later in the text: its place becomes a repeat, and
    /// what mends it there is added to the fix here that does the same ("Write …").
    void add_repeat(Finding same);
    /// The statement, and the cure after it where the message has one.
    [[nodiscard]] std::string message() const;
    /// The message with its arguments filled in, and how many more places it is true of.
    [[nodiscard]] std::string statement() const;
    /// How to mend it; empty where the message itself says so.
    [[nodiscard]] std::string cure() const;
    /// Related places and repeats.
    [[nodiscard]] std::vector<RelatedLocation> further_places() const;
};

/// Whether it is told only where somebody selects its rule.
[[nodiscard]] bool is_on_request(const Finding& finding);

/// The order of reports: path, line, column, code.
[[nodiscard]] bool comes_before(const Finding& a, const Finding& b);

} // namespace maclint
