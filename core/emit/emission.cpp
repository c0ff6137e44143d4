#include "texplorer/emit/emission.h"

#include "texplorer/files/file_io.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/pass_pictures.h"

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <utility>

namespace texplorer::emit {
namespace {

/// Whether a pass looks at normals: for light, or for coordinates that reflect.
bool looksAtNormals(const Scene& scene, const KeyFrames& keys, std::size_t index) {
    const auto reflects = [](TexGenMode mode) {
        return mode != TexGenMode::ObjectLinear && mode != TexGenMode::EyeLinear;
    };
    const Pass& pass = scene.passes[index];
    bool looks = pass.lighting;
    for (std::size_t u = 0; u < maxUnits; ++u) {
        for (const auto& [state, key, letter] : generatedCoordinates) {
            const TexGen& generated = pass.units[u].*state;
            const std::string path = unitPath(index, u, {key(), keyOf<&TexGen::mode>()});
            looks |= pass.units[u].enabled && generated.enabled && keys.mayBe(path, generated.mode, reflects);
        }
    }
    return pass.enabled && looks;
}

/// A file that the program may read instead of being given its texels.
bool mayRead(const Texture& texture, const ImageSource& images, const ProgramOptions& options) {
    return texture.source == SourceKind::File && options.fileName &&
           (options.readsFilesInMemory || !images.fileInMemory(texture.file)) &&
           !options.fileName(texture.file).empty();
}

/// Whether glPixelTransferf can prepare a texture's image: a scale is all that does, and levels that are made
/// of the scaled image are those of the image, scaled.
bool isTransferred(const Texture& texture, const TextureImage& image) {
    if (texture.preparation.size() != 1 || texture.preparation.front().op != ImageOp::Scale ||
        texture.transparency != Transparency::File || texture.border != 0 ||
        texture.npot != NpotPolicy::Keep || texture.oversize != Oversize::None ||
        isDepth(texture.internalFormat) || hasFewBits(texture.internalFormat) ||
        isFloat(texture.internalFormat) || // which limits nothing
        texture.source == SourceKind::LightDepth || texture.compression == Compression::Driver ||
        texture.compression == Compression::Cached || texture.upload.custom ||
        !std::holds_alternative<Image>(image.surfaces.front()))
        return false;
    const ImageStep& step = texture.preparation.front();
    const glm::vec4 white = step.factor + step.bias;
    const bool clamps = glm::any(glm::lessThan(glm::min(step.bias, white), glm::vec4(0))) ||
                        glm::any(glm::greaterThan(glm::max(step.bias, white), glm::vec4(1)));
    return texture.mipmaps == MipPolicy::None || texture.mipmaps == MipPolicy::GenerateMipmap ||
           texture.mipmaps == MipPolicy::OnUpload || (texture.mipmaps == MipPolicy::Glu && !clamps);
}

/// The texture with the mipmap functions that a program may call: OpenGL 3.1 removed the parameter, and GLU
/// belongs to OpenGL 2.1.
Texture withCallsOf(Flavour flavour, const Texture& texture, const TextureImage& image,
                    const ProgramOptions& options) {
    const bool isCore = flavour == Flavour::Glsl;
    Texture settings = texture;
    if (!isCore) { // makes the call that OpenGL refuses, and is drawn as if the unit were off
        settings.border = std::min(texture.border, 1);
        if (isRefused(texture.internalFormat))
            settings.internalFormat = internalFormat(baseFormat(texture.internalFormat));
    }
    // Of a custom upload the levels are made of what it reads.
    if (!texture.upload.custom && (options.selfContained || (isCore && texture.mipmaps == MipPolicy::Glu)))
        return withGeneratedLevels(settings);
    if (!isCore && isTransferred(texture, image))
        settings.preparation.clear();
    if (isCore && texture.mipmaps == MipPolicy::OnUpload)
        settings.mipmaps = MipPolicy::GenerateMipmap;
    return settings;
}

/// Whether a program can make the call: OpenGL 3.3's core profile has no luminance, and scales nothing.
bool hasCall(Flavour flavour, const Upload& upload) {
    return flavour == Flavour::Fixed || (componentsOf(upload.format).find('l') == std::string_view::npos &&
                                         upload.format != TransferFormat::Alpha &&
                                         upload.scale == glm::vec4(1) && upload.bias == glm::vec4(0));
}

/// What of a program reads it.
FileReader readerFor(const TexelRequest& request) {
    constexpr std::size_t header = 128;
    if (request.fileInMemory)
        return readerOf(*request.fileInMemory);
    const Result<Bytes> start = request.file.empty() ? Bytes{} : readFileStart(request.file, header);
    return start ? readerOf(*start) : FileReader::None;
}

/// What a program has to be given of the texture objects of a standing scene.
std::vector<std::optional<TexelRequest>> requestsOf(Flavour flavour, const Scene& scene,
                                                    const KeyFrames& keys, const ImageSource& images,
                                                    const ProgramOptions& options) {
    std::vector<std::optional<TexelRequest>> requests;
    for (const TextureObject& object : textureObjectsOf(scene, keys)) {
        const Texture& texture = scene.textures[object.texture];
        TexturePictures pictures = images.picturesOf(texture);
        std::optional<TexelRequest>& request = requests.emplace_back();
        if (!pictures.base || !hasPixels(*pictures.base))
            continue;
        const Texture settings = imageSettings(withCallsOf(flavour, texture, *pictures.base, options));
        request.emplace(TexelRequest{{std::move(pictures), settings, object.target}});
        request->readsMemory = hasCall(flavour, texture.upload);
        if (mayRead(texture, images, options)) {
            request->file = images.directory() / texture.file;
            request->fileInMemory = images.fileInMemory(texture.file);
        }
    }
    return requests;
}

} // namespace

std::string unitPath(std::size_t pass, std::size_t unit, std::initializer_list<std::string_view> keys) {
    std::string path = fmt::format("{}.{}", elementOf<&Scene::passes>(pass), elementOf<&Pass::units>(unit));
    for (const std::string_view key : keys)
        path += fmt::format(".{}", key);
    return path;
}

Emission::Emission(Flavour flavour, const Scene& drawn, const ImageSource& images,
                   const ProgramOptions& given, TextureCodes& codes, KeyFrames& moving)
    : scene(drawn)
    , options(given)
    , keys(moving)
    , objects(textureObjectsOf(drawn, moving))
    , isCore(flavour == Flavour::Glsl)
    , isLit(
          std::ranges::any_of(drawn.passes, [](const Pass& pass) { return pass.enabled && pass.lighting; })) {
    for (std::size_t p = 0; p < drawn.passes.size(); ++p)
        needsNormals |= looksAtNormals(drawn, moving, p);
    writer.explain(given.explained);
    for (CodeWriter* each : {&writer, &atStart, &atEnd})
        each->follow(moving);
    for (const std::optional<TexelRequest>& request : requestsOf(flavour, drawn, moving, images, given)) {
        if (request && request->levels.settings.preparation.empty() &&
            !drawn.textures[objects[texels.size()].texture].preparation.empty())
            transferred.insert(texels.size());
        texels.push_back(request ? codes.of(*request) : nullptr);
    }
    lateFlips.resize(drawn.passes.size());
    for (std::size_t p = 0; p < drawn.passes.size(); ++p) {
        for (std::size_t u = 0; u < maxUnits && drawsAnything(drawn, drawn.passes[p]); ++u)
            lateFlips[p][u] = keys.decided(
                drawn, {unitPath(p, u, {keyOf<&Unit::texture>()})},
                [&](const Scene& other) {
                    const Unit& unit = other.passes[p].units[u];
                    const TextureCode* code = unit.enabled ? codeOf(unit) : nullptr;
                    return code ? code->lateFlip : LateFlip::None;
                },
                N_("only some of its images are upside down"));
    }
    for (std::size_t i = 0; i < drawn.models.size(); ++i) {
        bool flips = false;
        for (std::size_t u = 0; u < maxUnits; ++u)
            flips |= flipsCoords(i, u);
        models.push_back(formOf(drawn, i, flips));
    }
    if (!isCore && !given.selfContained)
        takeGlu(*this);
    if (!keys.empty())
        refuseShapes();
}

void Emission::refuseShapes() {
    for (std::size_t m = 0; m < scene.models.size(); ++m) {
        const std::string path = elementOf<&Scene::models>(m);
        for (const std::string& key :
             {keyOf<&Model::slices>(), keyOf<&Model::stacks>(), keyOf<&Model::topRadius>(),
              keyOf<&Model::innerRadius>(), keyOf<&Model::tubeRadius>(), keyOf<&Model::startAngle>(),
              keyOf<&Model::sweepAngle>()}) {
            if (const std::string param = fmt::format("{}.{}", path, key);
                keys.moves(param) && models[m].drawing != Drawing::None &&
                models[m].drawing != Drawing::Quadric)
                keys.refuse(param, N_("shapes are made only when the program starts"));
        }
    }
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        const std::vector<std::size_t> drawn = drawnModels(scene, scene.passes[p]);
        for (std::size_t u = 0; u < maxUnits; ++u) {
            std::vector<std::string> paths;
            for (const auto& [state, key, letter] : generatedCoordinates)
                paths.push_back(unitPath(p, u, {key(), keyOf<&TexGen::enabled>()}));
            for (const std::size_t m : drawn)
                static_cast<void>(keys.decided(
                    scene, paths,
                    [&](const Scene& other) { return takesCoords(other, other.passes[p], u, m); },
                    N_("only some of its values need the vertices' coordinates")));
        }
    }
}

