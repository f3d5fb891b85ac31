//! Reads the words ID.
#include "analyzer/queries/contours/contour_names.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/section_kinds.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/program/word_lookup.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

namespace maclint::queries {
namespace {

constexpr std::string_view name_word = "ID";
/// Codes whose name is one of a contour, a level or a blank [SEED-003: the pages of these codes].
constexpr std::array wanting = {810.0, 820.0, 830.0, 835.0, 860.0, 869.0, 870.0, 890.0, 895.0, 891.0, 31.0,
                                71.0,  72.0,  73.0,  74.0,  75.0,  799.0, 797.0, 840.0, 845.0, 846.0, 847.0,
                                848.0, 702.0, 67.0,  841.0, 842.0, 843.0, 844.0, 800.0, 806.0};

/// Those of them that ask for a blank.
constexpr std::array for_blanks = {67.0, 702.0};
/// The level whose name is one of a contour. Other codes of contours have texts in that word.
constexpr double level = 308;

/// The name in a heading: `AUXIL_CONTOUR ID"GROOVE"`.
std::optional<ContourName> name_in(const Program& program, Span heading) {
    const std::string_view line = program.slice(heading);
    const std::size_t word = line.find("ID\"");
    if (word == std::string_view::npos) return std::nullopt;
    const std::size_t begin = word + 3, end = line.find('"', begin);
    if (end == std::string_view::npos) return std::nullopt;
    return ContourName{
        line.substr(begin, end - begin),
        {heading.begin + static_cast<Offset>(word), heading.begin + static_cast<Offset>(end + 1)}};
}

class Reader {
  public:
    explicit Reader(ContourNames& names)
        : names_(names) {}

    void read(const Program& program) {
        for (const Section& section : program.sections) {
            const SectionKind* kind = kind_of(*program.control, section);
            if (kind == nullptr) continue;
            const bool describes = kind->role == SectionKind::Role::contour;
            if (describes)
                if (auto name = name_in(program, section.heading)) {
                    name->is_blank = section.kind == "BLANK" || section.kind == "AUXIL_BLANK";
                    names_.described.push_back(*name);
                }
            if (describes) // a call without arguments has no words
                for_each_block_with_effects(program, section.items,
                                            [&](const BlockView& block) { look_for_others(program, block); });
            for_each_block_with_words(
                program, section.items, [](const PlainRun&, const auto&) {}, // no text stands in plain blocks
                [](const WordSummary&) { return true; },
                [&](const BlockView&, std::span<const Word> words, const WordSummary*) {
                    read(program, words, describes);
                });
        }
    }

  private:
    /// Who else may describe contours, and when.
    void look_for_others(const Program& program, const BlockView& block) {
        for (const Effect& effect : program.effects_in(block.effects)) {
            names_.has_branches |= std::holds_alternative<RegionMark>(effect.what);
            if (std::holds_alternative<Call>(effect.what) ||
                std::holds_alternative<UnreadableBlock>(effect.what))
                names_.is_complete = false;
        }
    }

    void read(const Program& program, std::span<const Word> words, bool describes) {
        const auto word = std::ranges::find(words, name_word, &Word::address);
        if (word == words.end()) return;
        const auto name = text_of(program, *word);
        if (!name) return;
        if (describes) {
            if (number_of(words, "G") == level) names_.described.push_back({*name, word->span});
            return;
        }
        for (const Word& code : words) {
            const auto* number = std::get_if<Literal>(&code.value);
            if (number != nullptr && code.address == "G" &&
                std::ranges::find(wanting, number->value) != wanting.end())
                names_.wanted.push_back({*name, word->span, program.slice(code.span),
                                         std::ranges::find(for_blanks, number->value) != for_blanks.end()});
        }
    }

    ContourNames& names_;
};

} // namespace

std::optional<std::string_view> text_of(const Program& program, const Word& word) {
    const auto* id = std::get_if<ExpressionId>(&word.value);
    if (id == nullptr) return std::nullopt;
    const auto* text = std::get_if<Text>(&program.expressions[*id].node);
    if (text == nullptr) return std::nullopt;
    return program.slice(text->characters);
}

ContourNames contour_names(const ProgramFile& file) {
    ContourNames names;
    Reader reader(names);
    for (const Program& program : file.programs) reader.read(program);
    return names;
}

std::string squeezed(std::string_view name) {
    std::string plain;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            plain += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return plain;
}

} // namespace maclint::queries
