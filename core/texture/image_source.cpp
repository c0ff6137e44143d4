#include "texplorer/texture/image_source.h"

#include "texplorer/codec/image_file.h"
#include "texplorer/files/file_fingerprint.h"
#include "texplorer/image/patterns/pattern.h"
#include "texplorer/texture/image_loader.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>

namespace texplorer {

namespace {

/// A picture of ours: there is no file whose first row could be the top one.
TextureImage madeHere(Image image) {
    TextureImage texture = textureOf(std::move(image), {});
    texture.fileTopFirst = false;
    return texture;
}

using SharedImage = std::shared_ptr<const TextureImage>;

Result<SharedImage> readImage(const std::filesystem::path& path, std::size_t left, Decoding decoding) {
    const Result<Bytes> file = readImageFile(path);
    if (!file)
        return fail(file.error());
    Result<TextureImage> texture = decodeWithin(*file, left, decoding);
    if (!texture)
        return fail(texture.error().code, texture.error().message, inFile(path.string()));
    return std::make_shared<const TextureImage>(std::move(*texture));
}

using SharedMeshes = std::shared_ptr<const MeshFile>;

Result<SharedMeshes> readMeshes(const std::filesystem::path& path, std::size_t left) {
    if (!isObjName(path))
        return fail(ErrorCode::Unsupported, "expected an OBJ file, whose name ends with .obj",
                    inFile(path.string()));
    Result<ImageLoader::Content> content = loadNow(path, ImageLoader::Wanted::Texture, left);
    if (!content)
        return fail(content.error());
    return std::get<SharedMeshes>(*std::move(content));
}

// Patterns are constants that are worked out when they are first asked for; every source shares them.
std::shared_ptr<const TextureImage> sharedPattern(Pattern pattern) {
    struct Constant {
        std::once_flag drawn;
        std::shared_ptr<const TextureImage> image;
    };
    static std::array<Constant, patternRows.size()> constants;

    const auto index = static_cast<std::size_t>(pattern);
    if (index >= constants.size())
        return nullptr;
    Constant& constant = constants[index];
    std::call_once(constant.drawn, [&] {
        constant.image = std::make_shared<const TextureImage>(madeHere(drawPattern(pattern)));
    });
    return constant.image;
}

template<class AScene, class Visit> ///< visit(source, file, whether the texture wants it, path of the file)
void forEachPicture(AScene& scene, Visit visit) {
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        auto& texture = scene.textures[i];
        const std::string path = fmt::format("textures[{}].", i);
        visit(texture.source, texture.file, true, path + "file");
        for (std::size_t level = 0; level < texture.levels.size(); ++level)
            visit(texture.levels[level].source, texture.levels[level].file,
                  texture.mipmaps == MipPolicy::Given, fmt::format("{}levels[{}].file", path, level));
        for (std::size_t step = 0; step < texture.preparation.size(); ++step)
            visit(texture.preparation[step].source, texture.preparation[step].file,
                  readsOther(texture.preparation[step]), fmt::format("{}preparation[{}].file", path, step));
        for (std::size_t subimage = 0; subimage < texture.subimages.size(); ++subimage)
            visit(texture.subimages[subimage].source, texture.subimages[subimage].file, true,
                  fmt::format("{}subimages[{}].file", path, subimage));
    }
}

/// The texts that a parameter has at its key frames.
std::vector<std::string> keyValuesOf(const Scene& scene, std::string_view path) {
    std::vector<std::string> values;
    for (const KeyFrame& key : scene.timeline.keys)
        if (key.path == path)
            values.push_back(key.value);
    return values;
}

/// Whether key frames decide what a texture makes of the files that it names: at some time it may want any.
bool changesItsPictures(const Scene& scene, const std::string& filePath) {
    const std::string texture = filePath.substr(0, filePath.find('.') + 1);
    return std::ranges::any_of(scene.timeline.keys, [&](const KeyFrame& key) {
        const std::string_view path = key.path;
        return path.starts_with(texture) &&
               (path.ends_with(".source") || path.ends_with(".mipmaps") ||
                path.starts_with(texture + "preparation[") || path.starts_with(texture + "subimages["));
    });
}

/// One image for each size, as long as it is used: all bytes have the value.
SharedImage uniform(PixelFormat format, int size, std::byte value) {
    static std::mutex mutex;
    static std::map<std::pair<PixelFormat, int>, std::weak_ptr<const TextureImage>> images;
    const int extent = std::max(size, 1);
    const std::lock_guard lock(mutex);
    std::weak_ptr<const TextureImage>& known = images[{format, extent}];
    if (SharedImage image = known.lock())
        return image;
    Image pixels = Image::uninitialised(format, extent, extent);
    std::ranges::fill(pixels.pixels, value);
    SharedImage image = drawnImage(std::move(pixels));
    known = image;
    return image;
}

SharedImage farthestDepths(int size) {
    return uniform(PixelFormat::Depth32, size, std::byte{255});
}

SharedImage blackPicture(int size) {
    return uniform(PixelFormat::Rgba8, size, std::byte{0});
}

} // namespace

ImageSource::ImageSource(std::filesystem::path directory)
    : directory_(std::move(directory)) {}

