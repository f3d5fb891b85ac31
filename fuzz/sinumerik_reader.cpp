//! The reader of SINUMERIK: any text.
#include "fuzz/reader.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    maclint::fuzz::read_for_some_control(maclint::fuzz::text_of(data, size), "sinumerik");
    return 0;
}
