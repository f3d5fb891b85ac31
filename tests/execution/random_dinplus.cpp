//! Random DIN PLUS programs.
#include "tests/execution/random_programs.hpp"

#include <array>
#include <string>
#include <string_view>

namespace maclint::test {
namespace {

constexpr std::array<std::string_view, 10> din_variables{"#l1", "#l2", "#l3", "#l90", "#g1",
                                                         "#g2", "#c1", "#_n", "#_m",  "#__la"};
constexpr std::array<std::string_view, 6> din_relations{"==", "<>", "<", "<=", ">", ">="};
constexpr std::array<std::string_view, 11> din_functions{"SIN",   "COS", "TAN",  "ASIN", "ACOS", "ATAN",
                                                         "ROUND", "INT", "SQRT", "LOGN", "ABS"};
constexpr std::array<std::string_view, 13> din_words{"G1 X10",   "G0 Z5",    "G40",  "G41",    "G95 F0.2",
                                                     "G96 S150", "G18",      "G17",  "G16 Q1", "G16 Q0",
                                                     "G94 F#l1", "G97 S#g1", "X5 Z2"};
constexpr std::array<std::string_view, 5> states{"#n18(G)", "#n40(G)", "#n95(F)", "#e1", "#i5"};

class DinWriter {
  public:
    DinWriter(Dice& dice, std::vector<std::string> callees, bool is_main)
        : dice_(dice)
        , callees_(std::move(callees))
        , is_main_(is_main) {}

    std::string run() {
        statements(3 + dice_.below(9), 0);
        return text_;
    }

  private:
    void line(const std::string& text) { text_ += text + "\n"; }

    void statements(std::size_t count, int depth) {
        for (std::size_t i = 0; i < count; ++i) statement(depth);
    }

    void statement(int depth) {
        switch (dice_.below(22)) {
        case 0:
        case 1:
        case 2:
        case 3:
        case 4: return line(skip() + std::string(target()) + "=" + expression(2));
        case 5: {
            const std::string counter(target());
            return line(counter + "=" + counter + dice_.one_of(std::string_view("+-")) + constant());
        }
        case 6:
        case 7: return choice(depth);
        case 8:
        case 9: return loop(depth);
        case 10:
        case 11: return selection(depth);
        case 12:
        case 13:
        case 14: return line(skip() + call());
        case 15:
            return line((dice_.one_in(2) ? "#g(" : "#l(") + std::string(dice_.one_of(din_variables)) +
                        ")=" + expression(1));
        case 16: return line("INPUT(\"n\"," + std::string(target()) + ")");
        case 17: return line("PRINT(\"n\"," + expression(0) + ")");
        case 18: return line(dice_.one_in(3) ? end() : "G" + std::string(target()));
        default: return line(skip() + std::string(dice_.one_of(din_words)));
        }
    }

    std::string skip() { return dice_.one_in(8) ? "/1 " : ""; }

    void choice(int depth) {
        if (depth == 3) return line("#l1=1");
        line("IF " + condition());
        line("THEN");
        statements(dice_.below(3), depth + 1);
        if (dice_.one_in(2)) {
            line("ELSE");
            statements(dice_.below(3), depth + 1);
        }
        line("ENDIF");
    }

    void loop(int depth) {
        if (depth == 3) return line("#l2=2");
        const std::string counter(target());
        if (dice_.one_in(2)) {
            line(counter + "=" + constant());
            line("WHILE " + counter + std::string(dice_.one_of(din_relations)) + constant());
            line(counter + "=" + counter + dice_.one_of(std::string_view("++-")) + constant());
        } else {
            line("WHILE " + condition());
        }
        statements(1 + dice_.below(3), depth + 1);
        line("ENDWHILE");
    }

    void selection(int depth) {
        if (depth == 3) return line("#l3=3");
        line("SWITCH " + std::string(target()));
        const std::size_t cases = dice_.below(4);
        const std::size_t otherwise = dice_.below(6);
        for (std::size_t i = 0; i <= cases; ++i) {
            if (i == otherwise) {
                line("DEFAULT");
                branch(depth);
            }
            if (i == cases) break;
            line("CASE " + constant());
            branch(depth);
        }
        line("ENDSWITCH");
    }

