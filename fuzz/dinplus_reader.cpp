//! The reader of DIN PLUS: any text, for any of its controls.
#include "fuzz/reader.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    maclint::fuzz::read_for_some_control(maclint::fuzz::text_of(data, size), "dinplus");
    return 0;
}
