#include "texplorer/scene/storage/obj_scene.h"

#include "texplorer/mesh/mesh_file.h"

#include <algorithm>
#include <utility>

namespace texplorer {
namespace {

static_assert(maxMeshParts == maxModels);

Texture textureOf(const std::string& image) {
    Texture texture;
    texture.mipmaps = MipPolicy::Generated;
    texture.minFilter = MinFilter::LinearMipmapLinear;
    if (image.empty())
        return texture;
    texture.source = SourceKind::File;
    texture.file = image;
    return texture;
}

Model modelOf(const ObjPart& part, const ObjMaterial& material) {
    Model model;
    model.name = part.name;
    model.shape = Shape::Mesh;
    model.mesh = part.mesh;
    model.ownMaterial = material.color != glm::vec4(1);
    model.material.color = material.color;
    return model;
}

} // namespace

bool isSmall(const ObjFile& file) {
    std::size_t vertices = 0;
    std::size_t indices = 0;
    for (const ObjPart& part : file.parts) {
        vertices += part.mesh.positions.size();
        indices += part.mesh.indices.size();
    }
    return vertices <= maxMeshVertices && indices <= maxMeshIndices;
}

Scene sceneOf(const ObjFile& file, const std::string& name) {
    Scene scene = defaultScene();
    const Pass like = scene.passes.front();
    scene.models.clear();
    scene.textures.clear();
    scene.passes.clear();
    const bool isOwn = isSmall(file);
    std::vector<std::string> images; // of each pass
    for (const ObjPart& part : file.parts) {
        const ObjMaterial& material = file.materials[static_cast<std::size_t>(part.material)];
        auto pass = std::ranges::find(images, material.image);
        if (pass == images.end() && images.size() == maxPasses)
            pass = images.end() - 1;
        const auto index = static_cast<std::size_t>(pass - images.begin());
        if (pass == images.end()) {
            images.push_back(material.image);
            scene.textures.push_back(textureOf(material.image));
            scene.passes.push_back(like);
            scene.passes.back().units[0].texture = static_cast<int>(index);
        }
        scene.passes[index].models.push_back(static_cast<int>(scene.models.size()));
        scene.models.push_back(modelOf(part, material));
        if (!isOwn) {
            scene.models.back().mesh.file = name;
            scene.models.back().mesh.part = static_cast<int>(scene.models.size()) - 1;
        }
    }
    return scene;
}

} // namespace texplorer
