#include "texplorer/codec/texture_file.h"

#include "texplorer/codec/image_file.h"
#include "texplorer/codec/registry.h"
#include "texplorer/files/file_io.h"

namespace texplorer {

Result<TextureImage> loadTexture(const std::filesystem::path& path, const DecodeLimits& limits) {
    const Result<Bytes> file = readImageFile(path);
    if (!file)
        return fail(file.error());
    Result<TextureImage> texture = decodeTexture(*file, limits);
    if (!texture)
        return fail(texture.error().code, texture.error().message, inFile(path.string()));
    return texture;
}

Result<void> saveTexture(const TextureImage& texture, const std::filesystem::path& path,
                         const WriteOptions& options) {
    const CodecRow* format = codecForExtension(path.string());
    if (format == nullptr || !format->encode)
        return fail(ErrorCode::Unsupported,
                    Sentence("expected a name that ends with one of {0}", writtenExtensions(", ")),
                    inFile(path.string()));
    const Result<Bytes> bytes = format->encode(texture, options);
    return bytes ? writeFileAtomically(path, *bytes)
                 : fail(bytes.error().code, bytes.error().message, inFile(path.string()));
}

} // namespace texplorer
