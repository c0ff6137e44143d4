#include "app/ui/files/program_file.h"

#include "texplorer/base/sentence.h"
#include "texplorer/emit/program.h"
#include "texplorer/files/file_io.h"

#include <algorithm>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr std::string_view programExtension = ".c";
constexpr Sentence::Key<Sentence> programFailure(N_("The program can't be written: {0}."));

std::string stemOf(const Document& document) {
    const std::filesystem::path& named = document.file.empty() ? document.suggested : document.file;
    std::string stem = named.filename().string();
    stem.erase(std::min(stem.find('.'), stem.size()));
    return stem.empty() ? "scene" : stem;
}

/// The name of a scene's image in a program's folder.
std::string imageNameFrom(const std::filesystem::path& folder, const std::filesystem::path& scenes,
                          const std::string& image) {
    const std::filesystem::path whole = (scenes / image).lexically_normal();
    const std::filesystem::path relative = whole.lexically_relative(folder);
    const bool below = !relative.empty() && *relative.begin() != "..";
    return (below ? relative : whole).generic_string();
}

/// The progress of all textures, each of which reports its own.
std::function<void(float)> reportOfAll(const FileMaking& making, std::size_t textures) {
    return [report = making.report, textures, done = std::size_t{0}, last = 0.0F](float share) mutable {
        if (share < std::exchange(last, share))
            ++done;
        report(std::min(1.0F, (static_cast<float>(done) + share) / static_cast<float>(textures)));
    };
}

} // namespace

std::string programFileName(const Document& document) {
    return stemOf(document).append(programExtension);
}

std::optional<emit::ProgramWorker::Program> programNow(Session& session, emit::Flavour flavour) {
    const Document& document = session.document;
    const emit::ProgramOptions options{.title = N_("Texplorer"),
                                       .fileName = [](const std::string& file) { return file; }};
    return session.services.programs->program(flavour, document.scene, document.images, options);
}

FileOrder programOrder(const Session& session, std::filesystem::path file) {
    const Document& document = session.document;
    emit::ProgramOptions options{.title = stemOf(document), .source = file.filename().string()};
    options.fileName = [folder = file.parent_path(), scenes = document.images.directory()](
                           const std::string& image) { return imageNameFrom(folder, scenes, image); };
    auto make = [options = std::move(options), flavour = session.asking.flavour,
                 all = session.window.allCalls, scene = document.scene,
                 images = document.images](const FileMaking& making) -> Result<MadeFile> {
        LevelWork levels = making.levels;
        const auto compressed =
            std::ranges::count(scene.textures, Compression::Cached, &Texture::compression);
        levels.progress = reportOfAll(making, static_cast<std::size_t>(compressed));
        emit::TextureCodes codes(std::move(levels));
        const Result<std::vector<emit::Line>> lines = emit::program(flavour, scene, images, options, codes);
        if (!lines)
            return fail(lines.error());
        const std::string text = textOf(*lines, all);
        const ByteView bytes = viewBytes(text);
        return MadeFile{Bytes(bytes.begin(), bytes.end())};
    };
    return {std::move(file), programFailure, 0, std::move(make)};
}

void askSaveProgram(Session& session, emit::Flavour flavour) {
    const std::optional<emit::ProgramWorker::Program> program = programNow(session, flavour);
    if (program && !*program) {
        session.look.notice = {{programFailure, describe(program->error())}, {}};
        return;
    }
    session.asking.flavour = flavour;
    session.asking.dialog = Dialog::SaveProgram;
}

Result<void> saveProgram(Session& session, const std::filesystem::path& file,
                         const std::optional<FileFingerprint>& replaces) {
    return session.services.writing->writeAs(programOrder(session, file), programExtension, replaces);
}

} // namespace texplorer::ui
