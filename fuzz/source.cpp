//! Lines, columns and encodings of any bytes.
#include "analyzer/source/source.hpp"

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/content.hpp"
#include "fuzz/harness.hpp"

using namespace maclint;

namespace {

void check(const Source& source) {
    const Offset size = source.size();
    std::uint32_t line = 1;
    for (Offset at = 0; at <= size; ++at) {
        const Position position = source.position(at);
        fuzz::require(position.line >= line && position.line <= source.line_count(), "lines do not grow");
        fuzz::require(position.column >= 1 && position.byte_column >= 1, "columns count from 1");
        fuzz::require(position.column <= position.byte_column, "no character takes more units than bytes");
        line = position.line;
        const Offset back = source.offset_at(position.line, position.column);
        fuzz::require(back <= size && source.position(back) <= position, "a position leads behind itself");
    }
    for (std::uint32_t i = 1; i <= source.line_count(); ++i) {
        const Span span = source.line_span(i);
        fuzz::require(span.begin <= span.end && span.end <= size, "a line ends where it begins or later");
        fuzz::require(source.line_text(i).find_first_of("\r\n") == std::string_view::npos,
                      "a line holds a line end");
        const std::string text = source.to_utf8(source.line_text(i));
        fuzz::require_harmless(printable(text), "a printable line");
    }
    const std::string whole = source.to_utf8(source.bytes());
    fuzz::require(to_utf8(whole, Encoding::utf8) == whole, "what is UTF-8 stays so");
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Source source = Source::from_bytes("O1.nc", std::string(fuzz::text_of(data, size)));
    check(source);
    check(source.read_as(Encoding::utf8));
    for (const Encoding encoding : {Encoding::windows_1252, Encoding::shift_jis, Encoding::gbk}) {
        const Source other = source.read_as(encoding);
        check(other);
        fuzz::require(other.stored_bytes() == source.stored_bytes(), "what is stored stays so");
        fuzz::require(other.line_count() == source.line_count(), "the lines are the same in any encoding");
    }
    static_cast<void>(classify(source.bytes()));
    fuzz::require_harmless(printable(source.to_utf8(detect_dialect(source).reason)), "the dialect's reason");
    return 0;
}
