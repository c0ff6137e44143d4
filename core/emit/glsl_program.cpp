// OpenGL 3.3, core profile, and C99.

#include "texplorer/diagnosis/applied_texture.h"
#include "texplorer/diagnosis/diagnosis.h"
#include "texplorer/emit/glsl_emission.h"
#include "texplorer/emit/program_frame.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/pass_pictures.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// What a shader has to know of a unit; nothing where it is off, or its texture missing or incomplete.
std::optional<glsl::SampledUnit> sampledUnit(const Emission& emission, const Scene& scene, const Unit& unit) {
    const TextureCode* code = unit.enabled ? emission.codeOf(unit) : nullptr;
    if (!code || code->levels.empty())
        return std::nullopt;
    const Texture& texture = scene.textures[static_cast<std::size_t>(unit.texture)];
    if (!appliedTexture(texture, code->shape, code->lastLevel, {}).completeness.complete())
        return std::nullopt;
    const bool hasDepths = isDepth(code->shape.internalFormat);
    const bool isUnclamped = isFloat(code->shape.internalFormat) || code->blocks == BlockFormat::Bc4Signed ||
                             code->blocks == BlockFormat::Bc5Signed;
    std::array<bool, 3> ends{};
    if (!hasDepths && !readsNearestAlone(texture) && unit.target != Target::CubeMap)
        ends = {texture.wrapS == Wrap::Clamp,
                texture.wrapT == Wrap::Clamp && unit.target != Target::Texture1D,
                texture.wrapR == Wrap::Clamp && unit.target == Target::Texture3D};
    return glsl::SampledUnit{hasDepths ? baseFormat(texture.depthMode) : code->shape.format,
                             code->lateFlip,
                             isUnclamped,
                             hasDepths,
                             hasDepths && texture.compareMode == CompareMode::RToTexture,
                             ends};
}

/// The same of a unit, which has to be so at all times.
std::optional<glsl::SampledUnit> sampledUnit(const Emission& emission, std::size_t pass, std::size_t unit) {
    const std::string path = unitPath(pass, unit, {keyOf<&Unit::texture>()});
    std::vector<std::string> paths{path};
    for (const int texture : emission.keys.indicesOf(path, emission.scene.passes[pass].units[unit].texture)) {
        const auto index = static_cast<std::size_t>(texture);
        for (std::vector<std::string> more :
             {samplerPaths(index),
              texturePaths(index, {keyOf<&Texture::baseLevel>(), keyOf<&Texture::maxLevel>()})})
            paths.insert(paths.end(), more.begin(), more.end());
    }
    return emission.keys.decided(
        emission.scene, paths,
        [&](const Scene& scene) { return sampledUnit(emission, scene, scene.passes[pass].units[unit]); },
        N_("its values need different shaders"));
}

/// The scene with what shaders leave out: a bias of 0, and a material that is the colour alone. Where these
/// move, the shaders have both.
Scene withAllTerms(const Emission& emission) {
    Scene scene = emission.scene;
    const auto showMaterial = [&](Material& material, const std::string& path) {
        if (emission.keys.moves(fmt::format("{}.{}", path, keyOf<&Material::emission>())) ||
            emission.keys.moves(fmt::format("{}.{}", path, keyOf<&Material::colorMaterial>())))
            material.emission = glm::vec4(1);
    };
    showMaterial(scene.material, keyOf<&Scene::material>());
    for (std::size_t m = 0; m < scene.models.size(); ++m)
        showMaterial(scene.models[m].material,
                     fmt::format("{}.{}", elementOf<&Scene::models>(m), keyOf<&Model::material>()));
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        for (std::size_t u = 0; u < maxUnits; ++u) {
            if (emission.keys.moves(unitPath(p, u, {keyOf<&Unit::lodBias>()})))
                scene.passes[p].units[u].lodBias = 1;
        }
    }
    return scene;
}

