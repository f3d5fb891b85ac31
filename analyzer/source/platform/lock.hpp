//! One run at a time changes a file that several write.
#pragma once

#include <chrono>
#include <memory>
#include <string>

namespace maclint::platform {

/// How long others may take who write the same file.
inline constexpr std::chrono::seconds patience_with_writers{30};

/// A file of this name beside the one that it is for, as long as somebody writes that. The system lets go of
/// it when its process ends, however that ends; on Linux the name may stay, which hinders nobody.
[[nodiscard]] std::string lock_name(const std::string& path);

/// Held from its making until it goes.
class WriteLock {
  public:
    /// `path`: of the file that is to be written, without links.
    explicit WriteLock(const std::string& path);
    WriteLock(const WriteLock&) = delete;
    WriteLock& operator=(const WriteLock&) = delete;
    ~WriteLock();

    /// 0: it is held. EBUSY: somebody else has held it all the time; EEXIST: a file that is no lock bears its
    /// name; else what errno has for the failure.
    [[nodiscard]] int error() const { return error_; }

  private:
    struct Held;
    std::unique_ptr<Held> held_;
    int error_ = 0;
};

} // namespace maclint::platform
