//! What data flow says of random programs, held against running them.
#include "tests/support/analysed.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

using Content = std::optional<double>; ///< of a variable; nothing: vacant

constexpr std::array locals_and_commons{1, 2, 3, 100, 101};
constexpr std::array inputs{500, 501, 502}; // nothing sets them, so they can hold anything
constexpr std::array<std::string_view, 6> relations{"EQ", "NE", "LT", "LE", "GT", "GE"};

/// From one engine without a standard distribution: the programs are the same everywhere.
class Dice {
  public:
    explicit Dice(unsigned seed)
        : engine_{seed} {}
    std::size_t below(std::size_t limit) { return static_cast<std::size_t>(engine_()) % limit; }
    template<class List>
    auto one_of(const List& list) {
        return list[below(list.size())];
    }

  private:
    std::mt19937 engine_;
};

/// A number or a variable.
struct Term {
    std::optional<int> variable;
    int number = 0;
};

struct Line {
    enum class Kind : std::uint8_t { assign, clear, jump, jump_if } kind = Kind::assign;
    int variable = 0;
    Term left, right;
    char sign = 0; ///< assign: '+' or '-' between the terms; 0: `left` alone
    std::string_view relation;
    std::size_t target = 0;
};

Term random_term(Dice& dice) {
    switch (dice.below(4)) {
    case 0: return {std::nullopt, static_cast<int>(dice.below(9)) - 3};
    case 1: return {dice.one_of(inputs), 0};
    default: return {dice.one_of(locals_and_commons), 0};
    }
}

std::vector<Line> random_program(Dice& dice) {
    constexpr std::array kinds{Line::Kind::assign,  Line::Kind::assign,  Line::Kind::clear,
                               Line::Kind::jump_if, Line::Kind::jump_if, Line::Kind::jump_if,
                               Line::Kind::jump};
    std::vector<Line> lines(6 + dice.below(10));
    for (Line& line : lines) {
        line.kind = dice.one_of(kinds);
        line.variable = dice.one_of(locals_and_commons);
        line.left = random_term(dice);
        line.right = random_term(dice);
        line.sign = dice.one_of(std::string_view("\0+-", 3));
        line.relation = dice.one_of(relations);
        line.target = dice.below(lines.size() + 1);
    }
    return lines;
}

std::string text_of(const Term& term) {
    if (term.variable) return "#" + std::to_string(*term.variable);
    return term.number < 0 ? "[" + std::to_string(term.number) + "]" : std::to_string(term.number);
}

/// The program, and where the statement of each line begins in it.
std::pair<std::string, std::map<Offset, std::size_t>> text_of(const std::vector<Line>& lines) {
    std::string text = "O0001\n";
    std::map<Offset, std::size_t> begins;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Line& line = lines[i];
        text += "N" + std::to_string(i + 1);
        begins[static_cast<Offset>(text.size())] = i;
        const std::string target = "GOTO" + std::to_string(line.target + 1);
        switch (line.kind) {
        case Line::Kind::assign:
            text += "#" + std::to_string(line.variable) + "=" + text_of(line.left);
            if (line.sign != 0) text += line.sign + text_of(line.right);
            break;
        case Line::Kind::clear: text += "#" + std::to_string(line.variable) + "=#0"; break;
        case Line::Kind::jump: text += target; break;
        case Line::Kind::jump_if:
            text += "IF[" + text_of(line.left) + std::string(line.relation) + text_of(line.right) + "]";
            text += target;
            break;
        }
        text += "\n";
    }
    text += "N" + std::to_string(lines.size() + 1) + "M30\n";
    return {text, begins};
}

/// What the runs of a program have shown of one line.
struct Seen {
    bool ran = false;
    bool held = false;
    bool failed = false;
    std::vector<std::pair<int, Content>> read;
};

class Machine {
  public:
    Machine(const std::vector<Line>& lines, std::vector<Seen>& seen)
        : lines_(lines)
        , seen_(seen) {}

    void run(Dice& dice) {
        constexpr std::array contents{Content{}, Content{0}, Content{1}, Content{4}, Content{-2}};
        for (const int variable : inputs) variables_[variable] = dice.one_of(contents);
        for (const int common : {100, 101}) variables_[common] = dice.one_of(contents);
        constexpr int longest_run = 120;
        std::size_t at = 0;
        for (int i = 0; i < longest_run && at < lines_.size(); ++i) at = step(at);
    }