Result<std::vector<GlslPass>> passesOf(const Emission& emission) {
    std::vector<GlslPass> passes;
    const Scene shaped = emission.keys.empty() ? emission.scene : withAllTerms(emission);
    if (emission.isLit) // a directional light has other shaders
        static_cast<void>(emission.keys.decided(
            emission.scene, {pathOf<&Scene::light, &Light::position>()},
            [](const Scene& scene) { return scene.light.position.w == 0; },
            N_("a directional light has other shaders")));
    for (std::size_t i = 0; i < emission.scene.passes.size(); ++i) {
        const Pass& drawn = emission.scene.passes[i];
        if (!drawsAnything(emission.scene, drawn) || !isSeen(emission.scene, drawn))
            continue;
        GlslPass pass{i, joined(emission.passVariable(i), "program"), emission.passVariable(i), {}, {}, {}};
        for (std::size_t u = 0; u < maxUnits; ++u)
            pass.units[u] = sampledUnit(emission, i, u);
        Result<glsl::ShaderSource> source = glsl::shaderSource(shaped, i, pass.units);
        if (!source)
            return fail(source.error());
        pass.source = std::move(*source);
        findUniforms(pass);
        passes.push_back(std::move(pass));
    }
    return passes;
}

std::vector<VertexArray> arraysOf(const Emission& emission, const std::vector<GlslPass>& passes) {
    std::vector<VertexArray> arrays;
    for (const GlslPass& pass : passes) {
        for (const std::size_t model : drawnModels(emission.scene, emission.scene.passes[pass.index])) {
            VertexArray array{model, coordFormsOf(emission, pass), {}};
            const auto same = [&](const VertexArray& other) { return other.model == model; };
            // An attribute that a shader doesn't ask for may as well be there.
            const auto found = std::ranges::find_if(arrays, [&](const VertexArray& other) {
                return same(other) &&
                       std::ranges::equal(other.coords, array.coords, [](CoordForm a, CoordForm b) {
                           return a == b || a == CoordForm::Off || b == CoordForm::Off;
                       });
            });
            if (found != arrays.end()) {
                for (std::size_t u = 0; u < maxUnits; ++u)
                    found->coords[u] = std::max(found->coords[u], array.coords[u]);
                continue;
            }
            const auto before = std::ranges::count_if(arrays, same);
            array.name = before == 0 ? fmt::format("model{}", model)
                                     : fmt::format("model{}Of{}", model, pass.variable);
            arrays.push_back(std::move(array));
        }
    }
    return arrays;
}

/// How far the coordinates of a target are looked at, and the wrap modes that they have.
std::vector<std::pair<const std::string*, Wrap>> wrapsOf(const Texture& texture, Target target) {
    std::vector<std::pair<const std::string*, Wrap>> wraps{{&keyOf<&Texture::wrapS>(), texture.wrapS}};
    if (target != Target::Texture1D)
        wraps.emplace_back(&keyOf<&Texture::wrapT>(), texture.wrapT);
    if (target == Target::Texture3D)
        wraps.emplace_back(&keyOf<&Texture::wrapR>(), texture.wrapR);
    return wraps;
}

Result<void> sayableTexture(const Texture& texture, const TextureCode& code, Target target,
                            const std::string& path) {
    if (code.border != 0)
        return refuse("textures have no border in OpenGL 3.3's core profile", path,
                      keyOf<&Texture::border>());
    if (readsNearestAlone(texture) || !(isDepth(code.shape.internalFormat) || target == Target::CubeMap))
        return {};
    for (const auto& [key, wrap] : wrapsOf(texture, target)) {
        if (wrap == Wrap::Clamp)
            return refuse(Sentence("OpenGL 3.3's core profile has no {0}, only {1} and {2}", rowOf(wrap).name,
                                   rowOf(Wrap::ClampToEdge).name, rowOf(Wrap::ClampToBorder).name),
                          path, *key);
    }
    return {};
}

/// Whether a program of the core profile can say the scene.
Result<void> sayable(const GlslEmission& glsl) {
    const Scene& scene = glsl.emission.scene;
    for (const GlslPass& pass : glsl.passes) {
        for (std::size_t i = 0; i < maxUnits; ++i) {
            if (!pass.units[i])
                continue;
            Unit unit = scene.passes[pass.index].units[i];
            for (const int texture : glsl.emission.keys.indicesOf(
                     unitPath(pass.index, i, {keyOf<&Unit::texture>()}), unit.texture)) {
                unit.texture = texture;
                const auto index = static_cast<std::size_t>(texture);
                const TextureCode* code = glsl.emission.codeOf(unit);
                if (const Result<void> said = code ? sayableTexture(scene.textures[index], *code, unit.target,
                                                                    elementOf<&Scene::textures>(index))
                                                   : Result<void>();
                    !said)
                    return said;
            }
            if (unit.emboss.enabled && pass.units[i]->lateFlip == LateFlip::Coordinates)
                return refuse("the shaders can't move coordinates of an upside-down image",
                              unitPath(pass.index, i), keyOf<&Unit::emboss>());
        }
    }
    return {};
}

