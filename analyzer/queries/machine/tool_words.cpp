//! Reads the words T of sections.
#include "analyzer/queries/machine/tool_words.hpp"

#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace maclint::queries {
namespace {

constexpr std::string_view tool_address = "T";
constexpr std::string_view tool_list = "TURRET";

ToolWord tool_word(const Program& program, const Word& word, double value) {
    const std::string_view written = program.slice(word.span);
    const std::size_t point = written.find('.');
    const std::string_view edge =
        point == std::string_view::npos ? std::string_view{} : written.substr(point + 1);
    return {std::floor(value), edge, word.span};
}

void add_tools(const Program& program, const Section& section, std::vector<ToolWord>& tools) {
    const syntax::AddressSet wanted = addresses_named(program, tool_address);
    for_each_block_with_words(
        program, section.items,
        [&](const PlainRun& run, const auto& take) {
            if (run.words.addresses.meets(wanted)) take(run.span);
        },
        [&](const WordSummary& summary) { return summary.addresses.meets(wanted); },
        [&](const BlockView& /*block*/, std::span<const Word> words, const WordSummary* /*summary*/) {
            for (const Word& word : words)
                if (const auto* literal = std::get_if<Literal>(&word.value);
                    literal != nullptr && word.address == tool_address)
                    tools.push_back(tool_word(program, word, literal->value));
        });
}

} // namespace

std::vector<ToolWord> listed_tools(const Program& program) {
    std::vector<ToolWord> tools;
    std::size_t list = 0;
    for (const Section& section : program.sections) {
        if (section.kind != tool_list) continue;
        const std::size_t first = tools.size();
        add_tools(program, section, tools);
        for (std::size_t i = first; i < tools.size(); ++i) tools[i].list = list;
        ++list;
    }
    return tools;
}

std::vector<ToolWord> called_tools(const Program& program) {
    std::vector<ToolWord> tools;
    for (const Section& section : program.sections)
        if (section.executed == Section::Executed::when_reached) add_tools(program, section, tools);
    return tools;
}

} // namespace maclint::queries
