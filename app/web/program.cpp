#include "app/web/program.h"

#include "app/stage/given_files.h"
#include "app/ui/files/address.h"
#include "app/ui/files/lessons.h"
#include "app/ui/model/notice.h"
#include "app/web/browser.h"
#include "app/web/level_work.h"
#include "texplorer/base/clock.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/files/file_io.h"

#include <imgui_internal.h> // the window below the pointer
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>
#include <variant>

namespace texplorer::web {
namespace {

constexpr const char* given = "/given";         // files of the user, which the page keeps with unsaved work
constexpr const char* downloads = "/downloads"; // what is written here, the page gives to the user

std::string jsonOf(const stage::Spoken& spoken) {
    nlohmann::ordered_json json{
        {"language", spoken.language}, {"status", spoken.status}, {"row", spoken.row}};
    if (const std::optional<stage::SpokenStep>& step = spoken.step)
        json["step"] = {
            {"lesson", step->lesson},   {"step", step->step},
            {"steps", step->steps},     {"title", step->title},
            {"text", step->text},       {"task", step->task},
            {"answers", step->answers}, {"chosen", step->chosen ? static_cast<int>(*step->chosen) : -1},
            {"verdict", step->verdict}};
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

} // namespace

Program::Program(const stage::Surface& surface, bool hasFingers, std::string page)
    : services_(When::WhenReady, {}, levelWork())
    , writing_(levelWork())
    , unsaved_(unsavedFolderOfUser())
    , captures_(downloads)
    , settings_(ui::SettingsPlaces::ofUser(), {}, std::chrono::milliseconds(0)) // a page ends without notice
    , session_(services())
    , loop_(graphics_, session_, surface,
            {[this] { return clipboard_; },
             [this](const std::string& text) {
                 clipboard_ = text;
                 browser::writeClipboard(text.data(), lengthOf(text));
             }},
            {[this](const stage::FileWish& wish) {
                 wish_ = wish;
                 browser::chooseFiles(wish.isScene);
             },
             [](const std::vector<stage::NamedFile>& files) {
                 for (const stage::NamedFile& file : files)
                     browser::saveFile(file.name.data(), lengthOf(file.name), file.bytes.data(),
                                       lengthOf(file.bytes));
             }}) {
    std::filesystem::current_path(given);
    const bool isFirstVisit = !std::filesystem::exists(ui::SettingsPlaces::ofUser().settings);
    session_.settings = settings_.read();
    session_.settings.largeControls |= isFirstVisit && hasFingers;
    session_.window.systemLanguage = ui::languageOfSystem();
    if (!session_.settings.hasSeenTour)
        session_.window.tour = 0;
    session_.window.page = std::move(page);
    static_cast<void>(
        ui::offerRenderers(session_.view, graphics_.renderers())); // not the user's choice: no message
}

ui::Services Program::services() {
    ui::Services services = services_.lend(&unsaved_);
    services.settings = &settings_;
    services.captures = &captures_;
    services.reference = now_.worker;
    services.kept = kept_.worker;
    services.writing = writing_;
    return services;
}

PageDrawing* Program::drawingOf(unsigned worker) {
    for (PageDrawing* each : {&now_.place, &kept_.place}) {
        if (worker != 0 && each->worker() == worker)
            return each;
    }
    return nullptr;
}

void Program::takePicture(unsigned worker, Image image, double milliseconds, std::vector<Sentence> problems) {
    if (PageDrawing* drawing = drawingOf(worker))
        drawing->drawn(std::move(image), milliseconds, std::move(problems));
    happened(stage::Refresh{});
}

void Program::takeFile(unsigned worker, ui::MadeFile file) {
    if (worker == writing_.worker())
        writing_.made(std::move(file));
    happened(stage::Refresh{});
}

void Program::fileProgress(unsigned worker, float share) {
    if (worker == writing_.worker())
        writing_.progressed(share);
    happened(stage::Refresh{});
}

void Program::workerEnded(unsigned worker, const Sentence& reason) {
    if (PageDrawing* drawing = drawingOf(worker))
        drawing->failed(reason);
    if (worker != 0 && worker == writing_.worker())
        writing_.failed(reason);
    happened(stage::Refresh{});
}

void Program::filesGiven(std::vector<stage::NamedFile> files, bool answers) {
    happened(
        stage::FilesGiven{std::move(files), answers ? std::exchange(wish_, std::nullopt) : std::nullopt});
}

bool Program::fileChanged(const Bytes& before, const Bytes& now) {
    happened(stage::Refresh{});
    return stage::replaceGivenFile(session_, before, now);
}

void Program::openAddress(const std::string& address) {
    if (const Result<void> opened = ui::openAddress(session_, address); !opened)
        say(Sentence("The address can't be opened: {0}.", describe(opened.error())));
    happened(stage::Refresh{});
}

void Program::say(const Sentence& sentence) {
    ui::say(session_, sentence);
    happened(stage::Refresh{});
}

void Program::fullScreenChanged(bool fills) {
    session_.window.fillsScreen = fillsScreen_ = fills;
    happened(stage::Refresh{});
}

void Program::answer(std::size_t answer) {
    const auto* asked =
        session_.lesson
            ? std::get_if<lesson::Predict>(&session_.lesson->lesson.steps[session_.lesson->step].task)
            : nullptr;
    if (asked && answer < asked->answers.size())
        ui::answerQuestion(session_, answer);
    happened(stage::Refresh{});
}

void Program::goToStep(std::size_t step) {
    if (session_.lesson && step < session_.lesson->lesson.steps.size())
        ui::goToLessonStep(session_, step);
    happened(stage::Refresh{});
}

void Program::contextRestored() {
    graphics_.contextRestored();
    happened(stage::Refresh{});
}

double Program::step() {
    const double now = steadySeconds();
    const stage::Step done = loop_.step(now, std::exchange(events_, {}));
    if (done.drawn)
        show(done);
    keepGivenFiles();
    std::optional<double> wait;
    if (done.wake)
        wait = std::max(0.0, *done.wake - steadySeconds());
    for (PageDrawing* each : {&now_.place, &kept_.place}) {
        if (const std::optional<double> check = each->check())
            wait = std::min(wait.value_or(*check), *check);
    }
    return wait.value_or(-1);
}

/// Unsaved work names its files, which are found again in the program's working folder. The files of the
/// document, and no others, are there; those that were found again are in memory like those that were given.
void Program::keepGivenFiles() {
    namespace fs = std::filesystem;
    ImageSource& images = session_.document.images;
    std::map<std::string, std::shared_ptr<const Bytes>> files;
    if (!session_.document.isLessons) {
        for (const std::string& name : filesOf(session_.document.scene)) {
            const fs::path path = fs::path(given) / name;
            if (!images.fileInMemory(name) && images.holds(name) && exists(path)) {
                if (Result<Bytes> file = readFile(path))
                    images.putFile(name, *std::move(file));
            }
            if (std::shared_ptr<const Bytes> file = images.fileInMemory(name))
                files.emplace(name, std::move(file));
        }
    }
    if (files == stored_)
        return;
    std::error_code ignored;
    for (const auto& [name, file] : stored_) {
        if (!files.contains(name))
            fs::remove(fs::path(given) / name, ignored);
    }
    for (const auto& [name, file] : files) {
        const auto before = stored_.find(name);
        if (before == stored_.end() || before->second != file)
            static_cast<void>(writeFileAtomically(fs::path(given) / name, *file)); // in memory
    }
    stored_ = std::move(files);
}

void Program::show(const stage::Step& done) {
    if (std::exchange(title_, done.title) != done.title)
        browser::setTitle(title_.data(), lengthOf(title_));
    if (std::exchange(cursor_, done.cursor) != done.cursor)
        browser::setCursor(cursor_);
    if (const bool fills = session_.window.fillsScreen; std::exchange(fillsScreen_, fills) != fills)
        browser::setFullScreen(fills);
    if (stage::Spoken spoken = stage::spokenBy(session_, loop_.problems()); spoken != spoken_) {
        spoken_ = std::move(spoken);
        const std::string json = jsonOf(spoken_);
        browser::speak(json.data(), lengthOf(json));
    }
    if (const std::string event = lessonEvents_.take(session_); !event.empty())
        browser::postMessage(event.data(), lengthOf(event));
    browser::setTyping(ImGui::GetIO().WantTextInput);
}

void Program::receive(std::string_view message) {
    const std::string answer = stage::answerMessage(session_, message);
    browser::postMessage(answer.data(), lengthOf(answer));
    happened(stage::Refresh{});
}

float Program::scrolledByNotch() {
    const ImGuiWindow* window = ImGui::GetCurrentContext()->HoveredWindow;
    while (window && (window->ScrollMax.y <= 0 || (window->Flags & ImGuiWindowFlags_NoScrollWithMouse) != 0))
        window = (window->Flags & ImGuiWindowFlags_ChildWindow) != 0 ? window->ParentWindow
                                                                     : nullptr; // no popup's
    return window ? std::floor(std::min(5 * window->CalcFontSize(), window->InnerRect.GetHeight() * 0.67F))
                  : 0;
}

std::optional<ui::WidgetPlaces::Item> Program::place(std::string_view name) {
    if (!places_) {
        places_.emplace();
        happened(stage::Refresh{});
    }
    const auto found = places_->items.find(name);
    return found != places_->items.end() && found->second.visible ? std::optional(found->second)
                                                                  : std::nullopt;
}

void Program::store() {
    static_cast<void>(unsaved_.autosave.flush()); // a failure is shown in the window
}

} // namespace texplorer::web
