#include "app/ui/files/scene_saving.h"

#include "app/ui/files/loads.h"
#include "app/ui/files/scene_paths.h"
#include "app/ui/model/notice.h"
#include "app/ui/services/settings_file.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/scene_file.h"
#include "texplorer/suite/hash.h"

#include <memory>
#include <utility>

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;

/// The same scene with its image files named from another folder. Names of files in no folder stay unchanged.
Scene rebased(const Scene& scene, const ImageSource& images, const fs::path& to) {
    Scene result = scene;
    renameFiles(result, [&](const std::string& file) {
        return images.fileInMemory(file) ? file : nameFrom(to, images.directory() / file);
    });
    return result;
}

/// Images in no folder are moved to that of the scene, unless it has another file of their name.
Result<void> saveFilesInMemory(const Scene& scene, const ImageSource& images, const fs::path& folder) {
    const auto another = [&](const std::string& file) {
        return fail(ErrorCode::Unwritable,
                    "the scene has an image of this name, but another file has it "
                    "too",
                    inFile((folder / file).string()));
    };
    std::vector<std::string> missing;
    for (const std::string& file : filesOf(scene)) {
        const std::shared_ptr<const Bytes> bytes = images.fileInMemory(file);
        if (!bytes)
            continue;
        const Result<Bytes> there = readFile(folder / file);
        if (!there && there.error().code == ErrorCode::NotFound)
            missing.push_back(file);
        else if (!there || *there != *bytes)
            return another(file);
    }
    for (const std::string& file : missing) {
        const Result<bool> written = writeFileIf(folder / file, *images.fileInMemory(file),
                                                 [&] { return !fingerprintOf(folder / file); });
        if (!written)
            return fail(written.error());
        if (!*written)
            return another(file);
    }
    return {};
}

bool isOwnFile(const Document& document, const fs::path& file) {
    if (document.file.empty())
        return false;
    const std::optional<FileFingerprint> there = fingerprintOf(file);
    return document.file == file || (there && there == fingerprintOf(document.file));
}

/// The content of the document's file, if it is neither the old one nor the one to be saved; nullptr:
/// replacing it loses nothing. Another text of the same scene is not a change.
std::shared_ptr<const ChangedFile> changedFileOf(const Document& document, const fs::path& file,
                                                 const Scene& mine) {
    const Result<std::string> text = readText(file, maxSceneBytes);
    if (!text && text.error().code == ErrorCode::NotFound)
        return nullptr;
    std::string hash = text ? suite::hashOf(*text) : "unreadable";
    if (hash == document.fileHash)
        return nullptr;
    Result<Scene> theirs = text ? parseScene(*text) : Result<Scene>(fail(text.error()));
    if (theirs)
        document.images.fillMeshes(*theirs);
    if (theirs && (*theirs == mine || (!document.fileHash.empty() && *theirs == document.saved)))
        return nullptr;
    std::vector<SceneChange> changes = theirs ? changesBetween(*theirs, mine) : std::vector<SceneChange>();
    return std::make_shared<const ChangedFile>(
        ChangedFile{std::move(hash), std::move(theirs), std::move(changes)});
}

} // namespace

Result<SceneText> readScene(const fs::path& path) {
    Result<SceneContent> read = readSceneFile(path);
    if (!read)
        return fail(read.error());
    Result<Scene> scene = parseScene(read->text);
    if (!scene)
        return fail(within(inFile(path.string()), scene.error()));
    return SceneText{std::move(*scene), suite::hashOf(read->text)};
}

Result<Saving> saveScene(Session& session, const fs::path& path,
                         const std::optional<FileFingerprint>& replaces) {
    const fs::path file = absolutePath(path);
    const fs::path folder = file.parent_path();
    Document& document = session.document;
    const Scene scene = rebased(document.scene, document.images, folder);
    const std::string text = writeScene(scene);
    if (text.size() > maxSceneBytes) // the existing file stays
        return fail(
            ErrorCode::TooLarge,
            Sentence("the scene takes {0} bytes, but only {1} can be read again", text.size(), maxSceneBytes),
            inFile(file.string()));
    const bool isOwn = isOwnFile(document, file);
    const auto mayReplace = [&] {
        if (!isOwn)
            return fingerprintOf(file) == replaces;
        document.changedFile = changedFileOf(document, file, scene);
        return document.changedFile == nullptr;
    };
    if (isOwn && !mayReplace())
        return Saving::FileHasChanged;
    if (Result<void> images = saveFilesInMemory(scene, document.images, folder); !images)
        return fail(images.error());
    const Result<bool> written = writeFileIf(file, viewBytes(text), mayReplace);
    if (!written)
        return fail(written.error());
    if (!*written && isOwn)
        return Saving::FileHasChanged;
    if (!*written)
        return fail(ErrorCode::Unwritable, "another program has written this file meanwhile",
                    inFile(file.string()));
    if (absolutePath(document.images.directory()) != folder || document.file.empty()) {
        ImageSource images(folder);
        const std::vector<FileName> before = fileNamesOf(document.scene);
        const std::vector<FileName> after = fileNamesOf(scene);
        for (std::size_t i = 0; i < after.size(); ++i)
            images.share(after[i].file, document.images, before[i].file);
        document.images = std::move(images);
    }
    if (scene != document.scene) {
        document.scene = scene;
        document.history.seal();
        document.history.record(scene, N_("Save elsewhere"));
        showPresent(session);
    }
    document.saved = scene;
    document.file = file;
    document.fileHash = suite::hashOf(text);
    rememberFile(session.settings, file);
    return Saving::Written;
}

void keepMine(Session& session) {
    if (const std::shared_ptr<const ChangedFile> changed = std::exchange(session.document.changedFile, {}))
        session.document.fileHash = changed->hash;
}

void takeTheirs(Session& session) {
    session.document.changedFile.reset();
    const fs::path file = session.document.file;
    Result<SceneText> read = readScene(file); // it may have changed again
    if (!read)
        return say(session, read.error());
    start(session, {.kind = Load::Kind::Scene,
                    .path = file,
                    .scene = std::move(read->scene),
                    .before = session.document.scene,
                    .images = ImageSource(file.parent_path()),
                    .fileHash = std::move(read->hash),
                    .reloads = true});
}

} // namespace texplorer::ui
