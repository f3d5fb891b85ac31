//! The reader: cuts the file, sorts its lines into sections and programs, and sends each block through the
//! grammar.
#include "analyzer/dialect/dinplus/read.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/dinplus/collect.hpp"
#include "analyzer/dialect/dinplus/diagnose.hpp"
#include "analyzer/dialect/dinplus/keywords.hpp"
#include "analyzer/dialect/dinplus/lexer.hpp"
#include "analyzer/dialect/dinplus/lowering.hpp"
#include "analyzer/dialect/dinplus/plain.hpp"
#include "analyzer/dialect/dinplus/plausible.hpp"
#include "analyzer/dialect/dinplus/sections.hpp"
#include "analyzer/dialect/dinplus/split.hpp"
#include "analyzer/dialect/error_throttle.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/plain_run.hpp"
#include "analyzer/syntax/parse_cache.hpp"

#include <algorithm>

namespace maclint::dinplus {
namespace {

/// Longer blocks are not parsed: noise in one line costs the parser quadratic time, and it dies of some ten
/// thousand nodes side by side. A comment counts as one byte, however long it is.
constexpr std::size_t longest_block = 4096;
constexpr Offset shown = 60;

/// A block number with nothing behind it.
bool is_block_number(std::string_view text) {
    return !text.empty() && (text[0] == 'N' || text[0] == 'n') &&
           std::ranges::all_of(text.substr(1), is_digit);
}

class Reader {
  public:
    Reader(std::shared_ptr<const Source> source, const ControlModel& control)
        : text_(source->bytes())
        , programs_(*source, control, file_)
        , lowering_(file_.syntax_errors) {
        file_.source = std::move(source);
        file_.control = &control;
    }

    ProgramFile run() {
        for (Offset at = 0; at < text_.size();) {
            at = pass_plain(at);
            close_run(); // the decoder of a run reads on to its end: nothing but plain blocks stands in it
            if (at == text_.size()) break;
            cut_block(text_, at, raw_);
            at = raw_.next;
            if (!raw_.span.empty()) take();
        }
        programs_.close();
        index_block_numbers(file_);
        for (SyntaxError& syntax_error : file_.syntax_errors) {
            syntax_error.subject = file_.source->to_utf8(syntax_error.subject);
            syntax_error.cure = file_.source->to_utf8(syntax_error.cure);
        }
        return std::move(file_);
    }

  private:
    /// Takes the plain blocks that stand there, and passes over blanks and comments between them.
    Offset pass_plain(Offset at) {
        const Preceding& before = programs_.preceding();
        if (before.waiting_if) return at; // its THEN is missing if the next block is not that
        const bool commands = before.effects && before.context == Context::machining;
        const std::uint8_t section = commands ? plain_sections::commands : plain_sections::descriptions;
        const syntax::PlainTables& tables = plain_tables(section);
        syntax::PlainBlock block;
        while (at < text_.size()) {
            const syntax::Lane lane = syntax::scan_block(text_, at, tables, block);
            if (lane == syntax::Lane::grammar) break;
            at = block.next;
            if (lane == syntax::Lane::blank) continue;
            if (waiting_ < file_.comments.size()) tell_comments(block.span);
            throttle_.record(false);
            if (run_.is_full()) close_run();
            run_.add(block);
            run_section_ = section;
        }
        return at;
    }

    void close_run() {
        if (run_.empty()) return;
        programs_.current().program.add_run(run_.run(run_section_), run_.net());
        run_ = {};
    }

    void take() {
        if (raw_.open_comment) {
            const Span open = raw_.comments.back();
            report(SyntaxErrorKind::unterminated_comment,
                   {open.begin, std::min(open.end, end_of_line(open.begin))}, "]");
        }
        const bool only_comments = raw_.code == 0;
        if (!only_comments) {
            tell_comments(raw_.span);
            take_line();
        }
        take_out_comments(text_, raw_.span, raw_.comments, code_);
        record_comments(only_comments || is_block_number(code_));
    }

    [[nodiscard]] Offset end_of_line(Offset at) const {
        return static_cast<Offset>(std::min(text_.find_first_of("\r\n", at), text_.size()));
    }

    /// What the line is can be told from its head.
    void take_line() {
        const Offset head = first_code();
        if (text_[head] == '%') return programs_.open_main(raw_.span, head);
        const Span words = words_at(text_, head);
        if (!words.empty() && take_section(words, raw_.span)) return;
        if (raw_.code + raw_.comments.size() > longest_block) {
            report(SyntaxErrorKind::oversized_block, {raw_.span.begin, raw_.span.begin + shown}, "");
            return add_unreadable(false);
        }
        parse();
    }

    /// Where the block's first byte stands that is no comment.
    [[nodiscard]] Offset first_code() const {
        Offset at = raw_.span.begin;
        for (const Span comment : raw_.comments) {
            if (comment.begin != at) break;
            at = skip_blanks(text_, comment.end);
        }
        return at;
    }

    bool take_section(Span words, Span heading) {
        const auto found = find_section(text_.substr(words.begin, words.length()));
        if (!found) return false;
        const Span name{words.begin, words.begin + found->length};
        // `End` may be the first word of anything; small letters are taken for a section word only alone.
        if (!found->capitals && name.end != words.end) return false;
        const bool wrong = !found->capitals || found->word->use == SectionWord::Use::translated;
        if (wrong)
            report(SyntaxErrorKind::unknown_keyword, name, spelling_of(*found->word));
        else if (holds_command({name.end, heading.end}))
            report(SyntaxErrorKind::not_alone, name, "");
        programs_.open_section(*found->word, heading);
        return true;
    }

