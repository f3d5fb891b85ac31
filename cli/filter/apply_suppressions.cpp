//! File by file: drop, suppress, then see which suppressions were not needed.
#include "cli/filter/apply_suppressions.hpp"

#include "analyzer/program/model.hpp"
#include "cli/filter/directive.hpp"
#include "cli/filter/one_cause.hpp"
#include "rules/finding_order.hpp"
#include "rules/fixes.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace maclint::cli {
namespace {

constexpr std::string_view unused_suppression = "MAC001";
constexpr std::string_view unknown_rule = "MAC002";

/// A token that is ready to suppress.
struct Allowance {
    const Directive* directive;
    const RuleToken* token;
    bool used = false;
};

/// What an OFF or ON said last of a rule as a whole, and after that of its rows; nullptr: it is on.
struct SwitchedRule {
    Allowance* whole = nullptr;
    std::unordered_map<const RuleRow*, Allowance*> rows = {};

    void set(const RuleRow* row, Allowance* allowance) {
        if (row != nullptr) {
            rows[row] = allowance;
            return;
        }
        whole = allowance;
        rows.clear();
    }
    [[nodiscard]] Allowance* of(const RuleRow* row) const {
        const auto own = rows.find(row);
        return own == rows.end() ? whole : own->second;
    }
};

/// The suppressions of one file, asked finding by finding in the order of the text.
class Suppressions {
  public:
    explicit Suppressions(const std::vector<Directive>& directives) {
        for (const Directive& directive : directives) {
            if (!directive.valid) continue;
            for (const RuleToken& token : directive.tokens)
                if (!token.rules.empty() && directive.verb != Verb::on)
                    allowances_.push_back({&directive, &token});
            if (directive.verb == Verb::off || directive.verb == Verb::on) switches_.push_back(&directive);
        }
        for (std::size_t i = 0; i < allowances_.size(); ++i) {
            by_token_.emplace(allowances_[i].token, i);
            place(i);
        }
        std::ranges::stable_sort(blocks_, {}, &Span::begin);
    }

    /// The allowance that the finding falls under; findings come in the order of their places.
    Allowance* find(const Finding& finding) {
        pass_switches(finding.span.begin);
        if (Allowance* block = of_block(finding)) return use(*block);
        if (const auto off = off_.find(finding.rule); off != off_.end())
            if (Allowance* switched = off->second.of(finding.row)) return use(*switched);
        return of_file(finding);
    }

    /// The next findings come from the beginning of the file again.
    void start_over() {
        next_switch_ = 0;
        off_.clear();
    }

    [[nodiscard]] const std::vector<Allowance>& all() const { return allowances_; }

  private:
    static Allowance* use(Allowance& allowance) {
        allowance.used = true;
        return &allowance;
    }

    void place(std::size_t index) {
        const Allowance& allowance = allowances_[index];
        const DirectiveComment& comment = *allowance.directive->comment;
        switch (allowance.directive->verb) {
        case Verb::allow:
            for (const Span block : {comment.block, comment.next_block}) {
                if (block.empty()) continue;
                blocks_.push_back(block);
                for (const auto& [rule, row] : allowance.token->rules)
                    of_block_.insert_or_assign({block.begin, {rule, row}}, index);
            }
            break;
        case Verb::allow_file:
            for (const auto& [rule, row] : allowance.token->rules) of_file_.try_emplace({rule, row}, index);
            break;
        case Verb::off:
        case Verb::on: break;
        }
    }

    /// Blocks do not overlap: one that begins last before the finding is the one that can hold it. Of several
    /// allowances there the last one counts.
    Allowance* of_block(const Finding& finding) {
        const auto after = std::ranges::upper_bound(blocks_, finding.span.begin, {}, &Span::begin);
        if (after == blocks_.begin()) return nullptr;
        const Span block = *std::prev(after);
        if (!block.contains(finding.span.begin)) return nullptr;
        Allowance* last = nullptr;
        for (const RuleRow* row : rows_that_allow(finding))
            if (const auto found = of_block_.find({block.begin, {finding.rule, row}});
                found != of_block_.end())
                last = std::max(last, &allowances_[found->second]);
        return last;
    }

    /// Of several allowances for the file the first one counts.
    Allowance* of_file(const Finding& finding) {
        Allowance* first = nullptr;
        for (const RuleRow* row : rows_that_allow(finding))
            if (const auto found = of_file_.find({finding.rule, row}); found != of_file_.end())
                if (Allowance* one = &allowances_[found->second]; first == nullptr || one < first)
                    first = one;
        return first == nullptr ? nullptr : use(*first);
    }

    /// The rule as a whole, and the row that found it.
    static std::array<const RuleRow*, 2> rows_that_allow(const Finding& finding) {
        return {nullptr, finding.row};
    }

