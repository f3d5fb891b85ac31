//! What stands in front of the cursor in its line decides what may follow.
#include "cli/lsp/features/completion.hpp"

#include "analyzer/program/language_words.hpp"
#include "analyzer/program/tables.hpp"
#include "cli/lsp/features/read_document.hpp"
#include "cli/lsp/meanings/meaning.hpp"
#include "cli/lsp/mentions/name_letters.hpp"
#include "cli/lsp/mentions/sightings.hpp"
#include "cli/text/letters.hpp"
#include "rules/words/code_pages.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace maclint::cli::lsp {
namespace {

/// CompletionItemKind of LSP.
enum class ItemKind : std::uint8_t {
    function = 3,
    field = 5,
    variable = 6,
    program = 9,
    value = 12,
    keyword = 14,
    label = 18
};

constexpr std::size_t most_items = 500;

bool is_figure(char c) { return c >= '0' && c <= '9'; }

/// The line up to the cursor, and the part of it that is being typed.
struct Typed {
    std::string before; ///< capitals, without the part
    std::string part;   ///< capitals: "G8", "#1", "WHI"
    Span span;          ///< of the part
};

Typed typed_at(const ReadText& text, Offset at) {
    const Span line = text.lines.line(text.lines.line_of(at));
    const std::string_view whole =
        text.source().bytes({line.begin, std::max(line.begin, std::min(at, line.end))});
    std::size_t begin = whole.size();
    while (begin > 0 && (is_figure(whole[begin - 1]) || whole[begin - 1] == '.')) --begin;
    while (begin > 0 && is_letter_of_name(whole[begin - 1])) --begin;
    if (begin > 0 && whole[begin - 1] == '#') --begin;
    const Span span{line.begin + static_cast<Offset>(begin), line.begin + static_cast<Offset>(whole.size())};
    return {in_upper_case(whole.substr(0, begin)), in_upper_case(whole.substr(begin)), span};
}

/// The place of a name that the cursor is at; the part of the name is then cut down to what stands behind.
const NamePlace* name_place(const Dialect& dialect, Typed& typed) {
    const std::string line = typed.before + typed.part;
    const NamePlace* best = nullptr;
    std::size_t from = 0;
    for (const NamePlace& place : dialect.words().name_places) {
        const std::size_t found = line.rfind(place.before);
        if (found == std::string::npos || line.find(place.word) > found) continue;
        std::size_t begin = found + place.before.size();
        while (begin < line.size() && line[begin] == ' ') ++begin;
        const std::string_view name = std::string_view(line).substr(begin);
        const bool is_name = std::ranges::all_of(name, is_of_name);
        if (!is_name || begin < from || (best != nullptr && place.before.size() < best->before.size()))
            continue;
        best = &place;
        from = begin;
    }
    if (best == nullptr) return nullptr;
    const std::size_t length = line.size() - from;
    typed.span.begin = typed.span.end - static_cast<Offset>(length);
    typed.part = line.substr(from);
    return best;
}

class Items {
  public:
    Items(const ReadText& text, Typed typed)
        : text_(text)
        , typed_(std::move(typed)) {}

    /// One that begins with what is typed, each once; `detail` is shown beside it.
    void add(std::string_view label, ItemKind kind, std::string_view detail) {
        if (in_upper_case(label.substr(0, typed_.part.size())) != typed_.part) return;
        if (items_.size() >= most_items || !seen_.emplace(label).second) {
            is_whole_ = is_whole_ && items_.size() < most_items;
            return;
        }
        Json item = {{"label", label},
                     {"kind", static_cast<int>(kind)},
                     {"data", {{"uri", text_.uri}, {"word", label}}},
                     {"textEdit", {{"range", text_.lines.range(typed_.span)}, {"newText", label}}}};
        if (const std::string* meaning = shop_meaning(text_, label))
            item["detail"] = *meaning;
        else if (!detail.empty())
            item["detail"] = detail;
        items_.push_back(std::move(item));
    }

    [[nodiscard]] const Typed& typed() const { return typed_; }
    [[nodiscard]] Json take() { return {{"isIncomplete", !is_whole_}, {"items", std::move(items_)}}; }

