#include "app/screenshot/arguments/input.h"
#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/columns.h"
#include "app/screenshot/output/json_text.h"
#include "texplorer/codec/registry.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/text/printable.h"
#include "texplorer/texture/texture_levels.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <optional>

namespace texplorer::screenshot {
namespace {

constexpr std::size_t shownBytes = 16; // of a field's raw bytes

std::string hex(ByteView bytes) {
    std::string text;
    for (const std::byte byte : bytes.first(std::min(bytes.size(), shownBytes)))
        text += fmt::format("{}{:02x}", text.empty() ? "" : " ", std::to_integer<unsigned>(byte));
    return bytes.size() > shownBytes ? text + " …" : text;
}

std::string_view encodingOf(const Surface& surface) {
    if (const Image* image = std::get_if<Image>(&surface))
        return rowOf(image->format).name;
    return rowOf(std::get<BlockImage>(surface).format).label;
}

std::string_view nameOf(AlphaMeaning alpha) {
    constexpr std::array<std::string_view, 4> names{"none", "straight", "premultiplied", "not specified"};
    return names[static_cast<std::size_t>(alpha)];
}

std::string extentOf(const Surface& surface) {
    std::string text = fmt::format("{} × {}", widthOf(surface), heightOf(surface));
    return depthOf(surface) == 1 ? text : fmt::format("{} × {}", text, depthOf(surface));
}

/// A text too long for its column still stands apart from what follows.
std::string padded(std::string text, std::size_t width) {
    const std::size_t columns = columnsOf(text);
    return text.append(columns < width ? width - columns : 2, ' ');
}

/// What the levels of one face cost; there is no source here that they could be compared with.
TextureReport costOf(const TextureImage& texture) {
    std::vector<TextureLevel> levels;
    levels.reserve(static_cast<std::size_t>(std::max(0, texture.levels)));
    for (int level = 0; level < texture.levels; ++level)
        levels.push_back({level, texture.surface(0, level)});
    return reportOn(levels);
}

std::string factsAsText(const std::string& path, const TextureImage& texture, std::size_t fileBytes) {
    const Surface& base = texture.surface(0, 0);
    std::string text;
    const auto line = [&](std::string name, const std::string& value) {
        text += fmt::format("{}{}\n", padded(std::move(name), 14), printable(value));
    };
    std::size_t surfaceBytes = 0;
    for (const Surface& surface : texture.surfaces)
        surfaceBytes += byteCount(surface);
    line("file", path);
    line("format", std::string(texture.format));
    line("size", extentOf(base) + " texels");
    std::string pixels = std::string(encodingOf(base)) + (texture.srgb ? ", sRGB" : "");
    if (texture.componentBits > 8)
        pixels += fmt::format("; the file has {} bits a component", texture.componentBits);
    line("pixels", pixels);
    line("alpha", std::string(nameOf(texture.alpha)));
    line("first row", texture.fileTopFirst ? "at the top" : "at the bottom");
    if (texture.layers > 1)
        line("layers", fmt::format("{}; scenes show the first", texture.layers));
    if (texture.faces > 1)
        line("faces", std::to_string(texture.faces));
    line("levels", fmt::format("{} of {}", texture.levels,
                               mipLevelCount(widthOf(base), heightOf(base), depthOf(base))));
    for (int level = 0; texture.levels > 1 && level < texture.levels; ++level)
        line(fmt::format("  level {}", level),
             fmt::format("{}, {} bytes", extentOf(texture.surface(0, level)),
                         byteCount(texture.surface(0, level))));
    line("file bytes", std::to_string(fileBytes));
    const TextureReport cost = costOf(texture);
    const std::string all =
        texture.levels > 1 ? fmt::format(", all levels {:.3f} times the base", cost.ratioToBase) : "";
    line("pixel bytes", fmt::format("{}{}; {:.1f} % of RGBA8, {:.1f} % of RGB8", surfaceBytes, all,
                                    100 * cost.shareOfRgba8, 100 * cost.shareOfRgb8));
    for (const std::vector<Sentence>& sentences : {texture.notes, texture.remarks})
        for (const Sentence& sentence : sentences)
            line("note", sentence);
    return text;
}

std::string anatomyAsText(const Anatomy& anatomy) {
    std::size_t nameWidth = 4;
    std::size_t valueWidth = 5;
    std::vector<Field> fields = anatomy.fields;
    for (Field& field : fields) {
        for (Sentence* part : {&field.name, &field.value, &field.meaning, &field.wrong})
            *part = printable(*part);
        nameWidth = std::max(nameWidth, columnsOf(field.name) + static_cast<std::size_t>(2 * field.depth));
        valueWidth = std::max(valueWidth, std::min<std::size_t>(28, columnsOf(field.value)));
    }
    std::string text = fmt::format("\n{}{}{}{}meaning\n", padded("offset", 10), padded("bytes", 10),
                                   padded("name", nameWidth + 2), padded("value", valueWidth + 2));
    for (const Field& field : fields) {
        text += padded(std::to_string(field.offset), 10) + padded(std::to_string(field.size), 10) +
                padded(std::string(static_cast<std::size_t>(2 * field.depth), ' ') + field.name.english(),
                       nameWidth + 2) +
                padded(field.value, valueWidth + 2) + field.meaning.english();
        while (text.ends_with(' '))
            text.pop_back();
        text += field.wrong.empty() ? "\n"
                                    : fmt::format("\n{}! {}\n", std::string(20, ' '), field.wrong.english());
    }
    return anatomy.damage.empty() ? text : fmt::format("{}! {}\n", text, printable(anatomy.damage));
}

nlohmann::ordered_json factsAsJson(const TextureImage& texture, std::size_t fileBytes) {
    const Surface& base = texture.surface(0, 0);
    nlohmann::ordered_json levels = nlohmann::ordered_json::array();
    std::size_t surfaceBytes = 0;
    for (const Surface& surface : texture.surfaces)
        surfaceBytes += byteCount(surface);
    for (int level = 0; level < texture.levels; ++level) {
        const Surface& surface = texture.surface(0, level);
        levels.push_back({{"width", widthOf(surface)},
                          {"height", heightOf(surface)},
                          {"depth", depthOf(surface)},
                          {"bytes", byteCount(surface)}});
    }
    const TextureReport cost = costOf(texture);
    return {{"format", texture.format},
            {"width", widthOf(base)},
            {"height", heightOf(base)},
            {"depth", depthOf(base)},
            {"pixelFormat", encodingOf(base)},
            {"componentBits", texture.componentBits},
            {"srgb", texture.srgb},
            {"alpha", nameOf(texture.alpha)},
            {"fileTopFirst", texture.fileTopFirst},
            {"layers", texture.layers},
            {"faces", texture.faces},
            {"levels", levels},
            {"fullChain", mipLevelCount(widthOf(base), heightOf(base), depthOf(base))},
            {"fileBytes", fileBytes},
            {"pixelBytes", surfaceBytes},
            {"ratioToBase", cost.ratioToBase},
            {"shareOfRgba8", cost.shareOfRgba8},
            {"shareOfRgb8", cost.shareOfRgb8},
            {"notes", messagesJson(texture.notes)},
            {"remarks", messagesJson(texture.remarks)}};
}

nlohmann::ordered_json anatomyAsJson(const Anatomy& anatomy, ByteView bytes) {
    nlohmann::ordered_json fields = nlohmann::ordered_json::array();
    for (const Field& field : anatomy.fields) {
        fields.push_back({{"offset", field.offset},
                          {"size", field.size},
                          {"depth", field.depth},
                          {"name", field.name},
                          {"bytes", hex(bytesOf(field, bytes))},
                          {"value", field.value},
                          {"meaning", field.meaning},
                          {"wrong", field.wrong}});
    }
    return {{"fields", fields}, {"damage", anatomy.damage}};
}

/// What is found out about one file.
struct Examined {
    std::string text;
    nlohmann::ordered_json document; ///< null: it can't be read
    std::optional<Error> error;
};

/// The anatomy is told of a damaged file too: that is when people need it.
Examined examine(const std::string& in) {
    const std::string name = inputName(in);
    Examined examined{{}, {{"file", in}}, {}};
    const Result<Bytes> bytes = readImageInput(in);
    if (!bytes) {
        examined.document = nullptr;
        examined.error = bytes.error();
        return examined;
    }
    const Anatomy anatomy = dissect(*bytes);
    DecodeLimits limits;
    limits.everything = true;
    const Result<TextureImage> texture = outlineTexture(*bytes, anatomy, limits);
    if (texture) {
        examined.text = factsAsText(name, *texture, bytes->size());
        examined.document.update(factsAsJson(*texture, bytes->size()));
    } else {
        examined.error = Error{texture.error().code, texture.error().message, inFile(name)};
    }
    if (!anatomy.fields.empty())
        examined.text += anatomyAsText(anatomy);
    examined.document["anatomy"] = anatomyAsJson(anatomy, *bytes);
    return examined;
}

/// One document for all of them.
std::string textOf(const std::vector<Examined>& all, bool json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    std::string text;
    for (const Examined& each : all) {
        if (!each.document.is_null())
            list.push_back(each.document);
        text += text.empty() || each.text.empty() ? each.text : "\n" + each.text;
    }
    return json ? documentText(std::move(list)) : text;
}

ExitCode examineAll(const std::vector<std::string>& files, bool json) {
    if (const Result<void> once = checkStandardInputOnce(files); !once)
        return complain(once.error(), wrongCall);
    std::vector<Examined> all;
    for (const std::string& file : files)
        all.push_back(examine(file));
    ExitCode status = success;
    for (const Examined& each : all)
        if (each.error)
            status = complain(*each.error);
    if (const auto written = print(textOf(all, json)); !written)
        return complain(written.error());
    return status;
}

} // namespace

void addInfo(CommandLine& line) {
    struct Options {
        std::vector<std::string> files;
        bool json = false;
    };
    Command& command =
        line.command("info", "Show the contents of image files, field by field; for a damaged file, up to "
                             "the damage.");
    auto options = std::make_shared<Options>();
    command.option("IN", options->files, "The images: any format that Texplorer reads; - for standard input.",
                   {.required = true});
    command.flag(
        "--json", options->json,
        "As JSON, for programs, of each file: \"file\", \"format\", \"width\", \"height\", "
        "\"depth\", \"pixelFormat\", \"componentBits\" (of the file, if more than the 8 that are kept), "
        "\"srgb\", \"alpha\", \"fileTopFirst\", \"layers\", \"faces\", \"levels\", \"fullChain\", "
        "\"fileBytes\", \"pixelBytes\", \"ratioToBase\", \"shareOfRgba8\", \"shareOfRgb8\", \"notes\" "
        "(recovered defects), \"remarks\" (valid data that is ignored) and \"anatomy\" (fields, "
        "damage). If an image is damaged, it has no more than file and anatomy.");
    command.onCall([options] { return examineAll(options->files, options->json); });
}

} // namespace texplorer::screenshot
