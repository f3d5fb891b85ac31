//! One pass at a time: what is due is taken under the lock, analysed without it, and published where nobody
//! has typed in between.
#include "cli/lsp/diagnostics/analyst.hpp"

#include "analyzer/source/platform/kept_by_thread.hpp"
#include "cli/gate/gate.hpp"
#include "cli/lsp/diagnostics/diagnostic.hpp"
#include "cli/report/uri.hpp"

#include <algorithm>
#include <new>
#include <utility>

namespace maclint::cli::lsp {
namespace {

/// What a client calls the files: documents as it wrote them.
class UriNames {
  public:
    explicit UriNames(const std::vector<Document>& documents) {
        for (const Document& document : documents) by_path_.emplace(document.path, document.uri);
    }
    [[nodiscard]] std::string operator()(const std::string& path) const {
        const auto found = by_path_.find(path);
        return found == by_path_.end() ? file_uri(path) : found->second;
    }

  private:
    std::map<std::string, std::string> by_path_;
};

} // namespace

Analyst::Analyst(WorkspaceFiles& files, FindingStore& findings, Outbox& outbox, AnalystOptions options)
    : files_(files)
    , findings_(findings)
    , outbox_(outbox)
    , options_(options)
    , engine_({.jobs = options.jobs, .kept_bytes = options.kept_bytes}, progress_) {}

Analyst::~Analyst() {
    {
        const std::lock_guard lock(mutex_);
        is_ending_ = true;
        running_.request_stop();
    }
    changed_.notify_all();
    thread_.reset();
}

void Analyst::start(PositionEncoding encoding, bool shows_progress) {
    encoding_ = encoding;
    if (shows_progress) {
        shown_progress_.emplace(outbox_);
        progress_.watch(
            [this](std::string_view phase, std::size_t percent) { shown_progress_->report(phase, percent); });
    }
    if (auto thread = platform::Thread::start([this] {
            const platform::ThreadWork keeps;
            work();
        }))
        thread_.emplace(*std::move(thread));
    if (!thread_)
        outbox_.show_once("maclint: there is no memory for a thread, so nothing is analysed. Close other "
                          "programs and start again.");
}

void Analyst::documents_changed(std::vector<Document> documents) {
    {
        const std::lock_guard lock(mutex_);
        documents_ = std::move(documents);
        documents_due_ = Clock::now() + options_.pause;
        running_.request_stop();
    }
    changed_.notify_all();
}

void Analyst::document_closed(std::vector<Document> documents, const Document& closed) {
    findings_.remove(closed.path);
    {
        const std::lock_guard lock(mutex_);
        closed_.insert(closed.path);
    }
    if (!files_.has(closed.path))
        outbox_.notify("textDocument/publishDiagnostics",
                       {{"uri", closed.uri}, {"diagnostics", Json::array()}});
    documents_changed(std::move(documents));
}

void Analyst::folders_changed() {
    files_.forget();
    {
        const std::lock_guard lock(mutex_);
        folders_due_ = true;
        if (!documents_.empty()) documents_due_ = Clock::now() + options_.pause;
        running_.request_stop();
    }
    changed_.notify_all();
}

void Analyst::cancel_folders(const Json& token) {
    if (!shown_progress_ || !shown_progress_->is_running(token)) return;
    const std::lock_guard lock(mutex_);
    folders_due_ = false;
    if (std::exchange(runs_folders_, false)) running_.request_stop();
}

void Analyst::work() {
    while (auto pass = next_pass()) {
        try {
            run(*pass);
        } catch (const std::bad_alloc&) {
            outbox_.show_once(
                "maclint: there is not enough memory to analyse the programs. Close large ones.");
        } catch (const std::exception& error) {
            outbox_.show_once("maclint: something went wrong inside maclint (" + std::string(error.what()) +
                              "). Please report it.");
        }
    }
}

/// Waits until something is due. Nothing: the end.
std::optional<Analyst::Pass> Analyst::next_pass() {
    std::unique_lock lock(mutex_);
    runs_folders_ = false;
    while (true) {
        if (is_ending_) return std::nullopt;
        if (documents_due_ && Clock::now() >= *documents_due_) {
            documents_due_.reset();
            running_ = {};
            return Pass{documents_, std::exchange(closed_, {}), Asked::documents, running_.get_token()};
        }
        if (!documents_due_ && folders_due_) {
            folders_due_ = false;
            runs_folders_ = true;
            running_ = {};
            return Pass{documents_, {}, Asked::all, running_.get_token()};
        }
        if (documents_due_)
            changed_.wait_until(lock, *documents_due_);
        else
            changed_.wait(lock);
    }
}

Snapshot Analyst::snapshot_of_pass(const Pass& pass) {
    Snapshot snapshot = files_.snapshot(pass.documents, pass.asked);
    for (SnapshotFile& file : snapshot.files)
        if (pass.closed.contains(file.input.path)) file.input.asked = true;
    tell(files_.take_notices());
    return snapshot;
}

void Analyst::run(const Pass& pass) {
    const bool is_shown = pass.asked == Asked::all && shown_progress_;
    if (is_shown) shown_progress_->begin();
    const Snapshot snapshot = snapshot_of_pass(pass);
    Result result = engine_.analyse(snapshot, pass.stop);
    if (is_shown) shown_progress_->end();
    if (result.cancelled) return again(pass);
    judge(snapshot, result);
    publish(pass, snapshot, std::move(result));
}

/// What a newer edit has ended is due again, unless the user has ended it.
void Analyst::again(const Pass& pass) {
    const std::lock_guard lock(mutex_);
    if (pass.asked == Asked::all && runs_folders_) folders_due_ = true;
    closed_.insert(pass.closed.begin(), pass.closed.end());
}

/// Baselines and programs of makers, as on the command line.
void Analyst::judge(const Snapshot& snapshot, Result& result) {
    auto gate = Gate::open(CheckRequest{}, snapshot, baselines_);
    if (const auto* refused = std::get_if<Notice>(&gate)) return tell({*refused});
    (void)std::get<Gate>(gate).judge(snapshot, result);
}

void Analyst::tell(const std::vector<Notice>& notices) {
    for (const Notice& notice : notices) {
        const std::string text =
            "maclint: " + notice.path + (notice.path.empty() ? "" : ": ") + notice.message;
        if (notice.kind == NoticeKind::configuration)
            outbox_.show_once(text);
        else if (notice.is_error() || notice.kind == NoticeKind::origin)
            outbox_.log(text);
    }
}

void Analyst::publish(const Pass& pass, const Snapshot& snapshot, Result result) {
    const UriNames uri_of(pass.documents);
    DiagnosticWriter writer(encoding_, uri_of);
    std::map<std::string, Json> lists;
    std::map<std::string, DocumentFindings> of_documents;
    for (const Document& document : pass.documents) of_documents[document.path].version = document.version;
    for (std::size_t i = 0; i < result.sources.size(); ++i)
        if (const auto found = of_documents.find(result.sources[i]->path()); found != of_documents.end())
            found->second.dialect = result.read_as[i].dialect;
    for (FilteredFinding& filtered : result.findings) {
        if (filtered.suppressed) continue;
        const std::string path = filtered.finding.source->path();
        lists.try_emplace(path, Json::array()).first->second.push_back(writer.write(filtered.finding));
        if (const auto found = of_documents.find(path); found != of_documents.end())
            found->second.findings.push_back(std::move(filtered.finding));
    }
    const std::lock_guard lock(mutex_);
    if (pass.stop.stop_requested()) { // somebody has typed: positions are not what they were
        closed_.insert(pass.closed.begin(), pass.closed.end());
        if (pass.asked == Asked::all && runs_folders_) folders_due_ = true;
        return;
    }
    std::set<std::string> gone = pass.asked == Asked::all ? published_ : std::set<std::string>();
    for (const SnapshotFile& file : snapshot.files) {
        if (!file.input.asked) continue;
        gone.erase(uri_of(file.input.path));
        const auto list = lists.find(file.input.path);
        const auto document = of_documents.find(file.input.path);
        const std::string uri = uri_of(file.input.path);
        const bool is_empty = list == lists.end();
        const bool is_news = document != of_documents.end() || !is_empty || published_.contains(uri);
        if (!is_news) continue;
        Json params = {{"uri", uri}, {"diagnostics", is_empty ? Json::array() : std::move(list->second)}};
        if (document != of_documents.end()) {
            params["version"] = document->second.version;
            findings_.set(file.input.path, std::move(document->second));
        }
        outbox_.notify("textDocument/publishDiagnostics", std::move(params));
        if (is_empty)
            published_.erase(uri);
        else
            published_.insert(uri);
    }
    for (const std::string& uri : gone) {
        published_.erase(uri);
        outbox_.notify("textDocument/publishDiagnostics", {{"uri", uri}, {"diagnostics", Json::array()}});
    }
}

} // namespace maclint::cli::lsp
