//! What the Fanuc family brings to the reader: tape marks, the plain lane, heads of programs.
#include "analyzer/dialect/fanuc/read.hpp"

#include "analyzer/dialect/block_reader.hpp"
#include "analyzer/dialect/fanuc/diagnose.hpp"
#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/dialect/fanuc/lowering.hpp"
#include "analyzer/dialect/fanuc/machine_type.hpp"
#include "analyzer/dialect/fanuc/plausible.hpp"
#include "analyzer/dialect/fanuc/real_time.hpp"
#include "analyzer/dialect/fanuc/remarks.hpp"
#include "analyzer/dialect/fanuc/split.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/program/builder.hpp"
#include "analyzer/program/faults.hpp"
#include "analyzer/program/own_codes.hpp"
#include "analyzer/program/plain_run.hpp"
#include "analyzer/source/content.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace maclint::fanuc {
namespace {

/// The program number in a name like "O9100".
std::optional<std::int64_t> number_in(std::string_view name) {
    if (name.size() < 2 || (name[0] != 'O' && name[0] != 'o')) return std::nullopt;
    const std::string_view digits = name.substr(1);
    return std::ranges::all_of(digits, is_digit) ? read_integer(digits) : std::nullopt;
}

constexpr std::array<bool, 256> bytes_of(std::string_view characters) {
    std::array<bool, 256> bytes{};
    for (const char c : characters) bytes[static_cast<unsigned char>(c)] = true;
    return bytes;
}

/// A BlockDialect.
class Family {
  public:
    static constexpr syntax::Grammar grammar = fanuc::grammar;
    static constexpr std::string_view comment_end = ")";
    static constexpr bool open_comment_takes_code = true;
    static constexpr auto make_cache_key = fanuc::make_cache_key;
    static constexpr auto is_plausible = fanuc::is_plausible;
    static constexpr auto find_cause = fanuc::find_cause;
    static constexpr auto find_parse_error = fanuc::find_parse_error;

    Family(const Source& source, const ControlModel& control, ProgramFile& file)
        : source_(source)
        , text_(without_end_of_file(source.bytes()))
        , control_(control)
        , file_(file)
        , codes_(codes_of(control))
        , lowering_(codes_, file.syntax_errors) {}

    Offset start() {
        const TapeStart start = find_tape_start(text_);
        tape_open_ = !start.at_mark;
        return start.begin;
    }

    /// Over tape marks and plain blocks.
    template<class Visit>
    Offset pass(Offset at, const Visit& visit) {
        while (at < text_.size()) {
            if (!tape_open_) {
                tape_open_ = true;
                at = after_opening_mark(text_, at);
            }
            at = skip_blanks(text_, pass_plain(at, visit));
            if (at == text_.size()) break;
            close_run(); // the decoder of a run reads on to its end: nothing but plain blocks stands in it
            if (text_[at] != '%') break;
            const AfterMark after = after_mark(text_, at);
            tape_open_ = !after.opens;
            if (const std::optional<Span> lost = code_behind_tape(text_, at, after))
                report(*lost, faults::behind_tape);
            at = after.begin;
        }
        return at;
    }

    void cut(Offset at, RawBlock& raw) const { cut_block(text_, at, program_behind_end(control_), raw); }

    /// The number of a program is a block of it, too. A memory dump says in lines of their own in which
    /// folder of the control the next programs are.
    bool take_head(const RawBlock& raw) {
        if (is_real_time(text_, raw.span, control_)) {
            if (auto fault = find_real_time_fault(text_, raw.span, control_))
                file_.syntax_errors.push_back(std::move(*fault));
            return true;
        }
        if (const std::optional<std::string_view> folder = folder_mark(text_, raw.span)) {
            close_program();
            folder_ = *folder;
            return true;
        }
        if (std::optional<ProgramHead> head = find_program_head(text_, raw.span)) {
            close_program();
            open_program(std::move(head->name), head->number).set_name_span(head->span);
        }
        return false;
    }

    void lower(const syntax::Tree& tree, const RawBlock& raw) { lowering_.lower(tree, raw.span, program()); }

    void add_unreadable(const RawBlock& raw) {
        ProgramBuilder& program = this->program();
        program.begin_block();
        // The control that it is written for passes a remark by; any other stops, and does nothing either.
        if (!is_bare_remark(text_, raw.span))
            program.add_unreadable(names_in(program.program(), raw.span), raw.span);
        program.end_block(unreadable_head(raw.span));
    }

    /// A call names its program by P or `<name>`, or is one by a code of the machine's own.
    [[nodiscard]] bool may_call(std::string_view block) const {
        return has_own_calls_ || block.find_first_of("Pp<") != std::string_view::npos;
    }

    /// The program is one with blocks, and so named after its file, too.
    void pass_over(Span block) {
        ProgramBuilder& program = this->program();
        if (!program.program().items.empty()) return;
        program.begin_block();
        program.end_block(unreadable_head(block));
    }

    /// Without P, `<` and `&`, without `O1` or `:` that may be a program number, `;` that ends it within the
    /// line, and `%`. A line of comments alone is no block.
    [[nodiscard]] std::optional<Offset> end_at_a_glance(std::string_view text, Offset at) const {
        if (has_own_calls_) return std::nullopt;
        static constexpr auto tells = bytes_of("Pp<:;%&");
        bool has_code = false;
        for (; at < text.size() && !is_line_break(text[at]); ++at) {
            const char c = text[at];
            if (tells[static_cast<unsigned char>(c)]) return std::nullopt;
            if (c == '(') {
                at = after_comment(text, at) - 1;
                continue;
            }
            has_code = has_code || !is_blank(c);
            if (to_capital(c) != 'O' || at + 1 == text.size()) continue;
            if (is_digit(text[at + 1]) || is_blank(text[at + 1])) return std::nullopt;
        }
        return has_code ? std::optional(at) : std::nullopt;
    }

