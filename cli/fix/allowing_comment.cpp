//! Words that cli/filter/directive reads.
#include "cli/fix/allowing_comment.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "cli/text/letters.hpp"

namespace maclint::cli {

std::string allowing_comment(const Dialect& dialect, const std::vector<std::string>& codes,
                             std::string_view reason) {
    std::string text = "MACLINT ALLOW";
    for (const std::string& code : codes) text += " " + code;
    const bool has_capitals_alone = dialect.comment_open.starts_with('(');
    if (!reason.empty()) text += " - " + (has_capitals_alone ? in_upper_case(reason) : std::string(reason));
    return std::string(dialect.comment_open) + text + std::string(dialect.comment_close);
}

std::size_t end_of_words(std::string_view line) {
    constexpr std::string_view blanks = " \t";
    std::size_t end = line.find_last_not_of(blanks) + 1;
    if (end > 0 && line[end - 1] == ';') --end;
    while (end > 0 && blanks.find(line[end - 1]) != std::string_view::npos) --end;
    return end;
}

Edit allowing_edit(const std::shared_ptr<const Source>& source, Offset place, const Dialect& dialect,
                   const std::vector<std::string>& codes) {
    const Span line = source->line_span(source->position(place).line);
    const Offset end = line.begin + static_cast<Offset>(end_of_words(source->bytes(line)));
    return {source, {end, end}, (end == line.begin ? "" : " ") + allowing_comment(dialect, codes, "")};
}

} // namespace maclint::cli