class GlslWriter {
public:
    explicit GlslWriter(GlslEmission& glsl)
        : glsl_(glsl)
        , emission_(glsl.emission)
        , writer_(glsl.emission.writer) {}

    void write() {
        for (const GlslPass& pass : glsl_.passes)
            writeShaders(glsl_, pass);
        writeGlslShadowShaders(glsl_);
        writeTextures(emission_);
        for (std::size_t m = 0; m < emission_.scene.models.size(); ++m)
            writeGlslModelData(glsl_, m);
        writeInit();
        writer_.take(Taking::All);
        writeKeyFrames(emission_);
        writePlace();
        writeGlslShadowMaps(glsl_);
        declareCamera(emission_);
        for (const std::size_t object : picturesOf(emission_))
            writePicture(object);
        writeDraw();
    }

private:
    [[nodiscard]] bool isOne() const { return glsl_.passes.size() == 1; }
    /// Whether the state of the only pass is set once.
    [[nodiscard]] bool isSetOnce() const {
        return isOne() && !hasShadowMaps(glsl_) && picturesOf(emission_).empty();
    }

    void writeInit() {
        writer_.heading("what is set once");
        writer_.open("static void init(void)");
        writer_.heading(keyOf<&Scene::textures>());
        if (emission_.leftOut.size() < emission_.objects.size()) {
            writer_.add(fmt::format("glGenTextures({}, textures);", emission_.objects.size()));
            for (std::size_t i = 0; i < emission_.objects.size(); ++i) {
                if (!emission_.leftOut.contains(i))
                    writer_.add(fmt::format("loadTexture{}();", i));
            }
        }
        for (std::size_t m = 0; m < emission_.scene.models.size(); ++m)
            writeGlslModelSetup(glsl_, m);
        for (const GlslPass& pass : glsl_.passes)
            writeGlslPassSetup(glsl_, pass);
        writeGlslShadowSetup(glsl_);
        if (isSetOnce())
            writeGlslPassState(glsl_, glsl_.passes.front());
        writer_.close();
    }

    /// A function that sets the matrices of a model.
    void writePlace() {
        if (glsl_.passes.empty())
            return;
        emission_.use(CFunction::SetMatrix);
        emission_.use(CFunction::FloatProduct);
        writer_.heading("gives the shader the matrices of a model");
        writer_.open(isOne() ? "static void place(Matrix projection, Matrix modelView)"
                             : "static void place(GLuint program, Matrix projection, Matrix modelView)");
        writer_.add("setMatrix(program, \"modelViewProjection\", multiplyFloats(projection, modelView));");
        if (glsl_.hasUniform("modelView"))
            writer_.add("setMatrix(program, \"modelView\", modelView);");
        if (glsl_.hasUniform("normalMatrix")) {
            emission_.use(CFunction::SetNormalMatrix);
            writer_.add("setNormalMatrix(program, \"normalMatrix\", modelView);");
        }
        writer_.close();
    }

    void writeDraw() {
        writer_.heading("a frame");
        writer_.open(emission_.moves ? "static void draw(int width, int height, double seconds)"
                                     : "static void draw(int width, int height)");
        writeKeyFramesCall(emission_);
        writePictureCalls(emission_);
        writePasses(0);
        writer_.close();
    }

    /// What a picture of passes shows.
    void writePicture(std::size_t object) {
        const int secondsUses = beginPicture(emission_, object);
        if (shownFrames(emission_.scene) > 1)
            writeKeyFramesCall(emission_);
        glsl_.hasModelMatrix = false;
        writePasses(emission_.scene.textures[emission_.objects[object].texture].picture);
        glsl_.hasModelMatrix = false;
        endPicture(emission_, object, secondsUses);
    }

