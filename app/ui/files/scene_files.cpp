#include "app/ui/files/scene_files.h"

#include "app/ui/files/loads.h"
#include "app/ui/files/replaced_document.h"
#include "app/ui/files/scene_paths.h"
#include "app/ui/files/scene_saving.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/timeline_edits.h"
#include "texplorer/codec/image_file.h"
#include "texplorer/codec/registry.h"
#include "texplorer/files/file_io.h"
#include "texplorer/lesson/example.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/storage/scene_file.h"
#include "texplorer/scene/storage/scene_link.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;

/// The same for a file that becomes an image of a source; absolute if the scene was never saved.
std::string nameIn(const ImageSource& images, const fs::path& file) {
    return images.directory().empty() ? absolutePath(file).generic_string()
                                      : nameFrom(images.directory(), file);
}

/// The scene in the file, if it can be read: for undo and the mark of unsaved changes.
SceneText savedScene(const fs::path& file) {
    return file.empty() ? SceneText{defaultScene()} : readScene(file).value_or(SceneText{});
}

/// Replaces the document's scene by what another program has written, as a step of its history; the view
/// stays.
void replaceByFile(Session& session, Load load) {
    Document document(std::move(load.scene), std::move(load.images), load.path);
    document.fileHash = std::move(load.fileHash);
    document.needsFit = false; // it was saved like this
    document.kept = std::move(session.document.kept);
    document.history = std::move(session.document.history);
    document.history.seal();
    document.history.record(document.scene, N_("Reload the file"));
    document.history.seal();
    exchangeDocument(session, std::move(document));
}

/// Replaces the document by unsaved work, with its draft as this window's own.
void replaceByUnsaved(Session& session, Load load) {
    const UnsavedScene draft{load.path, load.images.directory(), load.scene, load.fileHash};
    Document document(std::move(load.scene), std::move(load.images), load.path);
    SceneText saved = savedScene(document.file);
    if (saved.hash == load.fileHash) // otherwise it was written again since
        document.fileHash = std::move(saved.hash);
    document.saved = std::move(saved.scene);
    document.images.fillMeshes(document.saved);
    document.needsFit = false; // the camera belongs to the work
    replaceDocument(session, std::move(document));
    if (UnsavedWork* unsaved = session.services.unsaved)
        unsaved->autosave.adopt(unsaved->recovery.takeRestored(), draft);
}

/// Reads the scene in a file; nothing if it is an image. Errors: why the file cannot be opened.
Result<std::optional<SceneText>> sceneIn(const fs::path& file) {
    const Result<bool> scene = holdsScene(file);
    if (!scene)
        return fail(scene.error());
    if (*scene && isObjName(file))
        return SceneText{}; // it is made when the file has arrived
    if (*scene)
        return readScene(file).map([](SceneText read) { return std::optional(std::move(read)); });
    const Result<Bytes> start = readFileStart(file, recognisedBytes);
    if (!start)
        return fail(start.error());
    if (recogniseImage(*start))
        return std::nullopt;
    if (const Result<TextureImage> refused = decodeTexture(*start); !refused)
        return fail(refused.error().code, refused.error().message, inFile(file.string()));
    return std::nullopt;
}

/// A scene from a file. Of a picture or an OBJ file, it is saved as another file.
void takeScene(Load& load, const fs::path& path, SceneText read) {
    const fs::path file = absolutePath(path);
    const bool isObj = isObjName(file);
    const bool isSource = isObj || isPictureWithScene(file);
    load.kind = Load::Kind::Scene;
    load.path = isSource ? fs::path() : file;
    load.suggested = isSource ? fs::path(file).replace_extension(sceneExtension) : fs::path();
    load.scene = std::move(read.scene);
    load.fileHash = std::move(read.hash);
    load.images = ImageSource(file.parent_path());
    if (isObj)
        load.obj = file.filename().string();
    load.goesOn = isObj; // without images that aren't there
}

