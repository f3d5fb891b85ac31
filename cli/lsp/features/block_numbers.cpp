//! What `maclint renumber` knows of a file, asked at one place of it.
#include "cli/lsp/features/block_numbers.hpp"

#include "cli/lsp/features/read_document.hpp"
#include "cli/lsp/features/workspace_edit.hpp"
#include "cli/lsp/mentions/sightings.hpp"
#include "cli/renumber/connected_programs.hpp"
#include "cli/renumber/renumber.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

namespace maclint::cli::lsp {
namespace {

constexpr std::int64_t largest_number = 99'999'999; ///< that any of the controls takes

/// The block of a number that was pointed at.
struct Pointed {
    const NumberSpace* space;
    std::size_t block;
    Span digits; ///< under the cursor
};

/// The programs of other files that may name blocks of the text.
std::vector<std::shared_ptr<const ProgramFile>> connected(Session& session, const ReadText& text) {
    ProgramStore store(0);
    const Snapshot around = session.files.snapshot(session.documents.all(), Asked::documents);
    return connected_programs(around, text.programs(), store);
}

NumberSpaces safe_spaces(Session& session, const ReadText& text) {
    const auto others = connected(session, text);
    std::vector<const ProgramFile*> near;
    for (const auto& other : others) near.push_back(other.get());
    auto spaces = number_spaces(text.programs(), near);
    if (const auto* unsafe = std::get_if<UnsafeNumber>(&spaces))
        throw ResponseError{ErrorCode::request_failed, reason_of(*unsafe, text.source().path())};
    return std::get<NumberSpaces>(std::move(spaces));
}

/// Of the text alone, once: where a computed jump makes numbers unsafe, nothing is known of them.
std::shared_ptr<const NumberSpaces> spaces_of(const ReadText& text) {
    if (text.spaces == nullptr) {
        auto spaces = number_spaces(text.programs(), {});
        auto* known = std::get_if<NumberSpaces>(&spaces);
        text.spaces =
            std::make_shared<const NumberSpaces>(known == nullptr ? NumberSpaces() : std::move(*known));
    }
    return text.spaces;
}

std::optional<Pointed> pointed_at(const NumberSpaces& spaces, Offset at) {
    for (const NumberSpace& space : spaces) {
        for (std::size_t block = 0; block < space.blocks.size(); ++block)
            if (touches(space.blocks[block].digits, at))
                return Pointed{&space, block, space.blocks[block].digits};
        for (const BlockUse& use : space.uses)
            if (touches(use.written.digits, at)) return Pointed{&space, use.block, use.written.digits};
    }
    return std::nullopt;
}

/// A text, the numbers in it, and the block that is meant.
struct Asking {
    std::shared_ptr<const ReadText> text;
    std::shared_ptr<const NumberSpaces> spaces;
    std::optional<Pointed> pointed;

    [[nodiscard]] Span declared() const { return pointed->space->blocks[pointed->block].digits; }
    /// The digits of the words that name it.
    [[nodiscard]] std::vector<Span> uses() const {
        std::vector<Span> spans;
        for (const BlockUse& use : pointed->space->uses)
            if (use.block == pointed->block) spans.push_back(use.written.digits);
        return spans;
    }
};

Asking asked(Session& session, const Json& params) {
    Asking asking{read_document(session, params), {}, {}};
    if (asking.text == nullptr) return asking;
    asking.spaces = spaces_of(*asking.text);
    asking.pointed = pointed_at(*asking.spaces, asking.text->lines.offset(member(params, "position")));
    return asking;
}

/// "N50" and "50".
std::int64_t number_in(const std::string& name) {
    std::string_view digits = name;
    if (digits.starts_with('N') || digits.starts_with('n')) digits.remove_prefix(1);
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size() || number < 1 || number > largest_number)
        throw ResponseError{ErrorCode::invalid_params, "'" + name +
                                                           "' is no number of a block. Write one from 1 to " +
                                                           std::to_string(largest_number) + "."};
    return number;
}

Edit edit_of(const ReadText& text, Span digits, std::int64_t number) {
    return {text.programs().source, digits, std::to_string(number)};
}

} // namespace