  private:
    const ReadText& text_;
    Typed typed_;
    std::set<std::string, std::less<>> seen_;
    Json items_ = Json::array();
    bool is_whole_ = true;
};

void add_programs(Session& session, const ReadText& text, Items& items) {
    const auto map = session.programs.map(session.documents.all());
    const std::string_view language = text.read.control->language;
    for (const FileOutline& file : map->outlines()) {
        const std::string name = file.path.substr(file.path.rfind('/') + 1);
        for (const ProgramOutline& program : file.programs) {
            if (program.language != language) continue;
            if (program.number)
                items.add(std::to_string(*program.number), ItemKind::program, name);
            else
                for (const std::string& called : program.names) items.add(called, ItemKind::program, name);
        }
    }
}

void add_blocks(const ReadText& text, const Program& program, Items& items) {
    for_each_block(program, [&](const BlockView& block) {
        if (block.name) items.add(program.spell(Label(*block.name)), ItemKind::label, "");
        if (block.number) {
            const std::string line =
                text.source().to_utf8(program.slice(block.span).substr(0, std::size_t{60}));
            items.add(std::to_string(*block.number), ItemKind::label, line);
        }
    });
}

void add_variables(const ReadText& text, const Program& program, Items& items) {
    for (const auto& [variable, declared] : program.declarations)
        items.add(program.spell(variable), ItemKind::variable, declared.type_name);
    for_each_mention(program, [&](const Mention& mention) {
        if (const auto* variable = std::get_if<Variable>(&mention.named))
            items.add(program.spell(*variable), ItemKind::variable,
                      program.control->spaces[variable->space].name);
    });
    if (text.file.settings.configuration != nullptr)
        for (const auto& [word, meaning] : text.file.settings.configuration->words)
            items.add(word, ItemKind::variable, meaning);
    for (const VariableFamily& family : program.control->families)
        for (const VariableRange& range : family.ranges)
            if (range.meaning == Meaning::machine || range.meaning == Meaning::modal)
                items.add(std::string(family.name) + std::to_string(range.first), ItemKind::variable,
                          range.what);
}

void add_codes(const ControlModel& control, Items& items) {
    for (const CodePage& page : all_code_pages())
        if (page.is_of(control))
            for (const std::string_view code : words_of(page.head->row.code))
                items.add(code, ItemKind::function, page.head->row.means.view());
    for (std::size_t i = 0; i < control.groups.size(); ++i)
        for (const ModalMember& member : control.groups[i].members)
            items.add(control.spell(static_cast<GroupId>(i), member.number), ItemKind::function,
                      control.groups[i].name);
}

/// The words that the block's codes take.
void add_words_of_block(const ControlModel& control, const std::vector<Word>& block, Items& items) {
    for (const Word& word : block) {
        const auto* code = std::get_if<Literal>(&word.value);
        if (code == nullptr || (word.address != "G" && word.address != "M")) continue;
        for (const CodePage& page : all_code_pages()) {
            if (!page.is_of(control) || page.head->row.code.view().front() != word.address.front()) continue;
            const auto codes = words_of(page.head->row.code);
            if (std::ranges::none_of(
                    codes, [&](std::string_view one) { return code_number_of(one) == code->value; }))
                continue;
            for (const BookLine& line : page.lines)
                if (line.kind == BookLine::Kind::word && is_of(line, control))
                    for (const std::string_view address : words_of(line.row.words))
                        items.add(address, ItemKind::field, line.row.means.view());
        }
    }
}

void add_language(const Dialect& dialect, Items& items) {
    for (const LanguageWord& word : dialect.words().words)
        items.add(word.word, word.use == WordUse::function ? ItemKind::function : ItemKind::keyword,
                  word.what.empty() ? name_of(word.use) : word.what);
}

} // namespace

Json completion(Session& session, const Json& params) {
    const auto text = read_document(session, params);
    if (text == nullptr) return Json::array();
    const Offset at = text->lines.offset(member(params, "position"));
    const auto place = program_at(text->programs(), at);
    if (!place || is_in_comment(*text, at)) return Json::array();
    const Program& program = text->programs().programs[*place];
    Typed typed = typed_at(*text, at);
    const NamePlace* name = name_place(text->dialect(), typed);
    Items items(*text, std::move(typed));
    if (name != nullptr && name->names == NamePlace::Names::program)
        add_programs(session, *text, items);
    else if (name != nullptr)
        add_blocks(*text, program, items);
    else {
        add_words_of_block(*program.control, words_at(program, text->lines, at), items);
        add_variables(*text, program, items);
        if (!items.typed().part.starts_with('#')) {
            add_codes(*program.control, items);
            add_language(text->dialect(), items);
        }
    }
    return items.take();
}

Json resolve_completion(Session& session, const Json& item) {
    const Json& data = member(item, "data");
    const Document* document = session.documents.find(string_in(data, "uri"));
    const std::string& word = string_in(data, "word");
    const auto text = document == nullptr ? nullptr : session.reader.read(*document, session.client.encoding);
    if (text == nullptr) return item;
    std::string meaning = meaning_of_name(text->dialect(), word);
    if (meaning.empty()) meaning = meaning_of_code(*text->read.control, word);
    if (const std::string* own = shop_meaning(*text, word))
        meaning = *own + (meaning.empty() ? "" : "\n\n" + meaning);
    Json resolved = item;
    if (!meaning.empty()) resolved["documentation"] = {{"kind", "markdown"}, {"value", meaning}};
    return resolved;
}

} // namespace maclint::cli::lsp
