#include "app/ui/document.h"

#include "core/base/file_io.h"
#include "core/codec/registry.h"
#include "core/scene/json.h"

#include <algorithm>

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t maxSceneBytes = std::size_t{64} << 20;
constexpr std::size_t recognisedBytes = 4096; // enough of a file to tell what it is

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

/// The same of a file that becomes one of a source's images; absolute while the scene was never saved.
std::string nameIn(const ImageSource& images, const fs::path& file) {
    return images.directory().empty() ? absolutePath(file).generic_string()
                                      : nameFrom(images.directory(), file);
}

Result<Scene> readScene(const fs::path& path) {
    const Result<std::string> text = readText(path, maxSceneBytes);
    if (!text)
        return fail(text.error());
    Result<Scene> scene = parseScene(*text);
    if (!scene)
        return fail(scene.error().code, describe(scene.error()), path.string());
    return scene;
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
    const Views views = session.views;
    Probe* probe = session.probe;
    FileBrowser browser = session.browser;
    Background* background = session.background;
    cancelLoads(session);
    session = makeSession(std::move(scene), std::move(images), std::move(file));
    session.columns = columns;
    session.views = views;
    session.views.zoom = {};
    session.probe = probe;
    session.browser = std::move(browser);
    session.background = background;
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
    replaceDocument(session, defaultScene(), ImageSource{}, {});
}

Result<void> openScene(Session& session, const fs::path& path) {
    Result<Scene> scene = readScene(path);
    if (!scene)
        return fail(scene.error());
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
    std::string file = nameIn(session.images, path);
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
    const Result<Bytes> start = readFileStart(path, recognisedBytes);
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

Result<void> checkArguments(const std::vector<fs::path>& files) {
    for (const fs::path& file : files) {
        const Result<bool> scene = holdsScene(file);
        if (!scene)
            return fail(scene.error());
        if (*scene) {
            if (const Result<Scene> parsed = readScene(file); !parsed)
                return fail(parsed.error());
            continue;
        }
        const Result<Bytes> start = readFileStart(file, recognisedBytes);
        if (!start)
            return fail(start.error());
        if (recogniseImage(*start))
            continue;
        const Result<TextureImage> refused = decodeTexture(*start);
        if (!refused)
            return fail(refused.error().code, refused.error().message, file.string());
    }
    return {};
}

Result<void> openArguments(Session& session, const std::vector<fs::path>& files) {
    Load load{.kind = Load::Kind::Scene, .scene = session.scene, .before = session.scene};
    load.images = ImageSource(session.images.directory());
    std::vector<fs::path> images;
    for (const fs::path& file : files) {
        const Result<bool> scene = holdsScene(file);
        if (!scene)
            return fail(scene.error());
        if (!*scene) {
            images.push_back(file);
            continue;
        }
        Result<Scene> parsed = readScene(file);
        if (!parsed)
            return fail(parsed.error());
        load.scene = std::move(*parsed);
        load.path = absolutePath(file);
        load.images = ImageSource(load.path.parent_path());
    }
    Scene& scene = load.scene;
    for (std::size_t i = 0; i < images.size(); ++i) {
        std::string name = nameIn(load.images, images[i]);
        if (i == 0) {
            bindFile(scene, 0, 0, std::move(name));
            continue;
        }
        if (scene.textures.size() >= maxTextures)
            return fail(ErrorCode::TooLarge,
                        "a scene has at most " + std::to_string(maxTextures) + " textures",
                        images[i].string());
        Texture texture;
        texture.source = SourceKind::File;
        texture.mipmaps = MipPolicy::Generated;
        texture.file = std::move(name);
        scene.textures.push_back(std::move(texture));
    }
    return files.empty() ? Result<void>{} : start(session, std::move(load));
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
