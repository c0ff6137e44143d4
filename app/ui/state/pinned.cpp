#include "app/ui/state/pinned.h"

#include "texplorer/scene/params/keys.h"

#include <algorithm>
#include <array>

namespace texplorer::ui {

std::string patternOf(std::string_view path) {
    std::string pattern;
    bool isIndex = false;
    for (const char letter : path) {
        isIndex = isIndex && letter != ']';
        if (!isIndex)
            pattern += letter;
        isIndex = isIndex || letter == '[';
    }
    return pattern;
}

bool isPinned(const Settings& settings, std::string_view path) {
    return std::ranges::find(settings.pinned, patternOf(path)) != settings.pinned.end();
}

bool isEssential(std::string_view path) {
    static const std::string texture = keyOf<&Scene::textures>() + "[].";
    static const std::string unit = keyOf<&Scene::passes>() + "[]." + keyOf<&Pass::units>() + "[].";
    static const std::array essential{texture + keyOf<&Texture::source>(),
                                      texture + keyOf<&Texture::pattern>(),
                                      texture + keyOf<&Texture::file>(),
                                      texture + keyOf<&Texture::magFilter>(),
                                      texture + keyOf<&Texture::minFilter>(),
                                      texture + keyOf<&Texture::wrapS>(),
                                      texture + keyOf<&Texture::wrapT>(),
                                      texture + keyOf<&Texture::borderColor>(),
                                      texture + keyOf<&Texture::maxAnisotropy>(),
                                      unit + keyOf<&Unit::enabled>(),
                                      unit + keyOf<&Unit::envMode>(),
                                      unit + keyOf<&Unit::envColor>(),
                                      pathOf<&Scene::material, &Material::color>()};
    return std::ranges::find(essential, patternOf(path)) != essential.end();
}

void togglePin(Settings& settings, std::string_view path) {
    const std::string pattern = patternOf(path);
    if (std::erase(settings.pinned, pattern) == 0)
        settings.pinned.push_back(pattern);
}

} // namespace texplorer::ui
