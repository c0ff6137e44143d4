#include "app/ui/model/preview.h"

#include "app/ui/model/kept.h"
#include "app/ui/model/session.h"
#include "app/ui/model/timeline_edits.h"
#include "texplorer/scene/params/key_edits.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace texplorer::ui {

void preview(const Session& session, std::string_view choice, std::string_view text,
             const std::function<void(Scene&)>& edit) {
    const std::optional<Preview>& shown = session.look.preview;
    const Scene& scene = presentScene(session);
    if (shown && shown->choice == choice && shown->madeOf == scene)
        return act(session, [](Session& changed) {
            if (changed.look.preview)
                changed.look.preview->wanted = true;
        });
    Scene edited = scene;
    edit(edited);
    // As it would be recorded; a value that cannot be a key is not shown.
    static_cast<void>(keyEdits(edited, scene, presentKeyTime(session)));
    const bool isLoaded = std::ranges::all_of(
        filesOf(edited), [&](const std::string& file) { return session.document.images.holds(file); });
    if (!isLoaded)
        return;
    act(session, [made = Preview{std::string(choice), std::string(text),
                                 std::make_shared<const Scene>(std::move(edited)), scene,
                                 true}](Session& changed) { changed.look.preview = made; });
}

void endPreview(Session& session) {
    std::optional<Preview>& shown = session.look.preview;
    if (shown && !std::exchange(shown->wanted, false))
        shown.reset();
}

const Scene& shownScene(const Session& session) {
    if (session.look.preview)
        return *session.look.preview->scene;
    return isKeptShown(session) && session.document.kept.seen ? *session.document.kept.seen
                                                              : session.document.scene;
}

} // namespace texplorer::ui
