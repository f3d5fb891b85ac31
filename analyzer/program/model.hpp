//! The program model: what flow, data flow and rules see of a program in any language.
#pragma once

#include "analyzer/program/given.hpp"
#include "analyzer/program/ids.hpp"
#include "analyzer/program/label_search.hpp"
#include "analyzer/program/names.hpp"
#include "analyzer/program/region_kind.hpp"
#include "analyzer/program/syntax_error.hpp"
#include "analyzer/program/variable.hpp"
#include "analyzer/source/source.hpp"
#include "analyzer/source/span.hpp"
#include "analyzer/syntax/plain_tables.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

namespace maclint {

struct ControlModel;

/// Consecutive entries of an arena.
struct Slice {
    Id first = 0;
    Id count = 0;
};

// ---- labels ----

/// The name of a block: its number in Program::block_names.
struct BlockName {
    std::int32_t number;
    friend auto operator<=>(const BlockName&, const BlockName&) = default;
};
/// What a jump can name: the number of a block or its name.
using Label = std::variant<std::int64_t, BlockName>;

// ---- expressions ----

/// What an operator or function does; the analysis has one row of semantics for each.
enum class Operation : std::uint8_t {
    add,
    subtract,
    multiply,
    divide,
    modulo,
    power,
    negate,
    bit_and,
    bit_or,
    bit_xor,
    bit_not,
    all_of,
    any_of,
    one_of,
    not_of, // logic between conditions
    equal,
    not_equal,
    less,
    less_equal,
    greater,
    greater_equal,
    is_vacant,
    is_set, // #1 EQ #0, NDEF(__la)
    sine,
    cosine,
    tangent,
    arc_sine,
    arc_cosine,
    arc_tangent,
    arc_tangent_of_two,
    square_root,
    absolute,
    round,
    truncate,
    round_up,
    logarithm,
    exponential,
    to_binary,
    to_decimal_code,
    add_point, // BIN, BCD, ADP
    unknown,   // a function that the analysis knows nothing of
};

struct Literal {
    double value;
    bool decimal_point;
};
struct Text {
    Span characters;
};
struct Vacant {}; ///< the null variable
struct Load {
    Variable variable;
};
struct LoadAt {
    FamilyId family;
    ExpressionId index;
}; ///< #[#1+2]
struct LoadModal {
    GroupId group;
}; ///< #4003
struct LoadMachine {
    FamilyId family;
    std::int32_t number;
}; ///< #5041: a row of the family's table
struct Apply {
    Operation operation;
    Slice operands;
};                    ///< operands: Program::operands
struct Unreadable {}; ///< the parser could not make sense of it

struct Expression {
    std::variant<Literal, Text, BlockName, Vacant, Load, LoadAt, LoadModal, LoadMachine, Apply, Unreadable>
        node;
    Span span; ///< brackets around it included
};

// ---- effects ----

struct StoreAt {
    FamilyId family;
    ExpressionId index;
}; ///< target of #[#1]=…
struct StoreMachine {
    FamilyId family;
    std::int32_t number;
}; ///< target of #5221=…
struct Assign {
    std::variant<Variable, StoreAt, StoreMachine> target;
    ExpressionId value;
};

/// Sets a modal group. Without `group` the code decides (G#3): the analysis asks the value.
struct SetModal {
    std::optional<GroupId> group;
    ExpressionId value;
    char letter = 0; ///< the address whose codes are meant, where the group is not known
};

/// Values that words compute and that change nothing in the model: axis words, T, D, H.
struct EvaluateWords {
    Slice values; ///< Program::operands
};

/// Axes move.
struct Motion {
    bool without_feed = false; ///< at rapid traverse, whatever the motion mode is
    bool to_reference = false; ///< to or from a reference position of the machine
};
/// Look-ahead stops here.
struct Synchronise {
    bool from_here_on = false; ///< and is limited until further notice
};
struct Stop {
    enum class Kind : std::uint8_t {
        alarm,  ///< #3000
        pause,  ///< #3006, M00
        end,    ///< M30
        restart ///< the program ends and begins again, all modal groups as they are; `number`: at that block
    } kind;
    std::optional<ExpressionId> number;
};
struct ToolChange {
    enum class Kind : std::uint8_t {
        change,
        approach
    } kind = Kind::change; ///< approach: a move to its place
};
/// Words that name a block of another section: the start or end of a contour.
struct Reference {
    ReferenceKindId kind;
    ExpressionId block;
};

/// Opens, divides or closes a construct. In a language whose loops have numbers, a number pairs open and
/// close.
struct RegionMark {
    RegionKind region_kind;
    enum class Part : std::uint8_t {
        open,
        begin,  ///< THEN: what it opens has begun; the flow does not change
        middle, ///< ELSE; CASE with its condition, DEFAULT without
        leave,  ///< BREAK: on to the close
        close,
    } part;
    std::optional<std::int64_t>
        number; ///< m of DO m / END m; empty where the language pairs by nesting or the text lacks it
    std::optional<ExpressionId> condition;
};

/// What happens when no block bears the label.
enum class MissingLabel : std::uint8_t { alarm, skip };

/// A condition around it is a Guarded effect.
struct Jump {
    ExpressionId target; ///< Literal: a block number; BlockName: a name
    LabelSearch search = LabelSearch::forward_then_top;
    MissingLabel missing = MissingLabel::alarm;
};

/// How a value reaches the called program.
enum class Passing : std::uint8_t {
    by_value,
    by_reference, ///< the parameter is the variable of the caller
    as_declared,  ///< the called program says which
};
/// The place of an argument in its list, from 0 on.
struct ArgumentPosition {
    std::uint32_t number;
    friend bool operator==(const ArgumentPosition&, const ArgumentPosition&) = default;
};
struct Argument {
    /// A letter names the same variable of whatever program is called; a position or a name means one of
    /// its parameters (Program::formals), which only the workspace knows.
    std::variant<Variable, ArgumentPosition, std::string_view> given;
    ExpressionId value;
    std::string_view address; ///< "A", "LA"; static lifetime or into the source text
    Span span;
    Passing passing = Passing::by_value;
};
struct Call {
    std::variant<std::monostate, ExpressionId, Text>
        program; ///< number or name; monostate: the text does not say (MAC401)
    CallKindId kind;
    Slice arguments;                    ///< Program::arguments
    std::optional<ExpressionId> repeat; ///< L; absent: once
};
struct Return {
    std::optional<ExpressionId> value, resume_label;
}; ///< M99, M99 P
struct Exchange {
    Slice out; ///< Program::operands
    Slice in;  ///< Program::variables
};             ///< DPRNT, PRINT, INPUT
struct Guarded {
    ExpressionId condition;
    Slice effects;
}; ///< IF[…] THEN …, IF[…] GOTO …; effects: Program::effects

/// A block that could not be read. What its words name may or may not happen.
struct UnreadableBlock {
    Slice may_write; ///< Program::variables; all that it names: it may change them, or be the missing test
    Slice may_jump;  ///< Program::labels
    bool may_open_or_close; ///< it names DO, END, IF …: balance findings that it may explain are held back
    bool may_call_or_return;
};

struct Effect {
    std::variant<Assign, SetModal, EvaluateWords, Motion, Synchronise, Stop, ToolChange, RegionMark, Jump,
                 Call, Return, Exchange, Guarded, UnreadableBlock, Reference>
        what;
    Span span;
};

// ---- blocks ----

/// One word of a block: address and value as written.
struct Word {
    std::string_view address; ///< "X", ",C", "LA"; upper case, static lifetime or into the source text
    std::variant<std::monostate, Literal, ExpressionId> value; ///< an expression is no literal number
    bool incremental;
    Span span;
    bool absolute = false; ///< it says that its number counts from the program's zero, where others do not

