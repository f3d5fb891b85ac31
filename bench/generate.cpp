//! The generators: a writer for blocks, then one function per kind of program.
#include "bench/generate.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string_view>
#include <utility>

namespace maclint::bench {
namespace {

constexpr std::size_t lines_between_tool_changes = 20'000;
constexpr std::size_t points_in_a_pass = 120;
constexpr std::size_t passes_over_the_part = 400;
constexpr std::size_t first_helper_number = 9000;
constexpr std::size_t helper_count = 8;
constexpr std::size_t first_macro_number = 10'000;

/// A length in the least input increment of a metric control, 0.001 mm.
struct Micrometres {
    std::int64_t count;
};

Micrometres micrometres(double millimetres) { return {std::llround(millimetres * 1000.0)}; }

/// Numbers from one engine without a standard distribution, whose results differ between libraries.
class Dice {
  public:
    explicit Dice(unsigned seed)
        : engine_{seed} {}

    std::size_t below(std::size_t limit) { return static_cast<std::size_t>(engine_()) % limit; }

  private:
    std::mt19937 engine_;
};

/// Program text under construction.
class Tape {
  public:
    explicit Tape(std::size_t expected_bytes) { text_.reserve(expected_bytes + expected_bytes / 16 + 4096); }

    Tape& operator<<(std::string_view text) {
        text_ += text;
        return *this;
    }

    Tape& operator<<(std::size_t number) {
        std::array<char, 24> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
        text_.append(digits.data(), end);
        return *this;
    }

    /// Written with a decimal point and without trailing zeros: -12.5, 3., 0.001.
    Tape& operator<<(Micrometres length) {
        if (length.count < 0) text_ += '-';
        const auto magnitude = static_cast<std::size_t>(std::abs(length.count));
        *this << magnitude / 1000;
        text_ += '.';
        const std::size_t fraction = magnitude % 1000;
        if (fraction == 0) return *this;
        const std::array<char, 3> digits{digit(fraction / 100), digit(fraction / 10 % 10),
                                         digit(fraction % 10)};
        std::size_t used = digits.size();
        while (digits.at(used - 1) == '0') --used;
        text_.append(digits.data(), used);
        return *this;
    }

    [[nodiscard]] std::size_t size() const { return text_.size(); }
    [[nodiscard]] std::string take() { return std::move(text_); }

  private:
    static char digit(std::size_t value) { return static_cast<char>('0' + value); }

    std::string text_;
};

// ---- CAM output
// ----------------------------------------------------------------------------------------------

/// Which blocks have an N number.
enum class Numbers : std::uint8_t { of_every_second_tool, everywhere };

/// One job of raster passes over a freeform surface.
class CamJob {
  public:
    CamJob(Tape& tape, Numbers numbers)
        : tape_{tape}
        , numbers_{numbers} {
        tape_ << "%\nO0001 (MOULD INSERT, FINISHING)\n(POSTED FOR A 3 AXIS MILL, METRIC)\n";
        tape_ << "G00 G17 G21 G40 G49 G80 G90\n";
    }

    /// The operator may go on in the middle of a tool's work.
    void write_jump() { tape_ << "IF [#500 EQ 1] GOTO 15000\n"; }

    void write_pass() {
        if (tool_ == 0 || lines_since_tool_ >= lines_between_tool_changes) change_tool();
        const double y = height_of_pass(pass_);
        const bool forward = pass_ % 2 == 0;
        for (std::size_t i = 0; i < points_in_a_pass; ++i) {
            const auto step = static_cast<double>(forward ? i : points_in_a_pass - 1 - i);
            write_point(step * 0.8 - 48.0, y);
        }
        write_turn(forward);
        ++pass_;
    }

    void finish() {
        end_tool();
        begin_line() << "M30\n";
        tape_ << "%\n";
    }

  private:
    Tape& begin_line() {
        ++lines_since_tool_;
        if (numbers_ == Numbers::everywhere || tool_ % 2 == 0) tape_ << "N" << lines_since_tool_ << " ";
        return tape_;
    }

    static double height_of_pass(std::size_t pass) {
        return static_cast<double>(pass % passes_over_the_part) * 0.25 - 50.0;
    }

    static double surface(double x, double y) { return 6.0 * std::sin(x * 0.11) * std::cos(y * 0.07) - 8.0; }

    void write_point(double x, double y) {
        Tape& line = begin_line() << "X" << micrometres(x);
        // A post leaves out what does not change: Y within a pass.
        if (first_point_) line << " Y" << micrometres(y);
        line << " Z" << micrometres(surface(x, y));
        if (first_point_) line << " F2400";
        line << "\n";
        first_point_ = false;
    }

