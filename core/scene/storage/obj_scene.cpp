#include "texplorer/scene/storage/obj_scene.h"

#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cctype>
#include <limits>
#include <string>
#include <system_error>
#include <utility>

namespace texplorer {
namespace {

constexpr std::size_t maxMaterialBytes = std::size_t{4} << 20;

/// How far from the middle the models reach.
constexpr double radius = 2;

struct Box {
    glm::dvec3 middle{0};
    double scale = 1; ///< its corners are then at `radius`
};

Box boxAround(const ObjFile& file) {
    glm::vec3 low(std::numeric_limits<float>::max());
    glm::vec3 high(std::numeric_limits<float>::lowest());
    for (const ObjPart& part : file.parts) {
        for (const glm::vec3& position : part.mesh.positions) {
            low = glm::min(low, position);
            high = glm::max(high, position);
        }
    }
    const glm::dvec3 middle = (glm::dvec3(low) + glm::dvec3(high)) / 2.0;
    const double half = glm::length(glm::dvec3(high) - middle);
    return {middle, half > 0 ? radius / half : 1};
}

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

Model modelOf(const ObjPart& part, const ObjMaterial& material, const Box& box) {
    Model model;
    model.name = part.name;
    model.shape = Shape::Mesh;
    model.mesh = part.mesh;
    for (glm::vec3& position : model.mesh.positions)
        position = glm::vec3((glm::dvec3(position) - box.middle) * box.scale);
    model.ownMaterial = material.color != glm::vec4(1);
    model.material.color = material.color;
    return model;
}

} // namespace

bool isObjName(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char each) { return static_cast<char>(std::tolower(each)); });
    return extension == ".obj";
}

Scene sceneOf(const ObjFile& file) {
    Scene scene = defaultScene();
    const Pass like = scene.passes.front();
    scene.models.clear();
    scene.textures.clear();
    scene.passes.clear();
    const Box box = boxAround(file);
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
        scene.models.push_back(modelOf(part, material, box));
    }
    return scene;
}

Result<ObjScene> objSceneIn(ByteView file, const std::filesystem::path& folder) {
    ObjScene read;
    const auto materials = [&](const std::string& name) -> std::optional<std::string> {
        const std::filesystem::path library = folder / name;
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(library, ignored)) // a pipe would be waited for
            return std::nullopt;
        Result<std::string> text = readText(library, maxMaterialBytes);
        if (!text)
            return std::nullopt;
        read.libraries.push_back(library);
        return *std::move(text);
    };
    Result<ObjFile> decoded = decodeObj(file, materials, maxModels);
    if (!decoded)
        return fail(decoded.error());
    read.scene = sceneOf(*decoded);
    read.notes = std::move(decoded->notes);
    return read;
}

} // namespace texplorer
