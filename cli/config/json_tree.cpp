//! nlohmann's SAX parser fed through an iterator that counts: after a token it stands after the token's end.
#include "cli/config/json_tree.hpp"

#include "cli/config/json_mistakes.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <unordered_set>

#include <nlohmann/json.hpp>

namespace maclint::cli {
namespace {

/// Deeper nesting than any configuration has is refused, so that the tree can be walked by recursion.
constexpr std::size_t deepest = 64;

class CountingIterator {
  public:
    // NOLINTBEGIN(readability-identifier-naming): the standard library asks for these names
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;
    // NOLINTEND(readability-identifier-naming)

    CountingIterator(const char* at, Offset& count)
        : at_(at)
        , count_(&count) {}
    reference operator*() const { return *at_; }
    CountingIterator& operator++() {
        ++at_;
        ++*count_;
        return *this;
    }
    CountingIterator operator++(int) {
        auto before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const CountingIterator& a, const CountingIterator& b) { return a.at_ == b.at_; }

  private:
    const char* at_;
    Offset* count_;
};

/// Builds the tree from the parser's calls, whose names and signatures nlohmann's SAX interface sets.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
  public:
    TreeBuilder(std::string_view text, const Offset& count)
        : text_(text)
        , count_(count) {}

    bool null() override { return add(nullptr, end_span()); }
    bool boolean(bool value) override { return add(value, end_span()); }
    bool number_integer(std::int64_t value) override {
        return add(static_cast<double>(value), number_span());
    }
    bool number_unsigned(std::uint64_t value) override {
        return add(static_cast<double>(value), number_span());
    }
    bool number_float(double value, const std::string& /*text*/) override {
        return add(value, number_span());
    }
    bool string(std::string& value) override { return add(std::move(value), string_span()); }
    bool binary(nlohmann::json::binary_t& /*value*/) override { return false; }
    bool start_object(std::size_t /*size*/) override { return open(JsonNode::Object{}); }
    bool start_array(std::size_t /*size*/) override { return open(JsonNode::Array{}); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(std::string& key) override {
        auto& members = std::get<JsonNode::Object>(open_.back().node.value);
        if (has_key(members, key))
            return fail(string_span().begin, "the key '" + key + "' stands here a second time");
        members.push_back({key, string_span(), {nullptr, {}}});
        return true;
    }

    bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                     const nlohmann::json::exception& error) override {
        error_ = mistake_at(text_, count_ > 0 ? count_ - 1 : 0, error.what());
        return false;
    }

    [[nodiscard]] std::variant<JsonNode, JsonError> take() {
        if (error_) return *std::move(error_);
        if (!root_) return JsonError{0, "this is no JSON: it is empty", "Write { } into it"};
        return *std::move(root_);
    }

  private:
    bool fail(Offset at, std::string message) {
        error_ = JsonError{at, std::move(message)};
        return false;
    }

    /// A container whose bracket has not been closed yet.
    struct Open {
        JsonNode node;
        std::unordered_set<std::string> keys; ///< of an object that has many
    };

    /// Few keys are compared one by one: that takes less time than to keep them.
    bool has_key(const JsonNode::Object& members, const std::string& key) {
        constexpr std::size_t few = 16;
        if (members.size() < few) return std::ranges::find(members, key, &JsonMember::key) != members.end();
        auto& keys = open_.back().keys;
        if (keys.empty())
            for (const JsonMember& member : members) keys.insert(member.key);
        return !keys.insert(key).second;
    }

    [[nodiscard]] Span end_span() const { return {count_ > 0 ? count_ - 1 : 0, count_}; }

    /// The parser has looked at the character behind a number, if there is one.
    [[nodiscard]] Span number_span() const {
        const auto is_part = [this](Offset at) {
            constexpr std::string_view parts = "0123456789+-.eE";
            return parts.find(text_[at]) != std::string_view::npos;
        };
        Offset end = count_;
        if (end > 0 && !is_part(end - 1)) --end;
        Offset begin = end;
        while (begin > 0 && is_part(begin - 1)) --begin;
        return {begin, end};
    }

    /// Back to the quote that opens: the one with an even number of backslashes before it.
    [[nodiscard]] Span string_span() const {
        Offset begin = count_ > 0 ? count_ - 1 : 0;
        const auto is_escaped = [this](Offset at) {
            Offset slashes = 0;
            while (slashes < at && text_[at - 1 - slashes] == '\\') ++slashes;
            return slashes % 2 == 1;
        };
        do {
            if (begin == 0) break;
            --begin;
        } while (text_[begin] != '"' || is_escaped(begin));
        return {begin, count_};
    }

    template<class Value>
    bool add(Value value, Span span) {
        return place(JsonNode{std::move(value), span});
    }

    bool place(JsonNode node) {
        if (open_.empty()) {
            root_ = std::move(node);
        } else if (auto* members = std::get_if<JsonNode::Object>(&open_.back().node.value)) {
            members->back().node = std::move(node);
        } else {
            std::get<JsonNode::Array>(open_.back().node.value).push_back(std::move(node));
        }
        return true;
    }

    template<class Container>
    bool open(Container container) {
        if (open_.size() == deepest) return fail(count_ - 1, "brackets are nested too deep here");
        open_.push_back({{std::move(container), end_span()}, {}});
        return true;
    }

    bool close() {
        JsonNode node = std::move(open_.back().node);
        open_.pop_back();
        return place(std::move(node));
    }

    std::string_view text_;
    const Offset& count_;
    std::vector<Open> open_;
    std::optional<JsonNode> root_;
    std::optional<JsonError> error_;
};

} // namespace

std::variant<JsonNode, JsonError> parse_json(std::string_view written) {
    const std::string text = without_trailing_commas(written);
    Offset count = 0;
    TreeBuilder builder(text, count);
    nlohmann::json::sax_parse(CountingIterator(text.data(), count),
                              CountingIterator(text.data() + text.size(), count), &builder,
                              nlohmann::json::input_format_t::json, true, true);
    return builder.take();
}

} // namespace maclint::cli