/// Several files as one load: invalid files and a second scene are already refused.
Load sorted(const Session& session, const std::vector<fs::path>& files) {
    Load load{
        .kind = Load::Kind::Add, .pass = session.look.selection.pass, .unit = session.look.selection.unit};
    std::vector<fs::path> images;
    fs::path opened;
    for (const fs::path& file : files) {
        Result<std::optional<SceneText>> read = sceneIn(file);
        if (!read) {
            load.refused.push_back(read.error());
        } else if (!*read) {
            images.push_back(file);
        } else if (load.kind == Load::Kind::Scene) {
            load.refused.push_back({ErrorCode::OutOfRange,
                                    Sentence("only one scene is shown at a time, and {0} is opened",
                                             ProperName{opened.filename().string()}),
                                    inFile(file.string())});
        } else {
            opened = file;
            takeScene(load, file, **std::move(read));
            load.pass = load.unit = 0;
        }
    }
    const ImageSource& target = load.kind == Load::Kind::Scene ? load.images : session.document.images;
    for (const fs::path& image : images)
        load.added.push_back(nameIn(target, image));
    load.goesOn = load.goesOn || files.size() > 1;
    load.before = session.document.scene;
    return load;
}

bool opensNothing(const Load& load) {
    return load.kind == Load::Kind::Add && load.added.empty();
}

Result<void> beginWith(Session& session, const std::vector<fs::path>& files) {
    Load load = sorted(session, files);
    if (opensNothing(load))
        return fail(load.refused.front());
    for (const fs::path& file : files)
        rememberFile(session.settings, absolutePath(file));
    if (load.kind == Load::Kind::Add) { // opening them first is not an edit
        load.kind = Load::Kind::Scene;
        load.scene = session.document.scene;
        load.images = ImageSource(session.document.images.directory());
    }
    start(session, std::move(load));
    return {};
}

} // namespace

void bindFile(Scene& scene, int pass, int unit, std::string file) {
    const auto at = std::min(static_cast<std::size_t>(pass), scene.passes.size() - 1);
    Unit& shown = scene.passes[at].units[static_cast<std::size_t>(unit)];
    const bool bound = shown.texture >= 0 && static_cast<std::size_t>(shown.texture) < scene.textures.size();
    if (!bound) {
        scene.textures.push_back({});
        shown.texture = static_cast<int>(scene.textures.size()) - 1;
    }
    Texture& texture = scene.textures[static_cast<std::size_t>(shown.texture)];
    texture.source = SourceKind::File;
    texture.file = std::move(file);
    shown.enabled = true;
}

void newScene(Session& session) {
    replaceDocument(session, {defaultScene(), ImageSource{}});
    showAsAtFirst(session.view);
}

Result<void> openExample(Session& session, std::string_view file) {
    Result<Scene> scene = exampleScene(file);
    if (!scene)
        return fail(scene.error());
    replaceDocument(session, {std::move(*scene), ImageSource{}});
    return {};
}

Result<void> openScene(Session& session, const fs::path& path) {
    Result<SceneText> read = isObjName(path) ? Result<SceneText>(SceneText{}) : readScene(path);
    if (!read)
        return fail(read.error());
    const fs::path file = absolutePath(path);
    rememberFile(session.settings, file);
    Load load{.before = session.document.scene};
    takeScene(load, file, *std::move(read));
    start(session, std::move(load));
    return {};
}

void showLoadedScene(Session& session, Load load) {
    if (session.document.scene != load.before && isDirty(session.document)) { // changed meanwhile
        session.asking.pending = [later = std::make_shared<Load>(std::move(load))](Session& answered) {
            later->before = answered.document.scene; // the answer is for this scene
            showLoadedScene(answered, std::move(*later));
        };
        session.asking.dialog = Dialog::Discard;
        return;
    }
    if (load.restores)
        return replaceByUnsaved(session, std::move(load));
    if (load.reloads)
        return replaceByFile(session, std::move(load));
    Document document(std::move(load.scene), std::move(load.images), load.path);
    document.fileHash = std::move(load.fileHash);
    if (!load.suggested.empty())
        document.needsFit = document.scene.view == defaultScene().view; // it shows the same as the picture
    document.suggested = std::move(load.suggested);
    replaceDocument(session, std::move(document));
    if (!load.notes.empty())
        say(session, Sentence::joined("{0}; {1}", load.notes));
}

void restoreUnsaved(Session& session, UnsavedScene draft) {
    // A missing image does not lose the restored work: the load goes on without it.
    start(session, {.kind = Load::Kind::Scene,
                    .path = std::move(draft.file),
                    .goesOn = true,
                    .restores = true,
                    .scene = std::move(draft.scene),
                    .before = session.document.scene,
                    .images = ImageSource(std::move(draft.folder)),
                    .fileHash = std::move(draft.fileHash)});
}

