// A texture of a scene as a file: a picture after each step of its preparation, a level, or all levels.

#include "app/screenshot/arguments/context_argument.h"
#include "app/screenshot/arguments/option_use.h"
#include "app/screenshot/arguments/outputs_apart.h"
#include "app/screenshot/arguments/scene_argument.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/gl/gl_module.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/long_work.h"
#include "app/screenshot/output/messages.h"
#include "app/screenshot/output/output.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/image/convert.h"
#include "texplorer/reference/light_depth.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/texture/saved_texture.h"

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
    bool fromDriver = false;
    ContextArgument context;
    bool allLevels = false;
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

/// The first target that an enabled unit shows a texture with.
std::optional<Target> targetOf(const Scene& scene, int texture) {
    for (const Pass& pass : scene.passes) {
        for (const Unit& unit : pass.units) {
            if (pass.enabled && unit.enabled && unit.texture == texture)
                return unit.target;
        }
    }
    return std::nullopt;
}

/// The texture after OpenGL has drawn with it.
Result<ReadTexture> readFromDriver(const TextureOptions& options, const OpenedScene& opened,
                                   const view::ContextChoice& context) {
    const std::optional<Target> target = targetOf(opened.scene, options.texture);
    if (!target)
        return fail(ErrorCode::NotFound,
                    Sentence("no enabled unit shows textures[{0}]: the driver has none", options.texture),
                    atOption("--from-driver"));
    const auto studio = openStudio({}, {}, context);
    if (!studio)
        return fail(studio.error());
    constexpr int side = 16; // of a picture that is not read
    if (const auto drawn = (*studio)->draw(RendererKind::Fixed, {opened.scene, opened.images, 0, side, side});
        !drawn)
        return fail(drawn.error());
    Result<ReadTexture> read = (*studio)->read(static_cast<std::size_t>(options.texture), *target);
    const Texture& texture = opened.scene.textures[static_cast<std::size_t>(options.texture)];
    if (const auto made = read ? Result<TextureLevels>()
                               : prepareLevels(texture, opened.images.picturesOf(texture), *target);
        !made)
        return fail(made.error().code, made.error().message,
                    elementOf<&Scene::textures>(static_cast<std::size_t>(options.texture)));
    return read;
}

/// A level of the first face, decompressed, the row at t = 0 below.
Result<Image> levelOf(const TextureOptions& options, const ReadTexture& read) {
    const auto found = std::ranges::find(read.levels, std::max(options.level, 0), &TextureLevel::number);
    if (found == read.levels.end())
        return fail(
            ErrorCode::OutOfRange,
            Sentence("there is no level {0}: the driver has {1} of textures[{2}]", std::max(options.level, 0),
                     Sentence::plural("{0} level", "{0} levels", read.stored.levels.size()), options.texture),
            atOption("--level"));
    return toImage(*found->surface);
}

nlohmann::ordered_json jsonOf(const view::StoredTexture& stored) {
    auto levels = nlohmann::ordered_json::array();
    for (const view::StoredLevel& level : stored.levels) {
        auto bits = nlohmann::ordered_json::object();
        for (std::size_t i = 0; i < level.bits.size(); ++i)
            bits[std::string(view::storedComponents.at(i))] = level.bits.at(i);
        nlohmann::ordered_json one{{"number", level.number}, {"width", level.width},
                                   {"height", level.height}, {"depth", level.depth},
                                   {"border", level.border}, {"internalFormat", level.internalFormat},
                                   {"bits", std::move(bits)}};
        if (level.bytes > 0)
            one["bytes"] = level.bytes;
        levels.push_back(std::move(one));
    }
    return {{"resident", stored.resident},
            {"priority", stored.priority},
            {"largest", stored.largest},
            {"levels", std::move(levels)}};
}

/// All levels, as the window saves a texture.
Result<TextureImage> allLevelsOf(const Texture& texture, const TexturePictures& pictures) {
    LongWork work("texshot: making the levels");
    Result<SavedTexture> saved =
        savedTexture(texture, pictures, {},
                     {.progress = [&work](float done) { work.report(done); }, .stop = work.stopToken()});
    work.finish();
    if (!saved)
        return fail(saved.error());
    if (!saved->losses.empty())
        warn({ErrorCode::Unsupported, Sentence("lost in {0}: {1}", "DDS", allLost(saved->losses))});
    for (const Sentence& remark : saved->remarks)
        warn({ErrorCode::Unsupported, remark});
    return std::move(saved->image);
}

/// The content of the file; of --from-driver also what OpenGL says of it.
struct WrittenTexture {
    TextureImage image;
    std::optional<view::StoredTexture> stored{};
};

