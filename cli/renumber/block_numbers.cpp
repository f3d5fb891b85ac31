//! First all numbers of blocks, then all that names one: what cannot be followed ends it.
#include "cli/renumber/block_numbers.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/outline.hpp"
#include "cli/renumber/naming_words.hpp"
#include "cli/text/shown.hpp"
#include "rules/path.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>

namespace maclint::cli {
namespace {

/// Thrown where numbers cannot be changed, caught in number_spaces.
struct StopsAt {
    const Program* program;
    Span at;
    std::string why;
};

/// The digits of "N10", "N 0010", "[20]"; nothing where anything else stands in the span.
std::optional<WrittenNumber> digits_in(const Program& program, Span span) {
    const std::string_view text = program.slice(span);
    constexpr std::string_view figures = "0123456789";
    const std::size_t begin = text.find_first_of(figures);
    if (begin == std::string_view::npos) return std::nullopt;
    const std::size_t end = std::min(text.find_first_not_of(figures, begin), text.size());
    if (text.find_first_of(figures, end) != std::string_view::npos) return std::nullopt;
    // A point, a sign or an operator make another number of it.
    if (text.find_first_of(".+-*/#") != std::string_view::npos) return std::nullopt;
    std::int64_t number = 0;
    const auto [last, error] = std::from_chars(text.data() + begin, text.data() + end, number);
    if (error != std::errc() || last != text.data() + end) return std::nullopt;
    return WrittenNumber{{span.begin + static_cast<Offset>(begin), span.begin + static_cast<Offset>(end)},
                         number};
}

class Collector {
  public:
    explicit Collector(const ProgramFile& file)
        : file_(file)
        , outline_(outline_of(file)) {
        for (std::size_t i = 0; i < file.programs.size(); ++i) add_program(i);
    }

    NumberSpaces collect(std::span<const ProgramFile* const> others) {
        for (std::size_t i = 0; i < file_.programs.size(); ++i) look_at(i);
        for (const ProgramFile* other : others) look_at_other(*other);
        for (NumberSpace& space : spaces_) put_in_order(space);
        return std::move(spaces_);
    }

  private:
    /// A language whose programs have sections numbers them through.
    void add_program(std::size_t place) {
        const Program& program = file_.programs[place];
        const bool has_sections = !program.control->sections.empty();
        if (spaces_.empty() || !has_sections) spaces_.emplace_back();
        NumberSpace& space = spaces_.back();
        space.programs.push_back(place);
        space_of_.push_back(spaces_.size() - 1);
        for_each_block(program, [&](const BlockView& block) {
            if (!block.number || block.number_span.empty()) return;
            const auto digits = digits_in(program, block.number_span);
            if (!digits) stop(program, block.number_span, "is no plain number", "Write it in figures");
            space.blocks.push_back(*digits);
        });
    }

    void look_at(std::size_t place) {
        const Program& program = file_.programs[place];
        for (const Expression& expression : program.expressions) refuse_reading(program, expression);
        for (const Effect& effect : program.effects) look_at_effect(place, effect);
        for_each_naming_word(program, [&](const Word& word, const NamedIn& where) {
            const auto target = where.program ? program_numbered(*where.program) : std::optional(place);
            if (target) use(*target, program, word.span, "names a block");
        });
    }

    void look_at_effect(std::size_t place, const Effect& effect) {
        const Program& program = file_.programs[place];
        if (const auto* jump = std::get_if<Jump>(&effect.what))
            if (!std::holds_alternative<BlockName>(program.expressions[jump->target].node))
                use(place, program, program.expressions[jump->target].span, "jumps to a block");
        if (const auto* stop = std::get_if<Stop>(&effect.what))
            if (stop->kind == Stop::Kind::restart && stop->number)
                use(place, program, program.expressions[*stop->number].span, "begins again at a block");
        if (const auto* back = std::get_if<Return>(&effect.what); back != nullptr && back->resume_label)
            look_at_return(place, program.expressions[*back->resume_label].span);
        if (const auto* unreadable = std::get_if<UnreadableBlock>(&effect.what))
            if (!program.labels_of(*unreadable).empty())
                stop_at(program, effect.span,
                        "cannot be read, and may name a block. Correct it first ('maclint check' says how)");
    }

    /// M99 P names a block of the caller; where nobody calls, as in a main program, one of its own.
    void look_at_return(std::size_t place, Span label) {
        const Program& program = file_.programs[place];
        std::set<std::size_t> spaces;
        for (std::size_t i = 0; i < outline_.programs.size(); ++i)
            if (calls(outline_.programs[i], program)) spaces.insert(space_of_[i]);
        if (spaces.empty() && is_main(place)) spaces.insert(space_of_[place]);
        if (spaces.empty()) return; // the caller is another file, and its numbers stay
        if (spaces.size() > 1)
            stop_at(
                program, label,
                "returns to a block of several programs that call this one, which get numbers of their own. "
                "Renumber by hand");
        use_in(spaces_[*spaces.begin()], program, label, "returns to a block");
    }

    [[nodiscard]] static bool calls(const ProgramOutline& caller, const Program& program) {
        return program.number && std::ranges::any_of(caller.calls, [&](const CallOutline& call) {
                   const auto* number = std::get_if<std::int64_t>(&call.program);
                   return number != nullptr && *number == *program.number;
               });
    }

