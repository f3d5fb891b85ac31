//! Line by line from the head of the text.
#include "analyzer/dialect/detect/first_program.hpp"

#include "analyzer/dialect/detect/line.hpp"
#include "analyzer/dialect/detect/shapes.hpp"

#include <algorithm>
#include <optional>

namespace maclint::detect {
namespace {

bool ends_program(const Line& line) {
    return line.has('M', 20, 20) || line.has('M', 300, 300) || line.has('M', 990, 990);
}

/// `%shaft.nc`
bool is_name_line(std::string_view line) { return line.size() > 1 && line[0] == '%' && line[1] != ' '; }

/// Hands the lines that are not empty, and where each ends, to `step` until it answers: the text up to that
/// line, or nothing.
template<class Step>
std::string_view cut_by(std::string_view text, const Step& step) {
    std::string_view cut;
    for_each_filled_line(text, [&](const Line& line, std::size_t end) {
        const std::optional<bool> whole = step(line);
        if (whole.value_or(false)) cut = text.substr(0, end);
        return !whole;
    });
    return cut;
}

/// A program number, then nothing but blocks.
std::string_view first_of_blocks(std::string_view text) {
    bool begun = false;
    return cut_by(text, [&](const Line& line) -> std::optional<bool> {
        if (!begun && line.whole() == "%") return std::nullopt;
        if (!(begun ? looks_like_block(line.whole()) : program_number(line))) return false;
        if (begun && ends_program(line)) return true;
        begun = true;
        return std::nullopt;
    });
}

/// A name or a section word, then whatever comments may hold.
std::string_view first_of_sections(std::string_view text) {
    bool begun = false;
    return cut_by(text, [&](const Line& line) -> std::optional<bool> {
        if (begun && end_of_program_word(line)) return true;
        if (!begun && !is_name_line(line.whole()) && !section_word(line)) return false;
        begun = true;
        return std::nullopt;
    });
}

} // namespace

std::string_view first_program(std::string_view text) {
    const std::string_view first = first_of_blocks(text);
    return first.empty() ? first_of_sections(text) : first;
}

} // namespace maclint::detect