Result<WrittenTexture> imageOf(const TextureOptions& options, OpenedScene& opened,
                               const view::ContextChoice& context) {
    if (static_cast<std::size_t>(options.texture) >= opened.scene.textures.size())
        return fail(ErrorCode::OutOfRange,
                    Sentence("there is no textures[{0}]: the scene has {1}", options.texture,
                             Sentence::plural("{0} texture", "{0} textures", opened.scene.textures.size())),
                    opened.scene.textures.empty()
                        ? Location()
                        : atOption("--texture")); // of such a scene no number is right
    if (const auto loaded = opened.images.load(opened.scene); !loaded)
        return fail(loaded.error());
    const auto written = [](Image&& picture) {
        const bool areFloats = picture.format == PixelFormat::RgbaFloat;
        TextureImage image = textureOf(asBytes(std::move(picture)), {});
        if (areFloats)
            image.componentBits = 32;
        return WrittenTexture{std::move(image)};
    };
    if (options.fromDriver) {
        const Result<ReadTexture> read = readFromDriver(options, opened, context);
        if (!read)
            return fail(read.error());
        Result<WrittenTexture> level = levelOf(options, *read).map(written);
        if (level)
            level->stored = read->stored;
        return level;
    }
    const Texture& texture = opened.scene.textures[static_cast<std::size_t>(options.texture)];
    if (texture.source == SourceKind::LightDepth)
        opened.images.putLightDepth(
            texture.depthSize, drawnImage(reference::drawLightDepths(opened.scene, 0, texture.depthSize)));
    if (texture.source == SourceKind::Picture) {
        Result<ImageSource> drawn = reference::ReferenceRenderer().drawnImages({opened.scene, opened.images});
        if (!drawn)
            return fail(drawn.error());
        opened.images = std::move(*drawn);
    }
    const TexturePictures pictures = opened.images.picturesOf(texture);
    if (options.allLevels)
        return allLevelsOf(texture, pictures).map([](TextureImage&& image) {
            return WrittenTexture{std::move(image)};
        });
    return (options.step >= 0 ? stepOf(options, texture, pictures) : levelOf(options, texture, pictures))
        .map(written);
}

ExitCode writeTexture(const TextureOptions& options) {
    if (options.allLevels && options.fromDriver)
        return complain({ErrorCode::OutOfRange, N_("--all-levels and --from-driver exclude each other"), {}},
                        wrongCall);
    if (options.allLevels && options.level >= 0)
        noteUnused("--level", "--all-levels writes all");
    if (options.json && isStandardOutput(options.out))
        return complain(standardOutputIsTaken("--json").value(), wrongCall);
    const auto context = parseContext(options.context);
    if (!context)
        return complain(context.error(), wrongCall);
    if (options.context.option->isGiven() && !options.fromDriver)
        noteUnused("--context", "it concerns OpenGL, which only --from-driver uses");
    const std::string_view only = options.allLevels ? "DDS" : "";
    const auto output = openImageOutput(options.out, options.allLevels ? only : "PNG", only);
    if (!output)
        return output.error();
    auto opened = openScene(options.scene);
    if (!opened)
        return complain(opened.error().error, opened.error().code);
    if (const Result<void> apart =
            checkOutputsApart(std::array{NamedOutput{"--out", options.out}}, filesOf(options.scene, *opened));
        !apart)
        return complain(apart.error(), wrongCall);
    const Result<WrittenTexture> made = imageOf(options, *opened, *context);
    if (!made)
        return complain(inScene(options.scene, made.error()), statusOf(made.error()));
    if (const auto written = output->write(made->image); !written)
        return complain(written.error());
    if (!options.json)
        return success;
    nlohmann::ordered_json result{{"file", options.out},
                                  {"format", output->format->name},
                                  {"texture", options.texture},
                                  {"width", widthOf(made->image.surface(0, 0))},
                                  {"height", heightOf(made->image.surface(0, 0))},
                                  {"levelCount", made->image.levels}};
    if (made->stored)
        result["driver"] = jsonOf(*made->stored);
    const Result<void> printed = print(documentText(nlohmann::ordered_json::array({std::move(result)})));
    return printed ? success : complain(printed.error());
}

} // namespace

void addTexture(CommandLine& line) {
    Command& command = line.command(
        "texture",
        "Write a texture of a scene to an image file: a level, all, or after a step of its preparation.");
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
    command.flag("--all-levels", options->allLevels,
                 "Write a DDS file of all levels, as blocks if the texture is compressed, with t = 0 at the "
                 "bottom.",
                 {.excludes = &step});
    command.flag(
        "--from-driver", options->fromDriver,
        "The level as the driver returns it after drawing with it (glGetTexImage), with the row at t "
        "= 0 at the bottom; --json adds what the driver stores: internal format and bits of each "
        "level, residency, and the largest size that fits.",
        {.excludes = &step});
    addContextArgument(command, options->context);
    command.flag(
        "--json", options->json,
        "Print the result as JSON, for programs: output, format, texture, size and number of levels.");
    command.footer(
        "Without --step and --level it is the base level as uploaded. A shadow map is the one at time 0.\n"
        "Exit status: 0 done, 1 the scene or an image can't be read or the picture can't be written, 2 "
        "invalid arguments.");
    command.onCall([options] { return writeTexture(*options); });
}

} // namespace texplorer::screenshot
