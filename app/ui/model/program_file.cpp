#include "app/ui/model/program_file.h"

#include "core/base/file_io.h"
#include "core/emit/program.h"

#include <algorithm>

namespace texplorer::ui {
namespace {

std::string stemOf(const Document& document) {
    const std::filesystem::path& named = document.file.empty() ? document.suggested : document.file;
    std::string stem = named.filename().string();
    stem.erase(std::min(stem.find('.'), stem.size()));
    return stem.empty() ? "scene" : stem;
}

} // namespace

std::string programFileName(const Document& document, emit::Flavour flavour) {
    return stemOf(document) + std::string(emit::extensionOf(flavour));
}

Result<void> saveProgram(const Session& session, const std::filesystem::path& file) {
    const Document& document = session.document;
    emit::TextureCodes codes;
    emit::ProgramOptions options{.title = stemOf(document), .source = file.filename().string()};
    options.fileName = [&](const std::string& image) {
        const std::filesystem::path whole = (document.images.directory() / image).lexically_normal();
        const std::filesystem::path relative = whole.lexically_relative(file.parent_path());
        const bool below = !relative.empty() && *relative.begin() != "..";
        return (below ? relative : whole).generic_string();
    };
    const auto lines = emit::program(session.window.flavour, document.scene, document.images, options, codes);
    if (!lines)
        return fail(lines.error().code, describe(lines.error()));
    const std::string text = textOf(*lines, false);
    return writeFileAtomically(file, viewBytes(text));
}

} // namespace texplorer::ui
