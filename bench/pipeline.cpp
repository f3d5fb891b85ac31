//! Runs the layers one after the other, without files.
#include "bench/pipeline.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "analyzer/workspace/workspace.hpp"
#include "rules/rule.hpp"
#include "rules/word_check.hpp"
#include "rules/words/row_indexes.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <span>
#include <utility>

#include <tree_sitter/api.h>

extern "C" const TSLanguage* tree_sitter_fanuc();
extern "C" const TSLanguage* tree_sitter_dinplus();

namespace maclint::bench {

namespace {

/// Reports what no word says: all values have to be looked at for it.
void check_values(const queries::WordsOfBlock& block, Reporter& reporter) {
    constexpr double said_by_nobody = 1e15;
    for (const Word& word : block.words) {
        const auto* value = std::get_if<Literal>(&word.value);
        if (value != nullptr && value->value >= said_by_nobody)
            reporter.report({block.analysis, word.span}, word.span, "", {});
    }
}

const Rule every_value{.code = "BENCH",
                       .name = "every-value",
                       .summary = "",
                       .why = "",
                       .severity = Severity::note,
                       .precision = Precision::high,
                       .on_by_default = false,
                       .messages = {},
                       .bad = {},
                       .good = {},
                       .sources = {},
                       .check = WordCheck{"", WordCheck::Blocks::all, &check_values}};

/// What tables say of a code, so that programs as they should be keep it: only where a row can be wrong the
/// words are looked at.
constexpr std::array statements = {
    WordRow{.says = RowStatement::needs,
            .code = "G0",
            .words = "X Y Z A B C F P R S",
            .effect = "",
            .severity = Severity::note,
            .source = ""},
    WordRow{.says = RowStatement::takes_not,
            .code = "G0",
            .words = "D L",
            .effect = "",
            .severity = Severity::note,
            .source = ""},
    WordRow{.says = RowStatement::takes_not,
            .code = "G0",
            .words = "E",
            .effect = "",
            .severity = Severity::note,
            .source = ""},
    WordRow{.says = RowStatement::excludes,
            .code = "G0",
            .words = "R",
            .others = "I J K",
            .effect = "",
            .severity = Severity::note,
            .source = ""},
    WordRow{.says = RowStatement::excludes,
            .code = "G0",
            .words = "P",
            .others = "L",
            .effect = "",
            .severity = Severity::note,
            .source = ""},
    WordRow{.says = RowStatement::only_with,
            .code = "G0",
            .words = "Q",
            .others = "P R",
            .effect = "",
            .severity = Severity::note,
            .source = ""},
    WordRow{.says = RowStatement::values,
            .code = "G0",
            .words = "R",
            .least = -999,
            .most = 999,
            .effect = "",
            .severity = Severity::note,
            .source = ""},
    WordRow{.says = RowStatement::values,
            .code = "G0",
            .words = "P L",
            .least = 0,
            .most = 9999,
            .effect = "",
            .severity = Severity::note,
            .source = ""},
    WordRow{.says = RowStatement::values,
            .code = "G0",
            .words = "Q",
            .values = "0 1 2",
            .effect = "",
            .severity = Severity::note,
            .source = ""},
    WordRow{.says = RowStatement::whole,
            .code = "G0",
            .words = "P L H D",
            .effect = "",
            .severity = Severity::note,
            .source = ""},
};

std::shared_ptr<const RowIndexes> thousand_rows() {
    static const WordTable table{.language = "fanuc", .rows = statements};
    static const std::vector<RuleRow> rows = [] {
        std::vector<RuleRow> made;
        for (int code = 0; code < 100; ++code)
            for (const WordRow& row : statements)
                made.push_back({find_rule_row("MAC575/G4.X-P")->rule,
                                made.size(),
                                "",
                                {{&table, &row, 'G', static_cast<double>(code)}}});
        return made;
    }();
    std::vector<const RuleRow*> all;
    for (const RuleRow& row : rows) all.push_back(&row);
    return std::make_shared<const RowIndexes>(std::move(all));
}

std::size_t lint_with(const std::vector<std::string>& files, std::string_view dialect_name,
                      std::span<const Rule* const> more, std::shared_ptr<const RowIndexes> rows = nullptr) {
    const Dialect& dialect = *find_dialect(dialect_name);
    const ControlModel& control = *find_control(dialect.default_control);
    std::vector<WorkspaceFile> workspace;
    for (std::size_t i = 0; i < files.size(); ++i) {
        auto source = std::make_shared<const Source>(
            Source::from_bytes("bench/" + std::to_string(i) + ".nc", files[i]));
        workspace.push_back(
            {std::make_shared<const ProgramFile>(dialect.read(std::move(source), control, Extent::whole)),
             true});
    }
    const auto analysed = Workspace::analyse(std::move(workspace), {.jobs = 1});
    Selection selection;
    std::ranges::copy_if(all_rules(), std::back_inserter(selection.rules), &Rule::on_by_default);
    selection.rules.insert(selection.rules.end(), more.begin(), more.end());
    selection.rows = std::move(rows);
    return run_rules(*analysed, selection, 1).size();
}

} // namespace

std::size_t lint(const std::vector<std::string>& files, std::string_view dialect) {
    return lint_with(files, dialect, {});
}

std::size_t lint_every_value(const std::vector<std::string>& files, std::string_view dialect) {
    return lint_with(files, dialect, std::array{&every_value});
}

std::size_t lint_thousand_rows(const std::vector<std::string>& files) {
    return lint_with(files, "fanuc", {}, thousand_rows());
}

std::size_t parse_in_one_piece(const std::string& text, std::string_view dialect) {
    const std::unique_ptr<TSParser, decltype(&ts_parser_delete)> parser(ts_parser_new(), &ts_parser_delete);
    ts_parser_set_language(parser.get(), dialect == "dinplus" ? tree_sitter_dinplus() : tree_sitter_fanuc());
    const std::unique_ptr<TSTree, decltype(&ts_tree_delete)> tree(
        ts_parser_parse_string(parser.get(), nullptr, text.data(), static_cast<std::uint32_t>(text.size())),
        &ts_tree_delete);
    return ts_node_child_count(ts_tree_root_node(tree.get()));
}

} // namespace maclint::bench
