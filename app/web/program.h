#pragma once

#include "app/stage/loop.h"
#include "app/stage/messages.h"
#include "app/stage/spoken.h"
#include "app/ui/model/session.h"
#include "app/ui/services/services.h"
#include "app/ui/widgets/widget_places.h"
#include "app/web/page_drawing.h"
#include "app/web/page_writing.h"
#include "app/web/web_graphics.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace texplorer::web {

/// The window in a page: takes the page's events and draws frames on its canvas. One per page.
class Program {
public:
    /// `hasFingers`: at the first visit, controls are large. `page`: its address without #.
    Program(const stage::Surface& surface, bool hasFingers, std::string page);

    void happened(stage::Event event) { events_.push_back(std::move(event)); }
    /// The user has chosen or dropped files. Without `answers`, no request of the program has led to it.
    void filesGiven(std::vector<stage::NamedFile> files, bool answers);
    /// A given file has changed; see stage::replaceGivenFile.
    [[nodiscard]] bool fileChanged(const Bytes& before, const Bytes& now);
    /// See ui::openAddress. Errors are shown in the window.
    void openAddress(const std::string& address);
    void say(const Sentence& sentence);
    void answer(std::size_t answer);
    void goToStep(std::size_t step);
    /// The text that the next paste gets.
    void setClipboard(std::string text) { clipboard_ = std::move(text); }
    void contextRestored();
    void takePicture(unsigned worker, Image image, double milliseconds, std::vector<Sentence> problems);
    void takeFile(unsigned worker, ui::MadeFile file);
    void fileProgress(unsigned worker, float share);
    /// See PageDrawing::failed and PageWriting::failed.
    void workerEnded(unsigned worker, const Sentence& reason);
    /// The page fills the screen, or no longer does.
    void fullScreenChanged(bool fills);

    /// Draws a frame. Returns after how many seconds the next one is due; below 0: after the next event.
    [[nodiscard]] double step();
    /// See stage::answerMessage.
    void receive(std::string_view message);
    /// How far a notch of the wheel scrolls the list below the pointer, in units of the pointer; 0: there is
    /// none.
    [[nodiscard]] static float scrolledByNotch();
    /// Where a widget was in the last frame, in units of the pointer (ui::WidgetPlaces has the names);
    /// nothing if it was not visible. The first call starts the reports: it knows no widget.
    [[nodiscard]] std::optional<ui::WidgetPlaces::Item> place(std::string_view name);
    /// Writes unsaved work now.
    void store();

private:
    /// Draws in a Web Worker.
    struct Drawing {
        explicit Drawing(std::unique_ptr<PageDrawing> made = std::make_unique<PageDrawing>())
            : place(*made)
            , worker(std::move(made)) {}
        PageDrawing& place;
        reference::DrawWorker worker;
    };

    [[nodiscard]] ui::Services services();
    /// nullptr: it was dropped meanwhile.
    [[nodiscard]] PageDrawing* drawingOf(unsigned worker);
    void show(const stage::Step& done);
    void keepGivenFiles();

    WebGraphics graphics_;
    ui::OwnedServices<ui::FilesAtOnce> services_;
    Drawing now_;
    Drawing kept_;
    PageWriting writing_;
    ui::UnsavedWork unsaved_;
    ui::Captures captures_;
    ui::SettingsFile settings_;
    ui::Session session_;
    std::string clipboard_;
    std::optional<stage::FileWish> wish_; ///< the last request for files
    stage::Loop loop_;
    std::vector<stage::Event> events_;
    std::optional<ui::WidgetPlaces> places_;                     ///< nothing: none was requested
    std::map<std::string, std::shared_ptr<const Bytes>> stored_; ///< the files in the working folder
    stage::Spoken spoken_;
    stage::LessonEvents lessonEvents_;
    std::string title_;
    ImGuiMouseCursor cursor_ = ImGuiMouseCursor_Arrow;
    bool fillsScreen_ = false;
};

} // namespace texplorer::web
