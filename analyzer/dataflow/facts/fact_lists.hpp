//! The facts of a program while they are written down.
#pragma once

#include "analyzer/dataflow/facts/application.hpp"
#include "analyzer/dataflow/facts/call_begun.hpp"
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/computed_jump.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/fact_order.hpp"
#include "analyzer/dataflow/facts/fact_set.hpp"
#include "analyzer/dataflow/facts/facts.hpp"
#include "analyzer/dataflow/facts/modal_read.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"

#include <cassert>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

namespace maclint::dataflow {

/// Every type of fact, as arguments of `Of`, in the order of their places: what stands here can be recorded
/// and asked for.
template<template<class...> class Of>
using OfEveryFact =
    Of<Application, Comparison, Condition, Read, ModalRead, Store, Clobber, CallMade, ModalWrite,
       ComputedJump, BeforeToolChange, BeforeWatchedWord, ExitState, BeforeNode, CallBegun>;

/// Whether each type has the place at which it stands.
template<class... Types>
struct InOrder {
    static constexpr bool value = [] {
        std::size_t number = 0;
        return sizeof...(Types) <= FactPlace::most && ((Types::place.number == number++) && ...);
    }();
};
static_assert(OfEveryFact<InOrder>::value, "a new type of fact has the next free place");

/// A list for each of the types; those that are not recorded stay empty.
template<class... Types>
class ListsOf {
  public:
    void record_only(FactSet types) { recorded_ = types; }
    template<class T>
    [[nodiscard]] bool records() const {
        return recorded_.has<T>();
    }
    template<class T>
    void add(T fact) {
        assert(records<T>());
        of<T>().push_back(std::move(fact));
    }
    template<class T>
    [[nodiscard]] std::vector<T>& of() {
        return std::get<std::vector<T>>(lists_);
    }
    template<class T>
    [[nodiscard]] const std::vector<T>& of() const {
        return std::get<std::vector<T>>(lists_);
    }
    /// Sorts them by node; those of one node stay as they were added.
    void put_in_order() {
        const auto sort = []<class T>(std::vector<T>& list) {
            if constexpr (requires { &T::node; }) put_in_order_of(list, &T::node);
        };
        (sort(of<Types>()), ...);
    }
    /// Calls `visit(State&)` for all states that facts of these types hold.
    template<class Visit>
    void for_each_state(FactSet types, const Visit& visit) {
        const auto look_at = [&]<class T>(std::vector<T>& list) {
            if constexpr (HoldsState<T>)
                if (types.has<T>())
                    for (T& fact : list) visit(fact.state);
        };
        (look_at(of<Types>()), ...);
    }
    /// Moves the facts of the types that are `wanted` out, into no more memory than they need, and drops the
    /// others; the memory here stays for other programs, unless a list has more than `worth_keeping` bytes.
    [[nodiscard]] Facts hand_over(FactSet wanted, std::size_t worth_keeping) {
        Facts facts;
        const auto hand_over_list = [&]<class T>(std::vector<T>& list) {
            std::vector<T> taken = taken_from(list, worth_keeping);
            if (wanted.has<T>()) facts.put(std::move(taken));
        };
        (hand_over_list(of<Types>()), ...);
        return facts;
    }

  private:
    template<class T>
    static std::vector<T> taken_from(std::vector<T>& list, std::size_t worth_keeping) {
        std::vector<T> taken;
        if (list.capacity() * sizeof(T) > worth_keeping) {
            taken = std::exchange(list, {});
            taken.shrink_to_fit();
        } else {
            taken.assign(std::move_iterator(list.begin()), std::move_iterator(list.end()));
            list.clear();
        }
        return taken;
    }

    FactSet recorded_ = FactSet::all();
    std::tuple<std::vector<Types>...> lists_;
};

using FactLists = OfEveryFact<ListsOf>;

} // namespace maclint::dataflow
