//! The rounds of fixes write the comments: each round offers those that the round before has not silenced
//! another place, or none.
#include "cli/fix/add_suppressions.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "cli/config/rule_words.hpp"
#include "cli/fix/allowing_comment.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace maclint::cli {
namespace {

constexpr std::string_view line_blanks = " \t";

/// A line with findings that one comment is to allow.
struct AllowedLine {
    const Source* source;
    std::uint32_t line;
    friend auto operator<=>(const AllowedLine&, const AllowedLine&) = default;
};

struct Wanted {
    std::vector<std::string> codes; ///< each once
    Finding* carrier;               ///< the first of its findings, whose fix writes the comment
};

class Allowances {
  public:
    Allowances(std::string reason, Severity least)
        : reason_(std::move(reason))
        , least_(least) {}

    /// Puts the comments in the place of the findings' own fixes.
    void offer_in(Result& result) {
        plain_ = result.findings;
        dialects_.clear();
        for (std::size_t i = 0; i < result.sources.size(); ++i)
            dialects_[result.sources[i].get()] = find_dialect(result.read_as[i].dialect);
        std::map<AllowedLine, Wanted> lines;
        std::size_t count = 0;
        for (FilteredFinding& filtered : result.findings) {
            filtered.finding.fixes.clear();
            if (filtered.suppressed || filtered.finding.severity < least_ || is_of_comments(filtered.finding))
                continue;
            count += 1 + filtered.finding.repeats.size();
            note(filtered.finding, lines);
        }
        if (!first_) first_ = count;
        left_ = count;
        edits_.clear();
        for (const auto& [line, wanted] : lines) offer(line, wanted);
        for (auto& [finding, edits] : edits_) {
            if (edits.empty()) continue;
            std::ranges::sort(edits, {}, [](const Edit& edit) { return edit.span.begin; });
            finding->fixes = {{"Allow it", Applicability::safe, std::move(edits)}};
        }
    }

    [[nodiscard]] std::vector<FilteredFinding> take_plain() { return std::move(plain_); }
    [[nodiscard]] std::size_t allowed() const {
        return first_.value_or(0) - std::min(left_, first_.value_or(0));
    }
    [[nodiscard]] std::vector<Notice> take_notices() { return std::move(notices_); }

  private:
    /// What is said of comments for maclint is not allowed by one more.
    static bool is_of_comments(const Finding& finding) {
        return finding.rule->code == "MAC001" || finding.rule->code == "MAC002";
    }

    static void note(Finding& finding, std::map<AllowedLine, Wanted>& lines) {
        const std::string code = code_with_key(finding);
        const auto add = [&](const Source& source, Span span) {
            auto& codes = lines.try_emplace({&source, source.position(span.begin).line}, Wanted{{}, &finding})
                              .first->second.codes;
            if (std::ranges::find(codes, code) == codes.end()) codes.push_back(code);
        };
        add(*finding.source, finding.span);
        for (const RelatedLocation& repeat : finding.repeats) add(*repeat.source, repeat.span);
    }

    void offer(const AllowedLine& at, const Wanted& wanted) {
        const std::shared_ptr<const Source>& source =
            wanted.carrier->source; // findings of one cause share a file
        const Dialect* dialect = dialects_[at.source];
        if (dialect == nullptr) return;
        const Span line = at.source->line_span(at.line);
        std::string_view text = at.source->bytes(line);
        const std::string own = allowing_comment(*dialect, wanted.codes, reason_);
        const std::size_t here = text.find(own);
        const bool was_here = here != std::string_view::npos;
        const auto before = at.line > 1 ? at.source->line_span(at.line - 1) : Span{};
        const bool was_before = at.line > 1 && at.source->bytes(before) == own;
        const std::string key =
            at.source->path() + "\n" + std::string(was_here ? text.substr(0, here) : text) + "\n" + own;
        const bool is_given_up = given_up_.contains(key);
        std::vector<Edit>& edits = edits_[wanted.carrier];
        if (was_before) { // neither place has helped
            edits.push_back({source, {before.begin, line.begin}, ""});
            give_up(at, wanted, key);
        } else if (was_here) {
            const auto from =
                static_cast<Offset>(text.find_last_not_of(line_blanks, here - (here > 0 ? 1 : 0)) + 1);
            edits.push_back({source, {line.begin, line.begin}, own + "\n"});
            edits.push_back(
                {source,
                 {line.begin + (here == 0 ? 0 : from), line.begin + static_cast<Offset>(here + own.size())},
                 ""});
        } else if (!is_given_up) {
            const Offset end = line.begin + static_cast<Offset>(end_of_words(text));
            edits.push_back({source, {end, end}, (end == line.begin ? "" : " ") + own});
        }
    }

    void give_up(const AllowedLine& at, const Wanted& wanted, const std::string& key) {
        given_up_.insert(key);
        std::string codes;
        for (const std::string& code : wanted.codes) codes += (codes.empty() ? "" : ", ") + code;
        const std::uint32_t line = at.line - 1; // without the comment
        notices_.push_back({NoticeKind::left_out, at.source->path(),
                            "line " + std::to_string(line) + ": no comment there allows " + codes +
                                ". Write ALLOW-FILE at the head of the program, or 'per-file-ignores' in the "
                                "configuration."});
    }

    std::string reason_;
    Severity least_;
    std::vector<FilteredFinding> plain_;
    std::map<const Source*, const Dialect*> dialects_;
    std::map<Finding*, std::vector<Edit>> edits_;
    std::set<std::string> given_up_;
    std::optional<std::size_t> first_;
    std::size_t left_ = 0;
    std::vector<Notice> notices_;
};

} // namespace

AddedSuppressions add_suppressions(const Snapshot& snapshot, const std::string& reason, Severity least,
                                   const Analyse& analyse) {
    Allowances allowances(reason, least);
    const Analyse with_allowances = [&](const Snapshot& now) {
        Result result = analyse(now);
        allowances.offer_in(result);
        return result;
    };
    AddedSuppressions added{fix_programs(snapshot, FixesWanted::safe, with_allowances)};
    added.programs.result.findings = allowances.take_plain();
    added.allowed = allowances.allowed();
    for (Notice& notice : allowances.take_notices()) added.programs.notices.push_back(std::move(notice));
    return added;
}

std::optional<std::string> wrong_reason(std::string_view reason) {
    constexpr std::string_view marks = " .,:/-+_'!?";
    if (reason.find_first_not_of(line_blanks) == std::string_view::npos)
        return "--reason is empty. Write why the findings are allowed, for instance --reason \"proven on the "
               "machine\".";
    for (const char c : reason) {
        const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (!is_letter && marks.find(c) == std::string_view::npos)
            return "--reason goes into comments of programs, which not all can hold what it says. Write it "
                   "with letters A to "
                   "Z, figures, blanks and . , : / - + alone.";
    }
    return std::nullopt;
}

} // namespace maclint::cli
