//! Joins what is said of one line, and leaves the middle of a long path out.
#include "cli/report/rows.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace maclint::cli {
namespace {

/// Of a shortened path: where it begins and its last steps say most.
constexpr std::size_t most_before = 3;
constexpr std::size_t most_after = 2;

Row row_at(const Source& source, Span span, std::string remark) {
    return {&source, source.position(span.begin).line, span, std::move(remark), false};
}

bool on_one_line(const Row& a, const Row& b) { return a.source == b.source && a.line == b.line; }

void join(Row& row, const Row& next) {
    if (next.own) row.span = next.span;
    row.own = row.own || next.own;
    if (row.remark == next.remark || next.remark.empty()) return;
    row.remark += (row.remark.empty() ? "" : "; ") + next.remark;
}

void add(std::vector<Row>& rows, Row row) {
    if (!rows.empty() && on_one_line(rows.back(), row))
        join(rows.back(), row);
    else
        rows.push_back(std::move(row));
}

/// All rows; the path ends at the finding's own place.
std::vector<Row> all_rows_of(const Finding& finding, Remarks remarks) {
    std::vector<Row> rows;
    const auto row_of = [remarks](const RelatedLocation& related) {
        return row_at(*related.source, related.span, remark_of(related, remarks));
    };
    const auto end = finding.path.empty() ? finding.path.end() : std::prev(finding.path.end());
    for (auto step = finding.path.begin(); step != end; ++step) add(rows, row_of(*step));
    const bool told = end != finding.path.end() && end->span == finding.span;
    if (end != finding.path.end() && !told) add(rows, row_of(*end));
    Row own = row_at(*finding.source, finding.span, told ? remark_of(*end, remarks) : "");
    own.own = true;
    add(rows, std::move(own));
    for (const RelatedLocation& related : finding.related) add(rows, row_of(related));
    return rows;
}

/// Keeps the first row and the last ones before the finding's own, and the first ones after it.
void shorten(std::vector<Row>& rows) {
    const auto own = std::ranges::find(rows, true, &Row::own);
    const auto after = static_cast<std::size_t>(std::distance(own, rows.end())) - 1;
    if (after > most_after) rows.resize(rows.size() - (after - most_after));
    const auto before = static_cast<std::size_t>(std::ranges::find(rows, true, &Row::own) - rows.begin());
    if (before > most_before)
        rows.erase(rows.begin() + 1, rows.begin() + 1 + static_cast<std::ptrdiff_t>(before - most_before));
}

} // namespace

Rows rows_of(const Finding& finding, PathDetail detail, Remarks remarks) {
    Rows rows{all_rows_of(finding, remarks), 0};
    const std::size_t all = rows.rows.size();
    if (detail == PathDetail::shortened) shorten(rows.rows);
    if (detail == PathDetail::none) std::erase_if(rows.rows, [](const Row& row) { return !row.own; });
    rows.left_out = all - rows.rows.size();
    return rows;
}

} // namespace maclint::cli
