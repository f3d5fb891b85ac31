//! The printer.
#include "analyzer/program/dump.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"

#include <array>
#include <charconv>

namespace maclint {
namespace {

std::string text_of(double value) {
    std::array<char, 40> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    return {digits.data(), error == std::errc{} ? end : digits.data()};
}

std::string describe_machine(const Program& program, FamilyId family, std::int32_t number) {
    return program.control->families[family].name.data() + std::to_string(number);
}

std::string describe_slice(const Program& program, Slice slice) {
    std::string out;
    for (const Effect& effect : program.effects_in(slice)) {
        if (!out.empty()) out += "; ";
        out += describe(program, effect);
    }
    return out;
}

std::string describe_given(const Program& program, const Argument& argument) {
    return std::visit(overloaded{[&](Variable variable) { return program.spell(variable); },
                                 [](ArgumentPosition position) { return std::to_string(position.number); },
                                 [](std::string_view name) { return std::string(name); }},
                      argument.given);
}

std::string describe(const Program& program, const Jump& jump) {
    static constexpr std::string_view searches[] = {"", " forward", " backward", " forward-then-backward"};
    std::string out = "jump " + maclint::describe(program, jump.target);
    out += searches[static_cast<std::size_t>(jump.search)];
    if (jump.missing == MissingLabel::skip) out += " if-there";
    return out;
}

std::string describe(const Program& program, const Call& call) {
    std::string out = "call ";
    out += program.control->calls[call.kind].name;
    out += ' ';
    out += std::visit(overloaded{[](std::monostate) -> std::string { return "?"; },
                                 [&](ExpressionId id) { return maclint::describe(program, id); },
                                 [&](Text name) { return std::string(program.slice(name.characters)); }},
                      call.program);
    for (const Argument& argument : program.arguments_of(call)) {
        out += ' ';
        out += argument.address;
        out += '>' + describe_given(program, argument) + '=' + maclint::describe(program, argument.value);
    }
    if (call.repeat) out += " times " + maclint::describe(program, *call.repeat);
    return out;
}

std::string describe(const Program& program, const RegionMark& mark) {
    static constexpr std::string_view region_kinds[] = {"while", "endless",  "choice", "selection",
                                                        "unit",  "counting", "until"};
    static constexpr std::string_view parts[] = {"open", "begin", "middle", "leave", "close"};
    std::string out(parts[static_cast<std::size_t>(mark.part)]);
    out += ' ';
    out += region_kinds[static_cast<std::size_t>(mark.region_kind)];
    if (mark.number) out += ' ' + std::to_string(*mark.number);
    if (mark.condition) out += ' ' + maclint::describe(program, *mark.condition);
    return out;
}

std::string describe(const Program& program, const UnreadableBlock& block) {
    std::string out = "unreadable";
    for (const Variable variable : program.variables_of(block)) out += " writes " + program.spell(variable);
    for (const Label& label : program.labels_of(block)) out += " jumps " + program.spell(label);
    if (block.may_open_or_close) out += " opens-or-closes";
    if (block.may_call_or_return) out += " calls-or-returns";
    return out;
}

std::string describe(const Program& program, const Assign& assign) {
    const std::string target = std::visit(
        overloaded{[&](Variable variable) { return program.spell(variable); },
                   [&](const StoreAt& at) { return "#[" + maclint::describe(program, at.index) + "]"; },
                   [&](const StoreMachine& at) {
                       return "machine " + describe_machine(program, at.family, at.number);
                   }},
        assign.target);
    return target + " := " + maclint::describe(program, assign.value);
}

std::string describe(const Program& program, const BlockView& block) {
    std::string out;
    for (unsigned channel = 0; channel < 16; ++channel)
        if ((block.channels >> channel & 1U) != 0) out += '$' + std::to_string(channel) + ' ';
    if (block.number) out += 'N' + std::to_string(*block.number) + ' ';
    if (block.name) out += program.spell(*block.name) + ": ";
    for (unsigned level = 0; level < 16; ++level)
        if ((block.skip_levels >> level & 1U) != 0) out += '/' + std::to_string(level) + ' ';
    std::string effects = describe_slice(program, block.effects);
    const auto add = [&](const std::string& effect) { effects += (effects.empty() ? "" : "; ") + effect; };
    if (block.effects.count == 0)
        for (const BlockSetting& setting : block.settings)
            add(std::string(program.control->groups[setting.group].name) + '=' + text_of(*setting.value));
    if (block.moves) add("move");
    return out + effects;
}

} // namespace

std::string_view name_of(Operation operation) {
    static constexpr std::string_view names[] = {
        "add",     "subtract", "multiply",  "divide",  "modulo",     "power",   "negate",
        "bit-and", "bit-or",   "bit-xor",   "bit-not", "all-of",     "any-of",  "one-of",
        "not",     "equal",    "not-equal", "less",    "less-equal", "greater", "greater-equal",
        "vacant?", "set?",     "sin",       "cos",     "tan",        "asin",    "acos",
        "atan",    "atan2",    "sqrt",      "abs",     "round",      "fix",     "fup",
        "ln",      "exp",      "bin",       "bcd",     "adp",        "unknown"};
    static_assert(std::size(names) == static_cast<std::size_t>(Operation::unknown) + 1);
    return names[static_cast<std::size_t>(operation)];
}

std::string_view name_of(SyntaxErrorKind syntax_error) {
    static constexpr std::string_view names[] = {"oversized-block",
                                                 "unterminated-comment",
                                                 "parenthesis-as-bracket",
                                                 "bracket-mismatch",
                                                 "unknown-keyword",
                                                 "missing-construct",
                                                 "symbolic-comparison",
                                                 "bracket-depth",
                                                 "assignment-to-null",
                                                 "loop-without-do",
                                                 "call-without-program",
                                                 "not-alone",
                                                 "then-missing",
                                                 "assignment-in-condition",
                                                 "comparison-as-assignment",
                                                 "hash-in-vacancy-test",
                                                 "unknown-transfer-value",
                                                 "nested-comment",
                                                 "bare-remark",
                                                 "point-in-variable-number",
                                                 "fraction-in-variable-number",
                                                 "letter-o",
                                                 "letter-o-or-jump",
                                                 "missing-value",
                                                 "double-sharp",
                                                 "letter-in-jump",
                                                 "words-after-jump",
                                                 "condition-without-brackets",
                                                 "condition-alone",
                                                 "consequence-without-then",
                                                 "words-after-then",
                                                 "more-after-then",
                                                 "logic-outside-brackets",
                                                 "words-beside-statement",
                                                 "statement-beside-statement",
                                                 "jump-beside-statement",
                                                 "function-without-brackets",
                                                 "comparison-as-value",
                                                 "sign-after-sign",
                                                 "condition-before-return",
                                                 "wide-sign",
                                                 "foreign-remark",
                                                 "small-letters",
                                                 "unknown-variable",
                                                 "read-only-variable",
                                                 "reserved-variable",
                                                 "text-for-number",
                                                 "number-for-text",
                                                 "text-in-calculation",
                                                 "other-plc-type",
                                                 "fraction-for-integer",
                                                 "integer-overflow",
                                                 "malformed-name",
                                                 "constant-too-early",
                                                 "constant-stored",
                                                 "undeclared-name",
                                                 "calculated-index",
                                                 "unknown-selector",
                                                 "unknown-internal-constant",
                                                 "other-vacancy-test",
                                                 "argument-count",
                                                 "bit-out-of-range",
                                                 "window-out-of-range",
                                                 "input-into-no-variable",
                                                 "too-many-conditions",
                                                 "selection-of-calculation",
                                                 "unknown-call-word",
                                                 "too-many-arguments",
                                                 "repeat-count",
                                                 "number-for-block",
                                                 "long-program-name",
                                                 "description-unbalanced",
                                                 "wrong-description",
                                                 "doubled-alias",
                                                 "group-unbalanced",
                                                 "section-of-other-language",
                                                 "slide-not-in-head",
                                                 "blank-in-variable",
                                                 "number-too-long",
                                                 "no-condition",
                                                 "converted-leftover",
                                                 "missing-equals",
                                                 "remark-without-sign",
                                                 "colon-in-jump",
                                                 "second-block",
                                                 "head-at-structure",
                                                 "foreign-keyword",
                                                 "taken-name",
                                                 "text-too-long",
                                                 "malformed-case",
                                                 "split-declaration",
                                                 "late-definition",
                                                 "unknown-system-variable",
                                                 "wrong-dimensions",
                                                 "too-many-initial-values",
                                                 "empty-counting",
                                                 "value-twice",
                                                 "mark-missing",
                                                 "passes-out-of-range",
                                                 "action-on-local",
                                                 "action-again",
                                                 "action-left",
                                                 "alarm-number",
                                                 "block-too-long",
                                                 "too-many-functions",
                                                 "action-number",
                                                 "other-program-name",
                                                 "ambiguous-jump",
                                                 "frame-lost",
                                                 "position-as-distance",
                                                 "unreadable"};
    static_assert(std::size(names) == static_cast<std::size_t>(SyntaxErrorKind::unreadable) + 1);
    return names[static_cast<std::size_t>(syntax_error)];
}

std::string describe(const Program& program, ExpressionId expression) {
    const auto apply = [&](const Apply& node) {
        std::string out(name_of(node.operation));
        out += '(';
        bool first = true;
        for (const ExpressionId operand : program.operands_of(node)) {
            if (!first) out += ", ";
            first = false;
            out += describe(program, operand);
        }
        return out + ')';
    };
    return std::visit(
        overloaded{[](const Literal& node) { return text_of(node.value) + (node.decimal_point ? "." : ""); },
                   [&](const Text& node) { return '"' + std::string(program.slice(node.characters)) + '"'; },
                   [&](const BlockName& node) { return program.spell(Label(node)); },
                   [](Vacant) { return std::string("vacant"); },
                   [&](const Load& node) { return program.spell(node.variable); },
                   [&](const LoadAt& node) { return "#[" + describe(program, node.index) + "]"; },
                   [&](const LoadModal& node) {
                       return "modal(" + std::string(program.control->groups[node.group].name) + ")";
                   },
                   [&](const LoadMachine& node) {
                       return "machine " + describe_machine(program, node.family, node.number);
                   },
                   apply, [](Unreadable) { return std::string("unreadable"); }},
        program.expressions[expression].node);
}

std::string describe(const Program& program, const Effect& effect) {
    const auto optional = [&](std::string_view before, const std::optional<ExpressionId>& id) {
        return id ? std::string(before) + describe(program, *id) : std::string();
    };
    return std::visit(
        overloaded{
            [&](const Assign& what) { return describe(program, what); },
            [&](const SetModal& what) {
                const std::string group(what.group ? program.control->groups[*what.group].name : "modal");
                return group + '=' + describe(program, what.value);
            },
            [&](const EvaluateWords& values) {
                std::string text = "values";
                for (const ExpressionId value : program.values_of(values))
                    text += ' ' + describe(program, value);
                return text;
            },
            [](Motion motion) {
                return std::string(motion.without_feed ? "rapid move" : "move") +
                       (motion.to_reference ? " to reference" : "");
            },
            [](Synchronise stop) {
                return std::string(stop.from_here_on ? "synchronise from here on" : "synchronise");
            },
            [&](const Stop& what) {
                static constexpr std::string_view kinds[] = {"alarm", "pause", "end", "restart"};
                return std::string(kinds[static_cast<std::size_t>(what.kind)]) + optional(" ", what.number);
            },
            [](const ToolChange& what) {
                return std::string(what.kind == ToolChange::Kind::change ? "tool change"
                                                                         : "to the tool change position");
            },
            [&](const RegionMark& what) { return describe(program, what); },
            [&](const Jump& what) { return describe(program, what); },
            [&](const Call& what) { return describe(program, what); },
            [&](const Return& what) {
                return "return" + optional(" ", what.value) + optional(" to ", what.resume_label);
            },
            [&](const Exchange& what) {
                std::string out = "exchange";
                for (const ExpressionId id : program.values_of(what)) out += " out " + describe(program, id);
                for (const Variable variable : program.variables_of(what))
                    out += " in " + program.spell(variable);
                return out;
            },
            [&](const Guarded& what) {
                return "if " + describe(program, what.condition) + " {" +
                       describe_slice(program, what.effects) + "}";
            },
            [&](const UnreadableBlock& what) { return describe(program, what); },
            [&](const Reference& what) {
                return std::string(program.control->references[what.kind].name) + ' ' +
                       describe(program, what.block);
            }},
        effect.what);
}

std::string describe(const Program& program) {
    std::string out;
    for_each_block(program, [&](const BlockView& block) { out += describe(program, block) + '\n'; });
    return out;
}

std::string describe(const ProgramFile& file) {
    std::string out;
    for (const Program& program : file.programs) out += program.name + ":\n" + describe(program);
    for (const SyntaxError& syntax_error : file.syntax_errors) {
        out += "! ";
        out += name_of(syntax_error.kind);
        out += " '" + syntax_error.subject + "'";
        if (!syntax_error.cure.empty()) out += " -> " + syntax_error.cure;
        out += '\n';
    }
    return out;
}

} // namespace maclint
