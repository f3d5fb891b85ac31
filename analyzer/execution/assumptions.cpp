//! Intervals for comparisons with numbers, the three cases of "less, equal, greater" for those of two values.
#include "analyzer/execution/assumptions.hpp"

#include "analyzer/dataflow/domain/arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace maclint::execution {
namespace {

using dataflow::SymbolId;
using dataflow::Value;

constexpr unsigned below = 1, same = 2, above = 4;
/// Of the lists of alternatives that speak of a value only the last ones are asked.
constexpr std::size_t most_lists = 16;

/// Where the left side can lie beside the right one.
unsigned places(Operation operation) {
    switch (operation) {
    case Operation::less: return below;
    case Operation::less_equal: return below | same;
    case Operation::equal: return same;
    case Operation::greater_equal: return same | above;
    case Operation::greater: return above;
    default: return below | above;
    }
}

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of one that is calculated, in arithmetic that no manual tells to the last digit, two comparisons still see
/// the same.
bool is_number(const Value& value) {
    return value.constant() && value.exactness == dataflow::Exactness::exact;
}

/// What is left of the numbers that a value can be.
class Numbers {
  public:
    Numbers(const Value& value, bool may_be_fraction)
        : low_(is_number(value) || !value.constant() ? value.low : -infinity)
        , high_(is_number(value) || !value.constant() ? value.high : infinity)
        , whole_(value.integer)
        , counts_(!may_be_fraction && is_end_of_whole(low_) && is_end_of_whole(high_)) {}

    void cut(Operation operation, double number) {
        counts_ = counts_ && is_whole(number);
        const unsigned where = places(operation);
        if (where == (below | above)) return excluded_.push_back(number);
        if ((where & above) == 0) lower_to(number, (where & same) == 0);
        if ((where & below) == 0) raise_to(number, (where & same) == 0);
    }

    [[nodiscard]] bool none_left() const {
        if (low_ > high_ || (low_ == high_ && (low_open_ || high_open_ || is_excluded(low_)))) return true;
        return (counts_ || whole_) && no_whole_number_left();
    }

  private:
    static bool is_whole(double number) { return std::floor(number) == number; }
    /// What lies above 4 begins with the next number that there is.
    static bool is_end_of_whole(double end) {
        const double whole = std::round(end);
        return end == whole || end == std::nextafter(whole, end);
    }
    void lower_to(double number, bool open) {
        if (number > high_) return;
        high_open_ = open || (number == high_ && high_open_);
        high_ = number;
    }
    void raise_to(double number, bool open) {
        if (number < low_) return;
        low_open_ = open || (number == low_ && low_open_);
        low_ = number;
    }
    [[nodiscard]] bool is_excluded(double number) const {
        return std::ranges::find(excluded_, number) != excluded_.end();
    }
    [[nodiscard]] bool no_whole_number_left() const {
        const double first = low_open_ ? std::floor(low_) + 1 : std::ceil(low_);
        const double last = high_open_ ? std::ceil(high_) - 1 : std::floor(high_);
        if (first > last) return true;
        if (last - first >= static_cast<double>(excluded_.size())) return false;
        for (double number = first; number <= last; ++number)
            if (!is_excluded(number)) return false;
        return true;
    }

    double low_, high_;
    bool low_open_ = false, high_open_ = false;
    bool whole_;
    bool counts_; ///< it lies between whole numbers, and was compared with such only
    std::vector<double> excluded_;
};

} // namespace

std::optional<Assumptions::Made> Assumptions::make(Id known, Operation operation, const Value& left,
                                                   const Value& right) {
    Made made{{left.symbol, left.symbol, operation, 0, false, known}, &left};
    if (semantics::is_vacancy_test(operation)) return made;
    Assumption& now = made.assumption;
    now.other = right.symbol;
    if (is_number(left)) {
        if (is_number(right)) return std::nullopt; // decided without any assumption
        made.subject = &right;
        now = {right.symbol, left.symbol, dataflow::mirrored(operation), 0, false, known};
    }
    const auto number = (made.subject == &left ? right : left).constant();
    now.with_number = number.has_value();
    now.number = number.value_or(0);
    if (now.subject == 0 || now.other == 0) return std::nullopt; // values of which nothing is said
    if (!number && now.subject > now.other) {
        std::swap(now.subject, now.other);
        now.operation = dataflow::mirrored(now.operation);
    }
    return made;
}

std::optional<Assumptions::Id> Assumptions::add(Id known, Operation operation, const Value& left,
                                                const Value& right) {
    const auto made = make(known, operation, left, right);
    if (!made) return known;
    if (Budget::is_innermost_spent() || is_known(made->assumption)) return known;
    if (contradicts(made->assumption, *made->subject)) return std::nullopt;
    const Id added = put(made->assumption);
    return leaves_alternatives(added) ? std::optional(added) : std::nullopt;
}

Assumptions::Id Assumptions::put(Assumption assumption) {
    assumption.count = static_cast<std::uint32_t>(count(assumption.earlier) + 1);
    all_.push_back(assumption);
    return static_cast<Id>(all_.size());
}

