//! A row of the table of words: what must be of the words that stand in a block with a code.
#pragma once

#include "analyzer/program/tables.hpp"
#include "rules/finding.hpp"
#include "rules/rule.hpp"
#include "rules/words/table_text.hpp"

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

namespace maclint {

/// An alarm that a control raises where a row is not kept.
struct RowAlarm {
    TableText control = {}; ///< ControlModel::alarms: "FANUC 16i/18i/21i"; empty: none is known
    TableText number = {};
};

/// One line of a table. What a field does not say holds anywhere: in every section, whatever is in force.
/// Lists are separated by blanks.
struct WordRow {
    RowStatement says; ///< what is said of `words`; each kind is a rule of its own
    /// "G83", or several that say the same: each has a key of its own. "*": of `words`, a single address, in
    /// any block.
    TableText code;
    TableText words = {}; ///< addresses: "Q", "X Y Z"; of what precedes, codes that must not follow
    /// Addresses, beside which "O=1|2" is one with such a value; of what precedes or stands apart, codes.
    /// Of blocks that the words enclose: codes that must not stand between.
    TableText others = {};
    TableText first_block = {}; ///< of those blocks: codes of which the first one holds one
                                ///< of a block that they number: codes that it may hold

    /// Of a value, or of a number of words: the bounds and the values allowed. A word whose value is
    /// calculated is not looked at.
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool above_least = false; ///< the least itself is too little
    bool below_most = false;
    TableText values = {}; ///< "0 1 2"; others are wrong
    int modulo = 0; ///< what a value leaves when it is divided by this counts, and not the value; 0: itself

    /// Only there: names of sections (PROGRAM_HEAD for one of two words), codes of which one is surely in
    /// force in the block, its own included.
    TableText sections = {};
    TableText under = {};
    /// Only while the switch of the control with this name is surely on, or all that commas separate are off;
    /// what the row says of the end of a program is of the first.
    TableText while_on = {}, while_off = {};
    /// Only where the block's words are so, all of them: "A" stands there, "-A" does not, "A=1|2" has one of
    /// these values, "A!1|2" another one, "A?1|2" has one of them or is missing. A value that is calculated
    /// may be any: the row does not hold.
    TableText when = {};
    /// Codes: not where the next block holds one of them; only, or not, where the block before does.
    TableText unless_next = {};
    TableText unless_later = {}; ///< codes of which one stands in a later block of the section
    TableText after = {};
    TableText unless_after = {};
    /// Only on controls of these names or models; empty: on all of the table. One that nobody has named is
    /// "fanuc".
    TableText controls = {};
    TableText systems = {}; ///< of a lathe: "A", "BC"; empty: any
    bool kept =
        false; ///< the words stay while a code of its group is in force: only its first block needs them
    bool in_calls = false; ///< also in blocks that call a program: its code does

    TableText means = {}; ///< what the words are, without an article before: "depth of a peck"
    /// What comes of it at the machine, a sentence that begins with a small letter, without its full stop:
    /// "the hole is drilled in one stroke".
    TableText effect;
    Severity severity;
    std::array<RowAlarm, 3> alarms = {};
    TableText off_reason = {}; ///< why it is off by default; empty: it is on
    TableText aliases = {};    ///< further codes of rules that are this row: "DIN613"
    TableText source;          ///< key of docs/sources.md with its place: "SEED-003:12468"
};

/// Rows of one language.
struct WordTable {
    std::string_view language;           ///< of the control: "fanuc"
    std::optional<Machine> machine = {}; ///< nothing: of mills and lathes
    std::string_view sections = {};      ///< where a row names none; empty: any
    std::string_view controls = {};      ///< where a row names none; empty: any
    std::span<const WordRow> rows;
};

/// All tables: those of the chapters of codes and of the books of addresses.
[[nodiscard]] std::span<const WordTable* const> all_word_tables();

} // namespace maclint