    /// Whether words stand there that are no parameters of any section: G and M codes, the number of the next
    /// block, words of control flow.
    [[nodiscard]] bool holds_command(Span behind_name) const {
        const std::vector<Token> tokens = tokens_of(text_, behind_name);
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            if (tokens[i].kind != Token::Kind::letters) continue;
            const std::string_view word = text_.substr(tokens[i].span.begin, tokens[i].span.length());
            const bool number = i + 1 < tokens.size() && tokens[i + 1].kind == Token::Kind::number;
            if ((number && (word == "G" || word == "M" || word == "N")) || is_structural(word)) return true;
        }
        return false;
    }

    void parse() {
        static const syntax::Tree nothing{.nodes = {}, .has_error = true};
        const Span block = raw_.span;
        const bool throttling = throttle_.is_throttling();
        std::optional<SyntaxError> cause;
        if (throttling) cause = find_cause(text_, block);
        const syntax::Tree& tree = !cause && is_plausible(text_, block)
                                       ? tree_of(text_.substr(block.begin, block.length()))
                                       : nothing;
        throttle_.record(tree.has_error);
        if (tree.has_error) {
            if (!throttling) cause = find_cause(text_, block);
            file_.syntax_errors.push_back(cause ? *std::move(cause) : find_parse_error(text_, block, tree));
            return add_unreadable(false);
        }
        for (const syntax::Node& node : tree.nodes) {
            if (kind_of(node) == Kind::section) return take_unknown_section(tree, node);
            if (kind_of(node) == Kind::block && take_numbered_section(tree, node)) return;
        }
        auto& [program, before] = programs_.current();
        lowering_.lower(tree, block, program, before);
    }

    /// `N5 MACHINING`, `N3 FACE_C Z0`: the word counts although a number stands before it.
    bool take_numbered_section(const syntax::Tree& tree, const syntax::Node& block) {
        const syntax::Node* statement = nullptr;
        for (syntax::NodeIndex i = block.first_child; i != syntax::no_node; i = tree.nodes[i].next_sibling) {
            const Kind kind = kind_of(tree.nodes[i]);
            if (is_remark(tree.nodes[i])) continue;
            if (kind == Kind::unknown_statement) {
                if (statement == nullptr) statement = &tree.nodes[i];
            } else if (statement == nullptr ? !is_head(kind) : !is_word(kind) && kind != Kind::bare_value) {
                return false;
            }
        }
        if (statement == nullptr) return false;
        return take_section(words_at(text_, raw_.span.begin + statement->span.begin), raw_.span);
    }

    /// The shape of a section, but no such word.
    void take_unknown_section(const syntax::Tree& tree, const syntax::Node& section) {
        const syntax::Node& name = tree.nodes[section.first_child];
        const Span word{raw_.span.begin + name.span.begin, raw_.span.begin + name.span.end};
        const std::string meant = meant_by(capitals_of(text_.substr(word.begin, word.length())));
        report(SyntaxErrorKind::unknown_keyword, word, meant);
        add_unreadable(meant == "RETURN"); // manuals print the word in translation
    }

    /// The block's tree, good until the next block; every thread has a cache of its own.
    const syntax::Tree& tree_of(std::string_view block) {
        thread_local syntax::ParseCache cache(grammar);
        make_cache_key(block, key_);
        return cache.parse(key_);
    }

    void add_unreadable(bool returns) {
        auto& [program, before] = programs_.current();
        before.waiting_if.reset();
        Block block{};
        block.span = raw_.span;
        take_unreadable_head(block);
        program.begin_block();
        if (before.effects) program.add_effect({names_in(program.program(), before, raw_.span), raw_.span});
        if (returns) program.add_effect({Return{}, raw_.span});
        program.end_block(block);
    }

    /// The block number stands at the head of the text whatever is wrong behind it.
    void take_unreadable_head(Block& block) const {
        Offset at = after_marks(text_, first_code());
        if (at >= block.span.end || (text_[at] != 'N' && text_[at] != 'n')) return;
        const Offset letter = at;
        at = skip_blanks(text_, at + 1);
        const Offset digits = at;
        while (at < block.span.end && is_digit(text_[at])) ++at;
        if (at == digits) return;
        block.sequence_number = read_integer(text_.substr(digits, at - digits));
        if (block.sequence_number) block.sequence_number_span = {letter, at};
    }

    void report(SyntaxErrorKind kind, Span span, std::string cure) {
        file_.syntax_errors.push_back(
            {kind, span, std::string(text_.substr(span.begin, span.length())), std::move(cure)});
    }

    // ---- comments

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
    ProgramFile file_;
    Programs programs_;
    BlockLowering lowering_;
    PlainRunTotals run_;
    std::uint8_t run_section_ = 0;
    RawBlock raw_;
    std::string code_; ///< of the block, without its comments
    std::string key_;  ///< of the block, for the cache
    ErrorThrottle throttle_;
    std::size_t waiting_ = 0; ///< first comment without a next block
};

} // namespace

ProgramFile read(std::shared_ptr<const Source> source, const ControlModel& control) {
    return Reader(std::move(source), control).run();
}

} // namespace maclint::dinplus
