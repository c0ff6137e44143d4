// A texture of a scene as pictures: after each step of its preparation, and the levels that OpenGL is given.

#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/outputs_apart.h"
#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/output.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/image/depth_pixels.h"
#include "texplorer/reference/light_depth.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/texture/texture_levels.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stop_token>

namespace texplorer::screenshot {
namespace {

struct TextureOptions {
    SceneArgument scene;
    std::string out;
    int texture = 0;
    int step = -1;  ///< -1: none is asked for
    int level = -1; ///< likewise
    bool json = false;
};

/// The picture before the preparation (step 0), or after one of its steps.
Result<Image> stepOf(const TextureOptions& options, const Texture& texture, const TexturePictures& pictures) {
    std::optional<Image> asked;
    std::stop_source enough;
    int step = 0;
    const auto keep = [&](const Image& image) {
        if (step++ == options.step) {
            asked = image;
            enough.request_stop();
        }
    };
    eachPreparationStep(texture, pictures, keep, enough.get_token());
    if (asked)
        return *std::move(asked);
    return fail(ErrorCode::OutOfRange,
                Sentence("there is no step {0}: textures[{1}] has {2} in its preparation", options.step,
                         options.texture,
                         Sentence::plural("{0} step", "{0} steps", texture.preparation.size())),
                atOption("--step"));
}

/// A level as OpenGL is given it, but upright and decompressed.
Result<Image> levelOf(const TextureOptions& options, Texture texture, const TexturePictures& pictures) {
    texture.flip = FlipMode::Pixels;
    Result<TextureLevels> made = prepareLevels(texture, pictures);
    if (!made)
        return fail(made.error());
    const int asked = std::max(options.level, 0);
    const auto found = std::ranges::find(made->levels, asked, &TextureLevel::number);
    if (found == made->levels.end())
        return fail(ErrorCode::OutOfRange,
                    Sentence("there is no level {0}: textures[{1}] has {2}", asked, options.texture,
                             Sentence::plural("{0} level", "{0} levels", made->levels.size())),
                    atOption("--level"));
    return toImage(std::move(found->surface).take());
}

Result<Image> pictureOf(const TextureOptions& options, OpenedScene& opened) {
    if (static_cast<std::size_t>(options.texture) >= opened.scene.textures.size())
        return fail(ErrorCode::OutOfRange,
                    Sentence("there is no textures[{0}]: the scene has {1}", options.texture,
                             Sentence::plural("{0} texture", "{0} textures", opened.scene.textures.size())),
                    opened.scene.textures.empty()
                        ? Location()
                        : atOption("--texture")); // of such a scene no number is right
    if (const auto loaded = opened.images.load(opened.scene); !loaded)
        return fail(loaded.error());
    const Texture& texture = opened.scene.textures[static_cast<std::size_t>(options.texture)];
    if (texture.source == SourceKind::LightDepth)
        opened.images.putLightDepth(
            texture.depthSize, depthImage(reference::drawLightDepths(opened.scene, 0, texture.depthSize)));
    const TexturePictures pictures = opened.images.picturesOf(texture);
    return options.step >= 0 ? stepOf(options, texture, pictures) : levelOf(options, texture, pictures);
}

ExitCode writeTexture(const TextureOptions& options) {
    if (options.json && isStandardOutput(options.out))
        return complain(standardOutputIsTaken("--json").value(), wrongCall);
    const auto output = openImageOutput(options.out, "PNG");
    if (!output)
        return output.error();
    auto opened = openScene(options.scene);
    if (!opened)
        return complain(opened.error().error, opened.error().code);
    if (const Result<void> apart =
            checkOutputsApart(std::array{NamedOutput{"--out", options.out}}, filesOf(options.scene, *opened));
        !apart)
        return complain(apart.error(), wrongCall);
    Result<Image> picture = pictureOf(options, *opened);
    if (!picture)
        return complain(inScene(options.scene, picture.error()), statusOf(picture.error()));
    const TextureImage made = textureOf(greysOf(*std::move(picture)), {});
    if (const auto written = output->write(made); !written)
        return complain(written.error());
    if (!options.json)
        return success;
    const Result<void> printed =
        print(documentText(nlohmann::ordered_json::array({{{"file", options.out},
                                                           {"format", output->format->name},
                                                           {"texture", options.texture},
                                                           {"width", widthOf(made.surface(0, 0))},
                                                           {"height", heightOf(made.surface(0, 0))}}})));
    return printed ? success : complain(printed.error());
}

} // namespace

void addTexture(CommandLine& line) {
    Command& command = line.command(
        "texture", "Write a texture of a scene as a picture: a level, or after a step of its preparation.");
    auto options = std::make_shared<TextureOptions>();
    addSceneArgument(command, options->scene);
    command.option(
        "-o,--out", options->out,
        fmt::format("The picture to write, with the format of its extension: {}; - for standard output, as "
                    "PNG.",
                    writtenExtensions(" or ")),
        {.value = "FILE", .required = true});
    command.number("--texture", options->texture, 0, static_cast<int>(maxTextures) - 1,
                   "The texture of the scene, from 0.");
    const Option& step =
        command.number("--step", options->step, 0, static_cast<int>(maxImageSteps),
                       "The image after this number of preparation steps; 0: as in its file.");
    command.number("--level", options->level, 0, 30,
                   "The mip level as uploaded to GL_TEXTURE_2D, but upright and decompressed; 0 is the "
                   "base.",
                   {.excludes = &step});
    command.flag("--json", options->json,
                 "Print the result as JSON, for programs: output, format, texture, width and height.");
    command.footer(
        "Without --step and --level it is the base level as uploaded. A shadow map is the one at time 0.\n"
        "Exit status: 0 done, 1 the scene or an image can't be read or the picture can't be written, 2 "
        "invalid arguments.");
    command.onCall([options] { return writeTexture(*options); });
}

} // namespace texplorer::screenshot
