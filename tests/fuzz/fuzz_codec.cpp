// The decoders. `fuzz_codec --codec=TGA` passes every input to that row, regardless of its first bytes;
// without a name every input goes through all rows in turn, and to the one that recognises it.

#include "tests/fuzz/broken.h"
#include "tests/support/codec_promises.h"
#include "tests/support/png_repair.h"

#include <algorithm>
#include <cstring>

// libFuzzer's own mutations; it defines these.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace {

using namespace texplorer;

// A picture of 64 MiB finds as many errors as a larger one, and faster.
constexpr DecodeLimits limits{.maxBytes = std::size_t{64} << 20};

const CodecRow* chosen = nullptr;

void check(const CodecRow& row, ByteView file) {
    if (const std::string what = test::brokenPromise(row, file, limits); !what.empty())
        fuzz::broken(std::string(row.name) + ": " + what);
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
    constexpr std::string_view option = "--codec=";
    for (int i = 1; i < *count; ++i) {
        const std::string_view argument = (*arguments)[i];
        if (!argument.starts_with(option))
            continue;
        const auto found = std::ranges::find(codecRows(), argument.substr(option.size()), &CodecRow::name);
        if (found == codecRows().end())
            fuzz::broken("there is no codec row of the name in " + std::string(argument));
        chosen = &*found;
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView file = std::as_bytes(std::span(data, size));
    if (chosen) {
        check(*chosen, file);
        return 0;
    }
    for (const CodecRow& row : codecRows())
        check(row, file);
    const CodecRow* recognised = recogniseImage(file);
    const Result<Image> image = decodeImage(file, limits);
    if (!recognised && image)
        fuzz::broken("a file that no row recognises was decoded");
    if (!image && !test::isOneLine(image.error().message))
        fuzz::broken("the error isn't one line: " + image.error().message.english());
    if (dissect(file).format != (recognised ? recognised->name : std::string_view()))
        fuzz::broken("another row dissects the file than recognises it");
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
    const std::size_t mutated = LLVMFuzzerMutate(data, size, maxSize);
    if (seed % 16 != 0) // inputs with wrong checksums are useful, too
        test::repairPng(std::as_writable_bytes(std::span(data, mutated)));
    return mutated;
}
