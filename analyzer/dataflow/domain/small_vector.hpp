//! A list of mostly one or two small things, which then needs no allocation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>

namespace maclint::dataflow {

/// Up to `nearby` things stand in the list itself, more of them on the heap.
template<class T, std::uint32_t nearby>
class SmallVector {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    // NOLINTBEGIN(readability-identifier-naming): the standard's names for what a container has
    using value_type = T;
    using iterator = T*;
    using const_iterator = const T*;
    // NOLINTEND(readability-identifier-naming)

    SmallVector() = default;
    SmallVector(std::size_t count, T thing) {
        make_room(count);
        std::fill_n(begin(), count, thing);
        size_ = static_cast<std::uint32_t>(count);
    }
    SmallVector(std::initializer_list<T> things) { append(things.begin(), things.size()); }
    SmallVector(const SmallVector& other) { append(other.begin(), other.size_); }
    SmallVector(SmallVector&& other) noexcept { take(other); }
    SmallVector& operator=(const SmallVector& other) {
        if (this == &other) return *this;
        size_ = 0;
        append(other.begin(), other.size_);
        return *this;
    }
    SmallVector& operator=(SmallVector&& other) noexcept {
        if (this != &other) take(other);
        return *this;
    }
    ~SmallVector() = default;

    [[nodiscard]] T* begin() { return afar_ ? afar_.get() : here_.data(); }
    [[nodiscard]] T* end() { return begin() + size_; }
    [[nodiscard]] const T* begin() const { return afar_ ? afar_.get() : here_.data(); }
    [[nodiscard]] const T* end() const { return begin() + size_; }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] const T& front() const { return *begin(); }
    [[nodiscard]] T& operator[](std::size_t place) { return begin()[place]; }
    [[nodiscard]] const T& operator[](std::size_t place) const { return begin()[place]; }

    void push_back(T thing) { append(&thing, 1); }
    /// Puts the thing in front of `position`.
    void insert(const T* position, T thing) {
        const auto at = position - begin();
        append(&thing, 1);
        std::rotate(begin() + at, end() - 1, end());
    }
    /// Keeps the first things up to `position`.
    void cut_off(const T* position) { size_ = static_cast<std::uint32_t>(position - begin()); }

    friend bool operator==(const SmallVector& a, const SmallVector& b) { return std::ranges::equal(a, b); }

  private:
    void append(const T* things, std::size_t count) {
        make_room(size_ + count);
        std::copy_n(things, count, end());
        size_ += static_cast<std::uint32_t>(count);
    }

    void make_room(std::size_t needed) {
        if (needed <= room_) return;
        room_ = std::max(static_cast<std::uint32_t>(needed), 2 * room_);
        auto wider = std::make_unique<T[]>(room_);
        std::copy(begin(), end(), wider.get());
        afar_ = std::move(wider);
    }

    void take(SmallVector& other) noexcept {
        here_ = other.here_;
        afar_ = std::move(other.afar_);
        size_ = std::exchange(other.size_, 0);
        room_ = std::exchange(other.room_, nearby);
    }

    std::array<T, nearby> here_{};
    std::unique_ptr<T[]> afar_; ///< all things, when they are too many for `here_`
    std::uint32_t size_ = 0;
    std::uint32_t room_ = nearby;
};

} // namespace maclint::dataflow
