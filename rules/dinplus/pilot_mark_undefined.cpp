//! DIN819: a cycle works at positions that no cycle has stored.
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/word_lookup.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule pilot_mark_undefined{
    .code = "DIN819",
    .name = "nf-undefined",
    .summary = "A cycle works at positions that no cycle has stored",
    .why = "G840 and G845 with A1 or A2 calculate where to bore and store that under NF. Without them the "
           "cycle finds no positions, or those of another part.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Positions that nobody stores: '{0}' stands in no cycle with A1 or A2.",
                  "Store them before, or correct the number."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N1 T4
N2 G845 NS35 A1 NF1
N3 G71 NF2 ZE-10
N4 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N1 T4
N2 G845 NS35 A1 NF1
N3 G71 NF1 ZE-10
N4 M30
END
)nc"}},
    .sources = {"SEED-003:15633", "SEED-003:17142", "SEED-003:17428"},
    .check = &check,
};

namespace {

constexpr std::string_view mark_word = "NF", stores_word = "A";
/// Cycles that work at stored positions or store them; measuring cycles have another NF.
constexpr std::array<double, 6> cycles = {71, 840, 845, 846, 847, 848};

class Marks {
  public:
    void read(const Program& program) {
        for_each_running_block_with(
            program, mark_word, [&](const BlockView&, std::span<const Word> words) { read(program, words); });
        for (const Effect& effect : program.effects)
            is_whole_ &= !std::holds_alternative<Call>(effect.what) &&
                         !std::holds_alternative<UnreadableBlock>(effect.what);
    }

    void report(const ProgramFile& file, Reporter& reporter) const {
        if (!is_whole_) return;
        for (const auto& [program, word] : used_)
            if (!stored_.contains(std::get<Literal>(word.value).value))
                reporter.report({file, word.span}, word.span, "plain", {quoted(*program, word.span)});
    }

  private:
    void read(const Program& program, std::span<const Word> words) {
        const bool is_cycle = std::ranges::any_of(words, [](const Word& word) {
            const auto* code = std::get_if<Literal>(&word.value);
            return code != nullptr && word.address == "G" &&
                   std::ranges::find(cycles, code->value) != cycles.end();
        });
        const Word* mark = is_cycle ? find_word(words, mark_word) : nullptr;
        if (mark == nullptr) return;
        const auto* number = std::get_if<Literal>(&mark->value);
        const Word* stores = find_word(words, stores_word);
        const auto* kind = stores == nullptr ? nullptr : std::get_if<Literal>(&stores->value);
        if (number == nullptr || (stores != nullptr && kind == nullptr))
            is_whole_ = false;
        else if (kind != nullptr && kind->value != 0)
            stored_.insert(number->value);
        else
            used_.emplace_back(&program, *mark);
    }

    bool is_whole_ = true;
    std::set<double> stored_;
    std::vector<std::pair<const Program*, Word>> used_;
};

void check(const ProgramFile& file, Reporter& reporter) {
    Marks marks;
    for (const Program& program : file.programs) marks.read(program);
    marks.report(file, reporter);
}

} // namespace
} // namespace maclint::rules
