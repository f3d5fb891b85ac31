//! What the flow pairs is what folds.
#include "cli/lsp/features/folding.hpp"

#include "analyzer/flow/regions.hpp"
#include "analyzer/program/model.hpp"
#include "cli/lsp/features/read_document.hpp"

namespace maclint::cli::lsp {
namespace {

class Folds {
  public:
    explicit Folds(const LineTable& lines)
        : lines_(lines) {}

    void add(Span span) {
        const Offset last = span.empty() ? span.begin : span.end - 1;
        const std::size_t from = lines_.line_of(span.begin), to = lines_.line_of(last);
        if (to > from) list_.push_back({{"startLine", from}, {"endLine", to}});
    }
    [[nodiscard]] Json take() { return std::move(list_); }

  private:
    const LineTable& lines_;
    Json list_ = Json::array();
};

void add_sections(const Program& program, Folds& folds) {
    for (const Section& section : program.sections)
        if (!section.heading.empty() && section.items.count != 0)
            folds.add(join(section.heading, program.span_of(section.items.first + section.items.count - 1)));
}

void add_regions(const Program& program, Folds& folds) {
    for (const flow::Region& region : flow::pair_regions(program).all)
        if (region.close)
            folds.add(join(program.effects[region.open].span, program.effects[*region.close].span));
}

} // namespace

Json folding_ranges(Session& session, const Json& params) {
    const auto text = read_document(session, params);
    if (text == nullptr) return Json::array();
    Folds folds(text->lines);
    for (const Program& program : text->programs().programs) {
        folds.add(program.span);
        add_sections(program, folds);
        add_regions(program, folds);
    }
    return folds.take();
}

} // namespace maclint::cli::lsp
