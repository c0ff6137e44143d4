#include "app/ui/files/inspected_file.h"

#include "app/ui/files/loads.h"
#include "app/ui/model/session.h"

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;

struct WantedFile {
    fs::path path;
    std::shared_ptr<const Bytes> inMemory = nullptr;
};

WantedFile wantedFile(const Session& session) {
    if (!session.look.fileView.chosen.empty())
        return {session.look.fileView.chosen};
    const Texture* texture = boundTexture(session);
    if (!texture || texture->source != SourceKind::File || texture->file.empty())
        return {};
    if (auto bytes = session.document.images.fileInMemory(texture->file))
        return {texture->file, std::move(bytes)};
    return {session.document.images.directory() / texture->file};
}

} // namespace

void receiveInspected(Session& session, Result<ImageLoader::Content> content) {
    InspectedFile& view = session.look.fileView;
    view.ticket = 0;
    if (!content) {
        view.content.reset();
        view.problem = describe(content.error());
        return;
    }
    view.problem.clear();
    view.content = std::get<std::shared_ptr<const DissectedFile>>(std::move(*content));
    view.map = FieldMap(view.content->anatomy);
}

void refreshInspected(Session& session) {
    InspectedFile& view = session.look.fileView;
    if (view.shown.empty())
        return;
    if (view.inMemory)
        return receiveInspected(session, dissectFile(*view.inMemory)); // it is small
    Files& files = session.services.files;
    if (view.ticket != 0)
        files.cancel(view.ticket);
    view.ticket = files.load(view.shown, Files::Wanted::Anatomy);
}

void followFile(Session& session) {
    InspectedFile& view = session.look.fileView;
    WantedFile wanted = wantedFile(session);
    if (wanted.path == view.shown && wanted.inMemory == view.inMemory)
        return;
    if (view.ticket != 0)
        cancelLoad(session, view.ticket);
    InspectedFile next;
    next.chosen = std::move(view.chosen);
    next.shown = std::move(wanted.path);
    next.inMemory = std::move(wanted.inMemory);
    view = std::move(next);
    refreshInspected(session);
}

void lookInto(Session& session, fs::path file) {
    session.look.fileView.chosen = std::move(file);
    session.window.wantedTab = Tab::File;
}

} // namespace texplorer::ui
