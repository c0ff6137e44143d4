#include "app/ui/model/kept.h"

#include "app/ui/model/notice.h"
#include "app/ui/model/session.h"

#include <utility>

namespace texplorer::ui {
namespace {

/// The same view settings with another camera.
View lookedAtFrom(View view, const View& place) {
    view.azimuth = place.azimuth;
    view.elevation = place.elevation;
    view.roll = place.roll;
    view.distance = place.distance;
    view.target = place.target;
    return view;
}

bool differsInView(const Scene& a, const Scene& b) {
    return lookedAtFrom(a.view, b.view) != b.view;
}

/// Ignores the camera.
bool isSame(const Scene& a, const Scene& b) {
    return !differsInView(a, b) && a.light == b.light && a.material == b.material && a.models == b.models &&
           a.textures == b.textures && a.passes == b.passes;
}

/// The lists with selectable elements.
void selectAsInA(Selection& selection, const Selection& inA, std::string_view path) {
    if (path.empty() || path == "models") {
        selection.model = inA.model;
        selection.vertex = inA.vertex;
        selection.group = inA.group;
    }
    if (path.empty() || path == "passes") {
        selection.pass = inA.pass;
        selection.unit = inA.unit;
    }
}

Scene keptFrom(const Session& session) {
    Scene scene = *session.document.kept.scene;
    scene.view = lookedAtFrom(scene.view, presentScene(session).view);
    return scene;
}

void take(const Session& session, Sentence name, const std::string& path) {
    Selection selection = session.look.selection;
    selectAsInA(selection, session.document.kept.selection, path);
    edit::Replace replace{std::make_shared<const Scene>(keptFrom(session))};
    if (!path.empty())
        replace.paths.push_back(path);
    submit(session, {.name = std::move(name),
                     .edits = {std::move(replace)},
                     .path = path,
                     .select = std::move(selection)});
}

} // namespace

bool isKeptShown(const Session& session) {
    return session.document.kept.flippedAt.has_value();
}

bool isKeptBeside(const Session& session) {
    return session.view.arrangement == Arrangement::Kept;
}

void keepAsA(Session& session) {
    session.document.kept = {std::make_shared<const Scene>(session.document.scene), nullptr, std::nullopt,
                             session.look.selection};
    followKept(session);
    tell(session, "Kept as A. Change something and compare it with the menu A/B.");
}

void flipKept(Session& session) {
    Kept& kept = session.document.kept;
    if (!kept.scene)
        return;
    const bool shown = isKeptShown(session);
    if (isKeptBeside(session))
        session.view.arrangement = Arrangement::One;
    kept.flippedAt.reset();
    if (!shown)
        kept.flippedAt = session.document.scene;
    followKept(session);
}

void splitKept(Session& session) {
    Kept& kept = session.document.kept;
    if (!kept.scene)
        return;
    kept.flippedAt.reset();
    session.view.arrangement = isKeptBeside(session) ? Arrangement::One : Arrangement::Kept;
    followKept(session);
}

void forgetKept(Session& session) {
    session.document.kept = {};
    followKept(session);
}

void followKept(Session& session) {
    Kept& kept = session.document.kept;
    ViewSettings& view = session.view;
    if (!kept.scene && view.arrangement == Arrangement::Kept)
        view.arrangement = Arrangement::One;
    if (kept.flippedAt && (!isSame(*kept.flippedAt, session.document.scene) || isComparing(view)))
        kept.flippedAt.reset();
    if (!kept.flippedAt && view.arrangement != Arrangement::Kept)
        kept.seen.reset();
    else if (!kept.seen || kept.seen->view != lookedAtFrom(kept.seen->view, presentScene(session).view))
        kept.seen = std::make_shared<const Scene>(keptFrom(session));
}

std::vector<SceneChange> changesSinceKept(const Session& session) {
    if (!session.document.kept.scene)
        return {};
    return changesBetween(keptFrom(session), presentScene(session));
}

void takeFromKept(const Session& session, const SceneChange& change) {
    take(session, Sentence("{0} of A", change.label), change.path);
}

void takeAllFromKept(const Session& session) {
    if (session.document.kept.scene)
        take(session, N_("All of A"), {});
}

} // namespace texplorer::ui
