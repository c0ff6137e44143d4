#include "app/ui/files/inspected_file.h"

#include "app/ui/files/loads.h"
#include "app/ui/model/session.h"

namespace texplorer::ui {
namespace {

namespace fs = std::filesystem;

/// The file that the tab should show; not read yet.
InspectedFile wantedFile(const Session& session) {
    InspectedFile wanted;
    wanted.chosen = wanted.shown = session.look.fileView.chosen;
    const Texture* texture = boundTexture(session);
    if (!wanted.chosen.empty() || !texture || texture->source != SourceKind::File || texture->file.empty())
        return wanted;
    const ImageSource& images = session.document.images;
    wanted.inMemory = images.fileInMemory(texture->file);
    wanted.shown = wanted.inMemory ? fs::path(texture->file) : images.directory() / texture->file;
    return wanted;
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
    view.problem = {};
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
    InspectedFile wanted = wantedFile(session);
    if (wanted.shown == view.shown && wanted.inMemory == view.inMemory)
        return;
    if (view.ticket != 0)
        cancelLoad(session, view.ticket);
    view = std::move(wanted);
    refreshInspected(session);
}

void lookInto(Session& session, fs::path file) {
    session.look.fileView.chosen = std::move(file);
    session.window.wantedTab = Tab::File;
}

} // namespace texplorer::ui
