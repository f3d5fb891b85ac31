//! Random custom macros.
#include "tests/execution/random_programs.hpp"

#include <array>
#include <string>
#include <string_view>

namespace maclint::test {
namespace {

constexpr std::array variables{1, 2, 3, 4, 7, 10, 100, 101, 102, 500, 501};
constexpr std::array<std::string_view, 6> relations{"EQ", "NE", "LT", "LE", "GT", "GE"};
constexpr std::array<std::string_view, 8> operators{"+", "-", "*", "/", "MOD", "AND", "OR", "XOR"};
constexpr std::array<std::string_view, 17> functions{"SIN",  "COS", "TAN",   "ASIN", "ACOS", "ATAN",
                                                     "SQRT", "ABS", "ROUND", "FIX",  "FUP",  "LN",
                                                     "EXP",  "BIN", "BCD",   "ADP",  "ABS"};
constexpr std::array<std::string_view, 9> system_variables{"#4001", "#4003", "#4003", "#4007", "#4109",
                                                           "#3003", "#5041", "#1000", "#4012"};
constexpr std::array<std::string_view, 14> plain_words{"G90", "G91",   "G90 X1", "G91 G1 Y2 F100", "G81 Z-5",
                                                       "G80", "G0 Z5", "G17",    "G18 F200",       "G41",
                                                       "G40", "S800",  "X1 Y2",  "G90 G1 F50"};
constexpr std::string_view open_label = "@"; // replaced by a sequence number when all are there

class Writer {
  public:
    Writer(Dice& dice, int number, int programs, bool recursive)
        : dice_(dice)
        , number_(number)
        , programs_(programs)
        , is_main_(number == 1)
        , recursive_(recursive) {}

    std::string run() {
        statements(4 + dice_.below(10), 0);
        const std::string end = is_main_ ? (dice_.one_in(6) ? "" : "M30") : "M99";
        line(end);
        std::string text = "O000" + std::to_string(number_) + "\n";
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            std::string statement = lines_[i];
            for (auto at = statement.find(open_label); at != std::string::npos;
                 at = statement.find(open_label))
                statement.replace(at, 1, std::to_string(1 + dice_.below(lines_.size())));
            const bool skipped = statement.starts_with('/');
            // A sequence number makes a plain block no less plain; some have none.
            const std::string label = dice_.one_in(5) && i != 0 ? "" : "N" + std::to_string(i + 1);
            text += (skipped ? "/" : "") + label + statement.substr(skipped ? 1 : 0) + "\n";
        }
        return text;
    }

  private:
    void line(std::string text) { lines_.push_back(std::move(text)); }

    void statements(std::size_t count, int loops) {
        for (std::size_t i = 0; i < count; ++i) statement(loops);
    }

    void statement(int loops) {
        switch (dice_.below(30)) {
        case 0:
        case 1:
        case 2:
        case 3:
        case 4:
        case 5: return line(skip() + assignment());
        case 6: return line(variable() + "=#0");
        case 7: {
            const std::string counter = variable();
            return line(counter + "=" + counter + dice_.one_of(std::string_view("+-")) + constant());
        }
        case 8: return line("IF[" + condition() + "]THEN" + assignment());
        case 9:
        case 10:
        case 11: return line(skip() + "IF[" + condition() + "]GOTO@");
        case 12: return line("GOTO@");
        case 13: return dice_.one_in(3) ? line("GOTO" + variable()) : line("IF[" + condition() + "]GOTO@");
        case 14:
        case 15: return line(skip() + "#[" + store_index() + "]=" + expression(1));
        case 16: return line(skip() + std::string(dice_.one_of(plain_words)));
        case 17: return line(std::string(dice_.one_of(plain_words)));
        case 18: return line(computed_words());
        case 19: return line(dice_.one_in(2) ? "#3003=" + expression(0) : "G" + variable());
        case 20:
        case 21:
        case 22: return line(skip() + call());
        case 23: return modal_call();
        case 24:
        case 25: return loop(loops);
        case 26: return line(end());
        case 27: return line(variable() + "=" + std::string(dice_.one_of(system_variables)));
        case 28:
            return line(std::string(dice_.one_of(std::array{"DPRNT[X#1[35]]", "M00", "G4 X1", "", "M6"})));
        default: return line("X" + variable() + " F" + variable());
        }
    }

    std::string skip() { return dice_.one_in(8) ? "/" : ""; }

    void loop(int loops) {
        if (loops == 3) return line(assignment());
        const std::string number = std::to_string(loops + 1);
        const std::size_t length = 1 + dice_.below(4);
        if (dice_.one_in(4)) {
            line("DO" + number);
            line("IF[" + condition() + "]GOTO@");
        } else if (dice_.one_in(2)) { // a loop that counts
            const std::string counter = variable();
            line(counter + "=" + constant());
            line("WHILE[" + counter + std::string(dice_.one_of(relations)) + constant() + "]DO" + number);
            line(counter + "=" + counter + dice_.one_of(std::string_view("++-")) + constant());
        } else {
            line("WHILE[" + condition() + "]DO" + number);
        }
        statements(length, loops + 1);
        line("END" + number);
    }

