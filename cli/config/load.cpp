//! Reads .maclint.json: every key is known, every value is of its kind, or the user is told where and what
//! instead.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/config/configuration.hpp"
#include "cli/config/json_tree.hpp"
#include "cli/config/misplaced_words.hpp"
#include "cli/config/selection.hpp"
#include "cli/config/shop_demands.hpp"
#include "cli/input/size_limits.hpp"
#include "cli/text/guess.hpp"
#include "cli/text/shown.hpp"
#include "rules/listed.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <unordered_set>
#include <utility>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_chain = 16; ///< files that extend each other

/// Why loading stopped. Thrown from deep inside a tree, caught by load_configuration.
struct Rejected {
    Notice notice;
};

class Loader {
  public:
    explicit Loader(Reach reach)
        : reach_(std::move(reach)) {}

    std::shared_ptr<const Configuration> load(const std::string& path) {
        configuration_->path = path;
        read(path);
        configuration_->folder = folder_of(path);
        configuration_->files_by_glob = globs_of(configuration_->files);
        configuration_->vendor_by_glob = globs_of(configuration_->vendor);
        configuration_->ignores_by_glob = globs_of(configuration_->per_file_ignores);
        return configuration_;
    }

    [[nodiscard]] static bool knows_key(std::string_view key) {
        return std::ranges::find(keys(), key, &Key::name) != keys().end();
    }

  private:
    using Reader = void (Loader::*)(const JsonNode&);
    struct Key {
        std::string_view name;
        Reader reader;
    };

    /// The keys of the top level.
    static const std::array<Key, 17>& keys() {
        static constexpr std::array<Key, 17> rows{{
            {"$schema", &Loader::skip},
            {"extends", &Loader::skip},
            {"controls", &Loader::read_controls},
            {"files", &Loader::read_files},
            {"include", &Loader::read_include},
            {"exclude", &Loader::read_exclude},
            {"select", &Loader::read_select},
            {"ignore", &Loader::read_ignore},
            {"severity", &Loader::read_severity},
            {"per-file-ignores", &Loader::read_per_file_ignores},
            {"complete", &Loader::read_complete},
            {"known-names", &Loader::read_known_names},
            {"vendor", &Loader::read_vendor},
            {"encoding", &Loader::read_encoding},
            {"baseline", &Loader::read_baseline},
            {"words", &Loader::read_words},
            {"spacing", &Loader::read_spacing},
        }};
        return rows;
    }

    static std::string folder_of(const std::string& path) {
        std::error_code gone;
        const fs::path whole = fs::absolute(platform::path_of(path), gone);
        return platform::text_of(whole.lexically_normal().parent_path());
    }

    void read(const std::string& path) {
        folder_ = folder_of(path);
        const auto opened = open(path);
        configuration_->sources.push_back(opened);
        const auto parsed = parse_json(opened.bytes());
        if (const auto* error = std::get_if<JsonError>(&parsed))
            reject({error->at, error->at}, error->message + ". " + error->cure);
        const auto& root = std::get<JsonNode>(parsed);
        const auto& members = object(root, "the configuration");
        for (const JsonMember& member : members) {
            const auto* const key = std::ranges::find(keys(), member.key, &Key::name);
            if (key == keys().end()) reject_top_key(member);
            // The nearer file was read before the one that it extends: what is there stays.
            if (std::ranges::find(seen_, member.key) != seen_.end() && !is_merged(member.key)) continue;
            configuration_->source_of_key.try_emplace(member.key, source());
            (this->*key->reader)(member.node);
        }
        for (const JsonMember& member : members) seen_.push_back(member.key);
        const auto extends = std::ranges::find(members, "extends", &JsonMember::key);
        if (extends != members.end()) extend(extends->node, path);
    }

    static bool is_merged(std::string_view key) {
        return key == "controls" || key == "severity" || key == "per-file-ignores" || key == "words";
    }

    /// Only what the command line names may be a pipe: many that are found would be waited for one by one.
    Source open(const std::string& path) {
        const bool named = !reach_.is_bounded() && configuration_->sources.empty();
        auto result =
            named ? read_file(path, configuration_limit) : read_regular_file(path, configuration_limit);
        if (const auto* error = std::get_if<InputError>(&result))
            throw Rejected{{NoticeKind::configuration, path, error->message}};
        return std::get<Source>(std::move(result));
    }

