#pragma once

// A whole program that draws a scene, as a student would write it: in C with GLFW, or as a page.

#include "core/emit/code.h"
#include "core/emit/flavour.h"
#include "core/emit/texel_code.h"
#include "core/scene/scene.h"
#include "core/texture/image_source.h"
#include "core/texture/levels_source.h"

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace texplorer::emit {

/// What the texels of textures become, kept as long as a program needs them: to make them takes longer than
/// to write a program.
class TextureCodes {
public:
    [[nodiscard]] std::shared_ptr<const Result<TextureCode>> of(const Texture& texture,
                                                                const TexturePictures& pictures,
                                                                Target target,
                                                                const std::function<FileReader()>& reader);
    /// Forgets those that were not asked for since the last call.
    void forgetUnused();

private:
    struct Kept {
        LevelsRequest request;
        std::shared_ptr<const Result<TextureCode>> code;
        bool used = true;
    };
    std::vector<Kept> kept_;
};

struct ProgramOptions {
    std::string title = "Texplorer"; ///< of the window
    std::string about{};             ///< what the comment at its top says beside: sentences
    std::string source = "demo.c";   ///< what the file is called: for the line that compiles it
    int width = 640;                 ///< of the window, in pixels
    int height = 480;
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

/// The program, which moves as the scene's key frames say. What the scene's textures hold comes from
/// `images`; one that has none is left out, as renderers leave it out. Those of OpenGL 3.3's core profile and
/// of WebGL 2 have the shaders of the shader renderer. Unsupported: what the scene says that such a program
/// can't, in one sentence.
[[nodiscard]] Result<std::vector<Line>> program(Flavour flavour, const Scene& scene,
                                                const ImageSource& images, const ProgramOptions& options,
                                                TextureCodes& codes);

/// The files of a scene's textures that its program reads, as the scene spells them.
[[nodiscard]] std::set<std::string> filesRead(const std::vector<Line>& program, const Scene& scene);

/// Meshes of more vertices are data at the end of the program.
inline constexpr std::size_t mostWrittenVertices = 64;

} // namespace texplorer::emit
