#include "app/explorer/loop.h"

#include "app/command_line/standard_streams.h"
#include "app/explorer/reopening.h"
#include "app/opengl/window_graphics.h"
#include "app/stage/loop.h"
#include "app/ui/editor/received_files.h"
#include "app/ui/files/lessons.h"
#include "app/ui/files/scene_files.h"
#include "app/ui/files/scene_paths.h"
#include "app/ui/files/unsaved_work.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/session.h"
#include "app/ui/services/unsaved_work.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

#include <atomic>
#include <cstdlib>
#include <optional>

namespace texplorer::explorer {
namespace {

/// Writes unsaved work when the program is ended from outside: only standard error can still tell of a
/// failure.
void storeAtEnd(Autosave& autosave) {
    if (const Result<void> stored = autosave.flush(); !stored)
        complain("texplorer", fmt::format("unsaved work can't be stored: {}", describe(stored.error())));
}

std::atomic<Autosave*> keptWithoutDisplay = nullptr;

/// While an object of this class exists, unsaved work is written when the display connection is lost, which
/// is how many sessions end.
class KeptWithoutDisplay {
public:
    explicit KeptWithoutDisplay(Autosave& autosave) {
        keptWithoutDisplay = &autosave;
        Window::whenDisplayIsLost([] {
            if (Autosave* kept = keptWithoutDisplay)
                storeAtEnd(*kept);
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

/// While an object of this class exists, unsaved work is written before the program starts again because the
/// driver hangs.
class KeptWhenHanging {
public:
    KeptWhenHanging(const Host& host, Autosave& autosave)
        : watch_(host.watch) {
        watch_.whenHanging([&autosave, &restart = host.restart](double seconds) {
            storeAtEnd(autosave);
            restart.run(seconds);
        });
    }
    KeptWhenHanging(const KeptWhenHanging&) = delete;
    KeptWhenHanging& operator=(const KeptWhenHanging&) = delete;
    ~KeptWhenHanging() { watch_.whenHanging({}); }

private:
    FrameWatch& watch_;
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

/// The events since the last frame. Loaded files are received here, not in the frame: if that hangs, they are
/// what has to be shown again.
std::vector<stage::Event> nextEvents(Window& window, ui::Session& session) {
    std::vector<stage::Event> events = window.takeEvents();
    if (ui::receiveFiles(session)) {
        events.emplace_back(stage::Refresh{});
        ui::followEdits(session);
    }
    return events;
}

/// Draws a frame, watched. Showing it is not: the display may take it only when it is seen.
stage::Step drawFrame(const Host& host, stage::Loop& loop, double now,
                      const std::vector<stage::Event>& events) {
    host.watch.begin();
    stage::Step done = loop.step(now, events);
    if (!done.drawn) {
        host.watch.end();
        return done;
    }
    opengl::finishDrawing();
    host.watch.drawn();
    return done;
}

void showFrame(Window& window, const ui::Session& session, const stage::Step& done) {
    window.setTitle(done.title);
    window.setCursor(done.cursor);
    window.fillScreen(session.window.fillsScreen);
    window.swap();
}

} // namespace

std::vector<std::string> argumentsOf(const Beginning& beginning) {
    std::vector<std::string> arguments;
    for (const std::filesystem::path& file : beginning.files)
        arguments.push_back(ui::absolutePath(file).string()); // a name may begin with a dash
    if (!beginning.lesson.empty())
        arguments.insert(arguments.end(), {"--lesson", beginning.lesson});
    return arguments;
}

Result<void> runLoop(const Host& host, const Beginning& beginning) {
    Window& window = host.window;
    const auto graphics = opengl::createWindowGraphics({beginning.shaders, Window::wake}, beginning.pretence);
    if (!graphics)
        return fail(graphics.error());
    ui::ServicesBeside services(Window::wake, BlockCache::ofUser());
    ui::UnsavedWork unsaved(unsavedFolderOfUser(), Window::wake);
    // Destroyed last: on a slow disk, pictures must not keep settings from being written before the window
    // must end.
    ui::Captures captures(ui::picturesFolderOfUser(), When::WhenReady, Window::wake);
    ui::SettingsFile settings(ui::SettingsPlaces::ofUser(), Window::wake);
    ui::Services lent = services.lend(&unsaved);
    lent.settings = &settings;
    lent.captures = &captures;
    ui::Session session(lent);
    session.settings = settings.read();
    session.window.systemLanguage = ui::languageOfSystem();
    if (!session.settings.hasSeenTour)
        session.window.tour = 0;
    stage::Loop loop(**graphics, session, window.surface(),
                     {[&window] { return window.clipboard(); },
                      [&window](const std::string& text) { window.setClipboard(text); }});
    const KeptWithoutDisplay withoutDisplay(unsaved.autosave);
    const KeptOnSignal onSignal(host.signals, unsaved.autosave);
    const KeptWhenHanging whenHanging(host, unsaved.autosave);
    ui::report(session, ui::openArguments(session, beginning.files));
    if (!beginning.lesson.empty())
        ui::report(session, ui::openLessonNamed(session, beginning.lesson));
    Reopening reopening(session, **graphics, beginning);
    reopening.begin();

    for (;;) {
        if (host.signals.received() != 0) {
            storeAtEnd(unsaved.autosave); // including the changes of the last frame
            return {};
        }
        const double now = Window::now();
        const std::vector<stage::Event> events = nextEvents(window, session);
        reopening.receive(events);
        host.restart.note(reopening.reopened());
        const stage::Step done = drawFrame(host, loop, now, events);
        if (done.drawn)
            showFrame(window, session, done);
        if (done.quit) {
            unsaved.autosave.forget(); // the user has decided
            (void)unsaved.autosave.flush();
            host.signals.endSoon(EXIT_SUCCESS);
            return {};
        }
        rest(window, done.wake, now);
    }
}

} // namespace texplorer::explorer
