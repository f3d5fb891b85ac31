//! Of the findings in the version of the text that the client has; while it is analysed there are none.
#include "cli/lsp/features/code_actions.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "cli/config/rule_words.hpp"
#include "cli/fix/allowing_comment.hpp"
#include "cli/fix/choose.hpp"
#include "cli/lsp/diagnostics/diagnostic.hpp"
#include "cli/lsp/features/workspace_edit.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <utility>

namespace maclint::cli::lsp {
namespace {

constexpr std::string_view fix_all_kind = "source.fixAll.maclint";

/// CodeActionKinds are trees: "source" wants "source.fixAll".
bool is_wanted(const Json& params, std::string_view kind) {
    const Json* only = find(params, {"context", "only"});
    if (only == nullptr || !only->is_array()) return true;
    return std::ranges::any_of(*only, [&](const Json& wanted) {
        if (!wanted.is_string()) return false;
        const auto& name = wanted.get_ref<const std::string&>();
        return name.empty() || kind == name || kind.starts_with(name + ".");
    });
}

class Actions {
  public:
    Actions(const Session& session, const Document& document, const DocumentFindings& found)
        : session_(session)
        , document_(document)
        , found_(found)
        , writer_(session.client.encoding, [&](const std::string& path) {
            const Document* known = session.documents.find_path(path);
            return known == nullptr ? path : known->uri;
        }) {}

    void add_of(const Finding& finding) {
        const Json diagnostic = writer_.write(finding);
        for (const Fix& fix : finding.fixes) add_fix(fix, diagnostic, &fix == &finding.fixes.front());
        add_allowance(finding, diagnostic);
        add_explanation(finding, diagnostic);
    }

    /// What `--fix` would do in a first round, in this document alone.
    void add_fix_all() {
        std::vector<FilteredFinding> findings;
        for (const Finding& finding : found_.findings) findings.push_back({finding, std::nullopt});
        const auto changes = choose_fixes(findings, FixesWanted::safe,
                                          [&](std::string_view path) { return path == document_.path; });
        if (changes.empty()) return;
        list_.push_back({{"title", "Fix all safe findings of maclint"},
                         {"kind", fix_all_kind},
                         {"edit", workspace_edit(session_, changes.front().edits)}});
    }

    [[nodiscard]] Json take() { return std::move(list_); }

  private:
    void add_fix(const Fix& fix, const Json& diagnostic, bool is_best) {
        const bool is_safe = fix.applicability == Applicability::safe;
        list_.push_back({{"title", fix.title + (is_safe ? "" : " (look at it first)")},
                         {"kind", "quickfix"},
                         {"diagnostics", {diagnostic}},
                         {"isPreferred", is_safe && is_best},
                         {"edit", workspace_edit(session_, fix.edits)}});
    }

    void add_allowance(const Finding& finding, const Json& diagnostic) {
        const Dialect* dialect = find_dialect(found_.dialect);
        if (dialect == nullptr) return;
        const std::string code = code_with_key(finding);
        const Edit edit = allowing_edit(finding.source, finding.span.begin, *dialect, {code});
        list_.push_back({{"title", "Allow " + code + " here"},
                         {"kind", "quickfix"},
                         {"diagnostics", {diagnostic}},
                         {"edit", workspace_edit(session_, std::span(&edit, 1))}});
    }

    void add_explanation(const Finding& finding, const Json& diagnostic) {
        const std::string code = code_with_key(finding);
        list_.push_back(
            {{"title", "Explain " + code},
             {"kind", "quickfix"},
             {"diagnostics", {diagnostic}},
             {"command",
              {{"title", "Explain " + code}, {"command", "maclint.explain"}, {"arguments", {code}}}}});
    }

    const Session& session_;
    const Document& document_;
    const DocumentFindings& found_;
    DiagnosticWriter writer_;
    Json list_ = Json::array();
};

} // namespace

Json code_actions(Session& session, const Json& params) {
    const Document& document = session.documents.at(document_uri(params));
    const auto found = session.findings.find(document.path, document.version);
    if (found == nullptr) return Json::array();
    const Span range = LineTable(document.text, session.client.encoding).span(member(params, "range"));
    Actions actions(session, document, *found);
    if (is_wanted(params, "quickfix"))
        for (const Finding& finding : found->findings)
            if (finding.span.begin <= range.end && range.begin <= finding.span.end) actions.add_of(finding);
    if (is_wanted(params, fix_all_kind)) actions.add_fix_all();
    return actions.take();
}

} // namespace maclint::cli::lsp