Json block_definition(Session& session, const Json& params) {
    const Asking asking = asked(session, params);
    return asking.pointed ? location(*asking.text, asking.declared()) : Json(nullptr);
}

Json block_references(Session& session, const Json& params) {
    const Asking asking = asked(session, params);
    if (!asking.pointed) return nullptr;
    Json found = Json::array();
    if (is_true(params, {"context", "includeDeclaration"}))
        found.push_back(location(*asking.text, asking.declared()));
    for (const Span use : asking.uses()) found.push_back(location(*asking.text, use));
    return found;
}

Json block_highlight(Session& session, const Json& params) {
    const Asking asking = asked(session, params);
    if (!asking.pointed) return nullptr;
    Json found = Json::array();
    found.push_back({{"range", asking.text->lines.range(asking.declared())}});
    for (const Span use : asking.uses()) found.push_back({{"range", asking.text->lines.range(use)}});
    return found;
}

Json block_digits(Session& session, const Json& params) {
    const Asking asking = asked(session, params);
    return asking.pointed ? asking.text->lines.range(asking.pointed->digits) : Json(nullptr);
}

Json rename_block(Session& session, const Json& params) {
    const std::int64_t number = number_in(string_in(params, "newName"));
    Asking asking = asked(session, params);
    if (!asking.pointed)
        throw ResponseError{ErrorCode::request_failed, "There is no number of a block here."};
    asking.spaces = std::make_shared<const NumberSpaces>(safe_spaces(session, *asking.text));
    asking.pointed = pointed_at(*asking.spaces, asking.pointed->digits.begin);
    const auto has_number = [&](const WrittenNumber& written) { return written.number == number; };
    const NumberSpace& space = *asking.pointed->space;
    if (std::ranges::any_of(space.blocks, has_number))
        throw ResponseError{ErrorCode::request_failed,
                            "A block has the number " + std::to_string(number) + " already. Take another."};
    if (std::ranges::any_of(space.without_block, has_number))
        throw ResponseError{ErrorCode::request_failed,
                            "A word names the number " + std::to_string(number) +
                                ", which no block has: it would lead here. Take another."};
    std::vector<Edit> edits{edit_of(*asking.text, asking.declared(), number)};
    for (const Span use : asking.uses()) edits.push_back(edit_of(*asking.text, use, number));
    std::ranges::sort(edits, {}, [](const Edit& edit) { return edit.span.begin; });
    return workspace_edit(session, edits);
}

Json renumber(Session& session, const Json& arguments) {
    if (arguments.empty() || !arguments.front().is_string())
        throw ResponseError{ErrorCode::invalid_params, "'maclint.renumber' needs the URI of a program."};
    Numbering numbering;
    const auto take = [&](std::size_t place, std::int64_t& number) {
        if (arguments.size() <= place) return;
        if (!arguments[place].is_number_integer() || arguments[place] < 1 ||
            arguments[place] > largest_number)
            throw ResponseError{ErrorCode::invalid_params,
                                "'maclint.renumber' needs whole numbers from 1 on for "
                                "its start and its step."};
        number = arguments[place].get<std::int64_t>();
    };
    take(1, numbering.start);
    take(2, numbering.step);
    const Document& document = session.documents.at(arguments.front().get_ref<const std::string&>());
    const auto text = session.reader.read(document, session.client.encoding);
    if (text == nullptr)
        throw ResponseError{ErrorCode::request_failed,
                            "This is no program that maclint knows. It is left as it was."};
    const NumberSpaces spaces = safe_spaces(session, *text);
    auto edits = renumbering_of(text->programs().source, spaces, numbering);
    if (const auto* unsafe = std::get_if<UnsafeNumber>(&edits))
        throw ResponseError{ErrorCode::request_failed, reason_of(*unsafe, text->source().path())};
    return workspace_edit(session, std::get<std::vector<Edit>>(edits));
}

} // namespace maclint::cli::lsp
