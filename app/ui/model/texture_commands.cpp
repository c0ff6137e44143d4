#include "app/ui/model/texture_commands.h"

#include "core/scene/params/keys.h"
#include "core/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

/// What pixel transfer multiplies and adds (OpenGL 2.1, section 3.6.3, table 3.2).
struct Transfer {
    const char* name;
    glm::vec4 ImageStep::*amount;
    int component;
    float initial;
    Key key;
};

constexpr std::array transfers{
    Transfer{"GL_RED_SCALE", &ImageStep::factor, 0, 1, keyOf<&ImageStep::factor>},
    Transfer{"GL_GREEN_SCALE", &ImageStep::factor, 1, 1, keyOf<&ImageStep::factor>},
    Transfer{"GL_BLUE_SCALE", &ImageStep::factor, 2, 1, keyOf<&ImageStep::factor>},
    Transfer{"GL_ALPHA_SCALE", &ImageStep::factor, 3, 1, keyOf<&ImageStep::factor>},
    Transfer{"GL_RED_BIAS", &ImageStep::bias, 0, 0, keyOf<&ImageStep::bias>},
    Transfer{"GL_GREEN_BIAS", &ImageStep::bias, 1, 0, keyOf<&ImageStep::bias>},
    Transfer{"GL_BLUE_BIAS", &ImageStep::bias, 2, 0, keyOf<&ImageStep::bias>},
    Transfer{"GL_ALPHA_BIAS", &ImageStep::bias, 3, 0, keyOf<&ImageStep::bias>},
};

/// The step that can be left to the upload, after all others: nothing is done to the image between.
const ImageStep* lastScale(const Texture& texture) {
    const bool isLast = !texture.preparation.empty() && texture.preparation.back().op == ImageOp::Scale &&
                        texture.transparency == Transparency::File;
    return isLast ? &texture.preparation.back() : nullptr;
}

/// The calls that set what isn't initial, or set it back.
std::vector<Command> transferCommands(const ImageStep& step, const std::string& path, bool back) {
    std::vector<Command> calls;
    for (const Transfer& each : transfers) {
        const float amount = (step.*each.amount)[each.component];
        if (amount != each.initial)
            calls.push_back({Command::Kind::Call,
                             fmt::format("glPixelTransferf({}, {});", each.name,
                                         formatNumber(back ? each.initial : amount)),
                             fmt::format("{}.{}", path, each.key()), true});
    }
    return calls;
}

/// One call for each level, where the texture's has one for all.
std::vector<Command> levelCommands(const Texture& texture, const Command& upload, const std::string& owner) {
    constexpr std::string_view word = ", level, ";
    const std::size_t at = upload.text.find(word);
    if (texture.mipmaps != MipPolicy::Given || at == std::string::npos)
        return {upload};
    std::vector<Command> calls;
    for (std::size_t level = 0; level <= texture.levels.size(); ++level) {
        Command call = upload;
        call.text.replace(at, word.size(), fmt::format(", {}, ", level));
        if (level > 0) {
            call.path = fmt::format("{}.{}.{}", owner, elementOf<&Texture::levels>(level - 1),
                                    keyOf<&GivenLevel::source>());
            call.changed = true;
        }
        calls.push_back(std::move(call));
    }
    return calls;
}

} // namespace

void addImageCommands(const Scene& scene, std::size_t index, std::vector<Command>& block) {
    const Texture& texture = scene.textures[index];
    const auto upload = std::ranges::find_if(block, [](const Command& each) {
        return each.text.starts_with("glTexImage") || each.text.starts_with("glCompressedTexImage");
    });
    if (upload == block.end())
        return;
    const std::string owner = elementOf<&Scene::textures>(index);
    std::vector<Command> calls = levelCommands(texture, *upload, owner);
    if (const ImageStep* scale = lastScale(texture)) {
        const std::string path =
            fmt::format("{}.{}", owner, elementOf<&Texture::preparation>(texture.preparation.size() - 1));
        std::vector<Command> set = transferCommands(*scale, path, false);
        std::vector<Command> back = transferCommands(*scale, path, true);
        calls.insert(calls.begin(), set.begin(), set.end());
        calls.insert(calls.end(), back.begin(), back.end());
    }
    const auto place = block.erase(upload);
    block.insert(place, calls.begin(), calls.end());
}

} // namespace texplorer::ui
