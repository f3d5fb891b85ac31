//! Walks along lines and arcs that begin with G100, G110, G170 or G180.
#include "analyzer/queries/contours/surface_contours.hpp"

#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/queries/contours/contour_names.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <variant>

namespace maclint::queries {
namespace {

/// A surface: its start point, behind which the line and the two arcs have the next numbers; its axes, and
/// the centre of arcs, an absolute point [SEED-003:11606-11692, 11952-12028, 22441-22518, 22810-22888]. Where
/// the centre is an angle of the lateral surface as a length, it is left alone.
struct Surface {
    double start;
    std::string_view first, second, centre_first, centre_second;
};
constexpr std::array<Surface, 4> surfaces = {{
    {100, "XK", "YK", "I", "J"},
    {110, "Z", "CY", "", ""},
    {170, "X", "Y", "I", "J"},
    {180, "Y", "Z", "J", "K"},
}};
constexpr double level = 308;

/// Words beside which an end point follows from others.
constexpr std::array<std::string_view, 9> others = {"C", "AN", "AR", "PZ", "W", "XM", "CM", "PM", "WM"};

class SurfaceWalker {
  public:
    SurfaceWalker(const Program& program, const Section& section, std::vector<SurfaceContour>& contours)
        : program_(program)
        , section_(section)
        , contours_(contours) {}

    void look_at(const BlockView& block, std::span<const Word> words) {
        const Word* code = find_word(words, "G");
        const auto number = number_of(code);
        const Surface* surface = number ? surface_of(*number) : nullptr;
        if (surface == nullptr) {
            on_ = nullptr;
            name_ = {};
            if (number == level)
                if (const Word* name = find_word(words, "ID")) name_ = text_of(program_, *name).value_or("");
            return;
        }
        if (*number == surface->start) return begin(*surface, block, words);
        if (surface != on_) return;
        contours_.back().is_whole &= block.skip_levels == 0;
        if (block.number) contours_.back().numbers.push_back(*block.number);
        OutlineElement element;
        element.block = block.span;
        element.code = code->span;
        element.from = here();
        go(words);
        element.to = here();
        if (*number > surface->start + 1) read_arc(words, element);
        const Word* corner = find_word(words, "BR");
        element.corner = number_of(corner);
        if (corner != nullptr) element.corner_span = corner->span;
        contours_.back().elements.push_back(element);
    }

    /// A block that does something else: nobody can say how the contour goes on.
    void forget() {
        if (on_ != nullptr) contours_.back().is_whole = false;
        on_ = nullptr;
    }

  private:
    static const Surface* surface_of(double code) {
        const auto found = std::ranges::find_if(
            surfaces, [&](const Surface& row) { return code >= row.start && code <= row.start + 3; });
        return found == surfaces.end() ? nullptr : &*found;
    }

    void begin(const Surface& surface, const BlockView& block, std::span<const Word> words) {
        on_ = &surface;
        first_ = second_ = std::nullopt;
        go(words);
        SurfaceContour& contour = contours_.emplace_back();
        contour.section = &section_;
        contour.name = name_;
        contour.start = here();
        contour.is_whole = block.skip_levels == 0;
        if (block.number) contour.numbers.push_back(*block.number);
    }

    void go(std::span<const Word> words) {
        const bool is_polar = surface_has_polar_x() && find_word(words, "X") != nullptr;
        if (is_polar || std::ranges::any_of(others, [&](std::string_view word) {
                return find_word(words, word) != nullptr;
            })) {
            first_ = second_ = std::nullopt;
            return;
        }
        const Word *first = find_word(words, on_->first), *second = find_word(words, on_->second);
        // Which of two crossings is meant, or where a line of that length ends, is not calculated here.
        if (first == nullptr && second == nullptr) first_ = second_ = std::nullopt;
        go(first_, first);
        go(second_, second);
    }

    static void go(std::optional<double>& axis, const Word* word) {
        if (word == nullptr) return;
        const auto to = number_of(word);
        if (!to || (word->incremental && !axis))
            axis.reset();
        else
            axis = word->incremental ? *axis + *to : *to;
    }

    [[nodiscard]] bool surface_has_polar_x() const { return on_->first == "XK"; }

    void read_arc(std::span<const Word> words, OutlineElement& element) const {
        element.is_arc = true;
        const Word* radius = find_word(words, "R");
        element.radius = number_of(radius);
        const Word *first = find_word(words, on_->centre_first),
                   *second = find_word(words, on_->centre_second);
        if (radius != nullptr || first == nullptr || second == nullptr) return;
        const auto a = number_of(first), b = number_of(second);
        if (a && b && !first->incremental && !second->incremental) element.centre = OutlinePoint{*a, *b};
    }

    [[nodiscard]] std::optional<OutlinePoint> here() const {
        if (!first_ || !second_) return std::nullopt;
        return OutlinePoint{*first_, *second_};
    }

    const Program& program_;
    const Section& section_;
    std::vector<SurfaceContour>& contours_;
    const Surface* on_ = nullptr; ///< of the contour that goes on
    std::string_view name_;
    std::optional<double> first_, second_;
};

bool may_describe(const Program& program, const BlockView& block) {
    return std::ranges::none_of(program.effects_in(block.effects), [](const Effect& effect) {
        return std::holds_alternative<Call>(effect.what) ||
               std::holds_alternative<UnreadableBlock>(effect.what) ||
               std::holds_alternative<RegionMark>(effect.what);
    });
}

} // namespace

std::vector<SurfaceContour> surface_contours(const Program& program) {
    std::vector<SurfaceContour> contours;
    if (!program.control->has(Capability::sections)) return contours;
    for (const Section& section : program.sections) {
        const SectionKind* kind = kind_of(*program.control, section);
        if (kind == nullptr || kind->role != SectionKind::Role::contour) continue;
        const std::size_t first = contours.size();
        SurfaceWalker walker(program, section, contours);
        for_each_block_of(program, section, [&](const BlockView& block, std::span<const Word> words) {
            if (may_describe(program, block))
                walker.look_at(block, words);
            else
                walker.forget();
        });
        bool is_whole = true; // what nobody can read has no words
        for_each_block_with_effects(program, section.items, [&](const BlockView& block) {
            is_whole &= may_describe(program, block);
        });
        for (std::size_t i = first; i < contours.size(); ++i) contours[i].is_whole &= is_whole;
    }
    return contours;
}

} // namespace maclint::queries
