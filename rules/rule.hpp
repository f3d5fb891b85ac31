//! What a rule is: one record with everything that its page, the reports and the tests are made from.
#pragma once

#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/program/capability.hpp"
#include "analyzer/program/syntax_error.hpp"
#include "rules/check.hpp"
#include "rules/exemption.hpp"
#include "rules/finding.hpp"
#include "rules/reporter.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace maclint {

class Workspace;
struct ControlModel;

enum class Precision : std::uint8_t { low, medium, high, very_high };

/// A text that findings of a rule carry; {0}, {1} … stand for the finding's arguments.
struct Message {
    std::string_view id;
    std::string_view text;      ///< what is wrong, a sentence that begins with a word
    std::string_view cure = {}; ///< how to mend it, a sentence; reports for people give it a line of its own
    /// Few authors act on it: told where somebody selects the rule, and not by default.
    bool on_request = false;
};

/// An alarm of a control that the rule prevents.
struct Alarm {
    std::string_view control; ///< "FANUC 16i/18i/21i"
    std::string_view number;  ///< "124"
    std::string_view text;    ///< "MISSING END STATEMENT"
    bool always = true;       ///< wherever the rule finds an error, and not only in some of its cases
    /// Ids of messages, and `faults` of syntax errors, separated by blanks, that it is raised for; empty: for
    /// those which no other alarm of the control names.
    std::string_view of = {};
};

/// The severity in programs of a language, where it is not the rule's own.
struct OtherSeverity {
    std::string_view language; ///< of the control
    Severity severity;
};

/// A record says what is the rule's own; the rest is as here.
struct Rule {
    std::string_view code;         ///< "MAC303"
    std::string_view name;         ///< "jump-into-loop"
    std::string_view aliases = {}; ///< further codes, separated by blanks
    std::string_view summary;      ///< one line
    std::string_view why;          ///< why it matters at the machine
    Severity severity;
    std::vector<OtherSeverity> severity_elsewhere = {};
    Precision precision;
    std::vector<Capability> needs = {}; ///< of the language; in others it is not asked
    bool on_by_default = true; ///< very_high and high are on, the others off, or `off_reason` says why not
    std::string_view off_reason = {};
    /// Codes of rules, separated by blanks, that own what this one finds of the same cause: it is silent
    /// where one of them is on and speaks. What an owner leaves to a third rule does not come back to this
    /// one.
    std::string_view yields_to = {};
    std::string_view also = {}; ///< codes that the bad examples raise, too, under the default selection
    /// That the check asks for, itself or through what it calls; what a search for paths asks for is known.
    dataflow::FactSet facts = {};
    bool data_flow = false; ///< findings carry a path (SARIF codeFlows); a test demands it of the bad example
    /// The defect stands in the text: the path only shows how the control comes there.
    bool stands_without_path = false;
    std::vector<Message> messages;
    std::vector<Example> bad;                   ///< raises exactly this rule
    std::vector<Example> good;                  ///< raises nothing
    std::vector<RuleExemption> exemptions = {}; ///< 32 at most
    std::vector<Alarm> alarms = {};
    std::vector<std::string_view> sources;
    /// `SyntaxErrorKind`: whatever the text has of that kind, see rules/syntax_errors.hpp.
    std::variant<RaisedByCommand, SyntaxErrorKind, FileCheck, ProgramCheck, WordCheck, MachineCheck, RowCheck>
        check;
};

/// All rules, in the order of their codes.
[[nodiscard]] std::span<const Rule* const> all_rules();
/// The rule with this code, alias or name (any case), or nullptr.
[[nodiscard]] const Rule* find_rule(std::string_view code_or_name);

/// Whether programs for the control have what the rule speaks of.
[[nodiscard]] bool applies_to(const Rule& rule, const ControlModel& control);
/// Whether the code (any case) is one of a list that is separated by blanks.
[[nodiscard]] bool lists_code(std::string_view codes, std::string_view code);

class RowIndexes;

/// The rules that run.
struct Selection {
    std::vector<const Rule*> rules;
    /// Of those with rows the rows that run; nullptr: all of them.
    std::shared_ptr<const RowIndexes> rows = nullptr;
    ExemptionChoice exemptions = {};
};

/// What the rule asks data flow for.
[[nodiscard]] dataflow::FactSet facts_for(const Rule& rule);
/// What the selected rules ask data flow for.
[[nodiscard]] dataflow::FactSet facts_for(const Selection& selection);

/// Runs the selected rules over the workspace, which holds the facts for them, on up to `jobs` threads. The
/// order of the findings is that of path, line, column, code, whatever `jobs` is. Where those are listed that
/// exemptions hold back, Finding::withheld tells them from the others.
[[nodiscard]] std::vector<Finding> run_rules(const Workspace& workspace, const Selection& selection,
                                             unsigned jobs);

} // namespace maclint
