//! Reads a file block by block: what the readers of all dialects have in common.
#pragma once

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/dialect/error_throttle.hpp"
#include "analyzer/dialect/raw_block.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/source/content.hpp"
#include "analyzer/source/line_index.hpp"
#include "analyzer/source/platform/kept_by_thread.hpp"
#include "analyzer/syntax/parse_cache.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace maclint {

/// What a dialect brings with it, made anew for every file. It writes the programs of the file; the reader
/// does the rest.
template<class Dialect>
concept BlockDialect = requires(Dialect dialect, Offset at, RawBlock& raw, const RawBlock& block,
                                std::string_view text, std::string& key, Span span,
                                const syntax::Tree& tree) {
    { Dialect::grammar } -> std::convertible_to<syntax::Grammar>;
    /// What closes a comment, for the cure of one that nobody closed.
    { Dialect::comment_end } -> std::convertible_to<std::string_view>;
    /// Whether a comment that nobody closed has taken code with it, which explains any other error in its
    /// block.
    { Dialect::open_comment_takes_code } -> std::convertible_to<bool>;
    /// The first byte that the control reads.
    { dialect.start() } -> std::same_as<Offset>;
    /// Passes over all that needs no reader: plain blocks, of each of which the visitor is told, and what
    /// stands between programs. Ends at a block, or at the end of the file.
    {
        dialect.pass(at, [](Span) {})
        } -> std::same_as<Offset>;
    /// Cuts the block at `at`.
    {dialect.cut(at, raw)};
    /// Takes what the head of a block tells, and the whole of a line that is no block of a program: then
    /// true.
    { dialect.take_head(block) } -> std::same_as<bool>;
    {Dialect::make_cache_key(text, key)};
    /// Whether the parser can be given the block at all: its time grows with the square of some mistakes.
    { Dialect::is_plausible(text, span) } -> std::same_as<bool>;
    { Dialect::find_cause(text, span) } -> std::same_as<std::optional<SyntaxError>>;
    { Dialect::find_parse_error(text, span, tree) } -> std::same_as<SyntaxError>;
    /// Adds the block to its program: a tree without errors, or nothing that could be read.
    {dialect.lower(tree, block)};
    {dialect.add_unreadable(block)};
    /// Whether a block with this text may call a program or begin one, other than by its head.
    { dialect.may_call(text) } -> std::same_as<bool>;
    /// The block belongs to its program, but what it says is not asked for.
    {dialect.pass_over(span)};
    /// Where the block at `at` ends, if a glance tells that it neither begins a program nor calls one, and
    /// has no others in its line.
    { dialect.end_at_a_glance(text, at) } -> std::same_as<std::optional<Offset>>;
    /// At the end of the file.
    {dialect.close()};
};

template<BlockDialect Dialect>
class BlockReader {
  public:
    BlockReader(std::shared_ptr<const Source> source, const ControlModel& control, Extent extent)
        : text_(without_end_of_file(source->bytes()))
        , extent_(extent)
        , dialect_(*source, control, file_) {
        file_.source = std::move(source);
        file_.control = &control;
    }

    [[nodiscard]] ProgramFile run() {
        const auto take_plain = [this](Span block) {
            precede_comments(block);
            throttle_.record(false);
        };
        for (Offset at = dialect_.start(); at < text_.size();) {
            at = dialect_.pass(at, take_plain);
            if (at >= text_.size()) break;
            if (extent_ == Extent::names_and_calls) {
                if (const auto end = dialect_.end_at_a_glance(text_, at)) {
                    dialect_.pass_over({at, *end});
                    at = *end;
                    continue;
                }
            }
            dialect_.cut(at, raw_);
            at = raw_.next;
            if (!raw_.span.empty()) read_block();
        }
        dialect_.close();
        // That of a comment without an end is found before that of its block.
        std::ranges::stable_sort(file_.syntax_errors, {},
                                 [](const SyntaxError& error) { return error.span.begin; });
        for (SyntaxError& error : file_.syntax_errors) {
            error.subject = file_.source->to_utf8(error.subject);
            error.cure = file_.source->to_utf8(error.cure);
        }
        file_.programs.shrink_to_fit();
        return std::move(file_);
    }

  private:
    /// Longer blocks are not parsed: noise in one line costs the parser quadratic time, and it dies of some
    /// ten thousand nodes side by side. A comment counts as one byte, however long it is.
    static constexpr std::size_t longest_block = 4096;

    void read_block() {
        if (raw_.open_comment) report_open_comment();
        if (raw_.code != 0) {
            precede_comments(raw_.span);
            if (!dialect_.take_head(raw_)) is_asked_for() ? read_code() : dialect_.pass_over(raw_.span);
        }
        record_comments();
    }

