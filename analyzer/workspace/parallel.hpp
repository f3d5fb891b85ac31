//! Independent pieces of work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace maclint {

/// Calls `work(0) … work(count - 1)`, on up to `jobs` threads; returns when all are done.
/// What the work throws is thrown here, once every thread has ended.
void for_each_parallel(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work);

} // namespace maclint
