#include "app/ui/model/texture_commands.h"

#include "core/gl/pixel_transfer.h"
#include "core/scene/params/keys.h"
#include "core/scene/params/param_text.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::ui {
namespace {

/// The step that can be left to the upload, after all others: nothing is done to the image between.
const ImageStep* lastScale(const Texture& texture) {
    const bool isLast = !texture.preparation.empty() && texture.preparation.back().op == ImageOp::Scale &&
                        texture.transparency == Transparency::File;
    return isLast ? &texture.preparation.back() : nullptr;
}

/// The calls that set what isn't initial, or set it back.
std::vector<Command> transferCommands(const ImageStep& step, const std::string& path, bool back) {
    constexpr int components = 4;
    std::vector<Command> calls;
    const auto add = [&](glm::vec4 amounts, float initial, std::size_t firstRow, const std::string& key) {
        for (int i = 0; i < components; ++i) {
            if (amounts[i] != initial)
                calls.push_back(
                    {Command::Kind::Call,
                     fmt::format("glPixelTransferf({}, {});",
                                 pixelTransferRows.at(firstRow + static_cast<std::size_t>(i)).name,
                                 formatNumber(back ? initial : amounts[i])),
                     fmt::format("{}.{}", path, key), true});
        }
    };
    add(step.factor, 1, 0, keyOf<&ImageStep::factor>());
    add(step.bias, 0, components, keyOf<&ImageStep::bias>());
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
