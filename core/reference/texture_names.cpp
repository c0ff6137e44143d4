#include "texplorer/reference/texture_names.h"

#include "texplorer/reference/sampling/lod.h"
#include "texplorer/reference/shading/environment.h"

namespace texplorer::objects {

Sampled sampledBy(const TextureNames& names, std::size_t unit) {
    if (!names.units.at(unit).enabled)
        return Sampled::Off;
    const TextureObject& object = names.objectOf(unit);
    if (!object.picture)
        return Sampled::NoImage;
    return reference::wantsMipmaps(object.state.minFilter) ? Sampled::NoMipmaps // section 3.8.10
                                                           : Sampled::Textured;
}

glm::vec4 colorAfter(const TextureNames& names, std::size_t unit, glm::vec4 before, glm::vec4 texel) {
    if (sampledBy(names, unit) != Sampled::Textured)
        return before;
    return reference::evaluate(names.units.at(unit).envMode, BaseFormat::Rgb,
                               {.previous = before, .source = texel})
        .color;
}

} // namespace texplorer::objects
