#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/image/texture_image.h"
#include "core/scene/scene.h"
#include "core/texture/image_budget.h"
#include "core/texture/texture_pictures.h"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace texplorer {

/// Where the images of a Texture come from: all that a file holds, levels and compressed blocks as they are.
/// Renderers ask `find`, which never touches a file; an editor of the scene calls `load` for its file
/// textures first. Copying is cheap: images are shared and never change.
class ImageSource {
public:
    /// Relative paths are resolved against the current directory.
    ImageSource() = default;
    /// Relative paths are resolved against `directory`, that of the scene file; empty: the current one.
    explicit ImageSource(std::filesystem::path directory);

    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

    /// Reads every file that the scene names and that is not loaded yet: once, whatever it is called and
    /// however many textures name it, and as long as all images of the scene take no more than `budget`
    /// bytes. All are tried; the first error is returned: where it is, is the parameter that names the file.
    [[nodiscard]] Result<void> load(const Scene& scene, std::size_t budget = sceneImageBytes);

    /// The same with outlines (DecodeLimits::pixels): enough for a diagnosis, and nothing to draw. Why files
    /// can't be read: an error for each parameter that names one of them, in their order.
    [[nodiscard]] std::vector<Error> loadOutlines(const Scene& scene, std::size_t budget = sceneImageBytes);

    /// The content of a file, from somewhere else than a file: decoded elsewhere, or made up. `file` is
    /// spelled as in Texture::file; what was there before is replaced.
    void put(const std::string& file, TextureImage image) {
        put(file, std::make_shared<const TextureImage>(std::move(image)));
    }
    void put(const std::string& file, std::shared_ptr<const TextureImage> image) {
        files_[file] = std::move(image);
    }
    /// A picture, upright as images are.
    void put(const std::string& file, Image image);

    /// A file that lies in no folder, as those of the program's lessons: for who looks into it, or saves it.
    /// What it holds is put beside it.
    void putFile(const std::string& file, Bytes bytes) {
        inMemory_[file] = std::make_shared<const Bytes>(std::move(bytes));
    }
    /// nullptr: it lies in a folder, if anywhere.
    [[nodiscard]] std::shared_ptr<const Bytes> fileInMemory(const std::string& file) const {
        const auto found = inMemory_.find(file);
        return found == inMemory_.end() ? nullptr : found->second;
    }

    /// What the light sees, `size` texels on each side, for textures with SourceKind::LightDepth: from
    /// whoever draws the scene (core/reference/light_depth.h).
    void putLightDepth(int size, std::shared_ptr<const TextureImage> image) {
        lightDepths_[size] = std::move(image);
    }
    [[nodiscard]] bool holdsLightDepth(int size) const { return lightDepths_.contains(size); }

    /// All that there is of a texture, or nullptr where its file is not loaded. The pointer stays the same as
    /// long as the content does, so it can key a cache. Where nobody has put what the light sees, it sees
    /// nothing: all is farthest.
    [[nodiscard]] std::shared_ptr<const TextureImage> find(const Texture& texture) const;

    /// The same with the images of its levels, where it wants them (MipPolicy::Given), and of its
    /// preparation.
    [[nodiscard]] TexturePictures picturesOf(const Texture& texture) const;

    /// Takes over what another source holds of a file, under the name that it has here.
    void share(const std::string& file, const ImageSource& other, const std::string& nameThere) {
        if (const auto found = other.files_.find(nameThere); found != other.files_.end())
            files_[file] = found->second;
    }

    /// Whether a file is loaded; `file` is spelled as in Texture::file.
    [[nodiscard]] bool holds(const std::string& file) const { return files_.contains(file); }

    /// What a file holds, or nullptr where it is not loaded.
    [[nodiscard]] std::shared_ptr<const TextureImage> contentOf(const std::string& file) const {
        const auto found = files_.find(file);
        return found == files_.end() ? nullptr : found->second;
    }

    /// What the images of these files take, each image once.
    [[nodiscard]] std::size_t bytesOf(const std::set<std::string>& files) const;

    /// Every file that is loaded, whether a scene still names it or not.
    [[nodiscard]] std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& [name, image] : files_)
            names.push_back(name);
        return names;
    }

    /// The same images, not only equal ones.
    bool operator==(const ImageSource&) const = default;

private:
    [[nodiscard]] std::vector<Error> loadAll(const Scene& scene, std::size_t budget, Decoding decoding);
    [[nodiscard]] std::shared_ptr<const TextureImage> find(SourceKind source, Pattern pattern,
                                                           const std::string& file) const;

    std::filesystem::path directory_;
    std::map<std::string, std::shared_ptr<const TextureImage>> files_;
    std::map<std::string, std::shared_ptr<const Bytes>> inMemory_;
    std::map<int, std::shared_ptr<const TextureImage>> lightDepths_; ///< by their size
};

/// A picture of depths, PixelFormat::Depth32, as an image source holds it.
[[nodiscard]] std::shared_ptr<const TextureImage> depthImage(Image depths);

/// A parameter that names an image file.
struct FileName {
    std::string path; ///< "textures[0].levels[1].file"
    std::string file;
    bool used = false; ///< the texture wants it at present

    bool operator==(const FileName&) const = default;
};

/// All of a scene, used or not, with those that name none: first the texture's, then its levels' and its
/// preparation's.
[[nodiscard]] std::vector<FileName> fileNamesOf(const Scene& scene);

/// The files that the textures of a scene use.
[[nodiscard]] std::set<std::string> filesOf(const Scene& scene);

/// Names every file anew that a scene names, used or not: `rename` is given what is not empty.
void renameFiles(Scene& scene, const std::function<std::string(const std::string& file)>& rename);

} // namespace texplorer
