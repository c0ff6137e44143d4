#include "app/stage/file_requests.h"

#include "app/ui/files/answers.h"
#include "app/ui/files/asking.h"
#include "app/ui/files/program_file.h"
#include "app/ui/files/recording_file.h"
#include "app/ui/files/sheet_file.h"
#include "app/ui/files/texture_file.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/session.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"

#include <memory>
#include <utility>

namespace texplorer::stage {
namespace {

using ui::Dialog;

Bytes bytesOf(std::string_view text) {
    const ByteView view = viewBytes(text);
    return {view.begin(), view.end()};
}

std::string sceneNameOf(const ui::Document& document) {
    const std::string name = nameOf(document);
    return (name.empty() ? "scene" : name) + std::string(sceneExtension);
}

/// The scene, and the images that are in no folder either.
void saveScene(ui::Session& session, const FileRequests& host) {
    ui::Document& document = session.document;
    std::vector<NamedFile> files{{sceneNameOf(document), bytesOf(writeScene(document.scene))}};
    for (const std::string& file : filesOf(document.scene)) {
        if (const std::shared_ptr<const Bytes> image = document.images.fileInMemory(file))
            files.push_back({file, *image});
    }
    document.suggested = files.front().name;
    document.saved = document.scene;
    host.save(std::move(files));
    session.look.notice = {};
    ui::finishPending(session);
}

/// The host's FileWriting gives it to the user.
void saveOrder(ui::Session& session, Result<ui::FileOrder> order) {
    if (!order)
        return ui::say(session, order.error());
    session.services.writing->write(*std::move(order));
}

Result<ui::FileOrder> sheetFileOf(const ui::Session& session) {
    return ui::sheetOrder(session).and_then([&](ui::SheetOrder sheet) {
        return ui::fileOrder(std::move(sheet), ui::sheetFileName(session.document));
    });
}

Result<ui::FileOrder> animationFileOf(const ui::Session& session) {
    return ui::recordingOf(session).map([&](ui::Recording recording) {
        return ui::fileOrder(std::move(recording), ui::recordingFileName(session));
    });
}

/// Returns false for a dialog that is not about a file.
bool answered(ui::Session& session, const FileRequests& host, Dialog dialog) {
    switch (dialog) {
    case Dialog::OpenScene:
        host.open({.isScene = true});
        return true;
    case Dialog::OpenImage:
        host.open({.param = std::exchange(session.asking.imageParam, {})});
        return true;
    case Dialog::SaveScene:
        saveScene(session, host);
        return true;
    case Dialog::SaveAnswers:
        host.save({{"answers.json", bytesOf(ui::answersText(session.settings))}});
        return true;
    case Dialog::SaveSheet:
        saveOrder(session, sheetFileOf(session));
        return true;
    case Dialog::SaveProgram:
        saveOrder(session, ui::programOrder(session, ui::programFileName(session.document)));
        return true;
    case Dialog::SaveTexture:
        saveOrder(session, textureOrder(session, textureFileName(session)));
        return true;
    case Dialog::SaveRecording:
        saveOrder(session, animationFileOf(session));
        return true;
    default:
        return false;
    }
}

} // namespace

void requestFiles(ui::Session& session, const FileRequests& host) {
    if (!host.open || !host.save)
        return;
    Dialog dialog = Dialog::None;
    do { // an action that has waited for the file may open another dialog
        dialog = std::exchange(session.asking.dialog, Dialog::None);
    } while (answered(session, host, dialog));
    session.asking.dialog = dialog; // not about a file
}

} // namespace texplorer::stage
