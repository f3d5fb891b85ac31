//! What data flow found out, effect by effect: the material that rules are made of.
#pragma once

#include "analyzer/dataflow/facts/fact_set.hpp"
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

/// A fact of which the effect is known that it is about. Each type of fact has a header in facts/.
template<class T>
concept OfAnEffect = requires(const T& fact) {
    { fact.effect } -> std::convertible_to<EffectId>;
};

/// Notes which types of facts its thread asks for while it lives: so much a rule has to declare.
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
    /// Adds the list of a type, which is in the order of nodes.
    template<class T>
    void put(std::vector<T> facts) {
        lists_[EveryFact::index<T>()] = std::make_unique<List<T>>(std::move(facts));
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
        explicit List(std::vector<T> of_program)
            : facts(std::move(of_program)) {
            if constexpr (OfAnEffect<T>) {
                if (std::ranges::is_sorted(facts, {}, &T::effect)) return;
                by_effect = facts;
                std::ranges::stable_sort(by_effect, {}, &T::effect);
            }
        }
        std::vector<T> facts;
        std::vector<T> by_effect; ///< empty where `facts` are in that order
    };

    template<class T>
    [[nodiscard]] const List<T>& list() const {
        if (AskedFacts::innermost != nullptr) AskedFacts::innermost->types_ |= FactSet::of<T>();
        const auto& list = lists_[EveryFact::index<T>()];
        assert(list != nullptr); // Rule::facts declares what a rule asks for
        return static_cast<const List<T>&>(*list);
    }

    std::array<std::unique_ptr<const AnyList>, EveryFact::count> lists_;
};

} // namespace maclint::dataflow
