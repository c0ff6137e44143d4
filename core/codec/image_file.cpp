#include "texplorer/codec/image_file.h"

#include "texplorer/codec/registry.h"

namespace texplorer {

Result<Bytes> readImageFile(const std::filesystem::path& path, std::size_t maxBytes,
                            const ReadObserver& observer) {
    const Result<Bytes> start = readFileStart(path, recognisedBytes);
    if (!start)
        return fail(start.error());
    if (!recogniseImage(*start)) {
        const Error refused = decodeTexture(*start).error();
        return fail(refused.code, refused.message, inFile(path.string()));
    }
    return readFile(path, maxBytes, observer);
}

} // namespace texplorer
