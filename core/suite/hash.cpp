#include "texplorer/suite/hash.h"

#include "texplorer/files/file_io.h"

#define XXH_INLINE_ALL // the header is all of it: no library to link
#include <fmt/core.h>

#include <xxhash.h>

namespace texplorer::suite {

std::string hashOf(ByteView bytes) {
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string hashOf(std::string_view text) {
    return hashOf(viewBytes(text));
}

void HashedText::add(std::string_view text) {
    text_ += fmt::format("{}:{}\n", text.size(), text);
}

} // namespace texplorer::suite