    void pass_switches(Offset place) {
        for (; next_switch_ < switches_.size() && switches_[next_switch_]->comment->span.begin <= place;
             ++next_switch_) {
            const Directive& directive = *switches_[next_switch_];
            if (directive.tokens.empty()) off_.clear();
            for (const RuleToken& token : directive.tokens)
                for (const auto& [rule, row] : token.rules) off_[rule].set(row, allowance_of(token));
        }
    }

    /// nullptr for tokens of an ON.
    Allowance* allowance_of(const RuleToken& token) {
        const auto found = by_token_.find(&token);
        return found == by_token_.end() ? nullptr : &allowances_[found->second];
    }

    std::vector<Allowance> allowances_;
    std::unordered_map<const RuleToken*, std::size_t> by_token_;
    std::vector<Span> blocks_; ///< for which something is allowed, by where they begin
    using RuleAndRow = std::pair<const Rule*, const RuleRow*>;      ///< nullptr: the rule with all its rows
    std::map<std::pair<Offset, RuleAndRow>, std::size_t> of_block_; ///< by where it begins
    std::map<RuleAndRow, std::size_t> of_file_;
    std::vector<const Directive*> switches_;
    std::size_t next_switch_ = 0;
    std::unordered_map<const Rule*, SwitchedRule> off_;
};

/// Whether MAC001 may speak of the token: what it names has run, see rules_in_suppressions.
bool is_filtered(const RuleToken& token) {
    const bool only_itself = token.rules.size() == 1 && token.rules.front().rule->code == unused_suppression;
    return !token.rules.empty() && !only_itself;
}

/// The token with the separator after it, or before it when it is the last one.
Span removal_of(const Directive& directive, const RuleToken& token) {
    const auto& tokens = directive.tokens;
    const auto index = static_cast<std::size_t>(&token - tokens.data());
    if (index + 1 < tokens.size()) return {token.span.begin, tokens[index + 1].span.begin};
    if (index > 0) return {tokens[index - 1].span.end, token.span.end};
    return token.span;
}

std::string quoted_list(const std::vector<const RuleToken*>& tokens, const Source& source) {
    std::string list;
    for (const RuleToken* token : tokens) list += (list.empty() ? "" : ", ") + source.to_utf8(token->word);
    return list;
}

/// Judges one file.
class FileSuppressions {
  public:
    FileSuppressions(const ProgramFile& file, const RuleStates& rules)
        : file_(file)
        , rules_(rules)
        , directives_(read_directives(file))
        , suppressions_(directives_) {}

    std::vector<FilteredFinding> apply_suppressions(std::vector<Finding> findings) {
        std::erase_if(findings, [this](const Finding& finding) {
            return is_on_request(finding) && !rules_.is_asked_for(finding);
        });
        // Before suppression: who allows what the owner says has not asked to hear the other one.
        drop_yielding(findings, [this](const Finding& finding) {
            return finding.withheld == 0 && rules_.of(finding).on;
        });
        std::erase_if(findings, &Finding::is_silent);
        std::vector<Finding> withheld = take_withheld_out(findings);
        report_faults(findings);
        take(std::move(findings));
        suppressions_.start_over();
        take(unused());
        suppressions_.start_over();
        add_withheld(std::move(withheld));
        return std::move(evaluated_);
    }

  private:
    static std::vector<Directive> read_directives(const ProgramFile& file) {
        std::vector<Directive> directives;
        for (const DirectiveComment& comment : file.comments)
            if (auto directive = read_directive(file, comment)) directives.push_back(*std::move(directive));
        return directives;
    }

    static std::vector<Finding> take_withheld_out(std::vector<Finding>& findings) {
        std::vector<Finding> withheld;
        std::erase_if(findings, [&](Finding& finding) {
            if (finding.withheld == 0) return false;
            withheld.push_back(std::move(finding));
            return true;
        });
        return withheld;
    }

    /// What a comment allows is not told, and no comment is of use for what is withheld anyway.
    void add_withheld(std::vector<Finding> findings) {
        put_in_order(findings);
        for (Finding& finding : findings) {
            const RuleState& state = rules_.of(finding);
            if (!state.on || suppressions_.find(finding) != nullptr) continue;
            finding.severity = state.severity.value_or(finding.severity);
            evaluated_.push_back({std::move(finding), Suppression{}});
        }
    }

    void report_faults(std::vector<Finding>& findings) const {
        Reporter reporter(*find_rule(unknown_rule));
        for (const Directive& directive : directives_)
            for (const DirectiveFault& fault : directive.faults) {
                Finding& finding =
                    reporter.report({file_, fault.span}, fault.span, fault.message_id, fault.arguments);
                if (fault.message_id == "similar" ||
                    fault.message_id == "tied") // it may allow what nobody has looked at
                    rules::offer_text(finding, Applicability::unsafe, fault.span, fault.arguments[1]);
            }
        std::ranges::move(reporter.take(), std::back_inserter(findings));
    }

