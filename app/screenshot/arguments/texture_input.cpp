#include "app/screenshot/arguments/texture_input.h"

#include "app/screenshot/arguments/input.h"
#include "app/screenshot/output/messages.h"

namespace texplorer::screenshot {

Result<TextureImage> readTexture(const std::string& path) {
    const Result<Bytes> file = readImageInput(path);
    if (!file)
        return fail(file.error());
    Result<TextureImage> texture = decodeTexture(*file);
    if (!texture)
        return fail(texture.error().code, texture.error().message, inputName(path));
    for (const std::string& note : texture->notes)
        warn({ErrorCode::Malformed, note, inputName(path)});
    return texture;
}

} // namespace texplorer::screenshot