    std::string call() {
        const int callee =
            dice_.between(recursive_ ? 2 : number_ + 1, programs_ + 1); // the last one is not there
        const std::string program = "P" + std::to_string(callee > programs_ ? 77 : callee);
        const std::string times = dice_.one_in(4) ? " L" + times_of_call() : "";
        if (dice_.one_in(2)) return "M98 " + program + times;
        return "G65 " + program + times + arguments();
    }

    std::string times_of_call() { return dice_.one_in(4) ? variable() : std::to_string(dice_.below(3)); }

    std::string arguments() {
        std::string text;
        for (const char letter : std::string_view("ABCIDI"))
            if (dice_.one_in(3))
                text += std::string(" ") + letter + (dice_.one_in(2) ? variable() : constant());
        return text;
    }

    /// What programs that call each other leave in force counts as unknown, and an unknown program is taken
    /// to leave no modal call.
    void modal_call() {
        if (recursive_) return line("G17");
        if (dice_.one_in(3)) return line("G67");
        if (number_ >= programs_) return line("G66 P77" + arguments());
        line("G66 P" + std::to_string(dice_.between(number_ + 1, programs_)) + arguments());
        line(std::string(dice_.one_of(plain_words)));
        line(std::string(dice_.one_of(plain_words)));
    }

    std::string end() {
        if (is_main_) return dice_.one_in(2) ? "IF[" + condition() + "]THEN#3000=1" : "/M30";
        if (dice_.one_in(3)) return "/M99";
        if (dice_.one_in(3)) return "/M99 P" + std::to_string(1 + dice_.below(9));
        return dice_.one_in(3) ? "/M30" : "IF[" + condition() + "]THEN#3000=1";
    }

    std::string computed_words() {
        return std::string(dice_.one_of(std::array{"G1 X", "G0 Y", "F", "S", "G90 X", "T"})) + "[" +
               expression(1) + "]";
    }

    std::string assignment() { return variable() + "=" + expression(2); }

    std::string index() {
        switch (dice_.below(5)) {
        case 0: return variable();
        case 4: return std::to_string(dice_.one_of(std::array{1, 100, 101})) + "+#1000";
        case 1: return std::to_string(dice_.between(100, 103));
        case 2: return "100+ABS[" + variable() + "]";
        default: return variable() + "+" + std::to_string(dice_.one_of(std::array{1, 2, 100}));
        }
    }

    /// As programmers write it, see IndexCustom: what is counted is not what is stored in, and variables that
    /// all programs share lead to no local one.
    std::string store_index() {
        switch (dice_.below(4)) {
        case 0: return "#4007-39"; // local 1 to 3
        case 1: return std::to_string(dice_.between(100, 103));
        case 2: return "100+ABS[#1]";
        default: return std::to_string(dice_.one_of(std::array{1, 100, 101})) + "+#1000";
        }
    }

    std::string variable() { return "#" + std::to_string(dice_.one_of(variables)); }

    std::string constant() {
        constexpr std::array<std::string_view, 12> numbers{"0", "1",   "2",  "3",  "4",  "5",
                                                           "7", "0.5", "10", "90", "91", "2.25"};
        const std::string number(dice_.one_of(numbers));
        return dice_.one_in(4) ? "[-" + number + "]" : number;
    }

    std::string expression(int depth) {
        if (depth == 0) return term();
        switch (dice_.below(8)) {
        case 0:
        case 1: return term();
        case 2: return std::string(dice_.one_of(functions)) + "[" + expression(depth - 1) + "]";
        case 3: return "ATAN[" + term() + "]/[" + term() + "]";
        case 4: return dice_.one_in(2) ? "POW[" + term() + "," + term() + "]" : "-" + variable();
        case 5: return "#[" + index() + "]";
        default:
            return "[" + expression(depth - 1) + std::string(dice_.one_of(operators)) +
                   expression(depth - 1) + "]";
        }
    }

    std::string term() {
        switch (dice_.below(8)) {
        case 0:
        case 1: return constant();
        case 2: return std::string(dice_.one_of(system_variables));
        case 3: return dice_.one_in(4) ? "#0" : variable();
        default: return variable();
        }
    }

    std::string condition() {
        constexpr std::array<std::string_view, 4> links{"AND", "OR", "AND", "XOR"};
        if (!dice_.one_in(4)) return comparison();
        return "[" + comparison() + "]" + std::string(dice_.one_of(links)) + "[" + comparison() + "]";
    }

    std::string comparison() {
        if (dice_.one_in(4)) return variable() + (dice_.one_in(2) ? "EQ#0" : "NE#0");
        const std::string left = dice_.one_in(5)   ? "-" + variable()
                                 : dice_.one_in(4) ? expression(1)
                                                   : term();
        return left + std::string(dice_.one_of(relations)) + term();
    }

    Dice& dice_;
    int number_;
    int programs_; ///< O0001 to this one are there
    bool is_main_;
    bool recursive_; ///< programs call each other in circles
    std::vector<std::string> lines_;
};

} // namespace

std::vector<NamedText> random_fanuc_programs(Dice& dice) {
    const int programs = dice.between(1, 3);
    const bool recursive = dice.one_in(4);
    std::vector<NamedText> files;
    for (int number = 1; number <= programs; ++number)
        files.emplace_back("O" + std::to_string(number) + ".nc",
                           Writer(dice, number, programs, recursive).run());
    return files;
}

} // namespace maclint::test
