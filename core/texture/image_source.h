#pragma once

#include "core/base/result.h"
#include "core/image/texture_image.h"
#include "core/scene/scene.h"
#include "core/texture/image_budget.h"

#include <filesystem>
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

    /// The same with outlines (DecodeLimits::pixels): enough for a diagnosis, and nothing to draw. For each
    /// of the scene's textures, why its file can't be read.
    [[nodiscard]] std::vector<std::optional<Error>> loadOutlines(const Scene& scene,
                                                                 std::size_t budget = sceneImageBytes);

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

    /// All that there is of a texture, or nullptr where its file is not loaded. The pointer stays the same as
    /// long as the content does, so it can key a cache.
    [[nodiscard]] std::shared_ptr<const TextureImage> find(const Texture& texture) const;

    /// Takes over what another source holds of a file, under the name that it has here.
    void share(const std::string& file, const ImageSource& other, const std::string& nameThere) {
        if (const auto found = other.files_.find(nameThere); found != other.files_.end())
            files_[file] = found->second;
    }

    /// Whether a file is loaded; `file` is spelled as in Texture::file.
    [[nodiscard]] bool holds(const std::string& file) const { return files_.contains(file); }

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
    [[nodiscard]] std::vector<std::optional<Error>> loadAll(const Scene& scene, std::size_t budget,
                                                            Decoding decoding);

    std::filesystem::path directory_;
    std::map<std::string, std::shared_ptr<const TextureImage>> files_;
};

/// The files that the textures of a scene name.
[[nodiscard]] std::set<std::string> filesOf(const Scene& scene);

} // namespace texplorer
