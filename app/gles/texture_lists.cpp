#include "app/gles/texture_lists.h"

#include "app/gles/texel_list.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::gles {

BoundTexture TextureLists::prepare(const Scene& scene, std::size_t index, Target target,
                                   const ImageSource& images, std::vector<Sentence>& problems) {
    const reference::StoredTexture* stored = store_.prepare(scene, index, target, images, work_, problems);
    if (!stored || !stored->complete)
        return {};
    const ListedTexture& listed = listedOf(*stored, index);
    if (listed.texels)
        return {stored, &listed};
    Sentence problem("{0}: {1}", ProperName{fmt::format("textures[{}]", index)}, listed.problem);
    if (std::ranges::find(problems, problem) == problems.end())
        problems.push_back(std::move(problem));
    return {};
}

void TextureLists::keepOnly(const Scene& scene) {
    store_.keepOnly(scene);
    std::erase_if(lists_, [&scene](const auto& entry) {
        return !reference::isSampled(scene, entry.first.first, entry.first.second);
    });
}

const ListedTexture& TextureLists::listedOf(const reference::StoredTexture& stored, std::size_t texture) {
    ListedTexture& listed = lists_[{texture, stored.sampled.target}];
    if (listed.version == stored.version)
        return listed;
    listed = {}; // before the new one takes its memory
    ListedTexture next;
    const std::size_t count = texelCount(stored.sampled);
    unsigned made = 0;
    if (std::cmp_less_equal(rowsFor(count), device_.maxTextureSize())) {
        TexelList list = texelList(stored.sampled);
        made = device_.makeTexels(list.texels, list.rows, list.floats);
        next.levels = std::move(list.levels);
        next.isUnclamped = list.isUnclamped;
    }
    if (made == 0)
        next.problem = Sentence("the browser can't hold its {0} texels; drawn without it", count);
    else
        next.texels = own(device_, made, &Device::dropTexels);
    next.version = stored.version;
    return listed = std::move(next);
}

} // namespace texplorer::gles
