#include "app/ui/editor/received_files.h"

#include "app/ui/editor/editor.h"
#include "app/ui/files/inspected_file.h"
#include "app/ui/files/loads.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/session.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/storage/scene_file.h"

#include <algorithm>
#include <set>

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;

/// Adds the loaded files and their whole content to a source.
void putAll(ImageSource& images, const Load& load) {
    for (const auto& [file, content] : load.arrived) {
        if (const auto* texture = std::get_if<std::shared_ptr<const TextureImage>>(&content))
            images.put(file, *texture);
        else
            images.put(file, std::get<std::shared_ptr<const MeshFile>>(content));
    }
}

/// Takes in a file that has arrived, if the images of its scene leave room for it.
Result<void> arrive(const Session& session, Load& load, const std::vector<std::string>& spellings,
                    const ImageLoader::Content& content) {
    const auto* image = std::get_if<std::shared_ptr<const TextureImage>>(&content);
    const std::size_t bytes =
        image ? byteCount(**image) : byteCount(*std::get<std::shared_ptr<const MeshFile>>(content));
    const bool own = load.kind == Load::Kind::Scene;
    ImageSource images = own ? load.images : session.document.images;
    std::set<std::string> files = filesOf(own ? load.scene : session.document.scene);
    putAll(images, load);
    for (const auto& [file, arrived] : load.arrived)
        files.insert(file);
    for (const std::string& file : spellings)
        files.erase(file); // replaced files
    const std::size_t used = images.bytesOf(files);
    if (used + bytes > sceneImageBytes) {
        Error refused = beyondBudget(bytes, sceneImageBytes - std::min(sceneImageBytes, used));
        refused.where = inFile((folderOf(session, load) / spellings.front()).string());
        return fail(std::move(refused));
    }
    for (const std::string& file : spellings)
        load.arrived[file] = content;
    return {};
}

void finishImport(Session& session, const Load& load) {
    session.look.fileView.chosen.clear(); // the tab shows the new image
    submit(session, Sentence("Open {0}", ProperName{load.path.filename().string()}),
           [&](Scene& scene) { bindFile(scene, load.pass, load.unit, load.file); });
}

/// The models of all scenes of the document have the vertices of the files that are loaded: also after undo,
/// and where another file has replaced one.
void followMeshes(Session& session) {
    Document& document = session.document;
    Kept& kept = document.kept;
    const auto isFilled = [&](const Scene* scene) { return !scene || document.images.hasFilled(*scene); };
    if (isFilled(&document.scene) && isFilled(kept.scene.get()))
        return;
    const auto fill = [&](Scene& scene) { document.images.fillMeshes(scene); };
    for (std::shared_ptr<const Scene>* each : {&kept.scene, &kept.seen}) {
        if (!*each)
            continue;
        auto filled = std::make_shared<Scene>(**each);
        fill(*filled);
        *each = std::move(filled);
    }
    if (kept.flippedAt)
        fill(*kept.flippedAt);
    fill(document.scene);
    fill(document.saved);
    document.history.change(fill);
    showPresent(session);
}

/// The user gets the message in the next frame that has room for it.
void tellRefused(Session& session, std::vector<Error>& refused) {
    session.asking.refused.insert(session.asking.refused.end(), refused.begin(), refused.end());
    refused.clear();
}

/// Puts all of them into one undo step.
void finishAdd(Session& session, Load& load) {
    submit(session, Sentence("Open {0} images", load.added.size()),
           [&](Scene& scene) { addImages(scene, session.document.images, load); });
    tellRefused(session, load.refused);
}

/// The scene of an OBJ file, whose images are read next.
void finishObj(Session& session, Load load) {
    const std::shared_ptr<const MeshFile> meshes = load.images.meshesOf(load.obj);
    Result<SceneContent> content =
        meshes ? sceneOfObj(*meshes, load.obj) : Result<SceneContent>(fail(load.refused.back()));
    Result<Scene> scene = content ? parseScene(content->text) : Result<Scene>(fail(content.error()));
    if (!scene)
        return say(session, scene.error(), folderOf(session, load) / load.obj);
    load.scene = *std::move(scene);
    for (const Sentence& note : content->notes)
        load.notes.push_back(describe({ErrorCode::Unsupported, note, inFile(load.obj)}));
    load.obj.clear();
    load.arrived.clear();
    start(session, std::move(load));
}

void finishSetFile(Session& session, const Load& load) {
    const std::string owner = load.param.substr(0, load.param.rfind('.') + 1);
    const std::string source(rowOf(SourceKind::File).name);
    submit(
        session, "File",
        [&](Scene& scene) {
            if (setParam(scene, load.param, load.file)) // else it was removed in the meantime
                static_cast<void>(setParam(scene, owner + keyOf<&Texture::source>(), source));
        },
        load.param);
}

void finishReload(Session& session, const Load& load) {
    if (session.document.damaged.erase(load.file) > 0 &&
        session.look.notice.file == session.document.images.directory() / load.file)
        session.look.notice = {};
}

/// Whether it makes an undo step, or another scene.
bool isEdit(const Load& load) {
    return load.kind != Load::Kind::Reload && load.kind != Load::Kind::Used;
}

