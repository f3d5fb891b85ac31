//! Reads a text in every way that a dialect has, and asks for everything that was read.
#pragma once

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/dump.hpp"
#include "analyzer/workspace/outline.hpp"
#include "fuzz/harness.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <variant>
#include <vector>

namespace maclint::fuzz {

inline std::vector<ProgramOutline> outlines_for_calls(const ProgramFile& file) {
    const FileOutline outline = outline_of(file);
    std::vector<ProgramOutline> programs(outline.programs.begin(), outline.programs.end());
    for (ProgramOutline& program : programs) // a call without a program connects nothing
        std::erase_if(program.calls, [](const CallOutline& call) {
            return std::holds_alternative<std::monostate>(call.program);
        });
    return programs;
}

inline void require_inside(const ProgramFile& file, Span span) {
    require(span.begin <= span.end && span.end <= file.source->size(), "a span lies outside the text");
}

inline void read_whole(std::string_view text, const Dialect& dialect, const ControlModel& control) {
    const auto source = std::make_shared<const Source>(Source::from_bytes("a/O7.nc", std::string(text)));
    const ProgramFile file = dialect.read(source, control, Extent::whole);
    for (const Program& program : file.programs) {
        require_inside(file, program.span);
        for_each_block(program, [&](const BlockView& block) { require_inside(file, block.span); });
        for (const Effect& effect : program.effects) require_inside(file, effect.span);
        const auto all = [](const WordSummary&) { return true; };
        for_each_block_with_words(program, all,
                                  [&](const BlockView&, std::span<const Word> words, const WordSummary*) {
                                      for (const Word& word : words) require_inside(file, word.span);
                                  });
    }
    for (const SyntaxError& error : file.syntax_errors) require_inside(file, error.span);
    const auto begin = [](const SyntaxError& error) { return error.span.begin; };
    require(std::ranges::is_sorted(file.syntax_errors, {}, begin),
            "an error begins before the one before it");
    require(describe(file) == describe(dialect.read(source, control, Extent::whole)),
            "a text is read in two ways");
    require(outlines_for_calls(file) ==
                outlines_for_calls(dialect.read(source, control, Extent::names_and_calls)),
            "a glance finds other names and calls");
}

/// For one of the controls of the language, chosen by the text.
inline void read_for_some_control(std::string_view text, std::string_view dialect_name) {
    const Dialect& dialect = *find_dialect(dialect_name);
    std::size_t left = choice(text, controls().size());
    for (std::size_t i = 0;; ++i) {
        const ControlModel& control = *controls()[i % controls().size()];
        if (control.language == dialect_name && left-- == 0) return read_whole(text, dialect, control);
    }
}

} // namespace maclint::fuzz