    void extend(const JsonNode& node, const std::string& path) {
        const std::string other = file_named(node, "'extends'", path);
        if (configuration_->sources.size() >= longest_chain)
            reject(node.span, "'extends' leads in a circle or through more than " +
                                  std::to_string(longest_chain) + " files. Break the chain");
        read(other);
    }

    /// The file that a key of the configuration `path` names, relative to that. It is not looked at.
    std::string file_named(const JsonNode& node, const std::string& key, const std::string& path) const {
        const std::string& name = text(node, key);
        const fs::path file =
            (platform::path_of(path).parent_path() / platform::path_of(name)).lexically_normal();
        if (const auto objection = reach_.objection(name, file))
            reject(node.span, key + " names '" + name + "', which " + *objection +
                                  ". If you trust this configuration, name it with --config");
        return platform::text_of(file);
    }

    // ---- the keys

    void skip(const JsonNode& /*node*/) {}

    void read_controls(const JsonNode& node) {
        for (const JsonMember& member : object(node, "'controls'")) {
            require_words(member.key, member.key_span, "the name of a control");
            configuration_->controls.try_emplace(member.key, read_control(member));
        }
    }

    std::shared_ptr<const OwnControl> read_control(const JsonMember& member) {
        static constexpr std::array<std::string_view, 16> known = {"model",
                                                                   "machine",
                                                                   "gcode-system",
                                                                   "block-if",
                                                                   "limits",
                                                                   "stops-look-ahead",
                                                                   "codes",
                                                                   "lacks",
                                                                   "calls",
                                                                   "parameters",
                                                                   "options",
                                                                   "axes",
                                                                   "calculator-input",
                                                                   "at-start",
                                                                   "before-tool-change",
                                                                   "at-end"};
        const auto& settings = object(member.node, "a control");
        const auto model = std::ranges::find(settings, "model", &JsonMember::key);
        if (model == settings.end())
            reject(member.key_span, "the control '" + member.key +
                                        "' has no 'model'. Name the control that it is, "
                                        "for instance \"fanuc-16i\"");
        const std::string& name = text(model->node, "'model'");
        const ControlModel* base = find_control(name);
        if (base == nullptr)
            reject(model->node.span,
                   "there is no control '" + name + "'." +
                       did_you_mean(name, control_names(),
                                    "Known are " + rules::listed(control_names(), " and ")));
        OwnControl::Facts own{base->limits, base->functions};
        std::vector<const ControlModel*> lathes = base->lathes;
        // Which machine it is comes before its G code system, wherever the two stand.
        if (const auto machine = std::ranges::find(settings, "machine", &JsonMember::key);
            machine != settings.end()) {
            base = on_machine(*base, machine->node);
            if (base->machine == Machine::mill) lathes.clear();
        }
        for (const JsonMember& setting : settings) {
            if (setting.key == "limits") read_limits(setting.node, own.limits);
            if (setting.key == "stops-look-ahead")
                own.functions.stopping = functions(setting.node, own.functions);
            if (setting.key == "block-if") own.block_if = truth(setting.node, "'block-if'");
            read_machine(setting, own.machine, *base);
            if (setting.key == "gcode-system") {
                const ControlModel* system = of_system(*base, setting.node);
                if (base->machine == Machine::lathe) base = system;
                lathes = {system};
            }
            if (std::ranges::find(known, setting.key) == known.end())
                reject_key(setting, {known.begin(), known.end()});
        }
        read_demands(settings, *base, own.machine);
        return std::make_shared<const OwnControl>(member.key, *base, std::move(lathes), std::move(own));
    }

    /// The keys that tell what one machine has.
    void read_machine(const JsonMember& setting, MachineFacts& machine, const ControlModel& model) {
        if (setting.key == "options") {
            machine.list_options();
            for (const JsonNode& element : array(setting.node, "'options'"))
                accept(machine.add_option(text(element, "an entry of 'options'"), model), element.span);
        }
        if (setting.key == "axes") accept(machine.set_axes(text(setting.node, "'axes'")), setting.node.span);
        if (setting.key == "calculator-input")
            machine.set_calculator_input(truth(setting.node, "'calculator-input'"));
        if (setting.key == "codes")
            for (const JsonNode& element : array(setting.node, "'codes'"))
                accept(machine.add_codes(text(element, "an entry of 'codes'")), element.span);
        if (setting.key == "lacks")
            for (const JsonNode& element : array(setting.node, "'lacks'"))
                accept(machine.add_missing(text(element, "an entry of 'lacks'")), element.span);
        if (setting.key == "calls")
            for (const JsonMember& call : object(setting.node, "'calls'"))
                accept(machine.add_call(call.key, text(call.node, "a program of 'calls'")), call.key_span);
        if (setting.key == "parameters")
            for (const JsonMember& parameter : object(setting.node, "'parameters'"))
                accept(machine.add_parameter(parameter.key, number(parameter.node, parameter.key)),
                       parameter.key_span);
    }

