#include "app/ui/model/loads.h"

#include "app/ui/model/document.h"
#include "app/ui/model/session.h"
#include "core/base/file_fingerprint.h"

#include <algorithm>
#include <set>

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;
using Wanted = ImageLoader::Wanted;

/// What a load needs of the images that are not there.
std::set<std::string> missingFiles(const Session& session, const Load& load) {
    if (load.kind == Load::Kind::Reload)
        return {load.file};
    if (load.kind == Load::Kind::Import || load.kind == Load::Kind::SetFile)
        return session.images.holds(load.file) ? std::set<std::string>{} : std::set{load.file};
    std::set<std::string> files(load.added.begin(), load.added.end());
    if (load.kind == Load::Kind::Add)
        std::erase_if(files, [&](const std::string& file) { return session.images.holds(file); });
    files.merge(filesOf(load.scene));
    return files;
}

fs::path folderOf(const Session& session, const Load& load) {
    return load.kind == Load::Kind::Scene ? load.images.directory() : session.images.directory();
}

/// The files that a load needs, each with all spellings that it has.
std::vector<std::vector<std::string>> missingBySpelling(const Session& session, const Load& load) {
    std::vector<std::vector<std::string>> missing;
    std::map<FileFingerprint, std::size_t> places;
    for (const std::string& file : missingFiles(session, load)) {
        const std::optional<FileFingerprint> same = fingerprintOf(folderOf(session, load) / file);
        const auto known = same ? places.find(*same) : places.end();
        if (known != places.end()) {
            missing[known->second].push_back(file);
            continue;
        }
        if (same)
            places[*same] = missing.size();
        missing.push_back({file});
    }
    return missing;
}

/// The loaded files become part of a source, with all that they hold.
void putAll(ImageSource& images, const Load& load) {
    for (const auto& [file, texture] : load.arrived)
        images.put(file, texture);
}

/// Takes in a file that has arrived, if the images of the scene that it is for leave room for it.
Result<void> arrive(const Session& session, Load& load, const std::vector<std::string>& spellings,
                    const ImageLoader::Content& content) {
    const auto& image = std::get<std::shared_ptr<const TextureImage>>(content);
    const bool own = load.kind == Load::Kind::Scene;
    ImageSource images = own ? load.images : session.images;
    std::set<std::string> files = filesOf(own ? load.scene : session.scene);
    putAll(images, load);
    for (const auto& [file, texture] : load.arrived)
        files.insert(file);
    for (const std::string& file : spellings)
        files.erase(file); // what it replaces
    const std::size_t used = images.bytesOf(files);
    if (used + byteCount(*image) > sceneImageBytes) {
        Error refused = beyondBudget(byteCount(*image), sceneImageBytes - std::min(sceneImageBytes, used));
        refused.where = (folderOf(session, load) / spellings.front()).string();
        return fail(std::move(refused));
    }
    for (const std::string& file : spellings)
        load.arrived[file] = image;
    return {};
}

void finishImport(Session& session, const Load& load) {
    bindFile(session.scene, load.pass, load.unit, load.file);
    sealEdit(session);
    recordEdit(session, "Open " + load.path.filename().string());
    sealEdit(session);
}

/// One step of undo for all of them.
void finishAdd(Session& session, Load& load) {
    addImages(session.scene, session.images, load);
    sealEdit(session);
    recordEdit(session, "Open " + std::to_string(load.added.size()) + " images");
    sealEdit(session);
}

/// The user is told with the next frame that has room for it.
void tellRefused(Session& session, std::vector<Error>& refused) {
    session.refused.insert(session.refused.end(), refused.begin(), refused.end());
    refused.clear();
}

void finishSetFile(Session& session, const Load& load) {
    const auto index = static_cast<std::size_t>(load.texture);
    if (index >= session.scene.textures.size())
        return; // it was removed meanwhile
    session.scene.textures[index].file = load.file;
    sealEdit(session);
    recordEdit(session, "File", "textures[" + std::to_string(index) + "].file");
    sealEdit(session);
}

void finishReload(Session& session, const Load& load) {
    if (session.damaged.erase(load.file) > 0 && session.notice.file == session.images.directory() / load.file)
        session.notice = {};
}

/// Everything has arrived. False: it has to wait for the user.
bool finish(Session& session, Load& load) {
    switch (load.kind) {
    case Load::Kind::Import:
        putAll(session.images, load);
        finishImport(session, load);
        return true;
    case Load::Kind::Add:
        putAll(session.images, load);
        finishAdd(session, load);
        tellRefused(session, load.refused);
        return true;
    case Load::Kind::SetFile:
        putAll(session.images, load);
        finishSetFile(session, load);
        return true;
    case Load::Kind::Reload:
        putAll(session.images, load);
        finishReload(session, load);
        return true;
    case Load::Kind::Scene:
        if (session.dialog != Dialog::None)
            return false;
        putAll(load.images, load);
        addImages(load.scene, load.images, load);
        tellRefused(session, load.refused);
        showLoadedScene(session, std::move(load));
        return true;
    }
    return true;
}

