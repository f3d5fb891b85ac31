//! The thread that analyses while the user types.
#pragma once

#include "analyzer/source/platform/threads.hpp"
#include "cli/engine/engine.hpp"
#include "cli/gate/baseline_store.hpp"
#include "cli/lsp/diagnostics/finding_store.hpp"
#include "cli/lsp/diagnostics/work_progress.hpp"
#include "cli/lsp/documents/documents.hpp"
#include "cli/lsp/documents/workspace_files.hpp"
#include "cli/lsp/protocol/outbox.hpp"

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

namespace maclint::cli::lsp {

struct AnalystOptions {
    unsigned jobs = 1;                                ///< threads of the engine
    std::chrono::milliseconds pause{150};             ///< without an edit, before texts are analysed
    std::size_t kept_bytes = std::size_t{256} << 20U; ///< of text, whose programs are kept
};

/// First the documents, then, when nobody types, the folders. A newer edit ends what runs.
class Analyst {
  public:
    Analyst(WorkspaceFiles& files, FindingStore& findings, Outbox& outbox, AnalystOptions options);
    Analyst(const Analyst&) = delete;
    Analyst& operator=(const Analyst&) = delete;
    /// Ends what runs, and waits for it.
    ~Analyst();

    /// Before anything else is asked for.
    void start(PositionEncoding encoding, bool shows_progress);
    /// A text was opened, or changed: these are all.
    void documents_changed(std::vector<Document> documents);
    /// The same for one that was closed, whose file counts again.
    void document_closed(std::vector<Document> documents, const Document& closed);
    /// Files or configurations are not what they were.
    void folders_changed();
    /// The user does not want the folders searched now.
    void cancel_folders(const Json& token);

    /// What is known of files from looks at them.
    [[nodiscard]] OutlineStore& outlines() { return engine_.outlines(); }

  private:
    using Clock = std::chrono::steady_clock;
    struct Pass {
        std::vector<Document> documents;
        std::set<std::string> closed; ///< paths that findings are wanted of, too
        Asked asked;
        std::stop_token stop;
    };

    void work();
    [[nodiscard]] std::optional<Pass> next_pass();
    void run(const Pass& pass);
    [[nodiscard]] Snapshot snapshot_of_pass(const Pass& pass);
    void judge(const Snapshot& snapshot, Result& result);
    void publish(const Pass& pass, const Snapshot& snapshot, Result result);
    void tell(const std::vector<Notice>& notices);
    void again(const Pass& pass);

    WorkspaceFiles& files_;
    FindingStore& findings_;
    Outbox& outbox_;
    AnalystOptions options_;
    PositionEncoding encoding_ = PositionEncoding::utf16;
    Progress progress_{Progress::Shown::never};
    Engine engine_;
    BaselineStore baselines_;
    std::optional<WorkProgress> shown_progress_;
    std::set<std::string> published_; ///< URIs that findings stand at

    std::mutex mutex_; ///< for what follows
    std::condition_variable changed_;
    std::vector<Document> documents_;
    std::set<std::string> closed_;
    std::optional<Clock::time_point> documents_due_;
    bool folders_due_ = false;
    bool runs_folders_ = false;
    bool is_ending_ = false;
    std::stop_source running_;
    std::optional<platform::Thread> thread_; ///< last: it uses all of this
};

} // namespace maclint::cli::lsp
