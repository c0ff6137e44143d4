#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/image/texture_image.h"
#include "texplorer/mesh/mesh_file.h"
#include "texplorer/scene/pass_pictures.h"
#include "texplorer/texture/image_budget.h"
#include "texplorer/texture/texture_pictures.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace texplorer {

/// The images of a scene's textures: the whole content of files, with levels and compressed blocks; and the
/// OBJ files of its meshes. Renderers call `find`, which never reads files; the program calls `load` before.
/// Copies are cheap: images are shared and immutable.
class ImageSource {
public:
    /// Relative paths refer to the current directory.
    ImageSource() = default;
    /// Relative paths refer to `directory`, that of the scene file; empty: the current one.
    explicit ImageSource(std::filesystem::path directory);

    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

    /// Reads the scene's files that are not loaded yet: each file once, even if several paths or textures
    /// refer to it, while all images of the scene need at most `budget` bytes. All files are tried; the first
    /// error is returned, with the parameter of the file in `where`.
    [[nodiscard]] Result<void> load(const Scene& scene, std::size_t budget = sceneImageBytes);
    /// The same, and fills the scene's meshes.
    [[nodiscard]] Result<void> load(Scene& scene) {
        Result<void> loaded = load(std::as_const(scene));
        fillMeshes(scene);
        return loaded;
    }

    /// Gives the models that name a file its vertices, or none where it isn't loaded.
    void fillMeshes(Scene& scene) const;
    /// Whether that would change nothing. As cheap as a comparison of pointers where it is so.
    [[nodiscard]] bool hasFilled(const Scene& scene) const;

    /// The same; also for outlines (DecodeLimits::pixels), which are enough for most of a diagnosis, but not
    /// for drawing. Returns an error for each parameter whose file cannot be read, in order.
    [[nodiscard]] std::vector<Error> loadAll(const Scene& scene, Decoding decoding,
                                             std::size_t budget = sceneImageBytes);

    /// Sets the content of a file from memory: decoded elsewhere, or generated. `file` is spelled as in
    /// Texture::file; replaces earlier content.
    void put(const std::string& file, TextureImage image) {
        put(file, std::make_shared<const TextureImage>(std::move(image)));
    }
    void put(const std::string& file, std::shared_ptr<const TextureImage> image) {
        files_[file] = std::move(image);
    }
    void put(const std::string& file, std::shared_ptr<const MeshFile> meshes) {
        meshes_[file] = std::move(meshes);
    }
    /// A picture, in the normal orientation of an Image.
    void put(const std::string& file, Image image);

    /// Sets the bytes of a file that is not on disk, such as those of built-in lessons: to show or save them.
    /// The decoded content is set by `put`.
    void putFile(const std::string& file, Bytes bytes) {
        inMemory_[file] = std::make_shared<const Bytes>(std::move(bytes));
    }
    /// nullptr: no such file was set.
    [[nodiscard]] std::shared_ptr<const Bytes> fileInMemory(const std::string& file) const {
        const auto found = inMemory_.find(file);
        return found == inMemory_.end() ? nullptr : found->second;
    }

    /// Sets the light's view, `size` texels per side, for textures with SourceKind::LightDepth; called by the
    /// program that draws the scene (texplorer/reference/light_depth.h).
    void putLightDepth(int size, std::shared_ptr<const TextureImage> image) {
        lightDepths_[size] = std::move(image);
    }
    [[nodiscard]] bool holdsLightDepth(int size) const { return lightDepths_.contains(size); }

    /// Sets what passes draw, for textures with SourceKind::Picture; likewise
    /// (texplorer/reference/drawn_pictures.h).
    void putPicture(const PictureKey& key, std::shared_ptr<const TextureImage> image) {
        pictures_[key] = std::move(image);
    }
    [[nodiscard]] bool holdsPicture(const PictureKey& key) const { return pictures_.contains(key); }
    /// All of them.
    [[nodiscard]] const std::map<PictureKey, std::shared_ptr<const TextureImage>>& pictures() const {
        return pictures_;
    }

