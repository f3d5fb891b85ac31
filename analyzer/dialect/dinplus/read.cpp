//! What DIN PLUS brings to the reader: lines that begin a program or a section.
#include "analyzer/dialect/dinplus/read.hpp"

#include "analyzer/dialect/block_reader.hpp"
#include "analyzer/dialect/dinplus/channels.hpp"
#include "analyzer/dialect/dinplus/collect.hpp"
#include "analyzer/dialect/dinplus/diagnose.hpp"
#include "analyzer/dialect/dinplus/keywords.hpp"
#include "analyzer/dialect/dinplus/lexer.hpp"
#include "analyzer/dialect/dinplus/lowering.hpp"
#include "analyzer/dialect/dinplus/plain.hpp"
#include "analyzer/dialect/dinplus/plausible.hpp"
#include "analyzer/dialect/dinplus/sections.hpp"
#include "analyzer/dialect/dinplus/split.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/plain_run.hpp"
#include "analyzer/source/content.hpp"

#include <algorithm>

namespace maclint::dinplus {
namespace {

/// A BlockDialect.
class Language {
  public:
    static constexpr syntax::Grammar grammar = dinplus::grammar;
    static constexpr std::string_view comment_end = "]";
    static constexpr bool open_comment_takes_code = false; // it may go on over lines
    static constexpr auto make_cache_key = dinplus::make_cache_key;
    static constexpr auto is_plausible = dinplus::is_plausible;
    static constexpr auto find_cause = dinplus::find_cause;
    static constexpr auto find_parse_error = dinplus::find_parse_error;

    Language(const Source& source, const ControlModel& control, ProgramFile& file)
        : text_(without_end_of_file(source.bytes()))
        , file_(file)
        , programs_(source, control, file)
        , lowering_(file.syntax_errors) {}

    [[nodiscard]] static Offset start() { return 0; }

    /// Over plain blocks.
    template<class Visit>
    [[nodiscard]] Offset pass(Offset at, const Visit& visit) {
        const OpenProgram* program = programs_.current_if_any();
        if (program != nullptr && program->waiting_if) return at; // the next block has to be its THEN
        const bool commands =
            program == nullptr || (program->effects && program->context == Context::machining);
        run_section_ = commands ? plain_sections::commands : plain_sections::descriptions;
        syntax::PlainBlock block;
        for (; at < text_.size(); at = block.next) {
            const syntax::Lane lane = syntax::scan_block(text_, at, plain_tables(run_section_), block);
            if (lane == syntax::Lane::grammar) break;
            if (lane == syntax::Lane::blank) continue;
            visit(block.span);
            if (run_.is_full()) close_run();
            run_.add(block);
        }
        close_run(); // the decoder of a run reads on to its end: nothing but plain blocks stands in it
        return at;
    }

    void cut(Offset at, RawBlock& raw) const { cut_block(text_, at, raw); }

    /// What the line is can mostly be told from its head.
    bool take_head(const RawBlock& raw) {
        const Offset head = first_code(raw);
        if (text_[head] == '%') {
            programs_.open_main(raw.span, head);
            return true;
        }
        const Span words = words_at(text_, head);
        return !words.empty() && take_section(words, raw.span);
    }

    /// Section words after a block number, and words that have only the shape of one, are recognised by the
    /// tree.
    void lower(const syntax::Tree& tree, const RawBlock& raw) {
        for (const syntax::Node& node : tree.nodes) {
            if (kind_of(node) == Kind::section) return take_unknown_section(tree, node, raw);
            if (kind_of(node) == Kind::block && take_numbered_section(tree, node, raw.span)) return;
        }
        lowering_.lower(tree, raw.span, programs_.current());
    }

    void add_unreadable(const RawBlock& raw) {
        lowering_.add_unreadable(unreadable_head(raw), programs_.current());
    }

