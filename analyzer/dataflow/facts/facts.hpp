//! What data flow found out, effect by effect: the material that rules are made of.
#pragma once

#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/dataflow/facts/fact_order.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/dataflow/facts/sorted_facts.hpp"
#include "analyzer/flow/graph.hpp"
#include "analyzer/program/model.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <concepts>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace maclint::dataflow {

/// A fact about a known effect. Each type of fact has a header in facts/.
template<class T>
concept OfAnEffect = requires(const T& fact) {
    { fact.effect } -> std::convertible_to<EffectId>;
};

/// A fact about one variable and a value of it: what it is given, what is read.
template<class T>
concept OfAVariable = requires(const T& fact) {
    { fact.variable } -> std::convertible_to<Variable>;
    { fact.value } -> std::convertible_to<const Value&>;
};

/// A fact that holds the state of a point. The state keeps what is known of modal groups there after the
/// program is solved; values of variables are taken from it while the fact is recorded.
template<class T>
concept HoldsState = requires(T& fact) {
    { fact.state } -> std::same_as<State&>;
};

/// Notes which types of facts its thread asks for while it lives. A rule has to declare these.
class AskedFacts {
  public:
    AskedFacts()
        : outer_(std::exchange(innermost, this)) {}
    AskedFacts(const AskedFacts&) = delete;
    AskedFacts& operator=(const AskedFacts&) = delete;
    ~AskedFacts() { innermost = outer_; }
    [[nodiscard]] FactSet types() const { return types_; }

  private:
    friend class Facts;
    inline static constinit thread_local AskedFacts* innermost = nullptr;
    AskedFacts* outer_;
    FactSet types_;
};

/// The facts of one program: a list for each type that is recorded.
class Facts {
  public:
    /// In the order of nodes. Facts of a type that was not recorded cannot be asked for.
    template<class T>
    [[nodiscard]] std::span<const T> all() const {
        return list<T>().facts;
    }
    /// Those of one node.
    template<class T>
    [[nodiscard]] std::span<const T> in(flow::NodeId node) const {
        const auto found = std::ranges::equal_range(list<T>().facts, node, {}, &T::node);
        return {found.begin(), found.end()};
    }
    /// Those of one effect.
    template<OfAnEffect T>
    [[nodiscard]] std::span<const T> at(EffectId effect) const {
        const List<T>& of_type = list<T>();
        const auto& sorted = of_type.by_effect.empty() ? of_type.facts : of_type.by_effect;
        const auto found = std::ranges::equal_range(sorted, effect, {}, &T::effect);
        return {found.begin(), found.end()};
    }
    /// Those about one variable, in the order of nodes. May be asked on several threads.
    template<OfAVariable T>
    [[nodiscard]] std::span<const T* const> about(Variable variable) const {
        const List<T>& of_type = list<T>();
        return of_type.by_variable.with(std::span(of_type.facts), key_of(variable),
                                        [](const T& fact) { return key_of(fact.variable); });
    }
    /// Those with the result of one computation, in the order of nodes. May be asked on several threads.
    template<OfAVariable T>
    [[nodiscard]] std::span<const T* const> with(SymbolId symbol) const {
        const List<T>& of_type = list<T>();
        return of_type.by_symbol.with(std::span(of_type.facts), symbol,
                                      [](const T& fact) { return fact.value.symbol; });
    }
    /// Adds the list of a type, which is in the order of nodes.
    template<class T>
    void put(std::vector<T> facts) {
        recorded_ |= FactSet::of<T>();
        if (!facts.empty()) lists_[T::place.number] = std::make_unique<List<T>>(std::move(facts));
    }

  private:
    struct AnyList {
        AnyList() = default;
        AnyList(const AnyList&) = delete;
        AnyList& operator=(const AnyList&) = delete;
        virtual ~AnyList() = default;
    };
    template<class T>
    struct List : AnyList {
        List() = default;
        explicit List(std::vector<T> of_program)
            : facts(std::move(of_program)) {
            if constexpr (OfAnEffect<T>) {
                if (is_in_order(facts, &T::effect)) return;
                by_effect = facts;
                put_in_order_of(by_effect, &T::effect);
            }
        }
        std::vector<T> facts;
        std::vector<T> by_effect; ///< empty where `facts` are in that order
        SortedFacts<T> by_variable, by_symbol;
    };

    template<class T>
    [[nodiscard]] const List<T>& list() const {
        if (AskedFacts::innermost != nullptr) AskedFacts::innermost->types_ |= FactSet::of<T>();
        assert(recorded_.has<T>()); // Rule::facts declares what a rule asks for
        static const List<T> none;
        const auto& list = lists_[T::place.number];
        return list == nullptr ? none : static_cast<const List<T>&>(*list);
    }

    FactSet recorded_;
    std::array<std::unique_ptr<const AnyList>, FactPlace::most> lists_; ///< nullptr where there are none
};

} // namespace maclint::dataflow
