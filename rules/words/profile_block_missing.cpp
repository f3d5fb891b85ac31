//! MAC338: a cycle names blocks that are not there, or not such as it can work with.
#include "analyzer/queries/enclosed_blocks.hpp"
#include "analyzer/queries/next_block.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/words/row_of_block.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <variant>

namespace maclint::rules {

namespace {
void check(const RowOfBlock& block, Reporter& reporter);
}

extern const Rule profile_block_missing{
    .code = "MAC338",
    .name = "profile-block-missing",
    .summary = "A cycle names blocks that are missing, stand twice, or hold what it cannot take",
    .why = "A roughing cycle reads its profile between two sequence numbers. Where a number is mistyped, or "
           "stands twice after a part was copied, the control stops with the tool at the work, or turns "
           "another profile.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"missing", "Missing block: '{0}' of {1} names N{2}, and this program has none.",
                  "Correct the number, or give the block its N."},
                 {"twice",
                  "Block named twice: '{0}' of {1} names N{2}, which stands {3} times in this program.",
                  "Give each block a number of its own."},
                 {"order", "Profile that ends before it begins: N{2} of '{0}' stands before N{3}.",
                  "Exchange the two numbers."},
                 {"first", "Profile of {1} that begins without {3}: its first block, N{2}, has none.",
                  "Write one of them into that block."},
                 {"inside", "Word '{0}' between N{2} and N{3}, where {1} reads its profile: {4}.",
                  "Move it out of the profile."}},
    .bad = {{"fanuc", R"nc(
O9338(TURN)
G21 G40 G99
T0101
G50 S2000
G96 S180 M3
G0 X52. Z2.
G71 U2. R0.5
G71 P10 Q30 U0.4 W0.1 F0.25
N10 G0 X20.
G1 Z-10.
N20 X52.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9338(TURN)
G21 G40 G99
T0101
G50 S2000
G96 S180 M3
G0 X52. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.25
N10 G0 X20.
G1 Z-10.
N20 X52.
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "063", "SEQUENCE NUMBER NOT FOUND", true, "missing"},
               {"FANUC 30i/0i-D", "063", "THE BLOCK OF A SPECIFIED SEQUENCE NUMBER IS NOT FOUND", true,
                "missing"},
               {"FANUC 16i/18i/21i", "065", "ILLEGAL COMMAND IN G71-G73", true, "first"},
               {"FANUC 30i/0i-D", "065", "G00/G01 IS NOT IN THE FIRST BLOCK OF SHAPE PROGRAM", true, "first"},
               {"FANUC 16i/18i/21i", "066", "IMPROPER G-CODE IN G71-G73", true, "inside"},
               {"FANUC 30i/0i-D", "325", "UNAVAILABLE COMMAND IS IN SHAPE PROGRAM", true, "inside"}},
    .sources = {"GH-ALM", "BLOG-MRC: no number twice", "T"},
    .check = RowCheck{.says = RowStatement::encloses, .check = &check},
};

namespace {

/// Whether the word is one of the codes, or has one of the addresses.
bool is_one_of(std::string_view list, const Word& word) {
    const std::string code = RowOfBlock::code_of(word);
    return has_word(list, word.address) || (!code.empty() && has_word(list, code));
}

/// The block that a word of the cycle names.
struct Named {
    const Word& word;
    std::int64_t number;
    Span place;
};

class Profile {
  public:
    Profile(const RowOfBlock& block, Reporter& reporter)
        : block_(block)
        , reporter_(reporter) {}

    void look() {
        const auto addresses = words_of(block_.row().words);
        const auto first = named_by(addresses.front());
        const auto last = named_by(addresses.back());
        if (!first || !last) return;
        if (last->place.begin < first->place.begin)
            report(last->word, "order", {number_of(*last), number_of(*first)});
        else
            look_between(*first, *last);
    }

  private:
    [[nodiscard]] const Program& program() const { return block_.block.analysis.program(); }
    [[nodiscard]] static std::string number_of(const Named& named) { return std::to_string(named.number); }

    void report(const Word& word, std::string_view id, std::vector<std::string> more) {
        std::vector<std::string> arguments{block_.text_of(word), block_.text_of(block_.code)};
        for (std::string& one : more) arguments.push_back(std::move(one));
        block_.report(reporter_, word, id, std::move(arguments));
    }

    /// Nothing: the word is missing or calculated, or what it names was told of.
    std::optional<Named> named_by(std::string_view address) {
        const auto own = block_.own(address);
        const auto* value = own.empty() ? nullptr : std::get_if<Literal>(&own.front()->value);
        if (value == nullptr || value->value != std::floor(value->value) || std::abs(value->value) > 1e9)
            return std::nullopt;
        const auto number = static_cast<std::int64_t>(value->value);
        const auto places = queries::blocks_numbered(program(), number);
        if (places.size() == 1) return Named{*own.front(), number, places.front()};
        if (places.empty())
            report(*own.front(), "missing", {std::to_string(number)});
        else
            report(*own.front(), "twice", {std::to_string(number), std::to_string(places.size())});
        return std::nullopt;
    }

    void look_between(const Named& first, const Named& last) {
        const WordRow& row = block_.row();
        bool is_first = true;
        queries::for_each_block_in(
            program(), {first.place.begin, last.place.end},
            [&](const BlockView&, std::span<const Word> words) {
                const std::vector<Word> all(words.begin(), words.end());
                if (std::exchange(is_first, false) && !row.first_block.empty() &&
                    !queries::holds_code(all, row.first_block))
                    report(first.word, "first", {number_of(first), either_of(row.first_block)});
                for (const Word& word : words)
                    if (is_one_of(row.others, word))
                        block_.report(reporter_, word, "inside",
                                      {block_.text_of(word), block_.text_of(block_.code), number_of(first),
                                       number_of(last), std::string(row.effect)});
            });
    }

    const RowOfBlock& block_;
    Reporter& reporter_;
};

void check(const RowOfBlock& block, Reporter& reporter) { Profile(block, reporter).look(); }

} // namespace
} // namespace maclint::rules
