#include "core/emit/emission.h"

#include "core/base/file_io.h"
#include "core/scene/drawn_models.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// Whether anything looks at normals: light, and coordinates that reflect.
bool looksAtNormals(const Pass& pass) {
    const auto reflects = [](const TexGen& generated) {
        return generated.enabled && generated.mode != TexGenMode::ObjectLinear &&
               generated.mode != TexGenMode::EyeLinear;
    };
    return pass.enabled && (pass.lighting || std::ranges::any_of(pass.units, [&](const Unit& unit) {
                                return unit.enabled && (reflects(unit.texGenS) || reflects(unit.texGenT) ||
                                                        reflects(unit.texGenR) || reflects(unit.texGenQ));
                            }));
}

/// What of a program may read the texture's file.
FileReader readerFor(const Texture& texture, const ImageSource& images, const ProgramOptions& options) {
    constexpr std::size_t header = 128;
    const std::shared_ptr<const Bytes> inMemory = images.fileInMemory(texture.file);
    if (texture.source != SourceKind::File || !options.fileName ||
        (inMemory && !options.readsFilesInMemory) || options.fileName(texture.file).empty())
        return FileReader::None;
    if (inMemory)
        return readerOf(*inMemory);
    const Result<Bytes> start = readFileStart(images.directory() / texture.file, header);
    return start ? readerOf(*start) : FileReader::None;
}

} // namespace

Emission::Emission(const Scene& drawn, const ImageSource& images, const ProgramOptions& given,
                   TextureCodes& codes, KeyFrames& moving)
    : scene(drawn)
    , options(given)
    , keys(moving)
    , objects(textureObjectsOf(drawn))
    , isLit(std::ranges::any_of(drawn.passes, [](const Pass& pass) { return pass.enabled && pass.lighting; }))
    , needsNormals(std::ranges::any_of(drawn.passes, looksAtNormals)) {
    writer.explain(given.explained);
    for (CodeWriter* each : {&writer, &atStart, &atEnd})
        each->follow(moving);
    for (const TextureObject& object : objects) {
        const Texture& texture = drawn.textures[object.texture];
        const TexturePictures pictures = images.picturesOf(texture);
        texels.push_back(pictures.base && hasPixels(*pictures.base)
                             ? codes.of(texture, pictures, object.target,
                                        [&] { return readerFor(texture, images, given); })
                             : nullptr);
    }
    for (std::size_t i = 0; i < drawn.models.size(); ++i) {
        bool flips = false;
        for (std::size_t u = 0; u < maxUnits; ++u)
            flips |= flipsCoords(i, u);
        models.push_back(formOf(drawn, i, flips));
    }
}

std::string Emission::passVariable(std::size_t pass) const {
    const auto drawn =
        std::ranges::count_if(scene.passes, [&](const Pass& each) { return drawsAnything(scene, each); });
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
    return std::ranges::any_of(scene.passes, [&](const Pass& pass) {
        const std::vector<std::size_t> drawn = drawnModels(scene, pass);
        const TextureCode* code = pass.units[unit].enabled ? codeOf(pass.units[unit]) : nullptr;
        return code && code->lateFlip == LateFlip::Coordinates &&
               std::ranges::find(drawn, model) != drawn.end();
    });
}

void Emission::addData(const std::string& type, const std::string& name, std::size_t count,
                       std::string numbers) {
    const std::string declaration = fmt::format("static const {} {}[{}]", type, name, count);
    atStart.add({plain(declaration + "; "), {Part::Kind::Comment, "/* at the end */"}});
    atEnd.data(declaration, count, std::move(numbers));
}

std::shared_ptr<const Result<TextureCode>> TextureCodes::of(const Texture& texture,
                                                            const TexturePictures& pictures, Target target,
                                                            const std::function<FileReader()>& reader) {
    const LevelsRequest request{pictures, imageSettings(texture), target};
    for (Kept& each : kept_) {
        if (each.request == request) {
            each.used = true;
            return each.code;
        }
    }
    auto code = std::make_shared<const Result<TextureCode>>(textureCode(texture, pictures, target, reader()));
    kept_.push_back({request, code});
    return code;
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
