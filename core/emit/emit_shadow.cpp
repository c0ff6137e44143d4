// Textures that show what the light sees: a framebuffer object without colours, drawn into in every frame.

#include "texplorer/emit/emission.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

namespace texplorer::emit {
namespace {

bool isShown(const Scene& scene, const KeyFrames& keys, const TextureObject& object) {
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        for (std::size_t u = 0; u < maxUnits && drawsAnything(scene, scene.passes[p]); ++u) {
            const Unit& unit = scene.passes[p].units[u];
            const std::vector<int> textures =
                keys.indicesOf(unitPath(p, u, {keyOf<&Unit::texture>()}), unit.texture);
            if (unit.enabled && unit.target == object.target &&
                std::ranges::find(textures, static_cast<int>(object.texture)) != textures.end())
                return true;
        }
    }
    return false;
}

/// No texture takes part, least of all the one that is drawn into.
void writeUnitOff(Emission& emission, std::size_t unit) {
    std::set<Target> targets;
    for (const Pass& pass : emission.scene.passes) {
        if (drawsAnything(emission.scene, pass) && pass.units.at(unit).enabled)
            targets.insert(pass.units.at(unit).target);
    }
    if (!targets.empty())
        emission.writer.add(fmt::format("glActiveTexture({});", textureUnitName(unit)));
    for (const Target target : targets)
        emission.writer.add(fmt::format("glDisable({});", rowOf(target).name));
}

/// The objects that show it.
std::vector<std::size_t> shadowMapsOf(const Emission& emission) {
    std::vector<std::size_t> maps;
    for (std::size_t i = 0; i < emission.objects.size(); ++i) {
        if (isShadowMap(emission, i))
            maps.push_back(i);
    }
    return maps;
}

} // namespace

std::vector<std::size_t> modelsInLight(const Scene& scene) {
    std::vector<std::size_t> models;
    for (std::size_t m = 0; m < scene.models.size(); ++m) {
        if (isDrawn(scene, m))
            models.push_back(m);
    }
    return models;
}

bool spinsInLight(const Emission& emission) {
    return std::ranges::any_of(modelsInLight(emission.scene), [&](std::size_t m) {
        return emission.scene.models[m].spin != glm::vec3(0) ||
               emission.keys.moves(fmt::format("{}.{}", elementOf<&Scene::models>(m), keyOf<&Model::spin>()));
    });
}

bool isShadowMap(const Emission& emission, std::size_t object) {
    const TextureObject& held = emission.objects[object];
    return emission.scene.textures[held.texture].source == SourceKind::LightDepth &&
           isShown(emission.scene, emission.keys, held);
}

Result<void> checkShadowMaps(const Scene& scene, const KeyFrames& keys) {
    for (const TextureObject& object : textureObjectsOf(scene, keys)) {
        const Texture& texture = scene.textures[object.texture];
        if (texture.source != SourceKind::LightDepth || !isShown(scene, keys, object))
            continue;
        const std::string path = elementOf<&Scene::textures>(object.texture);
        if (object.target != Target::Texture2D)
            return fail(ErrorCode::Unsupported,
                        Sentence("programs support shadow maps for {0}, not for {1}",
                                 rowOf(Target::Texture2D).name, rowOf(object.target).name),
                        path);
        if (!isDepth(texture.internalFormat))
            return refuse(Sentence("programs support shadow maps in depth textures, not {0}",
                                   rowOf(texture.internalFormat).name),
                          path, keyOf<&Texture::internalFormat>());
    }
    return {};
}

void writeShadowMaps(Emission& emission) {
    CodeWriter& writer = emission.writer;
    const Scene& scene = emission.scene;
    for (const std::size_t map : shadowMapsOf(emission)) {
        const Texture& texture = scene.textures[emission.objects[map].texture];
        const Part size =
            whole(texture.depthSize,
                  fmt::format("{}.{}", elementOf<&Scene::textures>(emission.objects[map].texture),
                              keyOf<&Texture::depthSize>()));
        writer.heading("the depths that the light sees");
        writer.open(spinsInLight(emission) ? fmt::format("static void drawShadowMap{}(double seconds)", map)
                                           : fmt::format("static void drawShadowMap{}(void)", map));
        writer.add(fmt::format("glBindFramebuffer(GL_FRAMEBUFFER, shadowMap{});", map));
        writer.add("glPushAttrib(GL_ALL_ATTRIB_BITS);");
        writer.add("glDisable(GL_ALPHA_TEST);", std::ranges::any_of(scene.passes, &Pass::alphaTest));
        for (std::size_t unit = 0; unit < maxUnits; ++unit)
            writeUnitOff(emission, unit);
        writer.add(callWith("glViewport", {plain("0, 0, "), size, plain(", "), size}));
        writer.add("glEnable(GL_DEPTH_TEST);");
        writer.add("glDepthFunc(GL_LESS);");
        writer.add("glClear(GL_DEPTH_BUFFER_BIT);");
        writer.add(fmt::format("glMatrixMode({});", projectionMode));
        writer.add("glLoadIdentity();");
        writeLightProjection(emission);
        writer.add(fmt::format("glMatrixMode({});", modelViewMode));
        writer.add("glLoadIdentity();");
        writeLightView(emission, "lightView");
        for (const Attachment attachment : {Attachment::Eye, Attachment::World}) {
            std::vector<std::size_t> models;
            for (const std::size_t m : modelsInLight(scene)) {
                if (scene.models[m].attachment == attachment)
                    models.push_back(m);
            }
            if (attachment == Attachment::World && !models.empty())
                writeCamera(emission);
            for (const std::size_t model : models)
                writeModelShape(emission, model);
        }
        writer.add("glPopAttrib();");
        writer.add("glBindFramebuffer(GL_FRAMEBUFFER, 0);");
        writer.close();
    }
}

void writeShadowMapCalls(Emission& emission) {
    for (const std::size_t map : shadowMapsOf(emission))
        emission.writer.add(
            fmt::format("drawShadowMap{}({});", map, spinsInLight(emission) ? "seconds" : ""));
}

} // namespace texplorer::emit
