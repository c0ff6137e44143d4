#include "app/screenshot/texture_io.h"

#include "core/base/file_io.h"

namespace texplorer::screenshot {

Result<TextureImage> readTexture(const std::string& path) {
    const Result<Bytes> bytes = readFile(path);
    if (!bytes)
        return fail(bytes.error());
    Result<TextureImage> texture = decodeTexture(*bytes);
    if (!texture)
        return fail(texture.error().code, texture.error().message, path);
    return texture;
}

Result<const CodecRow*> writerFor(const std::string& path) {
    const CodecRow* codec = codecForExtension(path);
    if (codec && codec->encode)
        return codec;
    std::string known;
    for (const CodecRow& row : codecRows())
        if (row.encode)
            known.append(known.empty() ? "" : ", ").append(extensionsOf(row).front());
    return fail(ErrorCode::Unsupported,
                "expected a name that ends in one of " + known + ", found \"" + path + "\"");
}

Result<void> writeTexture(const std::string& path, const TextureImage& texture, const WriteOptions& options) {
    const Result<const CodecRow*> codec = writerFor(path);
    if (!codec)
        return fail(codec.error());
    const Result<Bytes> bytes = (*codec)->encode(texture, options);
    if (!bytes)
        return fail(bytes.error().code, bytes.error().message, path);
    return writeFileAtomically(path, *bytes);
}

} // namespace texplorer::screenshot