    [[nodiscard]] bool is_asked_for() const {
        return extent_ == Extent::whole ||
               dialect_.may_call(text_.substr(raw_.span.begin, raw_.span.length()));
    }

    void read_code() {
        if (raw_.code + raw_.comments.size() > longest_block) {
            constexpr Offset shown = 60;
            report(SyntaxErrorKind::oversized_block, {raw_.span.begin, raw_.span.begin + shown}, "");
            return dialect_.add_unreadable(raw_);
        }
        const Span block = raw_.span;
        const bool throttling = throttle_.is_throttling();
        std::optional<SyntaxError> cause;
        if (throttling) cause = Dialect::find_cause(text_, block);
        const syntax::Tree& tree = cause ? unparsed() : tree_of(block);
        throttle_.record(tree.has_error);
        if (!tree.has_error) return dialect_.lower(tree, raw_);
        if (!raw_.open_comment || !Dialect::open_comment_takes_code) {
            if (!throttling) cause = Dialect::find_cause(text_, block);
            file_.syntax_errors.push_back(cause ? *std::move(cause)
                                                : Dialect::find_parse_error(text_, block, tree));
        }
        dialect_.add_unreadable(raw_);
    }

    static const syntax::Tree& unparsed() {
        static const syntax::Tree nothing{.nodes = {}, .has_error = true};
        return nothing;
    }

    /// The block's tree, good until the next block; every thread has a cache of its own. What is plausible
    /// can be seen in the key as well as in the block.
    const syntax::Tree& tree_of(Span block) {
        auto& cache = platform::KeptByThread<syntax::ParseCache, Dialect>::get(Dialect::grammar);
        Dialect::make_cache_key(text_.substr(block.begin, block.length()), key_);
        if (const syntax::Tree* known = cache.find(key_)) return *known;
        const bool plausible = Dialect::is_plausible(key_, {0, static_cast<Offset>(key_.size())});
        return plausible ? cache.parse(key_) : unparsed();
    }

    void report_open_comment() {
        const Offset begin = raw_.comments.back().begin;
        const auto line_end = static_cast<Offset>(find_line_end(text_, begin));
        report(SyntaxErrorKind::unterminated_comment, {begin, std::min(raw_.comments.back().end, line_end)},
               std::string(Dialect::comment_end));
    }

    void report(SyntaxErrorKind kind, Span span, std::string cure) {
        file_.syntax_errors.push_back(
            {kind, span, std::string(text_.substr(span.begin, span.length())), std::move(cure)});
    }

    // ---- comments that speak to maclint

    void record_comments() {
        std::optional<bool> alone; // the same for all of them
        for (const Span comment : raw_.comments) {
            if (!addresses_maclint(text_.substr(comment.begin, comment.length()))) continue;
            if (!alone) alone = does_nothing();
            file_.comments.push_back({comment, block_beside(comment), {}});
        }
        if (raw_.code != 0 && alone == false) waiting_ = file_.comments.size(); // for this block alone
    }

    /// Whether the block has nothing but marks and its number beside its comments: `/2 $1 N5`.
    [[nodiscard]] bool does_nothing() const {
        std::string code;
        take_out_comments(text_, raw_.span, raw_.comments, code);
        std::string_view rest = code;
        const auto pass_digits = [&] {
            rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of("0123456789")));
        };
        while (!rest.empty() && (rest.front() == '/' || rest.front() == '$')) {
            rest.remove_prefix(1);
            pass_digits();
        }
        if (!rest.empty() && (rest.front() == 'N' || rest.front() == 'n')) {
            rest.remove_prefix(1);
            pass_digits();
        }
        return rest.empty();
    }

    /// The block that holds the comment, or the one that ends before it in its line: `G91; (…)`.
    [[nodiscard]] Span block_beside(Span comment) const {
        if (raw_.code != 0) return raw_.span;
        const std::string_view between = text_.substr(last_.end, comment.begin - last_.end);
        return between.find_first_of("\r\n") == std::string_view::npos ? last_ : Span{};
    }

    /// `block` is the next one for every comment that still waits for it.
    void precede_comments(Span block) {
        last_ = block;
        for (; waiting_ < file_.comments.size(); ++waiting_) file_.comments[waiting_].next_block = block;
    }

    std::string_view text_;
    Extent extent_;
    ProgramFile file_;
    Dialect dialect_;
    RawBlock raw_{};
    std::string key_; ///< of the block, for the cache
    ErrorThrottle throttle_;
    Span last_ = {};          ///< block with code
    std::size_t waiting_ = 0; ///< first comment without a next block
};

} // namespace maclint
