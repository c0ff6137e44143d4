#include "app/explorer/loop.h"

#include "app/opengl/window_graphics.h"
#include "app/stage/loop.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/model/session.h"

#include <atomic>
#include <optional>

namespace texplorer::explorer {
namespace {

std::atomic<Autosave*> keptWithoutDisplay = nullptr;

/// While an object of this class exists, unsaved work is written when the display connection is lost, which
/// is how many sessions end.
class KeptWithoutDisplay {
public:
    explicit KeptWithoutDisplay(Autosave& autosave) {
        keptWithoutDisplay = &autosave;
        Window::whenDisplayIsLost([] {
            if (Autosave* kept = keptWithoutDisplay)
                (void)kept->flush();
        });
    }
    KeptWithoutDisplay(const KeptWithoutDisplay&) = delete;
    KeptWithoutDisplay& operator=(const KeptWithoutDisplay&) = delete;
    ~KeptWithoutDisplay() { keptWithoutDisplay = nullptr; }
};

/// While an object of this class exists, a signal writes unsaved work and wakes the window so that it closes.
class KeptOnSignal {
public:
    KeptOnSignal(Signals& signals, Autosave& autosave)
        : signals_(signals) {
        signals_.onRequest([&autosave] {
            (void)autosave.flush();
            Window::wake();
        });
    }
    KeptOnSignal(const KeptOnSignal&) = delete;
    KeptOnSignal& operator=(const KeptOnSignal&) = delete;
    ~KeptOnSignal() { signals_.onRequest({}); }

private:
    Signals& signals_;
};

/// Sleeps until an event or until `wake`, but at least for one frame of the display: the driver may not wait
/// for it, and the mouse may report a thousand times a second.
void rest(Window& window, std::optional<double> wake, double last) {
    const double now = Window::now();
    if (!wake)
        window.wait();
    else if (*wake > now)
        window.wait(*wake - now);
    const double due = last + window.frameSeconds() * 0.95;
    do
        window.wait(due - Window::now());
    while (Window::now() < due);
}

} // namespace

Result<void> runLoop(Window& window, Signals& signals, const std::vector<std::filesystem::path>& files,
                     const std::string& lesson, const std::filesystem::path& shaders,
                     const view::Pretence& pretence) {
    const auto graphics = opengl::createWindowGraphics({shaders, Window::wake}, pretence);
    if (!graphics)
        return fail(graphics.error());
    ui::ServicesBeside services(Window::wake, BlockCache::ofUser());
    ui::UnsavedWork unsaved(unsavedFolderOfUser(), Window::wake);
    ui::SettingsFile settings(ui::SettingsPlaces::ofUser(), Window::wake);
    ui::Captures captures(ui::picturesFolderOfUser(), When::WhenReady, Window::wake);
    ui::Services lent = services.lend(&unsaved);
    lent.settings = &settings;
    lent.captures = &captures;
    ui::Session session(lent);
    session.window.settings = settings.read();
    session.window.systemLanguage = ui::languageOfSystem();
    if (!session.window.settings.hasSeenTour)
        session.window.tour = 0;
    stage::Loop loop(**graphics, session, window.surface(),
                     {[&window] { return window.clipboard(); },
                      [&window](const std::string& text) { window.setClipboard(text); }});
    const KeptWithoutDisplay withoutDisplay(unsaved.autosave);
    const KeptOnSignal onSignal(signals, unsaved.autosave);
    ui::report(session, ui::openArguments(session, files));
    if (!lesson.empty())
        ui::report(session, ui::openLessonNamed(session, lesson));

    for (;;) {
        if (signals.received() != 0) {
            (void)unsaved.autosave.flush(); // including the changes of the last frame
            return {};
        }
        const double now = Window::now();
        const stage::Step done = loop.step(now, window.takeEvents());
        if (done.drawn) {
            window.setTitle(done.title);
            window.setCursor(done.cursor);
            window.fillScreen(session.window.fillsScreen);
            window.swap();
        }
        if (done.quit) {
            unsaved.autosave.forget(); // the user has decided
            (void)unsaved.autosave.flush();
            return {};
        }
        rest(window, done.wake, now);
    }
}

} // namespace texplorer::explorer