    /// What the shop asks of programs for the machine.
    void read_demands(const JsonNode::Object& settings, const ControlModel& model, MachineFacts& machine) {
        ShopDemands demands;
        bool has_any = false;
        const auto take = [&](const JsonMember& member, const std::optional<WrongValue>& wrong) {
            if (wrong) reject(wrong->span, wrong->message);
            if (model.machine_words == nullptr)
                reject(member.key_span, "'" + member.key + "' is not known for the control '" + model.name +
                                            "', whose programs are not followed so far. Leave it out");
            has_any = true;
        };
        const auto is_one_of = [](const std::vector<std::string>& names, const std::string& key) {
            return std::ranges::find(names, key) != names.end();
        };
        for (const JsonMember& setting : settings) {
            if (is_one_of(demand_names(), setting.key)) take(setting, read_demand(setting, demands));
            if (setting.key != "limits") continue;
            for (const JsonMember& limit : object(setting.node, "'limits'"))
                if (is_one_of(shop_limit_names(), limit.key))
                    take(limit, read_shop_limit(limit, demands.limits));
        }
        if (has_any) machine.set_demands(std::move(demands));
    }

    void accept(const std::optional<WrongWord>& wrong, Span span) const {
        if (wrong) reject(span, wrong->message);
    }

    double number(const JsonNode& node, const std::string& key) const {
        const auto* value = std::get_if<double>(&node.value);
        if (value == nullptr) reject(node.span, "'" + key + "' must be a number. Correct it");
        return *value;
    }

    /// The model on the machine that the node names.
    const ControlModel* on_machine(const ControlModel& model, const JsonNode& node) const {
        const std::string& word = text(node, "'machine'");
        if (word != "mill" && word != "lathe")
            reject(node.span, "there is no machine '" + word + "'. Write mill or lathe");
        const bool lathe = word == "lathe";
        if (lathe == (model.machine == Machine::lathe)) return &model;
        if (lathe && !model.lathes.empty()) return model.lathes.front();
        reject(node.span, "the control '" + model.name + "' is not known for a " + word +
                              ". Name another 'model', or leave 'machine' out");
    }

    /// The lathe of the model with the G code system that the node names.
    const ControlModel* of_system(const ControlModel& model, const JsonNode& node) const {
        const std::string& word = text(node, "'gcode-system'");
        if (word != "A" && word != "B" && word != "C")
            reject(node.span, "there is no G code system '" + word + "'. Write A, B or C");
        if (model.machine == Machine::lathe && model.code_system == word.front()) return &model;
        if (const ControlModel* lathe = model.lathe_of(word.front())) return lathe;
        reject(node.span, "the control '" + model.name + "' is not known with G code system " + word +
                              ". Name another 'model', or leave 'gcode-system' out");
    }

    void read_limits(const JsonNode& node, Limits& limits) {
        struct Limit {
            std::string_view name;
            int Limits::*value;
        };
        static constexpr std::array<Limit, 5> known{{{"macro-calls", &Limits::macro_calls},
                                                     {"subprogram-calls", &Limits::subprogram_calls},
                                                     {"loop-levels", &Limits::loop_levels},
                                                     {"loop-numbers", &Limits::last_loop_number},
                                                     {"bracket-levels", &Limits::bracket_levels}}};
        for (const JsonMember& member : object(node, "'limits'")) {
            const auto* const limit = std::ranges::find(known, member.key, &Limit::name);
            const std::vector<std::string> of_shop = shop_limit_names(); // read_demands
            if (std::ranges::find(of_shop, member.key) != of_shop.end()) continue;
            if (limit == known.end()) {
                std::vector<std::string> all = names(known);
                all.insert(all.end(), of_shop.begin(), of_shop.end());
                reject_key(member, all);
            }
            limits.*(limit->value) = level(member.node, member.key);
        }
    }

