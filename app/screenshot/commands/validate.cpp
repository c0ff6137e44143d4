// Whether files are what they should be, strictly: what a decoder survives is a fault here.

#include "app/screenshot/arguments/input.h"
#include "app/screenshot/command.h"
#include "app/screenshot/output/json_text.h"
#include "core/base/printable.h"
#include "core/codec/registry.h"
#include "core/scene/params/json.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::screenshot {
namespace {

/// What a file is held to be, and what is wrong with it.
struct Validity {
    std::string file;
    std::string kind; ///< "PNG", "scene"; empty: it couldn't be told
    std::vector<std::string> faults{};

    [[nodiscard]] bool isValid() const { return faults.empty(); }
};

void addOnce(std::vector<std::string>& faults, std::string fault) {
    if (std::ranges::find(faults, fault) == faults.end())
        faults.push_back(std::move(fault));
}

/// All that the decoder refuses or notes, and all that looks wrong in a field.
Validity validateImage(const std::string& in, ByteView file) {
    Validity validity{in, std::string(recogniseImage(file)->name)};
    const Result<TextureImage> texture = decodeTexture(file);
    if (!texture)
        addOnce(validity.faults, texture.error().message);
    for (const std::string& note : texture ? texture->notes : std::vector<std::string>())
        addOnce(validity.faults, note);
    const Anatomy anatomy = dissect(file);
    for (const Field& field : anatomy.fields)
        if (!field.wrong.empty())
            addOnce(validity.faults, fmt::format("{} at {}: {}", field.name, field.offset, field.wrong));
    if (!anatomy.damage.empty() && texture) // else the decoder has said it
        addOnce(validity.faults, anatomy.damage);
    return validity;
}

Validity validateScene(const std::string& in, ByteView file) {
    Validity validity{in, "scene"};
    if (file.size() > maxSceneBytes) {
        validity.faults.push_back(
            fmt::format("at most {} bytes of a scene are read, it has {}", maxSceneBytes, file.size()));
        return validity;
    }
    const Result<Scene> scene = parseScene({reinterpret_cast<const char*>(file.data()), file.size()});
    if (!scene)
        validity.faults.push_back(describe(scene.error()));
    return validity;
}

bool beginsAsJson(ByteView file) {
    constexpr std::string_view space = " \t\r\n";
    std::string_view text(reinterpret_cast<const char*>(file.data()),
                          std::min<std::size_t>(file.size(), 4096));
    text.remove_prefix(std::min(text.find_first_not_of(space), text.size()));
    return text.starts_with("{");
}

/// By its content: an image, a scene, or nothing that is known. A name that ends in .json promises a scene.
Validity validate(const std::string& in, ByteView file) {
    if (recogniseImage(file) != nullptr)
        return validateImage(in, file);
    if (beginsAsJson(file) || in.ends_with(".json"))
        return validateScene(in, file);
    const std::string why = decodeTexture(file).error().message;
    constexpr std::string_view image = "expected an image";
    return {
        in, {}, {why.starts_with(image) ? "expected a scene or an image" + why.substr(image.size()) : why}};
}

Validity validateFile(const std::string& in) {
    const Result<Bytes> file = readInput(
        in, defaultMaxFileBytes, [](ByteView start) { return recogniseImage(start) || beginsAsJson(start); });
    if (!file)
        return {in, {}, {file.error().message}};
    return validate(in, *file);
}

std::string validityText(const std::vector<Validity>& all) {
    std::string text;
    for (const Validity& each : all) {
        std::string faults;
        for (const std::string& fault : each.faults)
            faults += (faults.empty() ? "" : "; ") + printable(fault);
        text += fmt::format("{}: {}{}\n", printable(inputName(each.file)),
                            each.kind.empty() ? std::string() : each.kind + ", ",
                            each.isValid() ? "valid" : "not valid: " + faults);
    }
    return text;
}

std::string validityJson(const std::vector<Validity>& all, bool valid) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const Validity& each : all)
        files.push_back(
            {{"file", each.file}, {"valid", each.isValid()}, {"kind", each.kind}, {"faults", each.faults}});
    return documentText({{"valid", valid}, {"files", std::move(files)}});
}

ExitCode validateAll(const std::vector<std::string>& files, bool json) {
    if (const Result<void> once = checkStandardInputOnce(files); !once)
        return complain(once.error(), wrongCall);
    std::vector<Validity> all;
    for (const std::string& file : files)
        all.push_back(validateFile(file));
    const bool valid = std::ranges::all_of(all, &Validity::isValid);
    const Result<void> printed = print(json ? validityJson(all, valid) : validityText(all));
    if (!printed)
        return complain(printed.error());
    return valid ? success : failure;
}

} // namespace

void addValidate(CommandLine& line) {
    struct Options {
        std::vector<std::string> files;
        bool json = false;
    };
    Command& command =
        line.command("validate", "Whether image files and scenes are what they should be, to the letter.");
    auto options = std::make_shared<Options>();
    command.option("FILE", options->files,
                   "Images and scenes, told apart by their content; - for standard input.",
                   {.required = true});
    command.flag("--json", options->json,
                 "As JSON, for programs: \"valid\" and \"files\" (file, valid, kind, faults).");
    command.footer(
        "A line for each file on standard output. Of an image, what is odd and survived by who reads it is "
        "a fault, too; of a scene, keys that there aren't and values out of their range. What a scene draws "
        "is not looked at: \"texshot check\" does that.\n"
        "Exit status: 0 all are valid, 1 one isn't or can't be read, 2 a wrong call.");
    command.onCall([options] { return validateAll(options->files, options->json); });
}

} // namespace texplorer::screenshot
