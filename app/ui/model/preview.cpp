#include "app/ui/model/preview.h"

#include "app/ui/model/kept.h"
#include "app/ui/model/session.h"
#include "app/ui/model/timeline_edits.h"
#include "texplorer/scene/params/key_edits.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace texplorer::ui {

void preview(const Session& session, std::string_view choice, const Sentence& text,
             const std::function<void(Scene&)>& edit) {
    const std::optional<Preview>& shown = session.look.preview;
    const Scene& scene = presentScene(session);
    const bool rests = shown && !shown->scene && (shown->choice.empty() || shown->choice == choice);
    if (rests || (shown && shown->choice == choice && shown->madeOf == scene))
        return act(session, [name = std::string(choice)](Session& changed) {
            if (std::optional<Preview>& kept = changed.look.preview) {
                kept->choice = name;
                kept->wanted = true;
            }
        });
    Scene edited = scene;
    edit(edited);
    // As it would be recorded; a value that cannot be a key is not shown.
    static_cast<void>(keyEdits(edited, scene, presentKeyTime(session)));
    const bool isLoaded = std::ranges::all_of(
        filesOf(edited), [&](const std::string& file) { return session.document.images.holds(file); });
    if (!isLoaded)
        return;
    session.document.images.fillMeshes(edited);
    act(session, [made = Preview{std::string(choice), text, std::make_shared<const Scene>(std::move(edited)),
                                 scene, true}](Session& changed) { changed.look.preview = made; });
}

void endPreview(Session& session) {
    std::optional<Preview>& shown = session.look.preview;
    if (shown && !std::exchange(shown->wanted, false))
        shown.reset();
}

void restPreview(Session& session) {
    session.look.preview = Preview{.wanted = true};
}

const Preview* shownPreview(const Session& session) {
    const std::optional<Preview>& preview = session.look.preview;
    return preview && preview->scene ? &*preview : nullptr;
}

const Scene& shownScene(const Session& session) {
    if (const Preview* shown = shownPreview(session))
        return *shown->scene;
    return isKeptShown(session) && session.document.kept.seen ? *session.document.kept.seen
                                                              : session.document.scene;
}

} // namespace texplorer::ui