    void close() {
        close_program();
        for (const Span comment : comments_with_percent(text_)) {
            report(comment, faults::percent_in_comment);
            Remedy& remedy = file_.syntax_errors.back().remedy;
            remedy.title = "Write PCT";
            for (Offset at = comment.begin; at < comment.end; ++at)
                if (text_[at] == '%') remedy.changes.push_back({{at, at + 1}, "PCT"});
        }
    }

  private:
    void report(Span span, std::string_view fault) {
        SyntaxError error{SyntaxErrorKind::unreadable, span,
                          std::string(text_.substr(span.begin, span.length())), ""};
        error.fault = fault;
        file_.syntax_errors.push_back(std::move(error));
    }

    template<class Visit>
    Offset pass_plain(Offset at, const Visit& visit) {
        syntax::PlainBlock block;
        for (; at < text_.size(); at = block.next) {
            const syntax::Lane lane = syntax::scan_block(text_, at, codes_.plain, block);
            if (lane == syntax::Lane::grammar) break;
            if (lane == syntax::Lane::blank) continue;
            visit(block.span);
            if (run_.is_full()) close_run();
            run_.add(block);
        }
        return at;
    }

    ProgramBuilder& open_program(std::string name, std::optional<std::int64_t> number) {
        ProgramBuilder& program = program_.emplace(std::move(name), text_, control_);
        program.set_plain_tables({&codes_.plain});
        program.begin_section("program", Section::Executed::when_reached, {});
        if (number) program.set_number(*number);
        program.set_folder(folder_);
        add_spellings(program);
        return program;
    }

    /// Ways in which a call may write the program's name.
    static void add_spellings(ProgramBuilder& builder) {
        const Program& program = builder.program();
        if (program.number) {
            const std::string digits = std::to_string(*program.number);
            builder.add_name("O" + digits);
            if (digits.size() < 4) builder.add_name("O" + std::string(4 - digits.size(), '0') + digits);
        } else if (program.name.size() > 2 && program.name.front() == '<') {
            builder.add_name(program.name.substr(1, program.name.size() - 2));
        }
    }

    /// The program that is being read; one without a number is named after its file.
    ProgramBuilder& program() {
        if (program_) return *program_;
        std::string name = stem_of(source_.path());
        const std::optional<std::int64_t> number = number_in(name);
        return open_program(std::move(name), number);
    }

    void close_program() {
        close_run();
        lowering_.end_program();
        if (!program_) return;
        const bool first = file_.programs.empty();
        if (first && !program_->program().items.empty()) program_->add_name(stem_of(source_.path()));
        Program& program = file_.programs.emplace_back(program_->take());
        program_.reset();
        if (program.number &&
            shows_own_call(text_.substr(program.span.begin, program.span.length()), *program.number))
            program.started = Program::Started::by_call;
    }

    void close_run() {
        if (run_.empty()) return;
        program().add_run(run_.run(0), run_.net(), run_.beside_codes());
        run_ = {};
    }

    /// Skip mark and sequence number stand at the head of the text whatever is wrong after them.
    [[nodiscard]] Block unreadable_head(Span span) const {
        Block block{};
        block.span = span;
        Offset at = span.begin;
        const auto pass = [&](const auto& is, Offset most) {
            const Offset begin = at;
            while (at < span.end && at - begin < most && is(text_[at])) ++at;
            return text_.substr(begin, at - begin);
        };
        while (at < span.end && text_[at] == '/') {
            ++at;
            pass(is_blank, span.length());
            block.skip_levels |=
                static_cast<std::uint16_t>(1U << read_integer(pass(is_digit, 1)).value_or(1));
            pass(is_blank, span.length());
        }
        if (at == span.end || to_capital(text_[at]) != 'N') return block;
        const Offset letter = at++;
        pass(is_blank, span.length());
        block.sequence_number = read_integer(pass(is_digit, span.length()));
        if (block.sequence_number) block.sequence_number_span = {letter, at};
        return block;
    }

    const Source& source_;
    std::string folder_; ///< that the last folder mark names
    std::string_view text_;
    const ControlModel& control_;
    ProgramFile& file_;
    const CodeTable& codes_;
    const bool has_own_calls_ = std::ranges::any_of(control_.own_codes, calls_program);
    BlockLowering lowering_;
    PlainRunTotals run_;
    bool tape_open_ = true;
    std::optional<ProgramBuilder> program_; ///< that is being read
};

} // namespace

ProgramFile read(std::shared_ptr<const Source> source, const ControlModel& control, Extent extent) {
    const MachineOfText machine =
        control.lathes.empty() ? MachineOfText{no_lathe, {}} : machine_of(source->bytes(), control.machine);
    const ControlModel* lathe = control.lathe_of(machine.lathe_system);
    ProgramFile file =
        BlockReader<Family>(std::move(source), lathe == nullptr ? control : *lathe, extent).run();
    file.machine_signs = machine.signs;
    return file;
}

} // namespace maclint::fanuc