    /// Returns the content of a texture's image, or nullptr if its file is not loaded. The pointer stays the
    /// same while the content does, so it can be the key of a cache. Without a light's view, all depths are
    /// farthest; a picture that isn't drawn is black, with alpha 0.
    [[nodiscard]] std::shared_ptr<const TextureImage> find(const Texture& texture) const;

    /// The same, with the images of its levels, if it uses them (MipPolicy::Given), and of its preparation.
    [[nodiscard]] TexturePictures picturesOf(const Texture& texture) const;

    /// Copies the content of a file from another source, under this source's name.
    void share(const std::string& file, const ImageSource& other, const std::string& nameThere) {
        if (const auto found = other.files_.find(nameThere); found != other.files_.end())
            files_[file] = found->second;
        if (const auto found = other.meshes_.find(nameThere); found != other.meshes_.end())
            meshes_[file] = found->second;
    }

    /// Whether a file is loaded; `file` is spelled as in Texture::file.
    [[nodiscard]] bool holds(const std::string& file) const {
        return files_.contains(file) || meshes_.contains(file);
    }

    /// The content of a file, or nullptr if it is not loaded.
    [[nodiscard]] std::shared_ptr<const TextureImage> contentOf(const std::string& file) const {
        const auto found = files_.find(file);
        return found == files_.end() ? nullptr : found->second;
    }

    /// The meshes of an OBJ file, or nullptr.
    [[nodiscard]] std::shared_ptr<const MeshFile> meshesOf(const std::string& file) const {
        const auto found = meshes_.find(file);
        return found == meshes_.end() ? nullptr : found->second;
    }

    /// The size of the content of these files, each image counted once.
    [[nodiscard]] std::size_t bytesOf(const std::set<std::string>& files) const;

    /// All loaded files, whether the scene still uses them or not.
    [[nodiscard]] std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& [name, image] : files_)
            names.push_back(name);
        for (const auto& [name, meshes] : meshes_)
            names.push_back(name);
        return names;
    }

    /// The limits of the driver that draws the textures, or that the reference draws like: they are part of
    /// the pictures of each texture with Oversize::Smaller.
    void setLimits(const TextureLimits& limits) { limits_ = limits; }

    /// Whether both have the same images and limits; equal copies are different.
    bool operator==(const ImageSource&) const = default;

private:
    [[nodiscard]] std::shared_ptr<const TextureImage> find(SourceKind source, Pattern pattern,
                                                           const std::string& file) const;

    std::filesystem::path directory_;
    std::map<std::string, std::shared_ptr<const TextureImage>> files_;
    std::map<std::string, std::shared_ptr<const MeshFile>> meshes_;
    std::map<std::string, std::shared_ptr<const Bytes>> inMemory_;
    std::map<int, std::shared_ptr<const TextureImage>> lightDepths_; ///< by size
    std::map<PictureKey, std::shared_ptr<const TextureImage>> pictures_;
    TextureLimits limits_;
};

/// Makes an image of what was drawn, bottom row first, for an image source: of depths, PixelFormat::Depth32,
/// or of colours.
[[nodiscard]] std::shared_ptr<const TextureImage> drawnImage(Image image);

/// A parameter that refers to a file: an image, or an OBJ file.
struct FileName {
    std::string path; ///< "textures[0].levels[1].file", "models[0].mesh.file"
    std::string file;
    bool used = false; ///< the texture currently uses it; the model is a mesh
    bool isMesh = false;

    bool operator==(const FileName&) const = default;
};

/// All such parameters of a scene, used or not, also empty ones: of each texture its own, then its levels'
/// and its preparation's; last those of meshes, which are not empty.
[[nodiscard]] std::vector<FileName> fileNamesOf(const Scene& scene);

/// The files that a scene uses.
[[nodiscard]] std::set<std::string> filesOf(const Scene& scene);

/// Renames all files in a scene, used or not: `rename` is called for names that are not empty.
void renameFiles(Scene& scene, const std::function<std::string(const std::string& file)>& rename);

} // namespace texplorer
