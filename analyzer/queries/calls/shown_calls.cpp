//! Reads remarks that look like calls, letter by letter.
#include "analyzer/queries/calls/shown_calls.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/begun_programs.hpp"
#include "analyzer/queries/calls/callers.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace maclint::queries {
namespace {

using dataflow::KnownStart;

constexpr std::size_t most_calls = 4; ///< that remarks of one program show

struct ShownWord {
    char letter;
    double value;
    bool decimal_point;
};

/// Takes words from a text, until something else comes.
class Words {
  public:
    Words(std::string_view text, std::size_t at)
        : text_(text)
        , at_(at) {}

    std::optional<ShownWord> next() {
        pass_blanks();
        const std::size_t number = at_ + 1;
        if (number >= text_.size() || !is_capital(text_[at_])) return std::nullopt;
        std::size_t end = number;
        if (text_[end] == '-' || text_[end] == '+') ++end;
        const std::size_t digits = end;
        while (end < text_.size() && (is_digit(text_[end]) || text_[end] == '.')) ++end;
        const std::size_t first = text_[number] == '+' ? digits : number; // from_chars takes no '+'
        const std::string_view spelled = text_.substr(first, end - first);
        double value = 0;
        const auto read = std::from_chars(spelled.data(), spelled.data() + spelled.size(), value);
        if (read.ec != std::errc{} || read.ptr != spelled.data() + spelled.size()) return std::nullopt;
        ShownWord word{text_[at_], value, spelled.find('.') != std::string_view::npos};
        at_ = end;
        return word;
    }

    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] bool is_at_end() {
        pass_blanks();
        return at_ == text_.size();
    }

  private:
    void pass_blanks() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    }

    std::string_view text_;
    std::size_t at_;
};

class Reader {
  public:
    explicit Reader(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , control_(analysis.control()) {}

    /// The call in a remark, given without its brackets.
    [[nodiscard]] std::optional<ShownCall> call_in(Span remark) const {
        const std::string text = in_capitals(analysis_.program().slice(remark));
        for (const CallKind& kind : control_.calls) {
            if (kind.trigger != CallTrigger::once || kind.frame != Frame::fresh) continue;
            const std::string_view code = kind.name.substr(0, kind.name.find(' '));
            const std::size_t begin = text.find(code);
            if (code.empty() || begin == std::string::npos) continue;
            Words words(text, begin + code.size());
            const auto program = words.next();
            if (!program || program->letter != 'P' || !is_own_number(program->value)) continue;
            auto start = start_of(words);
            if (!start || !has_numbers(*start)) continue;
            return ShownCall{
                {remark.begin + static_cast<Offset>(begin), remark.begin + static_cast<Offset>(words.at())},
                *std::move(start)};
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] bool is_own_number(double number) const {
        const std::string_view name = analysis_.program().name;
        int own = 0;
        const auto read = name.empty() ? std::from_chars_result{name.data(), std::errc::invalid_argument}
                                       : std::from_chars(name.data() + 1, name.data() + name.size(), own);
        return read.ec == std::errc{} && own == number;
    }

    /// Nothing where a letter stands twice, or means no variable.
    [[nodiscard]] std::optional<KnownStart> start_of(Words& words) const {
        KnownStart start;
        start.arguments.emplace();
        while (const auto word = words.next()) {
            const auto letter = std::ranges::find(control_.formal_letters, word->letter);
            if (letter == control_.formal_letters.end()) return std::nullopt;
            const Variable variable =
                control_.formals[static_cast<std::size_t>(letter - control_.formal_letters.begin())];
            if (std::ranges::find(*start.arguments, variable,
                                  [](const auto& passed) { return passed.first; }) != start.arguments->end())
                return std::nullopt;
            start.arguments->emplace_back(variable, dataflow::Vacancy::set);
            if (is_number_as_written(control_, std::string_view(&word->letter, 1), word->value,
                                     word->decimal_point))
                start.known.push_back({variable, word->value});
        }
        std::ranges::sort(*start.arguments, {},
                          [](const auto& passed) { return dataflow::key_of(passed.first); });
        if (!words.is_at_end()) start.arguments.reset();
        return start;
    }

    const ProgramAnalysis& analysis_;
    const ControlModel& control_;
};

} // namespace

std::vector<ShownCall> shown_calls(const ProgramAnalysis& analysis) {
    std::vector<ShownCall> shown;
    if (knows_callers(analysis) || analysis.control().formal_letters.empty()) return shown;
    const Program& program = analysis.program();
    const Reader reader(analysis);
    const std::string_view text = program.slice(program.span);
    for (std::size_t open = text.find('('); open != std::string_view::npos; open = text.find('(', open + 1)) {
        const std::size_t close = text.find_first_of(")\r\n", open);
        if (close == std::string_view::npos || text[close] != ')') continue;
        auto call = reader.call_in({program.span.begin + static_cast<Offset>(open + 1),
                                    program.span.begin + static_cast<Offset>(close)});
        if (call) shown.push_back(*std::move(call));
        if (shown.size() == most_calls) break;
    }
    return shown;
}

} // namespace maclint::queries
