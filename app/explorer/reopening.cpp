#include "app/explorer/reopening.h"

#include "app/ui/model/notice.h"

#include <algorithm>
#include <variant>

namespace texplorer::explorer {
namespace {

/// Another tab comes to the front: the driver makes what the tab GLSL shows.
void coverShaders(ui::Session& session) {
    if (session.window.wantedTab == ui::Tab::Glsl)
        session.window.wantedTab.reset();
    ui::Workspace& workspace = session.settings.workspace;
    if (!ui::isShown(workspace, ui::Tab::Glsl))
        return;
    const auto isBeside = [&](const ui::TabRow& row) {
        return row.tab != ui::Tab::Glsl && ui::isOpen(workspace, row.tab) &&
               ui::dockOf(workspace, row.tab) == ui::dockOf(workspace, ui::Tab::Glsl);
    };
    const auto other = std::ranges::find_if(ui::tabRows, isBeside);
    if (other != ui::tabRows.end())
        ui::showTab(workspace, other->tab);
    else
        ui::closeTab(workspace, ui::Tab::Glsl);
}

bool isPressed(const stage::Event& event) {
    const auto* input = std::get_if<stage::Input>(&event);
    return input && (std::holds_alternative<stage::ButtonChanged>(*input) ||
                     std::holds_alternative<stage::KeyChanged>(*input));
}

} // namespace

Reopening::Reopening(ui::Session& session, const stage::Graphics& graphics, const Beginning& beginning)
    : session_(session)
    , graphics_(graphics)
    , beginning_(beginning) {}

void Reopening::begin() {
    if (beginning_.renderer) {
        session_.view.arrangement = ui::Arrangement::One; // a lesson may have chosen others
        ui::showOne(session_.view, *beginning_.renderer);
    }
    if (beginning_.renderer == RendererKind::Reference)
        coverShaders(session_);
    if (!beginning_.hungFor)
        return;
    notice_ = {
        N_("The driver did not finish a picture within {0:g} s. The reference renderer draws now; choose "
           "another one to try again."),
        *beginning_.hungFor};
    ui::say(session_, notice_);
    documents_ = session_.documents;
}

void Reopening::receive(const std::vector<stage::Event>& events) {
    hasActed_ = hasActed_ || std::ranges::any_of(events, isPressed);
    keepNotice();
}

/// A document that replaces the first one, read from its file or restored, would hide the notice.
void Reopening::keepNotice() {
    if (notice_.empty())
        return;
    if (session_.look.notice.text.empty() && session_.documents != documents_)
        ui::say(session_, notice_);
    if (session_.look.notice.text != notice_)
        notice_ = {}; // dismissed, or there is another one
    documents_ = session_.documents;
}

bool Reopening::driverDraws() const {
    const view::OfferedRenderers& offered = graphics_.renderers();
    const auto isLive = [&](RendererKind kind) {
        return kind != RendererKind::Reference && offered.has(kind);
    };
    return std::ranges::any_of(ui::shownRenderers(session_.view), isLive) ||
           (ui::isShown(session_.settings.workspace, ui::Tab::Glsl) && offered.has(RendererKind::Shader));
}

std::vector<std::string> Reopening::shown() const {
    const ui::Document& document = session_.document;
    if (ui::isDirty(document))
        return {}; // it is offered as unsaved work
    if (const auto& lesson = session_.lesson) {
        const lesson::LessonFolder& folder = lesson->folder;
        return {"--lesson", folder.path().empty() ? folder.name() : folder.path().string()};
    }
    if (!document.file.empty())
        return {document.file.string()};
    return hasActed_ ? std::vector<std::string>() : argumentsOf(beginning_);
}

Restart::Reopened Reopening::reopened() const {
    return {shown(), driverDraws() && (!beginning_.hungFor || hasActed_)};
}

} // namespace texplorer::explorer
