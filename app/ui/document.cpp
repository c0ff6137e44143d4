#include "app/ui/document.h"

#include "core/base/file_io.h"
#include "core/codec/registry.h"
#include "core/scene/json.h"

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
    session = makeSession(std::move(scene), std::move(images), std::move(file));
    session.columns = columns;
    session.probe = probe;
    session.browser = std::move(browser);
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
    ImageSource images(file.parent_path());
    if (Result<void> loaded = images.load(*scene); !loaded)
        return loaded;
    replaceDocument(session, std::move(*scene), std::move(images), file);
    return {};
}

Result<void> saveScene(Session& session, const fs::path& path) {
    const fs::path file = absolutePath(path);
    const fs::path folder = file.parent_path();
    const Scene scene = rebased(session.scene, session.images.directory(), folder);
    const std::string text = writeScene(scene);
    if (Result<void> written = writeFileAtomically(file, viewBytes(text)); !written)
        return written;
    if (absolutePath(session.images.directory()) != folder || session.file.empty()) {
        // An image that has vanished since it was read is reported by the renderer; the scene is safe.
        ImageSource images(folder);
        (void)images.load(scene);
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
    Scene scene = session.scene;
    Unit& unit = scene.passes[static_cast<std::size_t>(session.selection.pass)]
                     .units[static_cast<std::size_t>(session.selection.unit)];
    if (!boundTexture(session)) {
        scene.textures.push_back({});
        unit.texture = static_cast<int>(scene.textures.size()) - 1;
    }
    Texture& texture = scene.textures[static_cast<std::size_t>(unit.texture)];
    texture.source = SourceKind::File;
    texture.file = session.images.directory().empty() ? absolutePath(path).generic_string()
                                                      : nameFrom(session.images.directory(), path);
    unit.enabled = true;
    if (Result<void> loaded = session.images.load(scene); !loaded)
        return loaded;
    session.scene = std::move(scene);
    sealEdit(session);
    recordEdit(session, "Open " + path.filename().string());
    return {};
}

Result<bool> holdsImage(const fs::path& path) {
    const Result<Bytes> bytes = readFile(path);
    if (!bytes)
        return fail(bytes.error());
    return recogniseImage(*bytes) != nullptr;
}

Result<void> openFile(Session& session, const fs::path& path) {
    const Result<Bytes> bytes = readFile(path);
    if (!bytes)
        return fail(bytes.error());
    if (recogniseImage(*bytes))
        return importImage(session, path);
    const auto looksLikeScene = [&] {
        for (const std::byte each : *bytes) {
            const char c = static_cast<char>(each);
            if (c != ' ' && c != '\n' && c != '\r' && c != '\t')
                return c == '{';
        }
        return false;
    };
    if (path.extension() == ".json" || looksLikeScene())
        return openScene(session, path);
    const Result<Image> refused = decodeImage(*bytes);
    if (refused) // a decoder without a recogniser is a programming mistake, and no reason to refuse the image
        return importImage(session, path);
    return fail(refused.error().code, refused.error().message, path.string());
}

Result<void> openArguments(Session& session, const std::vector<fs::path>& files) {
    std::vector<fs::path> images;
    for (const fs::path& file : files) {
        const Result<bool> isImage = holdsImage(file);
        if (!isImage)
            return fail(isImage.error());
        if (*isImage)
            images.push_back(file);
        else if (Result<void> opened = openFile(session, file); !opened)
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

void report(Session& session, const Result<void>& result) {
    if (!result)
        session.notice = describe(result.error());
}

} // namespace texplorer::ui