    int level(const JsonNode& node, const std::string& key) {
        const auto* number = std::get_if<double>(&node.value);
        if (number == nullptr || *number < 1 || *number > 1000 || *number != std::floor(*number))
            reject(node.span, "'" + key + "' must be a whole number from 1 to 1000. Correct it");
        return static_cast<int>(*number);
    }

    /// "M25", or several in a row as "M40-M49".
    std::vector<MachineFunctions::Range> functions(const JsonNode& node, const MachineFunctions& known) {
        std::vector<MachineFunctions::Range> ranges;
        for (const JsonNode& element : array(node, "'stops-look-ahead'")) {
            const std::string& word = text(element, "an entry of 'stops-look-ahead'");
            const std::size_t hyphen = word.find('-');
            const auto first = function(std::string_view(word).substr(0, hyphen), known);
            const auto last = hyphen == std::string::npos
                                  ? first
                                  : function(std::string_view(word).substr(hyphen + 1), known);
            if (!first || !last || *last < *first)
                reject(element.span,
                       "'" + word + "' is no M code. Write it as \"M25\", several in a row as \"M40-M49\"");
            ranges.push_back({*first, *last});
        }
        return ranges;
    }

    static std::optional<int> function(std::string_view word, const MachineFunctions& known) {
        if (!word.starts_with(known.address)) return std::nullopt;
        word.remove_prefix(known.address.size());
        int number = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        const bool whole = error == std::errc() && end == word.data() + word.size();
        return whole ? std::optional(number) : std::nullopt;
    }

    void read_files(const JsonNode& node) {
        static constexpr std::array<std::string_view, 3> known = {"glob", "control", "dialect"};
        for (const JsonNode& entry : array(node, "'files'")) {
            FileEntry file{.glob = {}, .control = {}, .dialect = {}, .source = source()};
            Span control_span{};
            for (const JsonMember& member : object(entry, "an entry of 'files'")) {
                const std::string& value = text(member.node, "'" + member.key + "'");
                if (member.key == "glob") {
                    file.glob = glob(value, member.node.span);
                } else if (member.key == "control") {
                    file.control = value;
                    control_span = member.node.span;
                } else if (member.key == "dialect") {
                    file.dialect = value;
                    if (find_dialect(value) == nullptr && value != "auto")
                        reject(
                            member.node.span,
                            "there is no dialect '" + value + "'." +
                                did_you_mean(value, dialect_names(),
                                             "Known are auto, " + rules::listed(dialect_names(), " and ")));
                } else {
                    reject_key(member, {known.begin(), known.end()});
                }
            }
            if (file.glob.pattern.empty())
                reject(entry.span, "an entry of 'files' has no 'glob'. Say which files it is for");
            if (!file.control.empty()) controls_named_.push_back({file.control, file.dialect, control_span});
            configuration_->files.push_back(std::move(file));
        }
        // Read once all controls are known: 'files' may stand before 'controls'.
        files_source_ = configuration_->sources.size() - 1;
    }

    void read_include(const JsonNode& node) {
        configuration_->included = globs(node, "'include'");
        configuration_->include = GlobSet(configuration_->included);
    }
    void read_exclude(const JsonNode& node) { configuration_->exclude = GlobSet(globs(node, "'exclude'")); }
    void read_select(const JsonNode& node) {
        configuration_->select = rule_words(node, "'select'");
        if (configuration_->select->empty())
            reject(node.span, "'select' is empty, so that nothing would be checked. Name rules, or leave it "
                              "out");
    }
    void read_ignore(const JsonNode& node) { configuration_->ignore = rule_words(node, "'ignore'"); }

    void read_severity(const JsonNode& node) {
        for (const JsonMember& member : object(node, "'severity'")) {
            require_words(member.key, member.key_span, "a key of 'severity'");
            const std::string& word = text(member.node, "a severity");
            const auto severity = severity_named(word);
            if (!severity)
                reject(member.node.span, "there is no severity '" + word + "'. Write error, warning or note" +
                                             advice_for_severity(member.key, word));
            require_rules(member.key, member.key_span);
            configuration_->severity.push_back({{member.key, source()}, *severity});
        }
    }

