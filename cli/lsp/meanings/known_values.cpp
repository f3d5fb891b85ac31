//! The group of files is the engine's, so that what is shown is what findings rest on.
#include "cli/lsp/meanings/known_values.hpp"

#include "analyzer/dataflow/facts/computed_jump.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/bind.hpp"
#include "analyzer/workspace/groups.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "cli/engine/computed_calls.hpp"
#include "cli/engine/own_macros.hpp"
#include "cli/lsp/mentions/place.hpp"
#include "rules/path.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace maclint::cli::lsp {
namespace {

constexpr std::size_t most_bytes = std::size_t{256} << 10U; ///< of text: a tenth of a second
constexpr std::size_t most_files = 30;

std::string listed(std::span<const double> numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        text += (i == 0 ? "" : i + 1 == numbers.size() ? " or " : ", ") + number_word(numbers[i]);
    return text;
}

/// Empty where it may be anything.
std::string in_words(const dataflow::ValueTable& table, const dataflow::Value& value) {
    using dataflow::Vacancy;
    if (value.vacancy == Vacancy::vacant) return "vacant";
    std::string text;
    const auto choices = table.choices_of(value);
    if (!choices.empty())
        text = listed(choices);
    else if (value.low == value.high)
        text = number_word(value.low);
    else if (std::isfinite(value.low) && std::isfinite(value.high))
        text = "from " + number_word(value.low) + " to " + number_word(value.high);
    else if (std::isfinite(value.low))
        text = number_word(value.low) + " or more";
    else if (std::isfinite(value.high))
        text = number_word(value.high) + " or less";
    if (value.vacancy == Vacancy::maybe && !text.empty()) text += ", or vacant";
    return text;
}

/// What all facts that are meant say; empty where one knows nothing, or they are many.
template<class Fact, class IsMeant>
std::string said_by(const ProgramAnalysis& analysis, const IsMeant& is_meant) {
    constexpr std::size_t most = 4;
    std::vector<std::string> said;
    for (const Fact& fact : analysis.facts().all<Fact>()) {
        if (!is_meant(fact)) continue;
        std::string text = in_words(analysis.data().table(), fact.value);
        if (text.empty()) return {};
        if (std::ranges::find(said, text) == said.end()) said.push_back(std::move(text));
    }
    if (said.size() > most) return {};
    std::string all;
    for (const std::string& text : said) all += (all.empty() ? "" : "; ") + text;
    return all;
}

/// The places in the map of the files that the text's programs are analysed with.
std::vector<std::size_t> group_of(const ProgramMap& map, std::size_t file) {
    for (auto& group : groups_of(map.outlines()))
        if (std::ranges::find(group, file) != group.end()) return std::move(group);
    return {};
}

} // namespace

std::unique_ptr<const KnownValues> KnownValues::of(Session& session,
                                                   const std::shared_ptr<const ReadText>& text) {
    if (text->source().size() > most_bytes) return nullptr;
    const auto map = session.programs.map(session.documents.all());
    const auto here = map->file_at(text->source().path());
    const auto group = here ? group_of(*map, *here) : std::vector<std::size_t>();
    if (group.empty() || group.size() > most_files) return nullptr;
    const ComputedCalls computed(map->snapshot(), map->outlines());
    const OwnMacros macros(map->snapshot(), map->outlines());
    std::vector<WorkspaceFile> members;
    std::size_t bytes = 0;
    for (const std::size_t place : group) {
        const SnapshotFile& file = map->snapshot().files[place];
        const Document* document = session.documents.find_path(file.input.path);
        auto read = place == *here ? text
                    : document != nullptr
                        ? session.reader.read(*document, session.client.encoding)
                        : session.reader.read_file(file.input.path, session.client.encoding, Extent::whole);
        if (read == nullptr) continue;
        bytes += read->source().size();
        if (bytes > most_bytes) return nullptr;
        const std::string_view language = read->read.control->language;
        members.push_back({read->read.file, place == *here, file.settings.complete,
                           computed.may_mean(file, language), macros.lie_by(file, language)});
    }
    auto workspace = Workspace::analyse(
        std::move(members),
        {.jobs = 1, .facts = dataflow::facts<dataflow::Read, dataflow::Store, dataflow::ComputedJump>()});
    return std::unique_ptr<const KnownValues>(new KnownValues(std::move(workspace), text->programs()));
}

const ProgramAnalysis* KnownValues::analysis_of(std::size_t program) const {
    for (const ProgramAnalysis& analysis : workspace_->programs())
        if (&analysis.program() == &file_.programs[program]) return &analysis;
    return nullptr;
}

std::string KnownValues::value_at(std::size_t program, const Mention& mention) const {
    const ProgramAnalysis* analysis = analysis_of(program);
    const auto* variable = std::get_if<Variable>(&mention.named);
    if (analysis == nullptr || variable == nullptr) return {};
    const Program& of = analysis->program();
    if (mention.role == Mention::Role::reads)
        return said_by<dataflow::Read>(*analysis, [&](const dataflow::Read& read) {
            const Span span = of.expressions[read.expression].span;
            return read.variable == *variable && span.begin <= mention.span.begin &&
                   mention.span.end <= span.end;
        });
    return said_by<dataflow::Store>(*analysis, [&](const dataflow::Store& store) {
        return store.variable == *variable && touches(of.effects[store.effect].span, mention.span.begin);
    });
}

std::vector<std::string> KnownValues::passed_for(std::size_t program, const Variable& variable) const {
    std::vector<std::string> passed;
    const ProgramAnalysis* analysis = analysis_of(program);
    if (analysis == nullptr) return passed;
    for (const Caller& caller : analysis->callers()) {
        const Program& calling = workspace_->programs()[caller.program].program();
        const auto& call = std::get<Call>(calling.effects[caller.effect].what);
        for (const Argument& argument : calling.arguments_of(call)) {
            const auto formal = bound_to(argument, &analysis->program());
            if (!formal || *formal != variable) continue;
            std::string text = quoted(calling, calling.expressions[argument.value].span);
            if (std::ranges::find(passed, text) == passed.end()) passed.push_back(std::move(text));
        }
    }
    return passed;
}

std::vector<std::int64_t> KnownValues::targets_of(std::size_t program, EffectId jump) const {
    std::vector<std::int64_t> numbers;
    const ProgramAnalysis* analysis = analysis_of(program);
    if (analysis == nullptr) return numbers;
    for (const dataflow::ComputedJump& computed : analysis->facts().all<dataflow::ComputedJump>()) {
        if (computed.effect != jump) continue;
        const auto choices = analysis->data().table().choices_of(computed.target);
        const auto one = computed.target.constant();
        if (choices.empty() && !one) return {};
        for (const double number : choices) numbers.push_back(std::llround(number));
        if (choices.empty()) numbers.push_back(std::llround(*one));
    }
    std::ranges::sort(numbers);
    const auto again = std::ranges::unique(numbers);
    numbers.erase(again.begin(), again.end());
    return numbers;
}

} // namespace maclint::cli::lsp