  private:
    std::size_t step(std::size_t at) {
        const Line& line = lines_[at];
        Seen& seen = seen_[at];
        seen.ran = true;
        switch (line.kind) {
        case Line::Kind::assign: {
            Content value = read(line.left, seen);
            // A calculation takes vacant for 0; a copy stays vacant.
            if (line.sign != 0) {
                const double right = read(line.right, seen).value_or(0);
                value = line.sign == '+' ? value.value_or(0) + right : value.value_or(0) - right;
            }
            variables_[line.variable] = value;
            return at + 1;
        }
        case Line::Kind::clear: variables_[line.variable] = Content{}; return at + 1;
        case Line::Kind::jump: return line.target;
        case Line::Kind::jump_if: {
            const Content left = read(line.left, seen);
            const Content right = read(line.right, seen);
            const bool holds = compare(left, line.relation, right);
            (holds ? seen.held : seen.failed) = true;
            return holds ? line.target : at + 1;
        }
        }
        return at + 1;
    }

    Content read(const Term& term, Seen& seen) {
        if (!term.variable) return term.number;
        const Content content = variables_[*term.variable];
        seen.read.emplace_back(*term.variable, content);
        return content;
    }

    /// EQ and NE tell vacant from 0, the others take it for 0 (custom macro reference, section 4).
    static bool compare(Content left, std::string_view relation, Content right) {
        if (relation == "EQ") return left == right;
        if (relation == "NE") return left != right;
        const double a = left.value_or(0);
        const double b = right.value_or(0);
        if (relation == "LT") return a < b;
        if (relation == "LE") return a <= b;
        return relation == "GT" ? a > b : a >= b;
    }

    const std::vector<Line>& lines_;
    std::vector<Seen>& seen_;
    std::map<int, Content> variables_;
};

bool allows(const dataflow::Value& value, Content content) {
    if (!content) return value.vacancy != dataflow::Vacancy::set;
    if (value.vacancy == dataflow::Vacancy::vacant) return false;
    return value.low <= *content && *content <= value.high && !(value.nonzero && *content == 0) &&
           !(value.integer && std::floor(*content) != *content);
}

void expect_sound(const std::vector<Line>& lines, Dice& dice) {
    const auto [text, begins] = text_of(lines);
    std::vector<Seen> seen(lines.size());
    constexpr int runs = 40;
    for (int i = 0; i < runs; ++i) Machine(lines, seen).run(dice);

    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto line_of = [&](EffectId effect) {
        return begins.at(analysis.program().effects[effect].span.begin);
    };
    for (const dataflow::Condition& condition : analysis.facts().conditions) {
        const std::size_t line = line_of(condition.effect);
        EXPECT_TRUE(condition.truth.can_hold || !seen[line].held) << "N" << line + 1 << " holds\n" << text;
        EXPECT_TRUE(condition.truth.can_fail || !seen[line].failed) << "N" << line + 1 << " fails\n" << text;
    }
    std::vector<bool> reached(lines.size(), false);
    for (flow::NodeId node = 0; node < analysis.graph().nodes.size(); ++node)
        for (const Effect& effect : analysis.program().effects_in(analysis.graph().nodes[node].effects))
            if (const auto line = begins.find(effect.span.begin);
                line != begins.end() && analysis.data().reached(node))
                reached[line->second] = true;
    for (std::size_t line = 0; line < lines.size(); ++line)
        EXPECT_TRUE(reached[line] || !seen[line].ran) << "N" << line + 1 << " runs\n" << text;
    for (const dataflow::Read& read : analysis.facts().reads) {
        const std::size_t line = line_of(read.effect);
        for (const auto& [variable, content] : seen[line].read)
            EXPECT_TRUE(variable != read.variable.number || allows(read.value, content))
                << "N" << line + 1 << " reads " << (content ? std::to_string(*content) : "vacant")
                << " from #" << variable << "\n"
                << text;
    }
}

TEST(Soundness, WhatRunsShowIsWhatDataFlowAllows) {
    constexpr unsigned programs = 2000;
    for (unsigned seed = 0; seed < programs && !testing::Test::HasFailure(); ++seed) {
        Dice dice(seed);
        expect_sound(random_program(dice), dice);
    }
}

} // namespace
} // namespace maclint