    void read_per_file_ignores(const JsonNode& node) {
        for (const JsonMember& member : object(node, "'per-file-ignores'")) {
            require_words(member.key, member.key_span, "a glob of 'per-file-ignores'");
            if (globs_with_ignores_.insert(member.key).second)
                configuration_->per_file_ignores.push_back({glob(member.key, member.key_span),
                                                            rule_words(member.node, "'per-file-ignores'"),
                                                            source()});
        }
    }

    void read_complete(const JsonNode& node) { configuration_->complete = truth(node, "'complete'"); }

    /// "CHIPS_AWAY", "MTB_*".
    void read_known_names(const JsonNode& node) {
        auto patterns = std::make_shared<ListedNames>();
        for (const JsonNode& element : array(node, "'known-names'")) {
            std::string name = in_capitals(text(element, "an entry of 'known-names'"));
            const bool is_beginning = name.ends_with('*');
            if (is_beginning) name.pop_back();
            const bool is_name = !name.empty() && std::ranges::all_of(name, [](char c) {
                return is_letter(c) || is_digit(c) || c == '_';
            });
            if (!is_name)
                reject(element.span,
                       "an entry of 'known-names' must be a name of letters, digits and _, or the "
                       "beginning of names with * behind it. Correct it");
            if (is_beginning)
                patterns->beginnings.push_back(std::move(name));
            else
                patterns->names.insert(std::move(name));
        }
        configuration_->known_names = std::move(patterns);
    }

    bool truth(const JsonNode& node, std::string_view key) const {
        const auto* value = std::get_if<bool>(&node.value);
        if (value == nullptr) reject(node.span, std::string(key) + " must be true or false. Correct it");
        return *value;
    }

    /// true: the remarks tell, as without the key.
    void read_vendor(const JsonNode& node) {
        if (const auto* value = std::get_if<bool>(&node.value)) {
            configuration_->vendor_by_remarks = *value;
            return;
        }
        if (!std::holds_alternative<JsonNode::Array>(node.value))
            reject(node.span, "'vendor' must be a list of globs, or false where no program is a maker's. "
                              "Correct it");
        for (const JsonNode& element : array(node, "'vendor'")) {
            const std::string& pattern = text(element, "an entry of 'vendor'");
            const bool is_vendor = !pattern.starts_with('!');
            if (pattern == "!")
                reject(element.span, "an entry of 'vendor' is '!' alone. Write a glob behind it");
            configuration_->vendor.push_back(
                {glob(is_vendor ? pattern : pattern.substr(1), element.span), is_vendor, source()});
        }
    }

    void read_encoding(const JsonNode& node) {
        const std::string& name = text(node, "'encoding'");
        std::vector<std::string> known = {"auto"};
        for (const Encoding encoding :
             {Encoding::utf8, Encoding::windows_1252, Encoding::shift_jis, Encoding::gbk}) {
            known.emplace_back(name_of(encoding));
            if (name == known.back()) configuration_->encoding = encoding;
        }
        if (std::ranges::find(known, name) == known.end())
            reject(node.span, "there is no encoding '" + name + "'." +
                                  did_you_mean(name, known, "Write " + rules::listed(known, " and ")));
    }

    /// Relative to the file that names it.
    void read_baseline(const JsonNode& node) {
        configuration_->baseline = file_named(node, "'baseline'", configuration_->sources.back().path());
    }

    /// What the nearer file says of a word counts.
    void read_words(const JsonNode& node) {
        std::unordered_set<std::string> here;
        for (const JsonMember& member : object(node, "'words'")) {
            require_words(member.key, member.key_span, "a key of 'words'");
            const auto word = one_spelling(member.key);
            if (!word)
                reject(member.key_span, "'" + member.key +
                                            "' is no word of a program. Write a code or a variable as "
                                            "programs write it, for instance \"M53\" or \"#550\"");
            if (!here.insert(*word).second)
                reject(member.key_span, "'words' says what '" + *word + "' is twice. Leave one of them out");
            const std::string& meaning = text(member.node, "what a word means");
            require_words(meaning, member.node.span, "what '" + member.key + "' means");
            configuration_->words.try_emplace(*word, meaning);
        }
    }