void importImage(Session& session, const fs::path& path) {
    rememberFile(session.settings, absolutePath(path));
    std::string file = nameIn(session.document.images, path);
    start(session, {.kind = Load::Kind::Import,
                    .path = path,
                    .file = std::move(file),
                    .pass = session.look.selection.pass,
                    .unit = session.look.selection.unit});
}

void setFile(Session& session, std::string param, std::string file) {
    const fs::path path = session.document.images.directory() / file;
    start(session,
          {.kind = Load::Kind::SetFile, .path = path, .file = std::move(file), .param = std::move(param)});
}

void chooseFile(Session& session, std::string param, const fs::path& path) {
    setFile(session, std::move(param), nameIn(session.document.images, path));
}

Result<std::string> sceneLink(const Session& session) {
    Scene scene = session.document.scene;
    renameFiles(scene,
                [&](const std::string& file) { // there is no folder that file names could be relative to
                    if (session.document.images.fileInMemory(file))
                        return file;
                    return absolutePath(session.document.images.directory() / file).generic_string();
                });
    Result<std::string> link = writeSceneLink(scene);
    if (link && !session.window.page.empty())
        link->insert(0, session.window.page + '#');
    return link;
}

Result<void> openSceneLink(Session& session, std::string_view link) {
    Result<Scene> scene = parseSceneLink(link);
    if (!scene)
        return fail(scene.error());
    start(session, {.kind = Load::Kind::Scene,
                    .goesOn = true,
                    .scene = std::move(*scene),
                    .before = session.document.saved, // otherwise the user is asked
                    .images = ImageSource(fs::path{})});
    return {};
}

Result<bool> holdsScene(const fs::path& path) {
    const Result<Bytes> start = readFileStart(path, recognisedBytes);
    if (!start)
        return fail(start.error());
    if (recogniseImage(*start))
        return false;
    if (path.extension() == ".json" || isObjName(path))
        return true;
    const auto isSpace = [](std::byte each) {
        return each == std::byte{' '} || each == std::byte{'\n'} || each == std::byte{'\r'} ||
               each == std::byte{'\t'};
    };
    const auto first = std::ranges::find_if_not(*start, isSpace);
    return first != start->end() && *first == std::byte{'{'};
}

Result<void> openFile(Session& session, const fs::path& path) {
    const Result<bool> scene = holdsScene(path);
    if (!scene)
        return fail(scene.error());
    if (*scene)
        return openScene(session, path);
    importImage(session, path);
    return {};
}

void addImages(Scene& scene, const ImageSource& images, Load& load) {
    bool first = true;
    for (const std::string& name : load.added) {
        if (!images.holds(name))
            continue; // it was refused
        if (first) {
            bindFile(scene, load.pass, load.unit, name);
            first = false;
            continue;
        }
        if (scene.textures.size() >= maxTextures) {
            load.refused.push_back({ErrorCode::TooLarge,
                                    Sentence("a scene has at most {0} textures", maxTextures),
                                    inFile((images.directory() / name).string())});
            continue;
        }
        Texture texture;
        texture.source = SourceKind::File;
        texture.mipmaps = MipPolicy::Generated;
        texture.file = name;
        scene.textures.push_back(std::move(texture));
    }
}

std::vector<Error> checkArguments(const std::vector<fs::path>& files) {
    std::vector<Error> refused;
    for (const fs::path& file : files) {
        if (const auto read = sceneIn(file); !read)
            refused.push_back(read.error());
    }
    return refused;
}

Result<void> openFiles(Session& session, const std::vector<fs::path>& files) {
    if (files.size() == 1)
        return openFile(session, files.front());
    Load load = sorted(session, files);
    if (opensNothing(load)) {
        session.asking.refused.insert(session.asking.refused.end(), load.refused.begin(), load.refused.end());
        return {};
    }
    start(session, std::move(load));
    return {};
}

Result<void> openArguments(Session& session, const std::vector<fs::path>& files) {
    if (files.empty())
        return {};
    if (files.size() != 1 || !isPictureWithScene(files.front()))
        return beginWith(session, files);
    session.asking.picture = {files.front(), true};
    session.asking.dialog = Dialog::Picture;
    return {};
}

void usePicture(Session& session) {
    const AskedPicture asked = std::exchange(session.asking.picture, {});
    report(session, asked.begins ? beginWith(session, {asked.file}) : openFile(session, asked.file),
           asked.file);
}

} // namespace texplorer::ui
