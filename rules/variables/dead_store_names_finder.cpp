//! Gathers which shared variables programs set and read.
#include "rules/variables/dead_store_names_finder.hpp"

#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/workspace.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace maclint::rules {
namespace {

using dataflow::Read;
using dataflow::Store;

bool is_passing(const ProgramAnalysis& analysis, Variable variable) {
    return analysis.control().spaces[variable.space].scope == Scope::shared;
}

/// Whether one digit differs, or two beside each other are exchanged. Neighbours are often a result and what
/// it is made of.
bool is_a_slip(Variable one, Variable other) {
    if (std::abs(one.number - other.number) <= 1) return false;
    const std::string a = std::to_string(one.number), b = std::to_string(other.number);
    if (one.space != other.space || a.size() != b.size()) return false;
    const auto [x, y] = std::ranges::mismatch(a, b);
    if (x == a.end()) return false;
    const std::string rest_a(x + 1, a.end()), rest_b(y + 1, b.end());
    if (rest_a == rest_b) return true;
    return !rest_a.empty() && *x == rest_b.front() && *y == rest_a.front() &&
           rest_a.substr(1) == rest_b.substr(1);
}

/// The only variable of the facts of which no fact of the other kind tells; nothing where there are several.
template<class Fact, class Other>
const Fact* only_one_without(const ProgramAnalysis& analysis) {
    const Fact* found = nullptr;
    for (const Fact& fact : analysis.facts().all<Fact>()) {
        if (!is_passing(analysis, fact.variable) ||
            !analysis.facts().template about<Other>(fact.variable).empty())
            continue;
        if (found != nullptr && !(found->variable == fact.variable)) return nullptr;
        if (found == nullptr) found = &fact;
    }
    return found;
}

/// Whether the program sets or reads one of the two, or may do so.
bool touches(const ProgramAnalysis& analysis, Variable variable) {
    const auto& facts = analysis.facts();
    return !facts.about<Store>(variable).empty() || !facts.about<Read>(variable).empty();
}

/// Whether a number that is computed may be that of a shared variable, or a call may do anything.
bool is_open(const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    return !analysis.facts().all<dataflow::Clobber>().empty() || !analysis.calls().empty() ||
           std::ranges::any_of(program.expressions, [](const Expression& expression) {
               return std::holds_alternative<LoadAt>(expression.node);
           });
}

} // namespace

std::optional<MistakenNumber> find_mistaken_number(const ProgramAnalysis& analysis) {
    if (is_open(analysis)) return std::nullopt;
    const Store* store = only_one_without<Store, Read>(analysis);
    const Read* read = store == nullptr ? nullptr : only_one_without<Read, Store>(analysis);
    if (read == nullptr || read->node <= store->node || !is_a_slip(store->variable, read->variable))
        return std::nullopt;
    for (const ProgramAnalysis& other : analysis.workspace().programs()) {
        if (!Budget::allows()) return std::nullopt;
        if (other.index() != analysis.index() &&
            (touches(other, store->variable) || touches(other, read->variable)))
            return std::nullopt;
    }
    return MistakenNumber{store, read};
}

} // namespace maclint::rules
