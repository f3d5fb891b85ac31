//! Whether the tests are compiled with a sanitizer.
#pragma once

namespace maclint::test {

/// Then the executable is, too; it takes terabytes of addresses.
constexpr bool sanitized() {
#if defined(__SANITIZE_ADDRESS__)
    return true;
#elif defined(__has_feature)
    return __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
    return false;
#endif
}

} // namespace maclint::test
