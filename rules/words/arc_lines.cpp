//! Reads each line only up to where it is known.
#include "rules/words/arc_lines.hpp"

#include <algorithm>
#include <cctype>

namespace maclint {

ArcLines::ArcLines() {
    mark('G', Letter::code);
    letters_['\n'] = letters_['\r'] = Letter::line_end;
    letters_['('] = Letter::comment;
}

void ArcLines::mark(char capital, Letter letter) {
    const auto byte = static_cast<unsigned char>(capital);
    letters_[byte] = letter;
    letters_[static_cast<unsigned char>(std::tolower(byte))] = letter;
}

void ArcLines::read(std::string_view whole, Span part, bool in_arc, const std::function<void(Span)>& visit) {
    const std::string_view text = whole.substr(0, part.end);
    in_arc_ = in_arc;
    line_end_ = text.find('\n', part.begin) == std::string_view::npos ? '\r' : '\n';
    std::size_t capital = 0, small = 0; // letters G: where the next stands
    for (std::size_t at = part.begin; at < text.size();) {
        if (in_arc_) {
            const std::size_t begin = at;
            if (!goes_on(text, at)) continue;
            visit({static_cast<Offset>(begin), static_cast<Offset>(at)});
        } else {
            if (capital < at) capital = text.find('G', at);
            if (small < at) small = text.find('g', at);
            at = std::min(capital, small);
            if (at == std::string_view::npos) return;
            in_arc_ = arcs_.may_begin(text.substr(++at));
            if (in_arc_) at = end_of_line(text, at);
        }
    }
}

std::size_t ArcLines::end_of_line(std::string_view text, std::size_t at) const {
    return std::min(text.find(line_end_, at), text.size());
}

/// Whether the line goes on with the arc, moves and lacks a word; it is read only up to where that is known.
bool ArcLines::goes_on(std::string_view text, std::size_t& at) {
    bool moves = false;
    for (; at < text.size(); ++at) {
        switch (letters_[static_cast<unsigned char>(text[at])]) {
        case Letter::none: continue;
        case Letter::axis: moves = true; continue;
        case Letter::comment: at = std::min(text.find_first_of(")\n\r", at), text.size()) - 1; continue;
        case Letter::wanted: at = end_of_line(text, at); return false;
        case Letter::code: {
            const std::string_view number = text.substr(at + 1);
            in_arc_ = !others_.may_begin(number);
            if (in_arc_ && !arcs_.may_begin(number)) continue;
            at = in_arc_ ? end_of_line(text, at) : at + 1;
            return false;
        }
        case Letter::line_end: ++at; return moves;
        }
    }
    return moves;
}

} // namespace maclint
