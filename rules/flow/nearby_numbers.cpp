//! Puts the nearest sequence numbers into words.
#include "rules/flow/nearby_numbers.hpp"

#include "rules/listed.hpp"
#include "rules/path.hpp"

namespace maclint::rules {

std::string NearbyNumbers::operator()(std::int64_t number) {
    if (!numbers_) numbers_ = queries::find_sequence_numbers(analysis_->program());
    std::vector<std::string> words;
    for (const queries::SequenceNumber& block : queries::find_nearest(*numbers_, number))
        words.push_back("N" + std::to_string(block.number) + " (line " +
                        line_number(analysis_->file(), block.at) + ")");
    return listed(words, " and ");
}

} // namespace maclint::rules
