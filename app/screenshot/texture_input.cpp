#include "app/screenshot/texture_input.h"

#include "app/screenshot/command.h"
#include "core/base/file_io.h"

namespace texplorer::screenshot {

Result<TextureImage> readTexture(const std::string& path) {
    const Result<Bytes> bytes = readFile(path);
    if (!bytes)
        return fail(bytes.error());
    Result<TextureImage> texture = decodeTexture(*bytes);
    if (!texture)
        return fail(texture.error().code, texture.error().message, path);
    for (const std::string& note : texture->notes)
        complain({ErrorCode::Malformed, note, path});
    return texture;
}

} // namespace texplorer::screenshot
