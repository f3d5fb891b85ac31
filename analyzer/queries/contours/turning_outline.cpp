//! Walks from point to point.
#include "analyzer/queries/contours/turning_outline.hpp"

#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/program/word_lookup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

namespace maclint::queries {
namespace {

/// X counts as a diameter, I and K from the start of the arc, of G12 and G13 from the zero point [SEED-003:
/// 10662-10665, 10718, 12381-12386, 12436]; both of them are radii.
/// A thread with its undercut is a line along Z of its own [SEED-003:10876-10900].
constexpr std::array straight = {0.0, 1.0}, thread_line = {24.0, 24.0};
constexpr std::array by_way = {2.0, 3.0}, by_place = {12.0, 13.0};
constexpr std::string_view x_word = "X", z_word = "Z", centre_x = "I", centre_z = "K", radius_word = "R",
                           corner_word = "BR";
/// Words after which the end of an element follows from others, or which leave the plane.
constexpr std::array<std::string_view, 10> others = {"A", "AN", "PZ", "W", "AR", "FI", "C", "Y", "Q", "PX"};

/// A section with more moves comes from a CAM system, which calculates its arcs.
constexpr std::uint32_t most_blocks = 5000;

bool is_one_of(double code, const std::array<double, 2>& codes) {
    return std::ranges::find(codes, code) != codes.end();
}

class Walker {
  public:
    explicit Walker(Outline& outline)
        : outline_(outline) {}

    /// Blocks that do something else end what is known.
    void forget(const BlockView& block) {
        x_ = z_ = std::nullopt;
        motion_.reset();
        if (outline_.describes) outline_.gaps.push_back(block.span.begin);
    }

    void look_at(const BlockView& block, std::span<const Word> words) {
        Span code{};
        for (const Word& word : words) {
            if (word.address != "G") continue;
            const auto number = number_of(&word);
            if (!number) return forget(block);
            if (is_motion(*number)) {
                motion_ = number;
                code = word.span;
            } else if (!sets_attribute(*number)) {
                return; // a recess, a thread: it lies on an element, which ends where it did
            }
        }
        const bool moves = find_word(words, x_word) != nullptr || find_word(words, z_word) != nullptr;
        if (!code.empty() || moves) move(block, words, code);
    }

  private:
    [[nodiscard]] static bool is_motion(double code) {
        return is_one_of(code, straight) || is_one_of(code, thread_line) || is_one_of(code, by_way) ||
               is_one_of(code, by_place);
    }

    /// Codes that stand beside an element, or alone [SEED-003:11231].
    [[nodiscard]] static bool sets_attribute(double code) {
        constexpr std::array attributes = {10.0, 38.0, 39.0, 52.0, 95.0, 149.0};
        return std::ranges::find(attributes, code) != attributes.end();
    }

    void move(const BlockView& block, std::span<const Word> words, Span code) {
        OutlineElement element;
        element.block = block.span;
        element.code = code;
        element.from = here();
        const bool is_plain = std::ranges::none_of(
            others, [&](std::string_view other) { return find_word(words, other) != nullptr; });
        if (is_plain && motion_) {
            go(x_, find_word(words, x_word), true);
            go(z_, find_word(words, z_word), false);
            if (is_one_of(*motion_, by_way) || is_one_of(*motion_, by_place)) read_arc(words, element);
        } else {
            x_ = z_ = std::nullopt;
        }
        element.to = here();
        const Word* corner = find_word(words, corner_word);
        element.corner = number_of(corner);
        if (corner != nullptr) element.corner_span = corner->span;
        if (outline_.describes || element.is_arc) outline_.elements.push_back(element);
    }

    /// An incremental word of a diameter is left alone: no manual says whether it is one.
    static void go(std::optional<double>& axis, const Word* word, bool is_diameter) {
        if (word == nullptr) return;
        const auto to = number_of(word);
        if (!to || (word->incremental && (is_diameter || !axis)))
            axis.reset();
        else if (word->incremental)
            *axis += *to;
        else
            axis = is_diameter ? *to / 2 : *to;
    }

    void read_arc(std::span<const Word> words, OutlineElement& element) const {
        element.is_arc = true;
        const Word* radius = find_word(words, radius_word);
        const Word *i = find_word(words, centre_x), *k = find_word(words, centre_z);
        element.radius = number_of(radius);
        if (radius != nullptr || i == nullptr || k == nullptr || !element.from) return;
        const auto x = number_of(i), z = number_of(k);
        if (!x || !z || i->incremental || k->incremental) return;
        if (is_one_of(*motion_, by_way))
            element.centre = OutlinePoint{element.from->x + *x, element.from->z + *z};
        else
            element.centre = OutlinePoint{*x, *z};
    }

