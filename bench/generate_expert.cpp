//! DIN PLUS programs made to measure.
#include "bench/generate.hpp"

#include <array>
#include <random>
#include <string_view>

namespace maclint::bench {
namespace {

/// Writes a program, numbering its blocks.
class Writer {
  public:
    void line(std::string_view text) { (text_ += text) += '\n'; }
    void block(const std::string& text) { line("N" + std::to_string(++number_) + " " + text); }
    [[nodiscard]] std::size_t size() const { return text_.size(); }
    [[nodiscard]] std::string take() { return std::move(text_); }

  private:
    std::string text_;
    std::size_t number_ = 0;
};

void write_head(Writer& out) {
    for (const std::string_view line :
         {"%bench.nc", "PROGRAM HEAD", "#UNIT METRIC", "#MATERIAL C45", "TURRET 1", "T1 ID\"ROUGH 80\"",
          "T2 ID\"DRILL 8\"", "VAR", "#_count=#g201", "BLANK"})
        out.line(line);
    out.block("G20 X120 Z200 K1");
    out.line("FINISHED");
    for (const char* element : {"G0 X0 Z0", "G1 X60 BR-1", "G1 Z-40 BR2", "G1 X110", "G1 Z-160"})
        out.block(element);
}

void write_groove_loop(Writer& out, std::size_t passes) {
    out.block("#l1=0");
    out.block("#l2=#__lb");
    out.block("WHILE #l1<" + std::to_string(passes));
    out.block("G0 X#__la+2 Z#l2 [above the groove]");
    out.block("G1 X#__la-(#l1+1)*0.5");
    out.block("G4 D2");
    out.block("#l2=#l2-4.5");
    out.block("#l1=#l1+1");
    out.block("ENDWHILE");
}

void write_choice(Writer& out, std::size_t cases) {
    out.block("SWITCH #_count");
    for (std::size_t i = 1; i <= cases; ++i) {
        out.block("CASE " + std::to_string(i));
        out.block("G96 S" + std::to_string(100 + 10 * i) + " G95 F0.2 M4");
        out.block("BREAK");
    }
    out.block("DEFAULT");
    out.block("G97 S500 G95 F0.1 M3");
    out.block("BREAK");
    out.block("ENDSWITCH");
}

void write_subprogram(Writer& out, std::size_t number, std::mt19937& random) {
    out.line("SUBPROGRAM \"S" + std::to_string(number) + "\"");
    out.block("IF NDEF(__lb)");
    out.block("THEN");
    out.block("#l3=1");
    out.block("ELSE");
    out.block("#l3=#__lb");
    out.block("ENDIF");
    out.block("IF (#__la>10) AND (#l3<>0)");
    out.block("THEN");
    write_groove_loop(out, random() % 9 + 2);
    out.block("ENDIF");
    write_choice(out, random() % 4 + 1);
    out.block("G810 NS3 NE4 P" + std::to_string(random() % 4 + 1) + " I0.3 K0.1");
    if (number > 1 && random() % 2 == 0)
        out.block("L\"S" + std::to_string(random() % (number - 1) / 1000 + 1) + "\" LA#l1 LB-#l3*2");
    out.block("PRINT(\"Part \",#_count)");
    out.line("RETURN #l1");
}

} // namespace

std::string expert_program(std::size_t bytes) {
    std::mt19937 random(3);
    Writer out;
    write_head(out);
    out.line("MACHINING");
    out.block("G26 S2500");
    out.block("G14 Q0");
    out.block("T1");
    // A call in the main part for every subprogram after it, as many as will fit.
    constexpr std::size_t bytes_of_subprogram = 760;
    const std::size_t subprograms = bytes / bytes_of_subprogram + 1;
    for (std::size_t i = 1; i <= subprograms; ++i)
        out.block("L\"S" + std::to_string(i) + "\" LA" + std::to_string(random() % 90 + 20) +
                  (random() % 2 == 0 ? " LB-12.5" : ""));
    out.block("M30");
    for (std::size_t i = 1; i <= subprograms || out.size() < bytes; ++i) write_subprogram(out, i, random);
    out.line("END");
    return out.take();
}

} // namespace maclint::bench