    void branch(int depth) {
        statements(dice_.below(3), depth + 1);
        if (!dice_.one_in(3)) line("BREAK");
    }

    std::string call() {
        const std::string times = dice_.one_in(4) ? " Q" + std::to_string(dice_.below(3)) : "";
        std::string arguments;
        for (const std::string_view letter : {"LA", "LB"})
            if (dice_.one_in(2))
                arguments += " " + std::string(letter) + (dice_.one_in(2) ? constant() : "#l1");
        if (callees_.empty() || dice_.one_in(5)) return "L\"GONE\" V1" + times + arguments;
        return dice_.one_of(callees_) + times + arguments;
    }

    std::string end() {
        if (is_main_) return dice_.one_in(2) ? "/1 M30" : "/1 M99";
        return "/1 RETURN";
    }

    std::string_view target() {
        return din_variables[dice_.below(din_variables.size() - (is_main_ ? 1 : 0))];
    }

    std::string constant() {
        constexpr std::array<std::string_view, 10> numbers{"0", "1",   "2",  "3",  "4",
                                                           "5", "0.5", "18", "41", "2.25"};
        const std::string number(dice_.one_of(numbers));
        return dice_.one_in(4) ? "-" + number : number;
    }

    std::string expression(int depth) {
        if (depth == 0) return term();
        switch (dice_.below(6)) {
        case 0:
        case 1: return term();
        case 2: return std::string(dice_.one_of(din_functions)) + "(" + expression(depth - 1) + ")";
        case 3:
            return dice_.one_in(2) ? "#g(" + term() + ")"
                                   : "(" + std::string(dice_.one_of(din_variables)) + ")";
        default:
            return "(" + expression(depth - 1) + dice_.one_of(std::string_view("+-*/")) + "(" +
                   expression(depth - 1) + "))";
        }
    }

    std::string term() {
        switch (dice_.below(6)) {
        case 0:
        case 1: return constant();
        case 2: return std::string(dice_.one_of(states));
        default: return std::string(target());
        }
    }

    std::string condition() {
        if (!dice_.one_in(4)) return comparison();
        return "(" + comparison() + ") " + (dice_.one_in(2) ? "AND" : "OR") + " (" + comparison() + ")";
    }

    std::string comparison() {
        if (dice_.one_in(5))
            return std::string(dice_.one_in(2) ? "DEF(" : "NDEF(") + std::string(target().substr(1)) + ")";
        return term() + std::string(dice_.one_of(din_relations)) + term();
    }

    Dice& dice_;
    std::vector<std::string> callees_;
    bool is_main_;
    std::string text_;
};

std::string declarations(Dice& dice) {
    std::string text;
    if (dice.one_in(2)) text += "#_n=#l1\n";
    if (dice.one_in(3)) text += "#_m=4\n";
    if (dice.one_in(2)) text += "#_k=#l90(4)\n";
    return text.empty() ? text : "VAR\n" + text;
}

} // namespace

std::vector<NamedText> random_dinplus_programs(Dice& dice) {
    std::vector<NamedText> files;
    const std::string local = "L\"S\"";
    const std::string external = "L\"EXT\" V1";
    const bool has_local = !dice.one_in(3);
    const bool has_external = !dice.one_in(3);
    std::vector<std::string> callees;
    if (has_external) callees.push_back(external);
    std::vector<std::string> of_main = callees;
    if (has_local) of_main.push_back(local);
    std::string main = declarations(dice) + "MACHINING\n" + DinWriter(dice, of_main, true).run() + "M30\n";
    if (has_local) main += "SUBPROGRAM \"S\"\n" + DinWriter(dice, callees, false).run() + "RETURN\n";
    files.emplace_back("main.nc", std::move(main));
    if (has_external)
        files.emplace_back(
            "EXT.ncs",
            declarations(dice) + "MACHINING\n" +
                DinWriter(dice, dice.one_in(4) ? callees : std::vector<std::string>{}, false).run() +
                "RETURN\n");
    return files;
}

} // namespace maclint::test
