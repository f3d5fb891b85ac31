//! Guesses by which a check says nothing although its statement is true; each can be switched off.
#pragma once

#include <algorithm>
#include <span>
#include <utility>

namespace maclint {

/// A guess at what the author means, or at a habit, that keeps a check from speaking: `if (guess.is_on() &&
/// what_it_looks_at(…)) continue;`. A constant of its own for each, which is known by its address; its name
/// and why it is made stand in the records of the rules that make it (Rule::exemptions).
class Exemption {
  public:
    constexpr Exemption() = default;
    Exemption(const Exemption&) = delete;
    Exemption& operator=(const Exemption&) = delete;
    ~Exemption() = default;
    /// Whether checks of this thread make it: all do but those that somebody switched off.
    [[nodiscard]] bool is_on() const;
};

/// While it lives its thread does without these exemptions, and without no others.
class WithoutExemptions {
  public:
    explicit WithoutExemptions(std::span<const Exemption* const> off)
        : off_(off)
        , outer_(std::exchange(innermost, this)) {}
    WithoutExemptions(const WithoutExemptions&) = delete;
    WithoutExemptions& operator=(const WithoutExemptions&) = delete;
    ~WithoutExemptions() { innermost = outer_; }

  private:
    friend class Exemption;
    inline static constinit thread_local WithoutExemptions* innermost = nullptr;
    std::span<const Exemption* const> off_;
    WithoutExemptions* outer_;
};

inline bool Exemption::is_on() const {
    const WithoutExemptions* without = WithoutExemptions::innermost;
    return without == nullptr || std::ranges::find(without->off_, this) == without->off_.end();
}

} // namespace maclint