    [[nodiscard]] bool has_value() const { return !std::holds_alternative<std::monostate>(value); }
};

/// Channels (slides) as bits: bit n is channel n. 0: none is named.
using Channels = std::uint16_t;

/// A block with anything beyond address letters and literal numbers.
struct Block {
    Span span; ///< without its end of line
    std::optional<std::int64_t> sequence_number;
    Span sequence_number_span;
    std::uint16_t skip_levels; ///< bit n: skip level n (bit 1 for a bare '/'); 0: never skipped
    Slice words;               ///< Program::words
    Slice effects;             ///< Program::effects, in execution order
    Channels channels = 0;     ///< that the block names; 0: those of its section
    std::optional<BlockName> name = {};
    Span name_span = {};
};

/// One modal setting of a plain block.
using ModalSetting = syntax::Setting;

/// What is known of the words of a block, or of blocks in a row, without reading them.
struct WordSummary {
    syntax::AddressSet addresses;
    syntax::AddressSet repeated; ///< in one block, where they may not by the tables
    bool conflicts = false;      ///< a modal group is set twice in one block, or codes exclude each other
    syntax::CodeSet codes = {};
};

/// The addresses that stand beside the codes of a kind, in a run.
struct CodeWords {
    syntax::CodeSet::Kind kind;
    syntax::AddressSet any; ///< in one of its blocks
    syntax::AddressSet all; ///< in each of them
};

/// Plain blocks in a row, not stored one by one; see block_view.hpp.
struct PlainRun {
    Span span;
    std::uint32_t blocks = 0;
    std::int32_t lowest_number = INT32_MAX; ///< of its blocks that have numbers
    std::int32_t highest_number = INT32_MIN;
    std::uint8_t tables = 0; ///< row of Program::plain_tables by which they are read
    bool moves = false;      ///< at least one block moves an axis
    WordSummary words;
    Slice net;               ///< Program::settings: the last setting of every group it touches
    Slice beside_codes = {}; ///< Program::code_words; empty, too, where there are too many kinds of codes

