#include "app/screenshot/arguments/texture_input.h"

#include "app/screenshot/arguments/input.h"
#include "app/screenshot/output/messages.h"

namespace texplorer::screenshot {

Result<TextureImage> readTexture(const std::string& path) {
    const Result<Bytes> file = readImageInput(path);
    if (!file)
        return fail(file.error());
    DecodeLimits limits;
    limits.everything = true;
    Result<TextureImage> texture = decodeTexture(*file, limits);
    if (!texture)
        return fail(texture.error().code, texture.error().message, inFile(inputName(path)));
    for (const std::vector<Sentence>& sentences : {texture->notes, texture->remarks})
        for (const Sentence& sentence : sentences)
            warn({ErrorCode::Malformed, sentence, inFile(inputName(path))});
    return texture;
}

} // namespace texplorer::screenshot
