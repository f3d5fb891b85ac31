//! Three lines around each change, as everybody writes it.
#include "cli/fix/unified_difference.hpp"

#include "cli/gate/line_difference.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::cli {
namespace {

constexpr std::uint32_t around = 3; // lines of context

/// With their ends.
std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::size_t size = end == std::string_view::npos ? text.size() : end + 1;
        lines.push_back(text.substr(0, size));
        text.remove_prefix(size);
    }
    return lines;
}

void add_line(std::string& out, char mark, std::string_view line) {
    out += mark;
    out += line;
    if (!line.ends_with('\n')) out += "\n\\ No newline at end of file\n";
}

/// "12,3": the first line and how many; an empty stretch is named by the line before it.
std::string stretch(std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t count = end - begin;
    const std::string first = std::to_string(count == 0 ? begin : begin + 1);
    return count == 1 ? first : first + "," + std::to_string(count);
}

class Hunks {
  public:
    Hunks(std::string_view before, std::string_view after)
        : before_(lines_of(before))
        , after_(lines_of(after))
        , differences_(differences(before, after)) {
        find_other_ends();
    }

    [[nodiscard]] std::string text() const {
        std::string out;
        for (std::size_t first = 0; first < differences_.size();) {
            std::size_t last = first;
            while (last + 1 < differences_.size() &&
                   differences_[last + 1].before - differences_[last].before_end <= 2 * around)
                ++last;
            add_hunk(out, first, last);
            first = last + 1;
        }
        return out;
    }

  private:
    /// Lines that differ in their ends alone, as the last one without a line feed: who compares lines takes
    /// them for the same.
    void find_other_ends() {
        std::vector<LineDifference> all;
        std::uint32_t before = 0, after = 0;
        const auto size = static_cast<std::uint32_t>(before_.size());
        for (std::size_t i = 0; i <= differences_.size(); ++i) {
            const std::uint32_t end = i < differences_.size() ? differences_[i].before : size;
            for (; before < end; ++before, ++after)
                if (before_[before] != after_[after]) all.push_back({before, before + 1, after, after + 1});
            if (i == differences_.size()) break;
            all.push_back(differences_[i]);
            before = differences_[i].before_end;
            after = differences_[i].after_end;
        }
        differences_ = std::move(all);
    }

    void add_hunk(std::string& out, std::size_t first, std::size_t last) const {
        const LineDifference &one = differences_[first], &other = differences_[last];
        const std::uint32_t lead = std::min(around, one.before);
        const auto left = static_cast<std::uint32_t>(before_.size()) - other.before_end;
        const std::uint32_t tail = std::min(around, left);
        out += "@@ -" + stretch(one.before - lead, other.before_end + tail) + " +" +
               stretch(one.after - lead, other.after_end + tail) + " @@\n";
        std::uint32_t at = one.before - lead;
        for (std::size_t i = first; i <= last; ++i) {
            const LineDifference& difference = differences_[i];
            for (; at < difference.before; ++at) add_line(out, ' ', before_[at]);
            for (; at < difference.before_end; ++at) add_line(out, '-', before_[at]);
            for (std::uint32_t line = difference.after; line < difference.after_end; ++line)
                add_line(out, '+', after_[line]);
        }
        for (std::uint32_t line = 0; line < tail; ++line) add_line(out, ' ', before_[at + line]);
    }

    std::vector<std::string_view> before_, after_;
    std::vector<LineDifference> differences_;
};

} // namespace

std::string unified_difference(const std::vector<FixedFile>& files) {
    std::string out;
    for (const FixedFile& file : files) {
        // A name with blanks ends with a tab, as git writes it.
        const std::string end = file.path.find(' ') == std::string::npos ? "\n" : "\t\n";
        out += "--- a/" + file.path + end + "+++ b/" + file.path + end;
        out += Hunks(file.before->stored_bytes(), file.after).text();
    }
    return out;
}

} // namespace maclint::cli
