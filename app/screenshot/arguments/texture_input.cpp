#include "app/screenshot/arguments/texture_input.h"

#include "app/screenshot/command.h"
#include "core/codec/texture_file.h"

namespace texplorer::screenshot {

Result<TextureImage> readTexture(const std::string& path) {
    Result<TextureImage> texture = loadTexture(path);
    if (!texture)
        return fail(texture.error());
    for (const std::string& note : texture->notes)
        complain({ErrorCode::Malformed, note, path});
    return texture;
}

} // namespace texplorer::screenshot
