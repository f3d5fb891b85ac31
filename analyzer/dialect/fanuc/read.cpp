//! The reader: cuts the file, sends each block down the plain lane or through the grammar, and collects
//! programs.
#include "analyzer/dialect/fanuc/read.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/error_throttle.hpp"
#include "analyzer/dialect/fanuc/diagnose.hpp"
#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/dialect/fanuc/lowering.hpp"
#include "analyzer/dialect/fanuc/machine_type.hpp"
#include "analyzer/dialect/fanuc/plausible.hpp"
#include "analyzer/dialect/fanuc/split.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/program/plain_run.hpp"
#include "analyzer/syntax/parse_cache.hpp"

#include <algorithm>
#include <string>

namespace maclint::fanuc {
namespace {

/// Longer blocks are not parsed: noise in one line costs the parser quadratic time.
constexpr Offset longest_block = 4096;

/// The program number in a name like "O9100".
std::optional<std::int64_t> number_in(std::string_view name) {
    if (name.size() < 2 || (name[0] != 'O' && name[0] != 'o')) return std::nullopt;
    const std::string_view digits = name.substr(1);
    const bool all = std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
    return all ? read_integer(digits) : std::nullopt;
}

bool is_sequence_number(std::string_view text) {
    return !text.empty() && (text[0] == 'N' || text[0] == 'n') &&
           std::ranges::all_of(text.substr(1), [](char c) { return c >= '0' && c <= '9'; });
}

/// The control on the machine that the text is for.
const ControlModel& control_for(const ControlModel& control, std::string_view text) {
    return control.lathe != nullptr && is_written_for_lathe(text) ? *control.lathe : control;
}

class Reader {
  public:
    Reader(std::shared_ptr<const Source> source, const ControlModel& control)
        : text_(source->bytes())
        , codes_(codes_of(control))
        , lowering_(codes_, file_.syntax_errors) {
        file_.source = std::move(source);
        file_.control = &control;
    }

    ProgramFile run() {
        const TapeStart start = find_tape_start(text_);
        tape_open_ = !start.at_mark;
        for (Offset at = start.begin; at < text_.size();) at = read_from(at);
        close_program();
        for (SyntaxError& syntax_error : file_.syntax_errors) {
            syntax_error.subject = file_.source->to_utf8(syntax_error.subject);
            syntax_error.cure = file_.source->to_utf8(syntax_error.cure);
        }
        return std::move(file_);
    }

  private:
    /// Reads one block and whatever plain blocks follow it.
    Offset read_from(Offset at) {
        if (!tape_open_) {
            tape_open_ = true;
            return behind_opening_mark(text_, at);
        }
        syntax::PlainBlock block;
        while (at < text_.size()) {
            const syntax::Lane lane = syntax::scan_block(text_, at, codes_.plain, block);
            if (lane == syntax::Lane::grammar) break;
            if (lane == syntax::Lane::plain) take_plain(block);
            at = block.next;
        }
        return at < text_.size() ? read_with_grammar(at) : at;
    }

    void take_plain(const syntax::PlainBlock& block) {
        if (waiting_ < file_.comments.size()) tell_comments(block.span);
        if (run_.is_full()) close_run();
        run_.add(block);
    }

    Offset read_with_grammar(Offset at) {
        const Offset first = skip_blanks(text_, at);
        if (first == text_.size()) return first;
        close_run(); // the decoder of a run reads on to its end: nothing but plain blocks stands in it
        if (text_[first] == '%') return take_tape_mark(first);
        cut_block(text_, first, raw_);
        if (raw_.span.empty()) return raw_.next;
        take_out_comments(text_, raw_.span, raw_.comments, code_);
        const bool only_comments = code_.empty();
        if (!only_comments) {
            tell_comments(raw_.span);
            take_head();
            lower(raw_.span);
        } else {
            report_open_comment();
        }
        record_comments(only_comments || is_sequence_number(code_));
        return raw_.next;
    }

    Offset take_tape_mark(Offset mark) {
        const BehindMark behind = behind_mark(text_, mark);
        tape_open_ = !behind.opens;
        return behind.begin;
    }

    void take_head() {
        std::optional<ProgramHead> head = find_program_head(text_, raw_.span);
        if (!head) return;
        close_program();
        ProgramBuilder& program = open_program(std::move(head->name), head->number);
        program.set_name_span(head->span);
    }

    ProgramBuilder& open_program(std::string name, std::optional<std::int64_t> number) {
        ProgramBuilder& program = program_.emplace(std::move(name), text_, *file_.control);
        program.set_plain_tables({&codes_.plain});
        program.begin_section("program", Section::Executed::when_reached, {});
        if (number) program.set_number(*number);
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
        std::string name = stem_of(file_.source->path());
        const std::optional<std::int64_t> number = number_in(name);
        return open_program(std::move(name), number);
    }