    [[nodiscard]] bool has_numbers() const { return lowest_number <= highest_number; }
};

using Item = std::variant<Block, PlainRun>;
using ItemId = Id;

/// Part of a program; the body is a slice of Program::items.
struct Section {
    std::string_view kind; ///< "program", "MACHINING", …: name of a row of ControlModel::sections
    Slice items;
    enum class Executed : std::uint8_t { when_reached, at_load, never } executed;
    Span heading = {};     ///< the line that begins it; empty for "program"
    Channels channels = 0; ///< of blocks that name none; 0: all those of the program
};

/// A parameter of a program.
struct Formal {
    Variable variable;
    std::string name; ///< as arguments that are given by name spell it
    Passing passing;  ///< by_value or by_reference
    Span span;
    /// As the text spells it, "REAL"; of static lifetime; empty: the language has no types.
    std::string_view type = {};
    bool is_array = false;
    bool has_default = false; ///< a call may leave it out
};

/// What the text says of the parameters of a program that lies elsewhere.
struct ExternalDeclaration {
    struct Parameter {
        std::string_view type; ///< as in Formal
        Passing passing;
        bool is_array;
    };
    std::string name;
    std::vector<Parameter> parameters;
    Span span;
};

/// An index of an array whose size the text gives.
struct ArrayIndex {
    ExpressionId index;
    std::int32_t size; ///< indices go from 0 to one less
    Span array;        ///< the element as it is written
    Span declared;
};

/// An element of an array that the text does not define.
struct ForeignElement {
    std::string array; ///< capitals
    Slice indices;     ///< Program::operands
    Span span;
};

/// A name that the text uses and does not define: the machine's maker or another file does, or it is
/// misspelt.
struct UnknownName {
    std::string name; ///< capitals
    Span span;
    std::string meant;   ///< what it is a letter off; empty: nothing that is known
    bool of_the_program; ///< that is something the program defines, else a word of the language
};

/// A variable that the text declares.
struct Declaration {
    VariableType type;
    std::optional<double> initial; ///< what it reads as before anything was stored, where its space does not
                                   ///< say so; of a parameter: when the call leaves it out
    Span span;
    std::string_view type_name = {}; ///< as in Formal
};

/// One program of a file.
class Program {
  public:
    std::string name;                       ///< "O9100", or the file's name where the text gives none
    std::optional<std::int64_t> number;     ///< program number
    std::vector<std::string> also_known_as; ///< further names that a call may use (<NAME>, file name)
    bool local = false;                     ///< only programs of its own file can call it
    std::string folder;    ///< on the control, where the text says it: "MTB/PROBING"; empty: it does not
    Span span;             ///< all its blocks
    Span name_span;        ///< where the name stands; empty at the first block otherwise
    std::string_view text; ///< bytes of the whole file; all spans point into it
    const ControlModel* control = nullptr;
    /// By these, plain blocks are read again.
    std::array<const syntax::PlainTables*, 2> plain_tables{};
    /// What the text says of how it is started; `unknown`: the calls and returns tell.
    enum class Started : std::uint8_t { unknown, by_hand, by_call } started = Started::unknown;