/// Whether the same has been assumed: of #1EQ1 OR #1EQ2, asked again, nothing new is learnt.
bool Assumptions::is_known(const Assumption& now) const {
    const auto is_same = [&now](const Assumption& earlier) {
        return earlier.subject == now.subject && earlier.other == now.other &&
               earlier.operation == now.operation && earlier.with_number == now.with_number &&
               earlier.number == now.number;
    };
    Id id = now.earlier;
    while (id != none && !is_same((*this)[id])) id = (*this)[id].earlier;
    work_.allows(count(now.earlier) - count(id));
    return id != none;
}

Assumptions::Id Assumptions::add_one_of(Id known, std::vector<Found> alternatives) {
    OneOf one_of{std::move(alternatives), {}};
    for (const Found& found : one_of.found) {
        const auto made = make(known, found.operation, found.left, found.right);
        if (!made) return known; // nothing can make it false
        one_of.said.push_back(made->assumption);
    }
    one_of_.push_back(std::move(one_of));
    return put({0, 0, Operation::any_of, 0, false, known, static_cast<std::uint32_t>(one_of_.size())});
}

std::span<const Assumptions::Assumption> Assumptions::alternatives(const Assumption& assumption) const {
    if (assumption.one_of == 0) return {};
    return one_of_[assumption.one_of - 1].said;
}

/// Whether of each earlier list that speaks of the same value some comparison can still be true.
bool Assumptions::leaves_alternatives(Id last) const {
    const SymbolId subject = (*this)[last].subject;
    const SymbolId other = (*this)[last].other;
    std::size_t lists = 0;
    if (!work_.allows(count(last))) return true;
    for (Id id = (*this)[last].earlier; id != none && lists < most_lists; id = (*this)[id].earlier) {
        const auto said = alternatives((*this)[id]);
        if (said.empty()) continue;
        if (!work_.allows(said.size())) return true;
        const bool same_value = std::ranges::any_of(said, [&](const Assumption& each) {
            return each.subject == subject || (!each.with_number && each.other == other);
        });
        if (!same_value) continue;
        ++lists;
        const auto& found = one_of_[(*this)[id].one_of - 1].found;
        const bool one_is_left = std::ranges::any_of(found, [&](const Found& each) {
            const auto made = make(last, each.operation, each.left, each.right);
            return !made || !contradicts(made->assumption, *made->subject);
        });
        if (!one_is_left) return false;
    }
    return true;
}

bool Assumptions::contradicts(const Assumption& now, const Value& subject) const {
    if (!work_.allows(count(now.earlier) + 1)) return false;
    if (now.with_number) return leaves_no_number(now, subject);
    if (semantics::is_vacancy_test(now.operation)) {
        for (Id id = now.earlier; id != none; id = (*this)[id].earlier) {
            const Assumption& earlier = (*this)[id];
            if (earlier.subject == now.subject && semantics::is_vacancy_test(earlier.operation) &&
                earlier.operation != now.operation)
                return true;
        }
        return now.operation == Operation::is_vacant && shows_set(now, now.subject);
    }
    unsigned left = places(now.operation);
    if (now.subject == now.other) left &= same;
    for (Id id = now.earlier; id != none; id = (*this)[id].earlier) {
        const Assumption& earlier = (*this)[id];
        if (!earlier.with_number && !semantics::is_vacancy_test(earlier.operation) &&
            earlier.subject == now.subject && earlier.other == now.other)
            left &= places(earlier.operation);
    }
    return left == 0;
}

/// Whether what is assumed from `last` on can be so of no vacant value.
bool Assumptions::shows_set(const Assumption& last, SymbolId subject) const {
    const auto shows = [this, subject](const Assumption& assumed) {
        if (assumed.subject != subject) return false;
        if (!assumed.with_number) return assumed.operation == Operation::is_set;
        const bool also_vacant = vacant_equals_zero_ && assumed.number == 0;
        return assumed.operation == Operation::equal && !also_vacant;
    };
    bool is_set = shows(last);
    for (Id id = last.earlier; id != none && !is_set; id = (*this)[id].earlier) is_set = shows((*this)[id]);
    return is_set;
}

bool Assumptions::leaves_no_number(const Assumption& now, const Value& subject) const {
    Numbers numbers(subject, fractions_.contains(now.subject));
    const bool is_set = subject.vacancy == dataflow::Vacancy::set || shows_set(now, now.subject);
    const auto cut = [&](const Assumption& assumed) {
        // A vacant value is not equal to 0, and counts as 0 beside LT, LE, GE and GT.
        const bool or_vacant = assumed.operation == Operation::not_equal && assumed.number == 0 && !is_set &&
                               !vacant_equals_zero_;
        if (!or_vacant) numbers.cut(assumed.operation, assumed.number);
    };
    cut(now);
    for (Id id = now.earlier; id != none; id = (*this)[id].earlier)
        if ((*this)[id].with_number && (*this)[id].subject == now.subject) cut((*this)[id]);
    return numbers.none_left();
}

} // namespace maclint::execution