    [[nodiscard]] std::optional<OutlinePoint> here() const {
        if (!x_ || !z_) return std::nullopt;
        return OutlinePoint{*x_, *z_};
    }

    Outline& outline_;
    std::optional<double> motion_, x_, z_;
};

/// Whether the control only moves and sets codes in the block.
bool only_moves(const Program& program, const BlockView& block) {
    return block.skip_levels == 0 &&
           std::ranges::all_of(program.effects_in(block.effects), [](const Effect& effect) {
               return std::holds_alternative<SetModal>(effect.what) ||
                      std::holds_alternative<EvaluateWords>(effect.what) ||
                      std::holds_alternative<Motion>(effect.what);
           });
}

/// Whether a block of the tool's moves holds another code than one that moves or sets the feed.
bool has_other_code(const Program& program, std::span<const Word> words) {
    return std::ranges::any_of(words, [&](const Word& word) {
        const auto code = number_of(&word);
        if (word.address == "T") return true;
        if (word.address != "G") return false;
        const auto group = code ? program.control->group_of('G', *code) : std::nullopt;
        if (!group) return true;
        const ModalRole role = program.control->groups[*group].role;
        return role != ModalRole::motion && role != ModalRole::feed_mode && role != ModalRole::speed_mode;
    });
}

std::vector<Outline> outlines_of(const Program& program, bool with_moves) {
    std::vector<Outline> outlines;
    if (program.control->machine != Machine::lathe || !program.control->has(Capability::sections)) return {};
    for (const Section& section : program.sections) {
        const SectionKind* kind = kind_of(*program.control, section);
        const bool describes = kind != nullptr && kind->role == SectionKind::Role::contour;
        const bool moves = with_moves && section.executed == Section::Executed::when_reached &&
                           plain_blocks(program, section) <= most_blocks;
        if (!describes && !moves) continue;
        Outline& outline = outlines.emplace_back();
        outline.section = &section;
        outline.describes = describes;
        Walker walker(outline);
        for_each_block_of(program, section, [&](const BlockView& block, std::span<const Word> words) {
            if (!only_moves(program, block) || (!describes && has_other_code(program, words)))
                walker.forget(block);
            else
                walker.look_at(block, words);
        });
    }
    return outlines;
}

} // namespace

bool Outline::has_gap(Offset begin, Offset end) const {
    const auto gap = std::ranges::lower_bound(gaps, begin);
    return gap != gaps.end() && *gap < end;
}

const OutlineElement* Outline::before(Offset block) const {
    const auto begins = [](const OutlineElement& element) { return element.block.begin; };
    const auto behind = std::ranges::upper_bound(elements, block, {}, begins);
    if (behind == elements.begin() || has_gap(std::prev(behind)->block.begin, block)) return nullptr;
    return &*std::prev(behind);
}

const OutlineElement* Outline::behind(Offset block) const {
    const auto begins = [](const OutlineElement& element) { return element.block.begin; };
    const auto behind = std::ranges::upper_bound(elements, block, {}, begins);
    if (behind == elements.end() || has_gap(block, behind->block.begin)) return nullptr;
    return &*behind;
}

double distance(const OutlinePoint& a, const OutlinePoint& b) { return std::hypot(a.x - b.x, a.z - b.z); }

std::optional<Bar> bar_of(const Program& program, const Section& section) {
    constexpr double bar = 20; // [SEED-003:10502-10513]
    std::optional<Bar> found;
    std::size_t blocks = 0;
    for_each_block_of(program, section, [&](const BlockView&, std::span<const Word> words) {
        ++blocks;
        const auto x = number_of(words, x_word), z = number_of(words, z_word), k = number_of(words, centre_z);
        if (number_of(words, "G") == bar && x && z)
            found = Bar{*x, k.value_or(0) - *z, k.value_or(0), number_of(words, centre_x).value_or(0)};
    });
    return blocks == 1 ? found : std::nullopt;
}

std::vector<Outline> turning_contours(const Program& program) { return outlines_of(program, false); }

std::vector<Outline> turning_contours_and_moves(const Program& program) { return outlines_of(program, true); }

} // namespace maclint::queries