    void take(std::vector<Finding> findings) {
        put_in_order(findings);
        evaluated_.reserve(evaluated_.size() + findings.size());
        for (Finding& finding : findings) {
            std::optional<Suppression> suppressed;
            if (const Allowance* allowance = suppressions_.find(finding))
                suppressed = Suppression{allowance->directive->comment->span, allowance->directive->reason};
            const RuleState& state = rules_.of(finding);
            if (!state.on) continue; // it ran only to tell whether its suppressions are of use
            finding.severity = state.severity.value_or(finding.severity);
            if (Finding* first = suppressed ? nullptr : first_of_cause(finding)) {
                first->add_repeat(std::move(finding));
                continue;
            }
            evaluated_.push_back({std::move(finding), std::move(suppressed)});
        }
    }

    /// One cause is told once: later places become repeats of the first that no comment allows. nullptr: this
    /// is the first.
    Finding* first_of_cause(const Finding& finding) {
        if (finding.same_cause.empty()) return nullptr;
        const auto [first, is_new] =
            first_of_cause_.try_emplace({finding.rule, finding.row, finding.same_cause}, evaluated_.size());
        return is_new ? nullptr : &evaluated_[first->second].finding;
    }

    std::vector<Finding> unused() const {
        Reporter reporter(*find_rule(unused_suppression));
        const auto& all = suppressions_.all();
        for (std::size_t i = 0; i < all.size();) {
            const Directive& directive = *all[i].directive;
            std::vector<const RuleToken*> tokens;
            for (; i < all.size() && all[i].directive == &directive; ++i)
                if (!all[i].used && is_filtered(*all[i].token)) tokens.push_back(all[i].token);
            if (!tokens.empty()) report_unused(directive, tokens, reporter);
        }
        return reporter.take();
    }

    void report_unused(const Directive& directive, const std::vector<const RuleToken*>& tokens,
                       Reporter& reporter) const {
        if (tokens.size() == directive.tokens.size()) {
            const Span comment = directive.comment->span;
            reporter.report({file_, comment}, comment, "comment", {quoted_list(tokens, *file_.source)})
                .offer(removal("Remove the comment", rules::removal_of(*file_.source, comment)));
            return;
        }
        for (const RuleToken* token : tokens) {
            const std::string word = file_.source->to_utf8(token->word);
            reporter.report({file_, token->span}, token->span, "unused", {word})
                .offer(removal("Remove " + word, removal_of(directive, *token)));
        }
    }

    /// A comment is nothing to the control.
    [[nodiscard]] Fix removal(std::string title, Span span) const {
        return {std::move(title), Applicability::safe, {{file_.source, span, ""}}};
    }

    const ProgramFile& file_;
    const RuleStates& rules_;
    std::vector<Directive> directives_;
    Suppressions suppressions_;
    std::vector<FilteredFinding> evaluated_;
    std::map<std::tuple<const Rule*, const RuleRow*, std::string>, std::size_t>
        first_of_cause_; ///< places in evaluated_
};

} // namespace

std::vector<NamedRule> rules_in_suppressions(const ProgramFile& file) {
    std::vector<NamedRule> rules;
    for (const DirectiveComment& comment : file.comments) {
        const auto directive = read_directive(file, comment);
        if (!directive || !directive->valid) continue;
        for (const RuleToken& token : directive->tokens)
            rules.insert(rules.end(), token.rules.begin(), token.rules.end());
    }
    return rules;
}

std::vector<FilteredFinding> apply_suppressions(std::vector<Finding> findings,
                                                const std::vector<FileRules>& files) {
    std::unordered_map<const Source*, std::size_t>
        counts; // there may be a million: no list grows step by step
    for (const Finding& finding : findings) ++counts[finding.source.get()];
    std::unordered_map<const Source*, std::vector<Finding>> by_file;
    for (const auto& [source, count] : counts) by_file[source].reserve(count);
    for (Finding& finding : findings) by_file[finding.source.get()].push_back(std::move(finding));
    findings = std::vector<Finding>();
    std::vector<FilteredFinding> filtered;
    for (const FileRules& file : files) {
        const auto own = by_file.find(file.file->source.get());
        auto mine = own == by_file.end() ? std::vector<Finding>() : std::move(own->second);
        if (mine.empty() && file.file->comments.empty()) continue;
        auto judged = FileSuppressions(*file.file, *file.rules).apply_suppressions(std::move(mine));
        if (filtered.empty())
            filtered = std::move(judged);
        else
            std::ranges::move(judged, std::back_inserter(filtered));
    }
    put_in_order(filtered, &FilteredFinding::finding);
    return filtered;
}

} // namespace maclint::cli