std::string Emission::passVariable(std::size_t pass) const {
    const auto drawn = std::ranges::count_if(
        scene.passes, [&](const Pass& each) { return drawsAnything(scene, each) && isSeen(scene, each); });
    return drawn > 1 ? fmt::format("pass{}", pass) : std::string();
}

const TextureCode* Emission::codeOf(const Unit& unit) const {
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (objects[i] == TextureObject{static_cast<std::size_t>(unit.texture), unit.target})
            return texels[i] && *texels[i] ? &**texels[i] : nullptr;
    }
    return nullptr;
}

bool Emission::flipsCoords(std::size_t model, std::size_t unit) const {
    for (std::size_t p = 0; p < scene.passes.size(); ++p) {
        const std::vector<std::size_t> drawn = drawnModels(scene, scene.passes[p]);
        if (std::ranges::find(drawn, model) != drawn.end() && lateFlips[p][unit] == LateFlip::Coordinates)
            return true;
    }
    return false;
}

void Emission::addData(const std::string& type, const std::string& name, std::size_t count, Numbers numbers) {
    const std::string declaration = fmt::format("static const {} {}[{}]", type, name, count);
    atStart.add({plain(declaration + "; "), {Part::Kind::Comment, "/* at the end */"}});
    atEnd.data(declaration, count, std::move(numbers));
}