    /// An L calls, and a word of three letters or more may begin a section after a block number.
    static bool may_call(std::string_view block) {
        for (std::size_t at = 0; at < block.size();) {
            std::size_t end = at;
            while (end < block.size() && is_letter(block[end])) ++end;
            if (end - at >= 3 || (end - at == 1 && block[at] == 'L')) return true;
            at = std::max(end, at + 1);
        }
        return false;
    }

    /// The program is there although none of its blocks says anything.
    void pass_over(Span /*block*/) { static_cast<void>(programs_.current()); }
    static std::optional<Offset> end_at_a_glance(std::string_view /*text*/, Offset /*at*/) {
        return std::nullopt;
    }

    void close() {
        programs_.close();
        index_block_numbers(file_);
    }

  private:
    void close_run() {
        if (run_.empty()) return;
        programs_.current().builder.add_run(run_.run(run_section_), run_.net(), run_.beside_codes());
        run_ = {};
    }

    /// Where the block's first byte stands that is no comment.
    [[nodiscard]] Offset first_code(const RawBlock& raw) const {
        Offset at = raw.span.begin;
        for (const Span comment : raw.comments) {
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
    [[nodiscard]] bool holds_command(Span after_name) const {
        const std::vector<Token> tokens = tokens_of(text_, after_name);
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            if (tokens[i].kind != Token::Kind::letters) continue;
            const std::string_view word = text_.substr(tokens[i].span.begin, tokens[i].span.length());
            const bool number = i + 1 < tokens.size() && tokens[i + 1].kind == Token::Kind::number;
            if ((number && (word == "G" || word == "M" || word == "N")) || is_structural(word)) return true;
        }
        return false;
    }

    /// `N5 MACHINING`, `N3 FACE_C Z0`: the word counts although a number stands before it.
    bool take_numbered_section(const syntax::Tree& tree, const syntax::Node& block, Span line) {
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
        return take_section(words_at(text_, line.begin + statement->span.begin), line);
    }

    /// The shape of a section, but no such word.
    void take_unknown_section(const syntax::Tree& tree, const syntax::Node& section, const RawBlock& raw) {
        const syntax::Node& name = tree.nodes[section.first_child];
        const Span word{raw.span.begin + name.span.begin, raw.span.begin + name.span.end};
        const std::string meant = meant_by(capitals_of(text_.substr(word.begin, word.length())));
        report(SyntaxErrorKind::unknown_keyword, word, meant);
        if (meant == "RETURN") // manuals print the word in translation
            lowering_.add_unreadable_return(unreadable_head(raw), programs_.current());
        else
            add_unreadable(raw);
    }

    /// The block number stands at the head of the text whatever is wrong after it.
    [[nodiscard]] Block unreadable_head(const RawBlock& raw) const {
        Block block{};
        block.span = raw.span;
        const Offset head = first_code(raw);
        Offset at = after_marks(text_, head);
        block.channels = channels_in(text_.substr(head, at - head));
        if (at >= block.span.end || (text_[at] != 'N' && text_[at] != 'n')) return block;
        const Offset letter = at;
        at = skip_blanks(text_, at + 1);
        const Offset digits = at;
        while (at < block.span.end && is_digit(text_[at])) ++at;
        if (at == digits) return block;
        block.sequence_number = read_integer(text_.substr(digits, at - digits));
        if (block.sequence_number) block.sequence_number_span = {letter, at};
        return block;
    }

    void report(SyntaxErrorKind kind, Span span, std::string cure) {
        file_.syntax_errors.push_back(
            {kind, span, std::string(text_.substr(span.begin, span.length())), std::move(cure)});
    }

    std::string_view text_;
    ProgramFile& file_;
    Programs programs_;
    BlockLowering lowering_;
    PlainRunTotals run_;
    std::uint8_t run_section_ = 0;
};

} // namespace

ProgramFile read(std::shared_ptr<const Source> source, const ControlModel& control, Extent extent) {
    return BlockReader<Language>(std::move(source), control, extent).run();
}

} // namespace maclint::dinplus
