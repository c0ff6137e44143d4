#include "texplorer/suite/stored_picture.h"

#include "texplorer/codec/registry.h"
#include "texplorer/files/file_io.h"

#include <algorithm>

namespace texplorer::suite {
namespace {

/// What stands for a large file in a checkout without `git lfs` (git-lfs, docs/spec.md).
bool isLfsPointer(ByteView file) {
    constexpr std::string_view start = "version https://git-lfs.github.com/spec/";
    return file.size() >= start.size() && std::ranges::equal(file.first(start.size()), viewBytes(start));
}

} // namespace

Result<StoredPicture> readStoredPicture(const std::filesystem::path& file) {
    Result<Bytes> bytes = readFile(file);
    if (!bytes)
        return fail(bytes.error());
    Result<Image> image = decodeImage(*bytes);
    if (image)
        return StoredPicture{*std::move(bytes), *std::move(image)};
    if (isLfsPointer(*bytes))
        return fail(ErrorCode::Malformed,
                    "expected a picture, found a Git LFS pointer: \"git lfs pull\" fetches the picture",
                    inFile(file.string()));
    const ErrorCode code = image.error().code;
    return fail(code == ErrorCode::NotFound ? ErrorCode::Malformed : code, image.error().message,
                inFile(file.string()));
}

bool isNoPicture(const Error& error) {
    return error.code == ErrorCode::Malformed || error.code == ErrorCode::Unsupported;
}

} // namespace texplorer::suite