std::vector<std::optional<TexelRequest>>
texelRequests(Flavour flavour, const Scene& scene, const ImageSource& images, const ProgramOptions& options) {
    if (scene.timeline.keys.empty())
        return requestsOf(flavour, scene, {}, images, options);
    const KeyFrames keys(flavour, scene);
    return requestsOf(flavour, keys.standing(), keys, images, options);
}

TextureCodes::Code TextureCodes::of(const TexelRequest& request) {
    const auto kept = std::ranges::find(kept_, request, &Kept::request);
    if (kept != kept_.end()) {
        kept->used = true;
        return kept->code;
    }
    const LevelsRequest& levels = request.levels;
    auto code = std::make_shared<const Result<TextureCode>>(textureCode(
        levels.settings, levels.pictures, levels.target, readerFor(request), work_, request.readsMemory));
    if (*code || code->error().code != ErrorCode::Cancelled)
        keep(request, code);
    return code;
}

bool TextureCodes::has(const TexelRequest& request) const {
    return std::ranges::find(kept_, request, &Kept::request) != kept_.end();
}

void TextureCodes::keep(TexelRequest request, Code code) {
    kept_.push_back({std::move(request), std::move(code)});
}

Result<void> checkMeshes(const Scene& scene) {
    for (std::size_t m = 0; m < scene.models.size(); ++m) {
        const MeshData& mesh = scene.models[m].mesh;
        if (scene.models[m].shape == Shape::Mesh && mesh.positions.size() > maxMeshVertices)
            return fail(ErrorCode::TooLarge,
                        Sentence("the mesh has {0} vertices; a program has at most {1} in its text",
                                 mesh.positions.size(), maxMeshVertices),
                        fmt::format("{}.{}", elementOf<&Scene::models>(m), keyOf<&Model::mesh>()));
    }
    return {};
}

std::set<std::string> filesRead(const std::vector<Line>& program, const Scene& scene) {
    std::set<std::string> files;
    for (const FileName& each : fileNamesOf(scene)) {
        const bool isRead = std::ranges::any_of(program, [&](const Line& line) {
            return std::ranges::any_of(line.parts, [&](const Part& part) {
                return part.kind == Part::Kind::Plain && part.path == each.path; // a comment may name it, too
            });
        });
        if (isRead)
            files.insert(each.file);
    }
    return files;
}

void TextureCodes::forgetUnused() {
    std::erase_if(kept_, [](const Kept& each) { return !each.used; });
    for (Kept& each : kept_)
        each.used = false;
}

} // namespace texplorer::emit
