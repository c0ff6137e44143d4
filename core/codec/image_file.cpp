#include "core/codec/image_file.h"

#include "core/base/file_io.h"
#include "core/codec/registry.h"

namespace texplorer {

Result<ImageFile> readImageFile(const std::filesystem::path& path) {
    const Result<Bytes> file = readFile(path);
    if (!file)
        return fail(file.error());
    Result<Image> image = decodeImage(*file);
    if (!image)
        return fail(image.error().code, image.error().message, path.string());
    return ImageFile{recogniseImage(*file)->name, file->size(), *std::move(image)};
}

} // namespace texplorer
