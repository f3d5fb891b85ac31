//! Looks for the two blocks, then at what stands between.
#include "rules/words/profile.hpp"

#include "analyzer/queries/words/enclosed_blocks.hpp"
#include "analyzer/queries/words/next_block.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/words/row_text.hpp"
#include "rules/words/word_list.hpp"

#include <optional>
#include <string>
#include <utility>

namespace maclint {
namespace {

/// Whether the word is one of the codes, or has one of the addresses.
bool is_one_of(std::string_view list, const Word& word) {
    const std::string code = RowOfBlock::code_of(word);
    return has_word(list, word.address) || (!code.empty() && has_word(list, code));
}

constexpr std::string_view program_ends = "M2 M30";

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
        if (last->begin < first->begin) return report(word(1), "order", {number(1), number(0)});
        const auto end = first_end_between(*first, *last);
        if (!end) return look_between({first->begin, last->end});
        const std::size_t which = end->begin < first->begin ? 0 : 1;
        report(word(which), "behind_end",
               {number(which), std::string(program().slice(*end)),
                line_number(block_.block.analysis.file(), end->begin)});
    }

  private:
    [[nodiscard]] const Program& program() const { return block_.block.analysis.program(); }
    /// The first or the second that names a block, and its number.
    [[nodiscard]] const Word& word(std::size_t which) const {
        return *block_.own(words_of(block_.row().words)[which]).front();
    }
    [[nodiscard]] std::string number(std::size_t which) const {
        return std::to_string(*queries::block_number(word(which)));
    }

    void report(const Word& word, std::string_view id, std::vector<std::string> more) {
        std::vector<std::string> arguments{block_.text_of(word), block_.text_of(block_.code)};
        for (std::string& one : more) arguments.push_back(std::move(one));
        block_.report(reporter_, word, id, std::move(arguments));
    }

    /// The block that a word names; nothing: the word is missing or calculated, or what it names was told of.
    std::optional<Span> named_by(std::string_view address) {
        const auto own = block_.own(address);
        const auto number = own.empty() ? std::nullopt : queries::block_number(*own.front());
        if (!number) return std::nullopt;
        const auto places = queries::blocks_numbered(program(), *number);
        if (places.size() == 1) return places.front();
        report(*own.front(), places.empty() ? "missing" : "twice",
               {std::to_string(*number), std::to_string(places.size())});
        return std::nullopt;
    }

    /// The word that ends the program before the control comes to one of the two blocks.
    [[nodiscard]] std::optional<Span> first_end_between(Span first, Span last) const {
        const Offset here = block_.code.span.begin;
        const Offset from = here < first.begin ? here : first.begin;
        std::optional<Span> end;
        queries::for_each_block_in(program(), {from, last.begin},
                                   [&](const BlockView&, std::span<const Word> words) {
                                       for (const Word& inner : words)
                                           if (!end && is_one_of(program_ends, inner)) end = inner.span;
                                   });
        return end;
    }

    void look_between(Span part) {
        const WordRow& row = block_.row();
        bool is_first = true;
        queries::for_each_block_in(program(), part, [&](const BlockView&, std::span<const Word> words) {
            const bool begins = queries::holds_code({words.begin(), words.end()}, row.first_block);
            if (std::exchange(is_first, false) && !row.first_block.empty() && !begins)
                report(word(0), "first", {number(0), either_of(row.first_block)});
            for (const Word& inner : words)
                if (is_one_of(row.others, inner))
                    report(inner, "inside", {number(0), number(1), std::string(row.effect)});
        });
    }

    const RowOfBlock& block_;
    Reporter& reporter_;
};

} // namespace

void look_at_profile(const RowOfBlock& block, Reporter& reporter) { Profile(block, reporter).look(); }

} // namespace maclint