    std::vector<Section> sections;
    std::vector<Item> items;
    std::vector<Expression> expressions;
    std::vector<ExpressionId> operands;
    std::vector<Effect> effects;
    std::vector<Word> words;
    std::vector<Argument> arguments;
    std::vector<Variable> variables; ///< those of effects that have lists of them
    std::vector<Label> labels;       ///< likewise
    std::vector<ModalSetting> settings;
    std::vector<CodeWords> code_words;
    Names names;                 ///< of named variables
    SharedNames shared_names;    ///< of those that all programs share
    Names block_names;           ///< of named blocks
    Channels channels = 0;       ///< all that its text names: it runs in each of them at the same time
    std::vector<Formal> formals; ///< parameters, by position
    std::vector<ExternalDeclaration> externals;
    std::vector<ArrayIndex> array_indices;        ///< in text order
    std::vector<UnknownName> unknown_names;       ///< in text order
    std::vector<std::string> given_names;         ///< that it defines for all programs; capitals
    std::vector<GivenWord> given_words;           ///< of these, those that stand for pieces of blocks
    std::vector<ArrayDefinition> arrays;          ///< that it defines
    std::vector<ForeignElement> foreign_elements; ///< in text order
    Span definition;                              ///< of its parameters: `PROC …`; empty: the text has none
    bool parameters_unknown = false;              ///< its definition cannot be read
    std::unordered_map<Variable, Declaration, VariableHash> declarations;
    std::vector<Variable> handed_down; ///< locals that all programs called from here see, too: #l1(200)
    std::unordered_map<Variable, Variable, VariableHash>
        aliases; ///< names, and the variables that they stand for

    [[nodiscard]] std::string_view slice(Span span) const {
        return text.substr(span.begin, span.end - span.begin);
    }
    [[nodiscard]] std::span<const ExpressionId> operands_of(const Apply& apply) const;
    [[nodiscard]] std::span<const ExpressionId> values_of(const EvaluateWords& values) const;
    [[nodiscard]] std::span<const ExpressionId> values_of(const Exchange& exchange) const;
    [[nodiscard]] std::span<const ExpressionId> indices_of(const ForeignElement& element) const;
    [[nodiscard]] std::span<const Variable> variables_of(const Exchange& exchange) const;
    [[nodiscard]] std::span<const Variable> variables_of(const UnreadableBlock& block) const;
    [[nodiscard]] std::span<const Label> labels_of(const UnreadableBlock& block) const;
    [[nodiscard]] std::span<const Effect> effects_in(Slice slice) const;
    [[nodiscard]] std::span<const Argument> arguments_of(const Call& call) const;
    [[nodiscard]] Span span_of(ItemId item) const;
    /// Whether a call can set the variable: a letter of the control reaches it, or it is a parameter.
    [[nodiscard]] bool is_formal(Variable variable) const;
    /// The declaration of the variable, or nullptr.
    [[nodiscard]] const Declaration* declaration_of(Variable variable) const;
    [[nodiscard]] VariableType type_of(Variable variable) const;
    /// "N10", "START".
    [[nodiscard]] std::string spell(const Label& label) const;
    /// Whether it runs in more than one channel: then what is true of one need not be true of another.
    [[nodiscard]] bool has_several_channels() const { return (channels & (channels - 1U)) != 0; }
    /// The channels that run the blocks of an item: those that it or its section names, else all.
    [[nodiscard]] Channels channels_of(ItemId item) const;
    /// The variable that a name stands for; any other variable is itself.
    [[nodiscard]] Variable meant_by(Variable variable) const;
    /// "#101", "__la".
    [[nodiscard]] std::string spell(Variable variable) const;
    /// Gives back memory that was taken for more blocks.
    void fit();
};

// ---- files ----

/// A comment that speaks to maclint.
struct DirectiveComment {
    Span span;       ///< brackets included
    Span block;      ///< beside which it stands; empty: it has its line for itself
    Span next_block; ///< that is no comment; empty: its own block does something, or the file ends
};

/// A block number that words of other sections name.
struct BlockNumber {
    std::int64_t number;
    Span span;             ///< of the number
    std::uint32_t program; ///< place in ProgramFile::programs
    std::uint32_t section; ///< place in its sections
};

/// One file, read and lowered.
/// What a text tells of the machine that it is written for, where nothing else says it.
struct MachineSigns {
    bool tell = true;               ///< whether it is a mill or a lathe
    bool has_distance_code = false; ///< G91, or G90 in a move: system A of lathes has none
    friend bool operator==(MachineSigns, MachineSigns) = default;
};

struct ProgramFile {
    std::shared_ptr<const Source> source;
    const ControlModel* control = nullptr;
    MachineSigns machine_signs = {};
    std::vector<Program> programs;
    std::vector<SyntaxError> syntax_errors; ///< by where they begin
    std::vector<DirectiveComment> comments; ///< only those that contain "MACLINT", any case
    /// By number, then in text order; see index_block_numbers.
    std::vector<BlockNumber> block_numbers;

    /// The errors that begin in the span.
    [[nodiscard]] std::span<const SyntaxError> syntax_errors_in(Span span) const;
};

} // namespace maclint
