//! Reads limits and blocks from their text.
#include "cli/config/shop_demands.hpp"

#include "analyzer/dialect/characters.hpp"
#include "rules/path.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace maclint::cli {
namespace {

using Place = DemandedBlock::Place;

struct LimitKey {
    std::string_view name;
    Bounds& (*bounds)(ShopLimits&);
    bool may_be_negative = false;
};
constexpr std::array<LimitKey, 7> limit_keys{{
    {"speed", [](ShopLimits& limits) -> Bounds& { return limits.speed; }},
    {"feed-per-minute", [](ShopLimits& limits) -> Bounds& { return limits.feed_per_minute; }},
    {"feed-per-revolution", [](ShopLimits& limits) -> Bounds& { return limits.feed_per_revolution; }},
    {"tool", [](ShopLimits& limits) -> Bounds& { return limits.tool; }},
    {"X", [](ShopLimits& limits) -> Bounds& { return limits.travel[0]; }, true},
    {"Y", [](ShopLimits& limits) -> Bounds& { return limits.travel[1]; }, true},
    {"Z", [](ShopLimits& limits) -> Bounds& { return limits.travel[2]; }, true},
}};

struct DemandKey {
    std::string_view name;
    Place place;
};
constexpr std::array<DemandKey, 3> demand_keys{
    {{"at-start", Place::start}, {"before-tool-change", Place::tool_change}, {"at-end", Place::end}}};

template<class Rows>
std::vector<std::string> names_of(const Rows& rows) {
    std::vector<std::string> names;
    for (const auto& row : rows) names.emplace_back(row.name);
    return names;
}

/// The words of "G91 G28 Z0" with and without blanks between them; nothing where the text holds anything
/// else.
std::optional<std::vector<DemandedBlock::Word>> words_in(std::string_view text) {
    std::vector<DemandedBlock::Word> words;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
        if (text.empty()) break;
        const char letter = to_capital(text.front());
        if (letter < 'A' || letter > 'Z' || letter == 'N' || letter == 'O') return std::nullopt;
        text.remove_prefix(1);
        const std::size_t digits = std::min(text.find_first_not_of("0123456789.-"), text.size());
        DemandedBlock::Word word{letter, std::nullopt};
        if (digits > 0) {
            double number = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + digits, number);
            if (error != std::errc() || end != text.data() + digits) return std::nullopt;
            word.number = number;
        } else if (letter == 'G' || letter == 'M') {
            return std::nullopt;
        }
        text.remove_prefix(digits);
        words.push_back(word);
    }
    return words.empty() ? std::nullopt : std::optional(std::move(words));
}

std::string words_of(const Bounds& bounds) {
    const bool has_least = !std::isinf(bounds.least);
    if (std::isinf(bounds.greatest)) return "from " + number_word(bounds.least);
    return (has_least ? number_word(bounds.least) + " to " : "up to ") + number_word(bounds.greatest);
}

} // namespace

std::vector<std::string> shop_limit_names() { return names_of(limit_keys); }
std::vector<std::string> demand_names() { return names_of(demand_keys); }

std::optional<WrongValue> read_shop_limit(const JsonMember& member, ShopLimits& limits) {
    const auto* const key = std::ranges::find(limit_keys, member.key, &LimitKey::name);
    Bounds bounds;
    const auto* both = std::get_if<JsonNode::Array>(&member.node.value);
    const auto* greatest = std::get_if<double>(&member.node.value);
    const bool are_numbers =
        both != nullptr && both->size() == 2 && std::ranges::all_of(*both, [](const JsonNode& node) {
            return std::holds_alternative<double>(node.value);
        });
    if (are_numbers)
        bounds = {std::get<double>(both->front().value), std::get<double>(both->back().value)};
    else if (greatest != nullptr)
        bounds.greatest = *greatest;
    else
        return WrongValue{member.node.span, "'" + member.key +
                                                "' must be the greatest number, or the least and the "
                                                "greatest, as [50, 8000]. Correct it"};
    const double least = std::min(are_numbers ? bounds.least : bounds.greatest, bounds.greatest);
    if (least < 0 && !key->may_be_negative)
        return WrongValue{member.node.span, "'" + member.key + "' is " + number_word(least) +
                                                ", and nothing is less than 0. Write how much is allowed"};
    if (bounds.least > bounds.greatest)
        return WrongValue{member.node.span, "the least number of '" + member.key +
                                                "' is above the greatest. Write the least first"};
    key->bounds(limits) = bounds;
    return std::nullopt;
}

std::optional<WrongValue> read_demand(const JsonMember& member, ShopDemands& demands) {
    const auto* const key = std::ranges::find(demand_keys, member.key, &DemandKey::name);
    const auto* blocks = std::get_if<JsonNode::Array>(&member.node.value);
    if (blocks == nullptr)
        return WrongValue{member.node.span,
                          "'" + member.key +
                              "' must be a list of blocks, as [\"M5\", \"G28 Z0\"]. Correct it"};
    for (const JsonNode& block : *blocks) {
        const auto* text = std::get_if<std::string>(&block.value);
        auto words = text == nullptr ? std::nullopt : words_in(*text);
        if (!words)
            return WrongValue{block.span, "an entry of '" + member.key +
                                              "' is no block of plain words, as \"G91 G28 Z0\". Correct it"};
        if (demands.blocks.size() == ShopDemands::most_blocks)
            return WrongValue{block.span, "a control may demand " + std::to_string(ShopDemands::most_blocks) +
                                              " blocks. Take some out"};
        demands.blocks.push_back({key->place, *text, *std::move(words)});
    }
    return std::nullopt;
}

std::vector<std::string> words_of(const ShopDemands& demands) {
    std::vector<std::string> words;
    ShopLimits limits = demands.limits;
    for (const LimitKey& key : limit_keys) {
        const Bounds& bounds = key.bounds(limits);
        if (!std::isinf(bounds.least) || !std::isinf(bounds.greatest))
            words.push_back(std::string(key.name) + " " + words_of(bounds));
    }
    for (const DemandKey& key : demand_keys)
        for (const DemandedBlock& block : demands.blocks)
            if (block.place == key.place) words.push_back(std::string(key.name) + " " + block.text);
    return words;
}

MachineFacts facts_of_example(std::string_view keys) {
    MachineFacts facts;
    if (keys.empty()) return facts;
    const auto parsed = parse_json("{" + std::string(keys) + "}");
    const auto* root = std::get_if<JsonNode>(&parsed);
    if (root == nullptr) throw std::logic_error("an example's configuration is no JSON");
    ShopDemands demands;
    std::optional<WrongValue> wrong;
    for (const JsonMember& member : std::get<JsonNode::Object>(root->value)) {
        if (member.key != "limits") {
            wrong = read_demand(member, demands);
        } else {
            for (const JsonMember& limit : std::get<JsonNode::Object>(member.node.value))
                if (!wrong) wrong = read_shop_limit(limit, demands.limits);
        }
        if (wrong) throw std::logic_error("an example's configuration: " + wrong->message);
    }
    facts.set_demands(std::move(demands));
    return facts;
}

} // namespace maclint::cli
