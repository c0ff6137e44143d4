#include "app/stage/given_files.h"

#include "app/ui/files/loads.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/session.h"
#include "texplorer/codec/registry.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/scene_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace texplorer::stage {
namespace {

using ui::Load;

/// A name in no folder: it may become the name of a file that is written.
std::string plainName(const std::string& name) {
    const std::string last = std::filesystem::path(name).filename().string();
    return last.empty() || last == "." || last == ".." ? "image" : last;
}

Result<Scene> sceneIn(const NamedFile& file) {
    Result<Scene> scene =
        sceneTextIn(file.bytes).and_then([](const std::string& text) { return parseScene(text); });
    if (!scene)
        return fail(within(inFile(file.name), scene.error()));
    return scene;
}

/// The files that do not open as images.
bool isScene(const NamedFile& file, bool wantsScene) {
    if (recogniseImage(file.bytes)) // texshot's pictures contain their scene, and are images otherwise
        return wantsScene && sceneIn(file).has_value();
    constexpr std::string_view spaces = " \t\r\n";
    const auto first = std::ranges::find_if(file.bytes, [&](std::byte each) {
        return spaces.find(std::to_integer<char>(each)) == std::string_view::npos;
    });
    return file.name.ends_with(".json") || (first != file.bytes.end() && *first == std::byte{'{'});
}

/// The images of a scene, with those that are given.
struct Target {
    const Scene& scene;
    ImageSource& images;
    std::vector<std::string> added; ///< names that the scene does not use
    std::vector<Error> refused;
};

/// The name for a new image: another image of this name stays.
std::string freeName(const ImageSource& images, const std::string& wanted, const Bytes& bytes) {
    const std::filesystem::path parts(wanted);
    std::string name = wanted;
    for (int number = 2; images.holds(name); ++number) {
        const std::shared_ptr<const Bytes> there = images.fileInMemory(name);
        if (there && *there == bytes)
            return name;
        name = fmt::format("{}-{}{}", parts.stem().string(), number, parts.extension().string());
    }
    return name;
}

/// Decodes a file, within the budget that the `others` leave.
Result<void> put(ImageSource& images, const std::string& name, const Bytes& bytes, bool isMesh,
                 const std::set<std::string>& others) {
    const std::size_t left = sceneImageBytes - std::min(sceneImageBytes, images.bytesOf(others));
    if (isMesh) {
        Result<MeshFile> meshes = meshFileIn(bytes, {});
        if (meshes && byteCount(*meshes) > left)
            return fail(beyondBudget(byteCount(*meshes), left));
        if (!meshes)
            return fail(meshes.error());
        images.put(name, std::make_shared<const MeshFile>(*std::move(meshes)));
    } else {
        Result<TextureImage> image = decodeWithin(bytes, left);
        if (!image)
            return fail(image.error());
        images.put(name, *std::move(image));
    }
    images.putFile(name, bytes);
    return {};
}

void addImage(Target& target, const NamedFile& file) {
    const std::set<std::string> used = filesOf(target.scene);
    std::string name = plainName(file.name);
    const bool isMesh = used.contains(name) && isObjName(name);
    if (!isMesh)
        name = freeName(target.images, name, file.bytes);
    if (const Result<void> added = put(target.images, name, file.bytes, isMesh, used); !added)
        target.refused.push_back({added.error().code, added.error().message, inFile(file.name)});
    else if (!used.contains(name))
        target.added.push_back(name);
}

/// Tells the user about files that were not opened: a single one in the status bar.
void tellRefused(ui::Session& session, std::vector<Error> refused, std::size_t files) {
    if (files == 1 && refused.size() == 1)
        return ui::say(session, refused.front());
    std::ranges::move(refused, std::back_inserter(session.asking.refused));
}

/// The given images are edits of the document's scene.
void addToDocument(ui::Session& session, const Target& target, const std::string& param) {
    Load load{
        .kind = Load::Kind::Add, .pass = session.look.selection.pass, .unit = session.look.selection.unit};
    if (target.added.size() == 1) {
        load.kind = param.empty() ? Load::Kind::Import : Load::Kind::SetFile;
        load.path = load.file = target.added.front();
        load.param = param;
    }
    load.added = target.added;
    if (!load.added.empty())
        ui::start(session, std::move(load));
}

void showScene(ui::Session& session, Load load, std::vector<std::string> added) {
    load.added = std::move(added);
    ui::addImages(load.scene, load.images, load);
    ui::showLoadedScene(session, std::move(load));
    if (session.asking.dialog != ui::Dialog::Discard)
        session.document.used.clear(); // images that were not given are read
}

} // namespace

void openGivenFiles(ui::Session& session, const FilesGiven& given) {
    const bool wantsScene = given.answers && given.answers->isScene;
    std::optional<Load> opened;
    std::vector<Error> refused;
    std::vector<const NamedFile*> images;
    for (const NamedFile& file : given.files) {
        if (!isScene(file, wantsScene)) {
            images.push_back(&file);
        } else if (Result<Scene> scene = sceneIn(file)) {
            opened = Load{.kind = Load::Kind::Scene,
                          .goesOn = true,
                          .scene = *std::move(scene),
                          .before = wantsScene ? session.document.scene : session.document.saved,
                          .suggested = plainName(file.name)};
        } else {
            refused.push_back(scene.error());
        }
    }
    Target target{opened ? opened->scene : session.document.scene,
                  opened ? opened->images : session.document.images,
                  {},
                  std::move(refused)};
    for (const NamedFile* image : images)
        addImage(target, *image);
    tellRefused(session, std::exchange(target.refused, {}), given.files.size());
    if (opened)
        showScene(session, *std::move(opened), std::move(target.added));
    else
        addToDocument(session, target, given.answers ? given.answers->param : std::string());
}

bool replaceGivenFile(ui::Session& session, const Bytes& before, const Bytes& now) {
    ImageSource& images = session.document.images;
    bool hasReplaced = false;
    const std::set<std::string> used =
        session.document.isLessons ? std::set<std::string>() : filesOf(session.document.scene);
    for (const std::string& name : used) {
        if (const std::shared_ptr<const Bytes> there = images.fileInMemory(name); !there || *there != before)
            continue;
        std::set<std::string> others = used;
        others.erase(name);
        std::set<std::string>& damaged = session.document.damaged;
        if (const Result<void> replaced = put(images, name, now, isObjName(name), others)) {
            hasReplaced = true;
            if (damaged.erase(name) > 0 && !session.look.notice.isGood)
                session.look.notice = {};
        } else if (damaged.insert(name).second) {
            ui::say(session, Error{replaced.error().code,
                                   Sentence("has changed and can't be read, so the old image stays: {0}",
                                            replaced.error().message),
                                   inFile(name)});
        }
    }
    return hasReplaced;
}

} // namespace texplorer::stage