    void read_spacing(const JsonNode& node) {
        SpacingChoice& spacing = configuration_->spacing;
        const std::vector<std::string> known = {"words", "operators", "brackets"};
        for (const JsonMember& member : object(node, "'spacing'")) {
            const auto which = std::ranges::find(known, member.key) - known.begin();
            if (which == std::ssize(known)) reject_key(member, known);
            Blanks& blanks = which == 0 ? spacing.words : which == 1 ? spacing.operators : spacing.brackets;
            blanks = blanks_named(member.node, "'" + member.key + "'");
            if (&blanks == &spacing.brackets && blanks == Blanks::one)
                reject(member.node.span,
                       "'brackets' takes \"none\" alone. Leave it out to keep what stands there");
        }
    }

    [[nodiscard]] Blanks blanks_named(const JsonNode& node, const std::string& what) const {
        const std::string& name = text(node, what);
        if (name != "one" && name != "none")
            reject(node.span, what + " is \"one\" or \"none\". Leave it out to keep what stands there");
        return name == "one" ? Blanks::one : Blanks::none;
    }

    // ---- values of a kind

    const JsonNode::Object& object(const JsonNode& node, const std::string& what) {
        const auto* members = std::get_if<JsonNode::Object>(&node.value);
        if (members == nullptr) reject(node.span, what + " must be an object. Put it in braces { }");
        return *members;
    }

    const JsonNode::Array& array(const JsonNode& node, const std::string& what) {
        const auto* elements = std::get_if<JsonNode::Array>(&node.value);
        if (elements == nullptr) reject(node.span, what + " must be a list. Put it in brackets [ ]");
        return *elements;
    }

    const std::string& text(const JsonNode& node, const std::string& what) const {
        const auto* value = std::get_if<std::string>(&node.value);
        if (value == nullptr) reject(node.span, what + " must be a text. Put it in quotes");
        require_words(*value, node.span, what);
        return *value;
    }

    /// Nothing, blanks and NUL name nothing: no file, no rule, no control.
    void require_words(const std::string& word, Span span, const std::string& what) const {
        if (word.find_first_not_of(" \t\r\n") == std::string::npos)
            reject(span, what + " is empty. Write what it stands for, or leave it out");
        if (word.find('\0') != std::string::npos)
            reject(span, what + " holds a NUL, which no name has. Take it out");
    }

    std::vector<Glob> globs(const JsonNode& node, const std::string& what) {
        std::vector<Glob> values;
        for (const JsonNode& element : array(node, what))
            values.push_back(glob(text(element, "an entry of " + what), element.span));
        return values;
    }

    template<class Entry>
    static GlobSet globs_of(const std::vector<Entry>& entries) {
        std::vector<Glob> values;
        for (const Entry& entry : entries) values.push_back(entry.glob);
        return GlobSet(values);
    }

    /// Relative to the folder of the file that is being read, not of the one that extends it.
    [[nodiscard]] Glob glob(const std::string& pattern, Span span) const {
        if (pattern.find('\\') != std::string::npos) {
            std::string other = pattern;
            std::ranges::replace(other, '\\', '/');
            reject(span, "the glob '" + pattern +
                             "' has a backslash, which separates nothing in one. Write \"" + other + "\"");
        }
        return {pattern, folder_};
    }

    std::vector<RuleWord> rule_words(const JsonNode& node, const std::string& what) {
        std::vector<RuleWord> words;
        for (const JsonNode& element : array(node, what)) {
            const std::string& word = text(element, "an entry of " + what);
            require_rules(word, element.span);
            words.push_back({word, source()});
        }
        return words;
    }

    /// A mistyped word in "select" would switch everything else off, so no such word is passed over.
    void require_rules(const std::string& word, Span span) const {
        if (rules_named(word).empty()) reject(span, "there is no rule '" + word + "'." + advice_for(word));
    }

    // ---- complaints

    [[nodiscard]] std::size_t source() const { return configuration_->sources.size() - 1; }

    template<class Rows>
    static std::vector<std::string> names(const Rows& rows) {
        std::vector<std::string> all;
        for (const auto& row : rows) all.emplace_back(row.name);
        return all;
    }

    [[noreturn]] void reject(Span span, const std::string& message) const {
        reject(configuration_->sources.back(), span, message);
    }

    [[noreturn]] void reject(const Source& source, Span span, const std::string& message) const {
        if (!reach_.may_quote(platform::path_of(source.path())))
            reject_at(source, span,
                      "this is wrong here, but text of a folder above is not shown. Name this file with "
                      "--config to be told more");
        reject_at(source, span, message);
    }