/// Nothing is changed; the user is told. A file that was fine before keeps its old picture, and is mentioned
/// once.
void giveUp(Session& session, const Load& load, const std::string& file, const Error& error) {
    const fs::path path = folderOf(session, load) / file;
    if (load.kind != Load::Kind::Reload)
        return say(session, error, path);
    if (session.damaged.insert(file).second)
        say(session,
            {error.code, "has changed and can't be read now, its old picture stays: " + error.message,
             path.string()},
            path);
}

void finishInOrder(Session& session) {
    while (!session.loads.empty() && session.loads.front().waits.empty()) {
        Load load = std::move(session.loads.front());
        session.loads.erase(session.loads.begin());
        if (!finish(session, load)) {
            session.loads.insert(session.loads.begin(), std::move(load));
            return;
        }
    }
}

void cancelWaiting(Session& session, const Load& load) {
    for (const auto& [ticket, spellings] : load.waits)
        session.background->loader.cancel(ticket);
}

void receive(Session& session, ImageLoader::Loaded loaded) {
    if (loaded.ticket == session.fileView.ticket)
        return receiveView(session, std::move(loaded.content));
    const auto load = std::ranges::find_if(
        session.loads, [&](const Load& each) { return each.waits.contains(loaded.ticket); });
    if (load == session.loads.end())
        return;
    const std::vector<std::string> spellings = load->waits.at(loaded.ticket);
    load->waits.erase(loaded.ticket);
    const Result<void> taken =
        loaded.content ? arrive(session, *load, spellings, *loaded.content) : fail(loaded.content.error());
    if (!taken && load->goesOn) {
        load->refused.push_back(taken.error());
    } else if (!taken) {
        const Load failed = std::move(*load);
        session.loads.erase(load);
        cancelWaiting(session, failed);
        giveUp(session, failed, spellings.front(), taken.error());
    }
}

void reloadChanged(Session& session) {
    std::set<std::string> files;
    for (const std::string& file : session.images.files())
        files.insert(file);
    for (const Load& load : session.loads) { // what is being read may have changed after it was read
        if (!load.file.empty())
            files.insert(load.file);
    }
    for (const fs::path& changed : session.background->watch.changed()) {
        if (changed == session.fileView.shown)
            refreshView(session);
        for (const std::string& file : files) {
            if (session.images.directory() / file == changed)
                (void)start(session, {.kind = Load::Kind::Reload, .path = changed, .file = file});
        }
    }
}

void watchFiles(Session& session) {
    std::vector<fs::path> paths;
    for (const std::string& file : session.images.files())
        paths.push_back(session.images.directory() / file);
    for (const Load& load : session.loads) {
        if (!load.file.empty())
            paths.push_back(session.images.directory() / load.file);
    }
    if (!session.fileView.shown.empty())
        paths.push_back(session.fileView.shown);
    session.background->watch.watch(std::move(paths));
}

Result<void> startNow(Session& session, Load& load) {
    const fs::path folder = folderOf(session, load);
    for (const std::vector<std::string>& spellings : missingBySpelling(session, load)) {
        const Result<ImageLoader::Content> content = loadNow(folder / spellings.front(), Wanted::Texture);
        const Result<void> taken =
            content ? arrive(session, load, spellings, *content) : fail(content.error());
        if (!taken && load.goesOn)
            load.refused.push_back(taken.error());
        else if (!taken)
            return taken;
    }
    (void)finish(session, load);
    return {};
}

} // namespace

Result<void> start(Session& session, Load load) {
    if (!session.background)
        return startNow(session, load);
    const fs::path folder = folderOf(session, load);
    for (std::vector<std::string>& spellings : missingBySpelling(session, load)) {
        const ImageLoader::Ticket ticket = session.background->loader.load(folder / spellings.front());
        load.waits[ticket] = std::move(spellings);
    }
    if (load.kind == Load::Kind::Scene) { // the last one that was asked for is the one that is wanted
        std::erase_if(session.loads, [&](const Load& each) {
            if (each.kind == Load::Kind::Scene)
                cancelWaiting(session, each);
            return each.kind == Load::Kind::Scene;
        });
    }
    session.loads.push_back(std::move(load));
    return {};
}

bool receiveFiles(Session& session) {
    bool news = levelsOf(session).receive();
    if (!session.background)
        return news;
    Background& background = *session.background;
    news |= background.thumbnails.receive();
    for (ImageLoader::Loaded& loaded : background.loader.take()) {
        receive(session, std::move(loaded));
        news = true;
    }
    const std::size_t before = session.loads.size();
    finishInOrder(session);
    reloadChanged(session);
    watchFiles(session);
    return news || session.loads.size() != before;
}

void cancelLoad(Session& session, ImageLoader::Ticket ticket) {
    if (!session.background)
        return;
    session.background->loader.cancel(ticket);
    if (ticket == session.fileView.ticket) {
        session.fileView.ticket = 0;
        session.fileView.problem = "Reading was cancelled.";
    }
    std::erase_if(session.loads, [&](const Load& load) {
        const bool given = load.waits.contains(ticket);
        if (given)
            cancelWaiting(session, load);
        return given;
    });
}

void cancelLoads(Session& session) {
    session.loads.clear();
    session.fileView.ticket = 0;
    if (session.background)
        session.background->loader.cancelAll();
}

void waitForFiles(Session& session) {
    if (!session.background)
        return;
    session.background->loader.wait();
    session.background->thumbnails.wait();
    (void)receiveFiles(session);
}

} // namespace texplorer::ui
