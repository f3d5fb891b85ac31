//! What SINUMERIK brings to the reader.
#include "analyzer/dialect/sinumerik/read.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/block_reader.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/sinumerik/collect.hpp"
#include "analyzer/dialect/sinumerik/diagnose.hpp"
#include "analyzer/dialect/sinumerik/lexer.hpp"
#include "analyzer/dialect/sinumerik/lowering.hpp"
#include "analyzer/dialect/sinumerik/plain.hpp"
#include "analyzer/dialect/sinumerik/plausible.hpp"
#include "analyzer/dialect/sinumerik/split.hpp"
#include "analyzer/dialect/sinumerik/tables.hpp"
#include "analyzer/program/plain_run.hpp"
#include "analyzer/source/content.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

namespace maclint::sinumerik {
namespace {

/// A BlockDialect.
class Language {
  public:
    static constexpr syntax::Grammar grammar = sinumerik::grammar;
    static constexpr std::string_view comment_end = {}; // it ends with its line
    static constexpr bool open_comment_takes_code = false;
    static constexpr auto make_cache_key = sinumerik::make_cache_key;
    static constexpr auto is_plausible = sinumerik::is_plausible;
    static constexpr auto find_cause = sinumerik::find_cause;
    static constexpr auto find_parse_error = sinumerik::find_parse_error;

    Language(const Source& source, const ControlModel& control, ProgramFile& file)
        : text_(without_end_of_file(source.bytes()))
        , file_(file)
        , programs_(source, control, file)
        , lowering_(file.syntax_errors) {}

    [[nodiscard]] static Offset start() { return 0; }
    static constexpr syntax::AddressId functions_of_machine = 'M' - 'A';

    /// Over plain blocks.
    template<class Visit>
    [[nodiscard]] Offset pass(Offset at, const Visit& visit) {
        if (programs_.is_in_foreign_language()) return at;
        syntax::PlainBlock block;
        for (; at < text_.size(); at = block.next) {
            const syntax::Lane lane = syntax::scan_block(text_, at, plain_tables(), block);
            if (lane == syntax::Lane::grammar) break;
            if (lane == syntax::Lane::blank) continue;
            if (block.repeated.contains(functions_of_machine)) break; // they are counted
            visit(block.span);
            if (run_.is_full()) close_run();
            run_.add(block);
        }
        close_run();
        return at;
    }

    void cut(Offset at, RawBlock& raw) const { cut_block(text_, at, raw); }

    bool take_head(const RawBlock& raw) {
        if (text_[raw.span.begin] != '%') return false;
        programs_.open_behind(raw.span, raw.span.begin);
        return true;
    }

    void lower(const syntax::Tree& tree, const RawBlock& raw) {
        lowering_.lower(tree, raw.span, programs_.current());
    }

    /// What is wrong in a block of another language nobody can tell here.
    void add_unreadable(const RawBlock& raw) {
        if (programs_.is_in_foreign_language())
            forget_errors_from(raw.span.begin);
        else
            explain_by_line_before(raw.span.begin);
        programs_.current().frame.reset();
        lowering_.add_unreadable(unreadable_head(raw), programs_.current());
    }

    /// Any name may call.
    static bool may_call(std::string_view /*block*/) { return true; }
    void pass_over(Span /*block*/) { static_cast<void>(programs_.current()); }
    static std::optional<Offset> end_at_a_glance(std::string_view /*text*/, Offset /*at*/) {
        return std::nullopt;
    }

    void close() { programs_.close(); }

  private:
    void forget_errors_from(Offset begin) {
        std::erase_if(file_.syntax_errors,
                      [&](const SyntaxError& error) { return error.span.begin >= begin; });
    }

    /// The second half of a PROC that stands on two lines makes no sense by itself.
    void explain_by_line_before(Offset begin) {
        const auto& errors = file_.syntax_errors;
        const auto own =
            std::ranges::find_if(errors, [&](const SyntaxError& error) { return error.span.begin >= begin; });
        if (own == errors.begin() || own == errors.end()) return;
        const SyntaxError& before = *std::prev(own);
        const std::string_view between = text_.substr(before.span.end, begin - before.span.end);
        const auto line_ends = std::max(std::ranges::count(between, '\n'), std::ranges::count(between, '\r'));
        if (before.kind == SyntaxErrorKind::split_declaration && line_ends <= 1) forget_errors_from(begin);
    }

    [[nodiscard]] Span first_line_of(Span run) const {
        const auto length = text_.substr(run.begin, run.length()).find_first_of("\r\n");
        return length == std::string_view::npos ? run
                                                : Span{run.begin, run.begin + static_cast<Offset>(length)};
    }

    static void follow_distance(OpenProgram& program, std::span<const ModalSetting> net) {
        const auto group = control().group_with(ModalRole::distance);
        for (const ModalSetting& setting : net)
            if (setting.group == group) program.incremental = setting.value != 1; // G90
    }

    void close_run() {
        if (run_.empty()) return;
        OpenProgram& program = programs_.current();
        const PlainRun run = run_.run(0);
        if (program.first_code.empty()) program.first_code = first_line_of(run.span);
        program.frame.reset();
        const std::vector<ModalSetting> net = run_.net();
        follow_distance(program, net);
        program.builder.add_run(run, net, run_.beside_codes());
        run_ = {};
    }

    /// The block number stands at the head of the text whatever is wrong after it, and so does the label.
    [[nodiscard]] Block unreadable_head(const RawBlock& raw) {
        Block block{};
        block.span = raw.span;
        const std::vector<Token> tokens = tokens_of(text_, raw.span);
        const auto text = [&](const Token& token) {
            return text_.substr(token.span.begin, token.span.length());
        };
        std::size_t next = 0;
        if (!tokens.empty() && tokens[0].kind == Token::Kind::name) {
            const std::string_view first = text(tokens[0]);
            const bool number = first.size() > 1 && to_capital(first[0]) == 'N' &&
                                std::all_of(first.begin() + 1, first.end(), is_digit);
            if (number) block.sequence_number = read_integer(first.substr(1));
            if (block.sequence_number) block.sequence_number_span = tokens[next++].span;
        }
        if (next + 1 < tokens.size() && tokens[next].kind == Token::Kind::name &&
            text(tokens[next + 1]) == ":") {
            block.name = programs_.current().builder.block_name(in_capitals(text(tokens[next])));
            block.name_span = join(tokens[next].span, tokens[next + 1].span);
        }
        return block;
    }

    std::string_view text_;
    ProgramFile& file_;
    Programs programs_;
    BlockLowering lowering_;
    PlainRunTotals run_;
};

} // namespace

ProgramFile read(std::shared_ptr<const Source> source, const ControlModel& control, Extent extent) {
    return BlockReader<Language>(std::move(source), control, extent).run();
}

} // namespace maclint::sinumerik
