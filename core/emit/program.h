#pragma once

// A whole program that draws a scene, as a student would write it: in C with GLFW.

#include "texplorer/emit/code.h"
#include "texplorer/emit/flavour.h"
#include "texplorer/emit/texel_code.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"
#include "texplorer/texture/levels_source.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace texplorer::emit {

struct ProgramOptions {
    std::string title = "Texplorer"; ///< of the window
    std::string about{};             ///< what the comment at its top says beside: sentences
    std::string source = "demo.c";   ///< what the file is called: for the line that compiles it
    int width = 640;                 ///< of the window, in pixels
    int height = 480;
    Loader loader = Loader::Prototypes;
    /// Calls nothing but OpenGL, GLFW and C's library: makes mip levels and quadrics itself instead of
    /// telling the driver or GLU to.
    bool selfContained = false;
    /// Parameters whose calls have a word on what they do before them, and stand there even where they set
    /// what OpenGL starts with.
    std::set<std::string, std::less<>> explained{};
    /// What the program calls an image file of the scene that lies in a folder: BMP, TGA and DDS files whose
    /// format takes few lines are read by it. Empty, or an empty name: their texels stand in the program.
    std::function<std::string(const std::string& file)> fileName{};
    /// Files that lie in no folder, as those of the program's lessons, are read as well: somebody writes them
    /// beside the program.
    bool readsFilesInMemory = false;
};

/// What a program has to be given of a texture object.
struct TexelRequest {
    LevelsRequest levels;
    std::filesystem::path file{};                ///< that the program may read instead; empty: none
    std::shared_ptr<const Bytes> fileInMemory{}; ///< what it holds, where it lies in no folder
    bool readsMemory = false;                    ///< custom uploads are calls

    bool operator==(const TexelRequest&) const = default;
};

/// Those of a scene's texture objects, in their order; nothing for one whose image isn't there.
[[nodiscard]] std::vector<std::optional<TexelRequest>>
texelRequests(Flavour flavour, const Scene& scene, const ImageSource& images, const ProgramOptions& options);

/// What the texels of textures become, kept as long as a program needs them: to make them takes longer than
/// to write a program.
class TextureCodes {
public:
    using Code = std::shared_ptr<const Result<TextureCode>>;

    /// How they are made.
    explicit TextureCodes(LevelWork work = {})
        : work_(std::move(work)) {}

    /// Made where nobody has. What was cancelled is not kept.
    [[nodiscard]] Code of(const TexelRequest& request);
    [[nodiscard]] bool has(const TexelRequest& request) const;
    /// Made elsewhere.
    void keep(TexelRequest request, Code code);
    /// Forgets those that were not asked for since the last call.
    void forgetUnused();
    void forgetAll() { kept_.clear(); }

private:
    struct Kept {
        TexelRequest request;
        Code code;
        bool used = true;
    };
    LevelWork work_;
    std::vector<Kept> kept_;
};

/// The program, which moves as the scene's key frames say. What the scene's textures hold comes from
/// `images`; one that has none is left out, as renderers leave it out. Those of OpenGL 3.3's core profile
/// have the shaders of the shader renderer. Unsupported: what the scene says that such a program can't, in
/// one sentence.
[[nodiscard]] Result<std::vector<Line>> program(Flavour flavour, const Scene& scene,
                                                const ImageSource& images, const ProgramOptions& options,
                                                TextureCodes& codes);

/// The files of a scene's textures that its program reads, as the scene spells them.
[[nodiscard]] std::set<std::string> filesRead(const std::vector<Line>& program, const Scene& scene);

/// A CMakeLists.txt for the program, with the libraries that it needs. options.source: its file, whose name
/// has letters, digits, _ and - before ".c".
[[nodiscard]] std::string cmakeLists(const std::vector<Line>& program, const ProgramOptions& options);

/// Meshes of more vertices are data at the end of the program.
inline constexpr std::size_t maxWrittenVertices = 64;

} // namespace texplorer::emit
