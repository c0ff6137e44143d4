#include "app/ui/document.h"

#include "core/base/file_io.h"
#include "core/codec/registry.h"
#include "core/scene/json.h"

#include <algorithm>

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxSceneBytes = std::size_t{64} << 20;

fs::path absolutePath(const fs::path& path) {
    std::error_code failed;
    const fs::path result = fs::absolute(path, failed);
    return failed ? path : result.lexically_normal();
}

/// How a scene in `directory` names a file: relative where it lies at or below it, absolute elsewhere.
std::string nameFrom(const fs::path& directory, const fs::path& file) {
    const fs::path relative = absolutePath(file).lexically_relative(absolutePath(directory));
    const bool below = !relative.empty() && *relative.begin() != "..";
    return below ? relative.generic_string() : absolutePath(file).generic_string();
}

/// The same scene, with its image files named from another folder.
Scene rebased(const Scene& scene, const fs::path& from, const fs::path& to) {
    Scene result = scene;
    for (Texture& texture : result.textures) {
        if (!texture.file.empty())
            texture.file = nameFrom(to, from / texture.file);
    }
    return result;
}

void replaceDocument(Session& session, Scene scene, ImageSource images, fs::path file) {
    const Columns columns = session.columns;
    Probe* probe = session.probe;
    FileBrowser browser = session.browser;
    Background* background = session.background;
    cancelLoads(session);
    session = makeSession(std::move(scene), std::move(images), std::move(file));
    session.columns = columns;
    session.probe = probe;
    session.browser = std::move(browser);
    session.background = background;
}

} // namespace

void newScene(Session& session) {
    replaceDocument(session, defaultScene(), ImageSource{}, {});
}

Result<void> openScene(Session& session, const fs::path& path) {
    const Result<std::string> text = readText(path, maxSceneBytes);
    if (!text)
        return fail(text.error());
    Result<Scene> scene = parseScene(*text);
    if (!scene)
        return fail(scene.error().code, describe(scene.error()), path.string());
    const fs::path file = absolutePath(path);
    return start(session, {.kind = Load::Kind::Scene,
                           .path = file,
                           .scene = std::move(*scene),
                           .before = session.scene,
                           .images = ImageSource(file.parent_path())});
}

void showLoadedScene(Session& session, Load load) {
    const bool changedMeanwhile = session.scene != load.before && isDirty(session);
    if (!changedMeanwhile)
        return replaceDocument(session, std::move(load.scene), std::move(load.images), load.path);
    load.before = session.scene; // the next answer is about this one
    session.readyScene = std::make_shared<Load>(std::move(load));
    session.pending = Pending::ShowScene;
    session.dialog = Dialog::Discard;
}

Result<void> saveScene(Session& session, const fs::path& path) {
    const fs::path file = absolutePath(path);
    const fs::path folder = file.parent_path();
    const Scene scene = rebased(session.scene, session.images.directory(), folder);
    const std::string text = writeScene(scene);
    if (Result<void> written = writeFileAtomically(file, viewBytes(text)); !written)
        return written;
    if (absolutePath(session.images.directory()) != folder || session.file.empty()) {
        ImageSource images(folder);
        for (std::size_t i = 0; i < scene.textures.size(); ++i)
            images.share(scene.textures[i].file, session.images, session.scene.textures[i].file);
        session.images = std::move(images);
    }
    if (scene != session.scene) {
        session.scene = scene;
        sealEdit(session);
        recordEdit(session, "Save elsewhere");
    }
    session.saved = scene;
    session.file = file;
    return {};
}

Result<void> importImage(Session& session, const fs::path& path) {
    std::string file = session.images.directory().empty() ? absolutePath(path).generic_string()
                                                          : nameFrom(session.images.directory(), path);
    return start(session, {.kind = Load::Kind::Import,
                           .path = path,
                           .file = std::move(file),
                           .pass = session.selection.pass,
                           .unit = session.selection.unit});
}

Result<void> setFile(Session& session, int texture, std::string file) {
    const fs::path path = session.images.directory() / file;
    return start(session,
                 {.kind = Load::Kind::SetFile, .path = path, .file = std::move(file), .texture = texture});
}

Result<bool> holdsScene(const fs::path& path) {
    constexpr std::size_t enough = 4096;
    const Result<Bytes> start = readFileStart(path, enough);
    if (!start)
        return fail(start.error());
    if (recogniseImage(*start))
        return false;
    if (path.extension() == ".json")
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
    return *scene ? openScene(session, path) : importImage(session, path);
}

Result<void> openArguments(Session& session, const std::vector<fs::path>& files) {
    std::vector<fs::path> images;
    for (const fs::path& file : files) {
        const Result<bool> scene = holdsScene(file);
        if (!scene)
            return fail(scene.error());
        if (!*scene)
            images.push_back(file);
        else if (Result<void> opened = openScene(session, file); !opened)
            return opened;
    }
    for (std::size_t i = 0; i < images.size(); ++i) {
        if (i == 0) {
            if (Result<void> imported = importImage(session, images[i]); !imported)
                return imported;
            continue;
        }
        if (session.scene.textures.size() >= maxTextures)
            return fail(ErrorCode::TooLarge,
                        "a scene has at most " + std::to_string(maxTextures) + " textures",
                        images[i].string());
        Scene scene = session.scene;
        Texture texture;
        texture.source = SourceKind::File;
        texture.mipmaps = MipPolicy::Generated;
        texture.file = absolutePath(images[i]).generic_string();
        scene.textures.push_back(std::move(texture));
        if (Result<void> loaded = session.images.load(scene); !loaded)
            return loaded;
        session.scene = std::move(scene);
    }
    if (!images.empty()) {
        session.saved = session.scene;
        session.history = History(session.scene);
        session.lastChanged.clear();
    }
    return {};
}

void say(Session& session, const Error& error, const fs::path& file) {
    const bool contentIsWrong = error.code == ErrorCode::Malformed || error.code == ErrorCode::Unsupported;
    session.notice = {describe(error), contentIsWrong ? file : fs::path{}};
}

void say(Session& session, std::string sentence) {
    session.notice = {std::move(sentence), {}};
}

void report(Session& session, const Result<void>& result, const fs::path& file) {
    if (!result)
        say(session, result.error(), file);
}

} // namespace texplorer::ui