    [[noreturn]] static void reject_at(const Source& source, Span span, const std::string& message) {
        const Position at = source.position(span.begin);
        const std::string place = "line " + std::to_string(at.line) + ", column " + std::to_string(at.column);
        const bool ends = message.ends_with('?') || message.ends_with('.');
        throw Rejected{
            {NoticeKind::configuration, source.path(), place + ": " + message + (ends ? "" : ".")}};
    }

    /// A rule has its place in one of the keys, and not beside them.
    [[noreturn]] void reject_top_key(const JsonMember& member) const {
        const std::string advice = advice_for_key(member.key);
        if (advice.empty()) reject_key(member, names(keys()));
        reject(member.key_span, "there is no key '" + member.key + "' here. " + advice);
    }

    [[noreturn]] void reject_key(const JsonMember& member, const std::vector<std::string>& known) const {
        reject(member.key_span,
               "there is no key '" + member.key + "' here." +
                   did_you_mean(member.key, known, "Known are " + rules::listed(known, " and ")));
    }

  public:
    /// Controls of "files" are looked up when all files of the chain have been read.
    void check_controls() const {
        const Source& source = configuration_->sources[files_source_];
        for (const auto& [name, dialect_name, span] : controls_named_) {
            const ControlModel* control = configuration_->model_behind(name);
            const Dialect* dialect = find_dialect(dialect_name);
            if (control == nullptr) {
                const auto known = configuration_->known_controls();
                reject(source, span,
                       "there is no control '" + name + "'." +
                           did_you_mean(name, known, "Known are " + rules::listed(known, " and ") + "."));
            }
            if (dialect != nullptr && !is_for(*control, *dialect))
                reject(source, span,
                       std::string("the control '")
                           .append(name)
                           .append("' does not run the dialect '")
                           .append(dialect_name)
                           .append("' of the same entry. Leave one of them out"));
        }
    }

  private:
    Reach reach_;
    std::shared_ptr<Configuration> configuration_ = std::make_shared<Configuration>();
    std::string folder_; ///< of the file that is being read
    std::vector<std::string> seen_;
    std::unordered_set<std::string> globs_with_ignores_;
    struct ControlWord {
        std::string control, dialect;
        Span span;
    };
    std::vector<ControlWord> controls_named_;
    std::size_t files_source_ = 0;
};

} // namespace

std::variant<std::shared_ptr<const Configuration>, Notice> load_configuration(const std::string& path,
                                                                              const Reach& reach) {
    try {
        Loader loader(reach);
        auto configuration = loader.load(path);
        loader.check_controls();
        return configuration;
    } catch (const Rejected& rejected) {
        return rejected.notice;
    }
}

bool looks_like_configuration(std::string_view text) {
    const auto parsed = parse_json(text);
    const auto* root = std::get_if<JsonNode>(&parsed);
    const auto* members = root == nullptr ? nullptr : std::get_if<JsonNode::Object>(&root->value);
    return members != nullptr && std::ranges::any_of(*members, [](const JsonMember& member) {
               return member.key != "$schema" && Loader::knows_key(member.key);
           });
}

std::string Configuration::said_in(std::size_t source, std::string_view how) const {
    return shown(sources[source].path()) + ": " + std::string(how);
}

std::string Configuration::said_in(std::string_view key) const {
    return said_in(source_of_key.at(std::string(key)), key);
}

const ControlModel* Configuration::control(std::string_view name) const {
    const auto own = controls.find(name);
    return own != controls.end() ? &own->second->model() : find_control(name);
}

const ControlModel* Configuration::model_behind(std::string_view name) const {
    const auto own = controls.find(name);
    return own != controls.end() ? &own->second->base() : find_control(name);
}

std::vector<std::string> Configuration::known_controls() const {
    std::vector<std::string> names = control_names();
    const auto built_in = static_cast<std::ptrdiff_t>(names.size());
    for (const auto& own : controls) names.push_back(own.first);
    std::sort(names.begin() + built_in, names.end());
    return names;
}

bool is_for(const ControlModel& control, const Dialect& dialect) {
    return control.language == find_control(dialect.default_control)->language;
}

std::vector<std::string> control_names() {
    std::vector<std::string> names;
    for (const ControlModel* control : controls()) names.push_back(control->name);
    return names;
}

std::vector<std::string> dialect_names() {
    std::vector<std::string> names;
    for (const Dialect& dialect : dialects()) names.emplace_back(dialect.name);
    return names;
}

} // namespace maclint::cli
