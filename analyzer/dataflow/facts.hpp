//! What data flow found out, effect by effect: the material that rules are made of.
#pragma once

#include "analyzer/flow/graph.hpp"
#include "analyzer/program/model.hpp"

#include <algorithm>
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

/// The facts of one program: a list for each type of them, whatever types there are.
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
        lists_.push_back(std::make_unique<List<T>>(std::move(facts)));
    }

  private:
    /// Its address stands for the type.
    template<class T>
    static constexpr char mark = 0;

    struct AnyList {
        explicit AnyList(const char* of_type)
            : type(of_type) {}
        AnyList(const AnyList&) = delete;
        AnyList& operator=(const AnyList&) = delete;
        virtual ~AnyList() = default;
        const char* type;
    };
    template<class T>
    struct List : AnyList {
        explicit List(std::vector<T> of_program)
            : AnyList(&mark<T>)
            , facts(std::move(of_program)) {
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
        const auto found = std::ranges::find(lists_, &mark<T>, &AnyList::type);
        assert(found != lists_.end());
        return static_cast<const List<T>&>(**found);
    }

    std::vector<std::unique_ptr<const AnyList>> lists_;
};

} // namespace maclint::dataflow