/// All files have arrived. Returns false if it has to wait for the user.
bool finish(Session& session, Load& load) {
    if (session.out.movesVertices && isEdit(load))
        return false; // otherwise the move would be two undo steps with this one in between
    if (load.kind == Load::Kind::Scene) {
        if (session.asking.dialog != Dialog::None)
            return false;
        putAll(load.images, load);
        if (!load.obj.empty()) {
            finishObj(session, std::move(load));
            return true;
        }
        load.images.fillMeshes(load.scene);
        addImages(load.scene, load.images, load);
        tellRefused(session, load.refused);
        showLoadedScene(session, std::move(load));
        return true;
    }
    putAll(session.document.images, load);
    followMeshes(session);
    if (load.kind == Load::Kind::Import)
        finishImport(session, load);
    else if (load.kind == Load::Kind::Add)
        finishAdd(session, load);
    else if (load.kind == Load::Kind::SetFile)
        finishSetFile(session, load);
    else if (load.kind == Load::Kind::Reload)
        finishReload(session, load);
    return true;
}

/// Changes nothing and tells the user. A file that was valid before keeps its old picture, and is mentioned
/// once.
void giveUp(Session& session, const Load& load, const std::string& file, const Error& error) {
    const fs::path path = folderOf(session, load) / file;
    if (load.kind != Load::Kind::Reload)
        return say(session, error, path);
    if (session.document.damaged.insert(file).second)
        say(session,
            {error.code,
             Sentence("has changed and can't be read, so the old image stays: {0}", error.message),
             inFile(path.string())},
            path);
}

void finishInOrder(Session& session) {
    while (!session.document.loads.empty() && session.document.loads.front().waits.empty()) {
        Load load = std::move(session.document.loads.front());
        session.document.loads.erase(session.document.loads.begin());
        if (!finish(session, load)) {
            session.document.loads.insert(session.document.loads.begin(), std::move(load));
            return;
        }
        takeRequests(session); // the next one goes on from its scene
    }
}

void receive(Session& session, ImageLoader::Loaded loaded) {
    if (loaded.ticket == session.look.fileView.ticket)
        return receiveInspected(session, std::move(loaded.content));
    const auto load = std::ranges::find_if(
        session.document.loads, [&](const Load& each) { return each.waits.contains(loaded.ticket); });
    if (load == session.document.loads.end())
        return;
    const std::vector<std::string> spellings = load->waits.at(loaded.ticket);
    load->waits.erase(loaded.ticket);
    const Result<void> taken =
        loaded.content ? arrive(session, *load, spellings, *loaded.content) : fail(loaded.content.error());
    if (!taken && load->goesOn) {
        load->refused.push_back(taken.error());
    } else if (!taken) {
        const Load failed = std::move(*load);
        session.document.loads.erase(load);
        cancelWaiting(session, failed);
        giveUp(session, failed, spellings.front(), taken.error());
    }
}

/// The images that are in a folder, and those that are being read: they may have changed after it.
std::set<std::string> filesOnDisk(const Document& document) {
    std::set<std::string> files;
    for (const std::string& file : document.images.files()) {
        if (!document.images.fileInMemory(file))
            files.insert(file);
    }
    for (const Load& load : document.loads) {
        if (!load.file.empty())
            files.insert(load.file);
    }
    return files;
}

/// Returns true if the open lesson has changed: it is read again in the next frame that has room for it.
bool reloadChanged(Session& session) {
    const std::set<std::string> files = filesOnDisk(session.document);
    std::optional<LessonRun>& lesson = session.lesson;
    bool lessonHasChanged = false;
    for (const fs::path& changed : session.services.files->changed()) {
        if (changed == session.look.fileView.shown)
            refreshInspected(session);
        if (lesson && std::ranges::find(lesson->files, changed) != lesson->files.end())
            lesson->hasChanged = lessonHasChanged = true;
        for (const std::string& file : files) {
            if (session.document.images.directory() / file == changed)
                start(session, {.kind = Load::Kind::Reload, .path = changed, .file = file});
        }
    }
    return lessonHasChanged;
}

/// An edit may add a file that was never read: unused files of a scene are not read with it.
void loadUsed(Session& session) {
    std::set<std::string> used = filesOf(session.document.scene);
    for (const std::string& file : used) {
        if (!file.empty() && !session.document.used.contains(file) && !session.document.images.holds(file))
            start(
                session,
                {.kind = Load::Kind::Used, .path = session.document.images.directory() / file, .file = file});
    }
    session.document.used = std::move(used);
}

void watchFiles(Session& session) {
    std::vector<fs::path> paths;
    for (const std::string& file : filesOnDisk(session.document))
        paths.push_back(session.document.images.directory() / file);
    if (!session.look.fileView.shown.empty() && !session.look.fileView.inMemory)
        paths.push_back(session.look.fileView.shown);
    if (session.lesson)
        std::ranges::copy(session.lesson->files, std::back_inserter(paths));
    session.services.files->watch(std::move(paths));
}

} // namespace

bool receiveFiles(Session& session) {
    Services& services = session.services;
    loadUsed(session);
    bool news = services.levels->receive();
    news |= services.files->receiveThumbnails();
    for (ImageLoader::Loaded& loaded : services.files->take()) {
        receive(session, std::move(loaded));
        news = true;
    }
    const std::size_t before = session.document.loads.size();
    finishInOrder(session);
    news |= reloadChanged(session);
    followMeshes(session);
    watchFiles(session);
    return news || session.document.loads.size() != before;
}

void waitForFiles(Session& session) {
    do // of an OBJ file the images are known when it has arrived
        session.services.files->wait();
    while (receiveFiles(session));
}

} // namespace texplorer::ui
