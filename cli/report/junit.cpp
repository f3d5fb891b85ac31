//! JUnit's XML as Jenkins and Surefire have it: a suite for each file, a test case for each finding, or one
//! that passed.
#include "analyzer/source/encoding.hpp"
#include "cli/config/rule_words.hpp"
#include "cli/report/service.hpp"
#include "cli/report/uri.hpp"
#include "cli/report/xml.hpp"

#include <map>

namespace maclint::cli {
namespace {

struct Counts {
    std::size_t tests = 0, failures = 0, errors = 0, skipped = 0;
};

std::string attributes_of(const Counts& counts) {
    return xml_attribute("tests", std::to_string(counts.tests)) +
           xml_attribute("failures", std::to_string(counts.failures)) +
           xml_attribute("errors", std::to_string(counts.errors));
}

/// Services tell test cases apart by class and name: where both are equal they keep one.
class Suite {
  public:
    explicit Suite(std::string name)
        : name_(std::move(name)) {}

    /// `what` is an element in the test case; empty: it passed.
    void add(std::string_view type, const std::string& name, const std::string& what) {
        ++counts.tests;
        const std::size_t count = ++seen_[std::string(type) + "\n" + name];
        cases_ += "    <testcase" + xml_attribute("classname", "maclint." + std::string(type)) +
                  xml_attribute("name", count == 1 ? name : name + " (" + std::to_string(count) + ")") +
                  xml_attribute("time", "0") + (what.empty() ? "/>\n" : ">\n" + what + "    </testcase>\n");
    }

    [[nodiscard]] std::string text() const {
        return "  <testsuite" + xml_attribute("name", name_) + attributes_of(counts) +
               xml_attribute("skipped", std::to_string(counts.skipped)) + xml_attribute("time", "0") + ">\n" +
               cases_ + "  </testsuite>\n";
    }

    Counts counts;

  private:
    std::string name_, cases_;
    std::map<std::string, std::size_t> seen_;
};

std::string element(std::string_view tag, std::string_view type, const std::string& message,
                    const std::string& text) {
    return "      <" + std::string(tag) + xml_attribute("type", type) + xml_attribute("message", message) +
           ">" + xml_escaped(text) + "</" + std::string(tag) + ">\n";
}

class JunitWriter {
  public:
    JunitWriter(const Report& report, PathDetail detail)
        : fail_on_(report.fail_on)
        , detail_(detail) {}

    void add(const FileFindings& file) {
        const std::string path = service_path(file.source->path(), root_);
        Suite suite(path);
        for (const Finding* finding : file.findings) add(suite, path, *finding);
        if (file.findings.empty()) suite.add("checked", path, {});
        add(suite);
    }

    void add(const std::vector<const Notice*>& errors) {
        if (errors.empty()) return;
        Suite suite("maclint");
        for (const Notice* error : errors) {
            const std::string message = printable(error->message);
            suite.add("run", error->path.empty() ? "maclint" : service_path(error->path, root_),
                      element("error", "error", message, message));
            ++suite.counts.errors;
        }
        add(suite);
    }

    [[nodiscard]] std::string text() const {
        return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + xml_attribute("name", "maclint") +
               attributes_of(all_) + ">\n" + suites_ + "</testsuites>\n";
    }

  private:
    void add(Suite& suite, const std::string& path, const Finding& finding) const {
        const Position at = finding.source->position(finding.span.begin);
        const std::string place = path + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
        const std::string message = printable(finding.message());
        std::string text = place + ": " + message;
        for (const std::string& step : steps_of(finding, detail_, root_)) text += "\n" + step;
        const bool fails = fail_on_ && finding.severity >= *fail_on_;
        suite.add(finding.rule->code, place + " " + name_with_key(finding),
                  element(fails ? "failure" : "skipped", name_of(finding.severity), message, text));
        ++(fails ? suite.counts.failures : suite.counts.skipped);
    }

    void add(const Suite& suite) {
        suites_ += suite.text();
        all_.tests += suite.counts.tests;
        all_.failures += suite.counts.failures;
        all_.errors += suite.counts.errors;
    }

    std::optional<Severity> fail_on_;
    PathDetail detail_;
    std::string root_ = source_root();
    std::string suites_;
    Counts all_;
};

} // namespace

std::string write_junit(const Report& report, const TextStyle& style) {
    JunitWriter writer(report, style.path);
    writer.add(run_errors(report));
    for (const FileFindings& file : findings_by_file(report)) writer.add(file);
    return writer.text();
}

} // namespace maclint::cli