    /// Those of the window or of a picture.
    void writePasses(int picture) {
        const auto isIn = [&](const GlslPass& pass) {
            return emission_.scene.passes[pass.index].picture == picture;
        };
        writeMatrices(emission_, std::ranges::any_of(glsl_.passes, isIn));
        writeMovingTextures(emission_);
        writeGlslShadowCalls(glsl_);
        for (const GlslPass& pass : glsl_.passes) {
            const Pass& drawn = emission_.scene.passes[pass.index];
            if (drawn.picture != picture)
                continue;
            if (!isOne()) {
                writer_.heading(drawn.name.empty() ? fmt::format("pass {}", pass.index)
                                                   : fmt::format("pass {}: {}", pass.index, drawn.name));
            }
            if (!isSetOnce()) {
                writer_.add(fmt::format("glUseProgram({});", pass.program));
                writeGlslPassState(glsl_, pass);
            } else
                writeMovingState(pass);
            writeMovingUniforms(pass);
            for (std::size_t u = 0; u < maxUnits; ++u)
                writeGlslMatrix(glsl_, pass, u, MatrixTime::Frame);
            for (const std::size_t model : drawnModels(emission_.scene, drawn))
                writeGlslModel(glsl_, pass, model);
        }
    }

    void writeMovingState(const GlslPass& pass) {
        const std::size_t start = writer_.size();
        writer_.take(Taking::Moving);
        writeGlslPassState(glsl_, pass);
        writer_.take(Taking::All);
        if (writer_.size() == start + 1) // its heading
            writer_.truncate(start);
    }

    void writeMovingUniforms(const GlslPass& pass) {
        const std::size_t start = writer_.size();
        writer_.heading("what the shaders are told of what moves");
        writer_.take(Taking::Moving);
        writeGlslUniforms(glsl_, pass);
        writer_.take(Taking::All);
        if (writer_.size() == start + 1)
            writer_.truncate(start);
    }

    GlslEmission& glsl_;
    Emission& emission_;
    CodeWriter& writer_;
};

} // namespace

const VertexArray& GlslEmission::arrayOf(const GlslPass& pass, std::size_t model) const {
    const std::array<CoordForm, maxUnits> wanted = coordFormsOf(emission, pass);
    return *std::ranges::find_if(arrays, [&](const VertexArray& array) {
        return array.model == model &&
               std::ranges::equal(wanted, array.coords, [](CoordForm asked, CoordForm has) {
                   return asked == CoordForm::Off || asked == has;
               });
    });
}

bool GlslEmission::hasUniform(std::string_view name) const {
    return std::ranges::any_of(passes, [&](const GlslPass& pass) { return pass.uniforms.contains(name); });
}

namespace {

void leaveOut(GlslEmission& glsl) {
    Emission& emission = glsl.emission;
    for (std::size_t i = 0; i < emission.objects.size(); ++i) {
        const bool isShown = std::ranges::any_of(glsl.passes, [&](const GlslPass& pass) {
            for (std::size_t u = 0; u < maxUnits; ++u) {
                const Unit& unit = emission.scene.passes[pass.index].units[u];
                const bool isOne = emission.keys.moves(unitPath(pass.index, u, {keyOf<&Unit::texture>()})) ||
                                   static_cast<std::size_t>(unit.texture) == emission.objects[i].texture;
                if (pass.units[u] && isOne && emission.objects[i].target == unit.target)
                    return true;
            }
            return false;
        });
        if (!isShown)
            emission.leftOut.insert(i);
    }
}

} // namespace

Result<std::vector<Line>> glslProgram(const Scene& scene, const ImageSource& images,
                                      const ProgramOptions& options, TextureCodes& codes, KeyFrames& keys) {
    if (const Result<void> possible = checkMeshes(scene); !possible)
        return fail(possible.error());
    if (const Result<void> possible = checkShadowMaps(scene, keys); !possible)
        return fail(possible.error());
    if (const Result<void> possible = checkPictures(scene, keys); !possible)
        return fail(possible.error());
    bool moves = false;
    for (const bool isTrial : {true, false}) {
        Emission emission(Flavour::Glsl, scene, images, options, codes, keys);
        emission.moves = moves;
        Result<std::vector<GlslPass>> passes = passesOf(emission);
        if (!passes)
            return fail(passes.error());
        GlslEmission glsl{emission, std::move(*passes), {}};
        glsl.arrays = arraysOf(emission, glsl.passes);
        if (const Result<void> said = sayable(glsl); !said)
            return fail(said.error());
        leaveOut(glsl);
        GlslWriter(glsl).write();
        moves = emission.writer.usesSeconds() || keys.isUsed();
        if (isTrial)
            continue;
        return framed(std::move(emission),
                      {.hints = {"GLFW_CONTEXT_VERSION_MAJOR, 3", "GLFW_CONTEXT_VERSION_MINOR, 3",
                                 "GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE"},
                       .headers = {"stddef.h"}});
    }
    return fail(ErrorCode::Unsupported, "the program can't be made"); // not reached
}

} // namespace texplorer::emit