    /// It ends without going back, or is the only one of its file and is started by hand.
    [[nodiscard]] bool is_main(std::size_t place) const {
        const Program& program = file_.programs[place];
        return outline_.programs[place].started_by_hand ||
               std::ranges::any_of(program.effects, [](const Effect& effect) {
                   const auto* stop = std::get_if<Stop>(&effect.what);
                   return stop != nullptr && stop->kind == Stop::Kind::end;
               });
    }

    [[nodiscard]] std::optional<std::size_t> program_numbered(std::int64_t number) const {
        const auto found = std::ranges::find(file_.programs, std::optional(number), &Program::number);
        if (found == file_.programs.end()) return std::nullopt;
        return static_cast<std::size_t>(found - file_.programs.begin());
    }

    /// #4114 is the number of the block that runs: what the program does with it nobody follows here.
    static void refuse_reading(const Program& program, const Expression& expression) {
        const auto* load = std::get_if<LoadMachine>(&expression.node);
        if (load == nullptr) return;
        const VariableRange* range = program.control->families[load->family].find(load->number);
        if (range != nullptr && range->what.starts_with("sequence number"))
            stop_at(program, expression.span, "reads the number of a block. Renumber by hand");
    }

    void use(std::size_t place, const Program& program, Span span, std::string_view does) {
        use_in(spaces_[space_of_[place]], program, span, does);
    }

    void use_in(NumberSpace& space, const Program& program, Span span, std::string_view does) {
        const auto written = digits_in(program, span);
        if (!written)
            stop(program, span, std::string(does) + " whose number is calculated",
                 "Write the number itself, or renumber by hand");
        const auto found = blocks_numbered(space, written->number);
        if (found.empty()) {
            space.without_block.push_back(*written);
            return;
        }
        if (found.size() > 1)
            stop_at(program, span,
                    "names N" + std::to_string(written->number) +
                        ", which stands more than once. Give each block a number of its own first");
        space.uses.push_back({*written, found.front().second});
    }

    using Numbered = std::pair<std::int64_t, std::size_t>; ///< and its place in NumberSpace::blocks

    std::span<const Numbered> blocks_numbered(const NumberSpace& space, std::int64_t number) {
        std::vector<Numbered>& blocks = numbered_[static_cast<std::size_t>(&space - spaces_.data())];
        if (blocks.empty()) {
            for (std::size_t i = 0; i < space.blocks.size(); ++i)
                blocks.emplace_back(space.blocks[i].number, i);
            std::ranges::sort(blocks);
        }
        const auto found = std::ranges::equal_range(blocks, number, {}, &Numbered::first);
        return {found.begin(), found.end()};
    }

    /// What another file names of this one keeps its number, and would lead to another block.
    void look_at_other(const ProgramFile& other) {
        for (const Program& program : other.programs) {
            for_each_naming_word(program, [&](const Word& word, const NamedIn& where) {
                if (where.program && program_numbered(*where.program))
                    refuse_use_elsewhere(program, word.span, space_of_[*program_numbered(*where.program)]);
            });
            for (std::size_t p = 0; p < outline_.programs.size(); ++p)
                if (calls(outline_.programs[p], program)) refuse_returns(program, space_of_[p]);
        }
    }

    void refuse_returns(const Program& program, std::size_t space) {
        for (const Effect& effect : program.effects)
            if (const auto* back = std::get_if<Return>(&effect.what); back != nullptr && back->resume_label)
                refuse_use_elsewhere(program, program.expressions[*back->resume_label].span, space);
    }

    void refuse_use_elsewhere(const Program& program, Span span, std::size_t space) {
        const auto written = digits_in(program, span);
        if (!written || !blocks_numbered(spaces_[space], written->number).empty())
            stop_at(
                program, span,
                "names a block of this file from another one, which is not changed with it. Renumber both by "
                "hand");
    }

    static void put_in_order(NumberSpace& space) {
        const auto begin_of = [](const BlockUse& use) { return use.written.digits.begin; };
        std::ranges::sort(space.uses, {}, begin_of);
        const auto again = std::ranges::unique(space.uses, {}, begin_of);
        space.uses.erase(again.begin(), again.end());
    }

    [[noreturn]] static void stop(const Program& program, Span span, const std::string& what,
                                  std::string_view cure) {
        stop_at(program, span, what + ". " + std::string(cure));
    }
    [[noreturn]] static void stop_at(const Program& program, Span span, const std::string& why) {
        throw StopsAt{&program, span, "'" + quoted(program, span) + "' " + why + "."};
    }

    const ProgramFile& file_;
    FileOutline outline_;
    NumberSpaces spaces_;
    std::map<std::size_t, std::vector<Numbered>> numbered_; ///< of spaces that are asked, sorted by number
    std::vector<std::size_t> space_of_;                     ///< by place of the program
};

} // namespace

std::variant<NumberSpaces, UnsafeNumber> number_spaces(const ProgramFile& file,
                                                       std::span<const ProgramFile* const> others) {
    try {
        return Collector(file).collect(others);
    } catch (const StopsAt& stopped) {
        const ProgramFile* holder = &file;
        for (const ProgramFile* other : others)
            if (stopped.program->text.data() == other->source->bytes().data()) holder = other;
        return UnsafeNumber{holder->source, stopped.at, stopped.why};
    }
}

} // namespace maclint::cli
