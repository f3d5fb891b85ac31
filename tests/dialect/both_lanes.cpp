//! A comment that speaks to maclint keeps a block from the plain lane.
#include "tests/dialect/both_lanes.hpp"

#include "analyzer/program/block_view.hpp"
#include "tests/dialect/reading.hpp"

#include <algorithm>
#include <span>
#include <variant>
#include <vector>

namespace maclint::test {
namespace {

/// What a block does and which words it has, whatever lane it came through.
std::string meaning(const Program& program, const BlockView& block) {
    std::string text;
    if (block.number)
        text += 'N' + std::to_string(*block.number) + ' ' + std::string(program.slice(block.number_span));
    const auto set = [&](GroupId group, double value) {
        text += " " + std::to_string(group) + "=" + std::to_string(value);
    };
    for (const BlockSetting& setting : block.settings)
        if (setting.value) set(setting.group, *setting.value);
    if (block.moves) text += " move";
    for (const Effect& effect : program.effects_in(block.effects))
        if (const auto setting = setting_of(program, effect); !setting || !setting->value)
            text += " " + describe(program, effect);
    return text;
}

std::string meaning(const Program& program, std::span<const Word> words) {
    std::string text;
    for (const Word& word : words) {
        text += std::string(word.address) + (word.incremental ? "i " : " ") +
                std::string(program.slice(word.span));
        if (const auto* value = std::get_if<Literal>(&word.value))
            text += " is " + std::to_string(value->value) + (value->decimal_point ? "." : "");
        text += "; ";
    }
    return text;
}

std::vector<std::string> meaning(const ProgramFile& file) {
    std::vector<std::string> lines;
    for (const Program& program : file.programs) {
        lines.push_back(program.name);
        for_each_block(program, [&](const BlockView& block) { lines.push_back(meaning(program, block)); });
        const auto all = [](const WordSummary&) { return true; };
        for_each_block_with_words(program, all,
                                  [&](const BlockView&, std::span<const Word> words, const WordSummary*) {
                                      lines.push_back(meaning(program, words));
                                  });
    }
    for (const SyntaxError& error : file.syntax_errors) lines.emplace_back(name_of(error.kind));
    return lines;
}

} // namespace

BothLanes forbid_plain_lane(std::string_view text, std::string_view control) {
    const std::string_view comment = control == "dinplus"     ? "[maclint]"
                                     : control == "sinumerik" ? ";maclint"
                                                              : "(maclint)";
    const ProgramFile file = read_as(control, "O1.nc", text);
    std::vector<Offset> ends; // of the plain blocks; a program may go on behind another
    for (const Program& program : file.programs)
        for (const Item& item : program.items)
            if (const auto* run = std::get_if<PlainRun>(&item))
                blocks::visit_part(program, *run, run->span,
                                   [&](const BlockView& block) { ends.push_back(block.span.end); });
    std::ranges::sort(ends);
    BothLanes lanes;
    lanes.plain = ends.size();
    const std::string_view read = file.source->bytes(); // of a text in two bytes a letter other ones
    Offset copied = 0;
    for (const Offset end : ends) {
        lanes.grammar_only.append(read.substr(copied, end - copied)).append(comment);
        copied = end;
    }
    lanes.grammar_only.append(read.substr(copied));
    return lanes;
}

std::optional<std::string> difference_of_lanes(std::string_view text, std::string_view control,
                                               std::string_view name) {
    const BothLanes lanes = forbid_plain_lane(text, control);
    const auto plain = meaning(read_as(control, std::string(name), text));
    const auto parsed = meaning(read_as(control, std::string(name), lanes.grammar_only));
    if (plain == parsed) return std::nullopt;
    const auto [a, b] = std::ranges::mismatch(plain, parsed);
    return "with the plain lane:\n" + (a == plain.end() ? "(end)" : *a) + "\nwithout:\n" +
           (b == parsed.end() ? "(end)" : *b);
}

} // namespace maclint::test