std::vector<Error> ImageSource::loadAll(const Scene& scene, Decoding decoding, std::size_t budget) {
    std::vector<Error> errors;
    std::map<FileFingerprint, Result<SharedImage>> read;
    std::map<std::string, Error> refused; // meshes
    std::size_t used = bytesOf(filesOf(scene));
    for (const FileName& name : fileNamesOf(scene)) {
        if (!name.used || holds(name.file))
            continue;
        if (name.file.empty()) {
            errors.push_back(
                {ErrorCode::NotFound, N_("an image file is needed, but none is named"), name.path});
            continue;
        }
        const std::filesystem::path path = directory_ / name.file;
        if (name.isMesh) {
            if (!refused.contains(name.file)) {
                if (auto meshes = readMeshes(path, budget - std::min(budget, used))) {
                    used += byteCount(**meshes);
                    put(name.file, *std::move(meshes));
                    continue;
                } else {
                    refused.emplace(name.file, meshes.error());
                }
            }
            errors.push_back(within(name.path, refused.at(name.file)));
            continue;
        }
        const std::optional<FileFingerprint> same = fingerprintOf(path);
        const auto known = same ? read.find(*same) : read.end();
        const Result<SharedImage> image =
            known != read.end() ? known->second : readImage(path, budget - std::min(budget, used), decoding);
        if (image) {
            used += known != read.end() ? 0 : byteCount(**image);
            put(name.file, *image);
        } else {
            errors.push_back(within(name.path, image.error()));
        }
        if (same)
            read.emplace(*same, image);
    }
    return errors;
}

Result<void> ImageSource::load(const Scene& scene, std::size_t budget) {
    std::vector<Error> errors = loadAll(scene, Decoding::Pixels, budget);
    if (!errors.empty())
        return fail(std::move(errors.front()));
    return {};
}

std::size_t ImageSource::bytesOf(const std::set<std::string>& files) const {
    std::set<SharedImage> images;
    for (const std::string& file : files)
        if (const auto found = files_.find(file); found != files_.end())
            images.insert(found->second);
    std::size_t bytes = 0;
    for (const std::string& file : files)
        if (const auto found = meshes_.find(file); found != meshes_.end())
            bytes += byteCount(*found->second);
    for (const SharedImage& image : images)
        bytes += byteCount(*image);
    return bytes;
}

std::vector<FileName> fileNamesOf(const Scene& scene) {
    std::vector<FileName> names;
    forEachPicture(scene, [&](SourceKind source, const std::string& file, bool wanted, std::string path) {
        const bool used =
            (wanted && source == SourceKind::File) || (!file.empty() && changesItsPictures(scene, path));
        const std::vector<std::string> later = keyValuesOf(scene, path);
        names.push_back({path, file, used && later.empty()});
        for (const std::string& each : later)
            names.push_back({path, each, used});
    });
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        const Model& model = scene.models[i];
        if (!model.mesh.file.empty())
            names.push_back(
                {fmt::format("models[{}].mesh.file", i), model.mesh.file, model.shape == Shape::Mesh, true});
    }
    return names;
}

std::set<std::string> filesOf(const Scene& scene) {
    std::set<std::string> files;
    for (FileName& name : fileNamesOf(scene))
        if (name.used)
            files.insert(std::move(name.file));
    return files;
}

void renameFiles(Scene& scene, const std::function<std::string(const std::string& file)>& rename) {
    forEachPicture(scene, [&](SourceKind, std::string& file, bool, const std::string& path) {
        if (!file.empty())
            file = rename(file);
        for (KeyFrame& key : scene.timeline.keys)
            if (key.path == path && !key.value.empty())
                key.value = rename(key.value);
    });
    for (Model& model : scene.models)
        if (!model.mesh.file.empty())
            model.mesh.file = rename(model.mesh.file);
}

void ImageSource::fillMeshes(Scene& scene) const {
    for (Model& model : scene.models)
        if (!model.mesh.file.empty())
            model.mesh = meshOf(model.mesh, meshesOf(model.mesh.file).get());
}

bool ImageSource::hasFilled(const Scene& scene) const {
    return std::ranges::all_of(scene.models, [&](const Model& model) {
        const MeshData& mesh = model.mesh;
        return mesh.file.empty() || mesh == meshOf(mesh, meshesOf(mesh.file).get());
    });
}

void ImageSource::put(const std::string& file, Image image) {
    put(file, madeHere(std::move(image)));
}

SharedImage ImageSource::find(SourceKind source, Pattern pattern, const std::string& file) const {
    return source == SourceKind::Pattern ? sharedPattern(pattern) : contentOf(file);
}

SharedImage drawnImage(Image image) {
    return std::make_shared<const TextureImage>(madeHere(std::move(image)));
}

SharedImage ImageSource::find(const Texture& texture) const {
    if (texture.source == SourceKind::LightDepth) {
        const auto seen = lightDepths_.find(texture.depthSize);
        return seen == lightDepths_.end() ? farthestDepths(texture.depthSize) : seen->second;
    }
    if (texture.source == SourceKind::Picture) {
        const auto drawn = pictures_.find(pictureOf(texture));
        return drawn == pictures_.end() ? blackPicture(texture.pictureSize) : drawn->second;
    }
    return find(texture.source, texture.pattern, texture.file);
}

TexturePictures ImageSource::picturesOf(const Texture& texture) const {
    TexturePictures pictures(find(texture));
    if (texture.oversize == Oversize::Smaller)
        pictures.limits = limits_;
    if (texture.mipmaps == MipPolicy::Given) {
        for (const GivenLevel& level : texture.levels)
            pictures.levels.push_back(find(level.source, level.pattern, level.file));
    }
    for (const ImageStep& step : texture.preparation)
        pictures.others.push_back(readsOther(step) ? find(step.source, step.pattern, step.file) : nullptr);
    for (const Subimage& subimage : texture.subimages)
        pictures.subimages.push_back(find(subimage.source, subimage.pattern, subimage.file));
    return pictures;
}

} // namespace texplorer