    void close_program() {
        close_run();
        if (!program_) return;
        const bool first = file_.programs.empty();
        if (first && !program_->program().items.empty()) program_->add_name(stem_of(file_.source->path()));
        file_.programs.push_back(program_->take());
        program_.reset();
    }

    void close_run() {
        if (run_.empty()) return;
        program().add_run(run_.run(0), run_.net());
        run_ = {};
    }

    void lower(Span block) {
        const bool swallowed = report_open_comment();
        if (block.length() > longest_block) {
            constexpr Offset shown = 60;
            file_.syntax_errors.push_back(
                {SyntaxErrorKind::oversized_block, {block.begin, block.begin + shown}, "", ""});
            add_unreadable(block);
            return;
        }
        static const syntax::Tree nothing{.nodes = {}, .has_error = true};
        const std::string_view code = text_.substr(block.begin, block.length());
        const bool throttling = throttle_.is_throttling();
        std::optional<SyntaxError> cause;
        if (throttling) cause = find_cause(text_, block);
        const syntax::Tree& tree = !cause && is_plausible(text_, block) ? parse(code) : nothing;
        throttle_.record(tree.has_error);
        if (!tree.has_error) {
            lowering_.lower(tree, block, program());
            return;
        }
        if (!swallowed) {
            if (!throttling) cause = find_cause(text_, block);
            file_.syntax_errors.push_back(cause ? *std::move(cause) : find_parse_error(text_, block, tree));
        }
        add_unreadable(block);
    }

    /// The block's tree, good until the next block; every thread has a cache of its own.
    const syntax::Tree& parse(std::string_view block) {
        thread_local syntax::ParseCache cache(grammar);
        make_cache_key(block, key_);
        return cache.parse(key_);
    }

    /// Whether the block ends in a comment that nobody closed; what it swallowed explains any other error.
    bool report_open_comment() {
        if (raw_.comments.empty()) return false;
        const Span open = raw_.comments.back();
        if (is_closed(text_.substr(open.begin, open.length()))) return false;
        file_.syntax_errors.push_back({SyntaxErrorKind::unterminated_comment, open,
                                       std::string(text_.substr(open.begin, open.length())), ")"});
        return true;
    }

    void add_unreadable(Span span) {
        ProgramBuilder& program = this->program();
        Block block{};
        block.span = span;
        take_unreadable_head(block);
        program.begin_block();
        program.add_effect({names_in(program.program(), span), span});
        program.end_block(block);
    }

    /// Skip mark and sequence number stand at the head of the text whatever is wrong behind them.
    void take_unreadable_head(Block& block) const {
        Offset at = block.span.begin;
        const auto skip_blanks = [&] {
            while (at < block.span.end && (text_[at] == ' ' || text_[at] == '\t')) ++at;
        };
        const auto digits = [&](Offset most) {
            const Offset begin = at;
            while (at < block.span.end && at - begin < most && text_[at] >= '0' && text_[at] <= '9') ++at;
            return text_.substr(begin, at - begin);
        };
        while (at < block.span.end && text_[at] == '/') {
            ++at;
            block.skip_levels |= static_cast<std::uint16_t>(1U << read_integer(digits(1)).value_or(1));
            skip_blanks();
        }
        if (at == block.span.end || (text_[at] != 'N' && text_[at] != 'n')) return;
        const Offset letter = at++;
        skip_blanks();
        block.sequence_number = read_integer(digits(longest_block));
        if (block.sequence_number) block.sequence_number_span = {letter, at};
    }

    void record_comments(bool alone) {
        for (const Span comment : raw_.comments)
            if (addresses_maclint(text_.substr(comment.begin, comment.length())))
                file_.comments.push_back({comment, alone, raw_.span, {}});
    }

    /// `block` is the next one for every comment that still waits for it.
    void tell_comments(Span block) {
        for (; waiting_ < file_.comments.size(); ++waiting_) file_.comments[waiting_].next_block = block;
    }

    std::string_view text_;
    const CodeTable& codes_;
    ProgramFile file_;
    BlockLowering lowering_;
    PlainRunTotals run_;
    RawBlock raw_;
    std::string code_; ///< of the block, without its comments
    std::string key_;  ///< of the block, for the cache
    ErrorThrottle throttle_;
    std::size_t waiting_ = 0; ///< first comment without a next block
    bool tape_open_ = true;
    std::optional<ProgramBuilder> program_; ///< that is being read
};

} // namespace

ProgramFile read(std::shared_ptr<const Source> source, const ControlModel& control) {
    const ControlModel& actual = control_for(control, source->bytes());
    return Reader(std::move(source), actual).run();
}

} // namespace maclint::fanuc
