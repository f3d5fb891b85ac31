//! Programs that need not be read again while their text stays as it is.
#pragma once

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/platform/files.hpp"
#include "cli/config/configuration.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace maclint::cli {

/// Files as they were read whole, by path, content, control and configuration. May be asked on several
/// threads.
class ProgramStore {
  public:
    /// Keeps files of so many bytes of text in all, those first that come first.
    explicit ProgramStore(std::size_t capacity)
        : capacity_(capacity) {}

    /// How a text is read. `control`: as somebody named it, or as the dialect assumes. `configuration` may be
    /// nullptr; it owns the control.
    struct Reading {
        const Dialect* dialect;
        const ControlModel* control;
        std::shared_ptr<const Configuration> configuration;
        friend bool operator==(const Reading&, const Reading&) = default;
    };
    using Stamp = std::optional<platform::FileStamp>;

    /// What is kept of the file that had the stamp when it was read; nullptr: nothing, it has to be opened.
    [[nodiscard]] std::shared_ptr<const ProgramFile> find(const std::string& path, const Stamp& stamp,
                                                          const Reading& reading);
    /// `stamp` was taken before the file was opened; none of what an editor holds.
    [[nodiscard]] std::shared_ptr<const ProgramFile> read(const std::shared_ptr<const Source>& source,
                                                          const Reading& reading, const Stamp& stamp = {});
    /// Lets go what was not asked for since the last call.
    void drop_unused();

    /// How many files were read because they were not kept.
    [[nodiscard]] std::size_t reads() const { return reads_; }

  private:
    struct Kept {
        std::shared_ptr<const ProgramFile> file;
        Reading reading;
        Stamp stamp;
        bool used = true;
    };

    mutable std::mutex mutex_;
    std::size_t capacity_;
    std::size_t size_ = 0; ///< bytes of text
    std::size_t reads_ = 0;
    std::map<std::string, Kept, std::less<>> by_path_;
};

} // namespace maclint::cli