    /// Half a circle of 0.125 mm into the next pass, then straight on; back to the first pass after the last.
    void write_turn(bool forward) {
        const auto next = micrometres(height_of_pass(pass_ + 1));
        if ((pass_ + 1) % passes_over_the_part == 0) {
            begin_line() << "Y" << next << "\n";
            return;
        }
        begin_line() << (forward ? "G03" : "G02") << " Y" << next << " J.125\n";
        begin_line() << "G01\n";
    }

    void change_tool() {
        if (tool_ > 0) end_tool();
        ++tool_;
        lines_since_tool_ = 0;
        first_point_ = true;
        const std::size_t number = (tool_ - 1) % 24 + 1;
        tape_ << "\n(BALL NOSE " << number << ")\n";
        begin_line() << "T" << number << " M06\n";
        begin_line() << "G90 G54 G00 X-48. Y-50. S12000 M03\n";
        begin_line() << "G43 H" << number << " Z30. M08\n";
        begin_line() << "G01 Z2. F1000\n";
    }

    void end_tool() {
        begin_line() << "G00 Z30. M09\n";
        begin_line() << "M05\n";
        begin_line() << "G91 G28 Z0.\n";
        begin_line() << "G90 G49\n";
    }

    Tape& tape_;
    Numbers numbers_;
    std::size_t lines_since_tool_ = 0;
    std::size_t tool_ = 0;
    std::size_t pass_ = 0;
    bool first_point_ = true;
};

// ---- macro code
// ----------------------------------------------------------------------------------------------

void write_checks(Tape& tape, Dice& dice) {
    constexpr std::array<std::string_view, 6> checks{"IF [#24 EQ #0] THEN #3000 = 1 (X MISSING)\n",
                                                     "IF [#25 EQ #0] THEN #3000 = 2 (Y MISSING)\n",
                                                     "IF [#26 EQ #0] GOTO 900\n",
                                                     "IF [#18 EQ #0] GOTO 900\n",
                                                     "IF [#17 LE 0] GOTO 901\n",
                                                     "IF [#9 LE 0] GOTO 902\n"};
    for (const std::string_view check : checks) tape << check;
    if (dice.below(2) == 0) tape << "IF [#1 EQ #0] THEN #1 = 0\n";
    if (dice.below(2) == 0) tape << "IF [#11 LT 1] THEN #11 = 1\n";
}

void write_drilling_loop(Tape& tape, Dice& dice) {
    tape << "#27 = 0\n#28 = " << dice.below(20) + 2 << "\nWHILE [#27 LT #28] DO 1\n"
         << "  #29 = #1 + #27 * 360 / #28\n"
         << "  G81 X[#24 + #4 * COS[#29]] Y[#25 + #4 * SIN[#29]] Z#26 R#18 F#9\n"
         << "  #27 = #27 + 1\nEND 1\nG80\n";
}

void write_pocket_loop(Tape& tape, Dice& dice) {
    tape << "#27 = FUP[[#18 - #26] / #17]\n#28 = 1\nWHILE [#28 LE #27] DO 1\n"
         << "  G0 X#24 Y#25\n  G1 Z[#18 - #28 * [#18 - #26] / #27] F[#9 / 2]\n  #29 = 1\n"
         << "  WHILE [#29 LE " << dice.below(9) + 2 << "] DO 2\n"
         << "    X[#24 + #29 * 1.5] F#9\n    Y[#25 + #29 * 1.5]\n    X[#24 - #29 * 1.5]\n"
         << "    Y[#25 - #29 * 1.5]\n    #29 = #29 + 1\n  END 2\n"
         << "  G0 Z[#18 + 2.]\n  #28 = #28 + 1\nEND 1\n";
}

void write_probing(Tape& tape, Dice& dice) {
    tape << "#27 = #26 - #17\nG31 Z#27 F" << dice.below(200) + 50 << ".\n"
         << "IF [ABS[#5063 - #27] LT 0.01] GOTO 903\n#28 = #5063\nG0 Z#18\n"
         << "#[100 + " << dice.below(40) << "] = #28 (HEIGHT FOUND)\n";
}

void write_choice(Tape& tape, Dice& dice) {
    tape << "IF [#19 LT 1] GOTO 901\nIF [#19 GT 3] GOTO 901\nGOTO [#19 * 100]\n";
    for (std::size_t label = 100; label <= 300; label += 100)
        tape << "N" << label << " #27 = " << dice.below(90) + 1 << ".\nGOTO 400\n";
    tape << "N400 G0 X[#24 + #27] Y#25\nG1 Z#26 F#9\nG0 Z#18\n";
}

void write_helper_call(Tape& tape, Dice& dice) {
    tape << "G65 P" << first_helper_number + dice.below(helper_count) << " X#24 Y#25 Z#26 R#18 F#9 S"
         << dice.below(3) + 1 << "\n";
}

void write_macro_end(Tape& tape) {
    tape << "G#30 G#31 G#32 F#33\nM99\nN900 #3000 = 100 (Z OR R MISSING)\nN901 #3000 = 101 (Q OR S)\n"
         << "N902 #3000 = 102 (FEED F MISSING)\nN903 #3000 = 103 (NO TOUCH)\n";
}

void write_macro_head(Tape& tape, std::size_t number, std::string_view title) {
    tape << "O" << number << " (" << title
         << ")\n(X Y PLACE, Z DEPTH, R R POINT, I RADIUS, Q STEP, F FEED)\n";
}

void write_saved_state(Tape& tape) {
    tape << "#30 = #4001\n#31 = #4003\n#32 = #4010\n#33 = #4109\nG90 G98\n";
}

/// A macro that calls nobody.
void write_helper(Tape& tape, std::size_t number) {
    write_macro_head(tape, number, "ONE PLUNGE");
    tape << "IF [#26 EQ #0] GOTO 900\nIF [#18 EQ #0] GOTO 900\nIF [#9 LE 0] GOTO 902\n";
    write_saved_state(tape);
    tape << "G0 X#24 Y#25\nZ#18\nG1 Z#26 F#9\nG4 P200\nG0 Z#18\n";
    write_macro_end(tape);
}

void write_macro(Tape& tape, std::size_t number, Dice& dice) {
    constexpr std::array sections{write_drilling_loop, write_pocket_loop, write_probing, write_helper_call};
    write_macro_head(tape, number, "GENERATED CYCLE");
    write_checks(tape, dice);
    write_saved_state(tape);
    const std::size_t count = dice.below(2) + 2;
    for (std::size_t i = 0; i < count; ++i) sections.at(dice.below(sections.size()))(tape, dice);
    // Its labels exist once, so it comes once.
    if (dice.below(2) == 0) write_choice(tape, dice);
    write_macro_end(tape);
}

// ---- variables
// -----------------------------------------------------------------------------------------------

/// The i-th variable: the common ranges of a large control first, then by index above them.
void write_variable(Tape& tape, std::size_t i) {
    struct Range {
        std::size_t first;
        std::size_t count;
    };
    // fanuc-custom-macro 2.1: #100-#199, #500-#999, and #98000-#98499 on newer controls.
    constexpr std::array<Range, 3> ranges{{{100, 100}, {500, 500}, {98'000, 500}}};
    for (const Range range : ranges) {
        if (i < range.count) {
            tape << "#" << range.first + i;
            return;
        }
        i -= range.count;
    }
    tape << "#[98500 + " << i << "]";
}

} // namespace

std::string cam_output(std::size_t bytes) {
    Tape tape{bytes};
    CamJob job{tape, Numbers::of_every_second_tool};
    do job.write_pass();
    while (tape.size() < bytes);
    job.finish();
    return tape.take();
}

std::string numbered_cam_output(std::size_t bytes) {
    Tape tape{bytes};
    CamJob job{tape, Numbers::everywhere};
    job.write_jump();
    do job.write_pass();
    while (tape.size() < bytes);
    job.finish();
    return tape.take();
}

std::string plain_turning(std::size_t bytes) {
    constexpr std::size_t cuts_per_contour = 400;
    Tape tape{bytes};
    tape << "%shaft.nc\nMACHINING\nN1 G59 Z150\n";
    std::size_t number = 1;
    for (std::size_t cut = 0; tape.size() < bytes; ++cut) {
        const auto step = static_cast<double>(cut % cuts_per_contour);
        const auto x = micrometres(30.0 + 8.0 * std::sin(step * 0.05));
        const auto z = micrometres(-0.25 * step);
        tape << "N" << ++number << (cut % 16 == 15 ? " G2 X" : " G1 X") << x << " Z" << z;
        if (cut % 16 == 15) tape << " R2.5";
        tape << "\n";
        if (cut % cuts_per_contour == cuts_per_contour - 1) tape << "N" << ++number << " G0 X100 Z5 [BACK]\n";
    }
    tape << "N" << ++number << " M30\nEND\n";
    return tape.take();
}

std::string macro_code(std::size_t bytes) {
    Tape tape{bytes};
    Dice dice{2024};
    tape << "%\n";
    for (std::size_t i = 0; i < helper_count; ++i) write_helper(tape, first_helper_number + i);
    for (std::size_t number = first_macro_number; tape.size() < bytes; ++number)
        write_macro(tape, number, dice);
    tape << "%\n";
    return tape.take();
}

std::vector<std::string> macro_files(std::size_t files, std::size_t bytes) {
    Dice dice{2024};
    std::vector<std::string> folder;
    for (std::size_t i = 0; i < helper_count; ++i) {
        Tape tape{bytes};
        tape << "%\n";
        write_helper(tape, first_helper_number + i);
        tape << "%\n";
        folder.push_back(tape.take());
    }
    for (std::size_t number = first_macro_number; folder.size() < files;) {
        Tape tape{bytes};
        tape << "%\n";
        while (tape.size() < bytes) write_macro(tape, number++, dice);
        tape << "%\n";
        folder.push_back(tape.take());
    }
    return folder;
}

std::string one_program_with_jumps(std::size_t jumps) {
    Tape tape{jumps * 48};
    Dice dice{7};
    tape << "%\nO0002 (JUMPS)\n#100 = 0\n#101 = 0\n";
    for (std::size_t i = 1; i <= jumps; ++i) {
        tape << "N" << i << " #101 = #101 + 1\n";
        const std::size_t kind = dice.below(3);
        if (kind == 0 && i + 1 < jumps) {
            tape << "IF [#101 GT " << dice.below(100) << "] GOTO " << i + 2 << "\n";
        } else if (kind == 1) {
            tape << "IF [#101 GT " << 1000 + dice.below(1000) << "] GOTO "
                 << i + dice.below(jumps - i + 1) + 1 << "\n";
        } else {
            tape << "#100 = #100 + 1\nIF [#100 LT " << dice.below(1000) << "] GOTO " << i - dice.below(i)
                 << "\n";
        }
    }
    tape << "N" << jumps + 1 << " M30\n%\n";
    return tape.take();
}

std::string one_program_with_variables(std::size_t variables) {
    Tape tape{variables * 64};
    tape << "%\nO0003 (VARIABLES)\n#1 = #5001\n";
    for (std::size_t i = 0; i < variables; ++i) {
        write_variable(tape, i);
        tape << " = ";
        if (i == 0) {
            tape << "#1\n";
            continue;
        }
        write_variable(tape, i - 1);
        tape << " + " << i % 17 << "\n";
        if (i % 8 != 0) continue;
        tape << "IF [#1 GT " << i << "] THEN ";
        write_variable(tape, i);
        tape << " = #[99 + #1]\n";
    }
    tape << "M30\n%\n";
    return tape.take();
}

std::string call_chain(std::size_t depth) {
    constexpr std::size_t main_number = 1000;
    Tape tape{depth * 64};
    tape << "%\nO" << main_number << " (TOP OF THE CHAIN)\n";
    if (depth > 0) tape << "G65 P" << main_number + 1 << " A1.\n";
    tape << "M30\n";
    for (std::size_t i = 1; i <= depth; ++i) {
        tape << "O" << main_number + i << " (LEVEL " << i << ")\n#2 = #1 + 1\n";
        if (i < depth) tape << "G65 P" << main_number + i + 1 << " A#2\n";
        tape << "M99\n";
    }
    tape << "%\n";
    return tape.take();
}

std::string line_noise(std::size_t bytes, unsigned seed) {
    constexpr std::string_view alphabet = "XYZGMNOPIJKRSTF0123456789.-+*/#[]()=%;, \"<>'\x1b\x80\xfe";
    constexpr std::array<std::string_view, 10> words{"IF",  "WHILE", "GOTO", "THEN", "DO1",
                                                     "END", "G65P",  "SIN",  "EQ",   "#["};
    Dice dice{seed};
    std::string noise;
    noise.reserve(bytes + 8);
    while (noise.size() < bytes) {
        const std::size_t roll = dice.below(64);
        if (roll == 0) {
            noise += '\n';
        } else if (roll < 8) {
            noise += words.at(dice.below(words.size()));
        } else {
            noise += alphabet[dice.below(alphabet.size())];
        }
    }
    noise.resize(bytes);
    return noise;
}

} // namespace maclint::bench
