#include "app/ui/files/address.h"

#include "app/ui/files/asking.h"
#include "app/ui/files/scene_files.h"
#include "texplorer/lesson/lesson_files.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/storage/scene_link.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>

namespace texplorer::ui {
namespace {

/// What an address names.
struct Named {
    std::string lesson;
    std::optional<std::size_t> step; ///< from 0
    const LayoutRow* layout = nullptr;
    bool isEmbedded = false;
};

constexpr std::string_view embedded = "embed"; // for a frame in another page: the view, and the open lesson

Error unexpected(std::string_view found) {
    return {ErrorCode::Malformed,
            Sentence("expected a link to a scene, or lesson=NAME, step=NUMBER and layout=NAME, found \"{0}\"",
                     shortened(found)),
            {}};
}

Result<std::size_t> stepIn(std::string_view text) {
    std::size_t number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end || number == 0)
        return fail(ErrorCode::Malformed,
                    Sentence("expected a number from 1, found \"{0}\"", shortened(text)), atName("step"));
    return number - 1;
}

Result<const LayoutRow*> layoutIn(std::string_view text) {
    const std::string_view name = text == embedded ? "minimal" : text;
    const auto* row = std::ranges::find(layoutRows, name, &LayoutRow::name);
    if (row == layoutRows.end())
        return fail(ErrorCode::NotFound,
                    Sentence("expected embed, minimal, student or teacher, found \"{0}\"", shortened(text)),
                    atName("layout"));
    return row;
}

Result<Named> parse(std::string_view address) {
    Named named;
    while (!address.empty()) {
        const std::string_view part = address.substr(0, address.find('&'));
        address.remove_prefix(std::min(address.size(), part.size() + 1));
        const std::string_view name = part.substr(0, part.find('='));
        const std::string_view value = part.substr(std::min(part.size(), name.size() + 1));
        if (name == "lesson") {
            named.lesson = value;
        } else if (name == "step") {
            const Result<std::size_t> step = stepIn(value);
            if (!step)
                return fail(step.error());
            named.step = *step;
        } else if (name == "layout") {
            const Result<const LayoutRow*> layout = layoutIn(value);
            if (!layout)
                return fail(layout.error());
            named.layout = *layout;
            named.isEmbedded = value == embedded;
        } else {
            return fail(unexpected(part));
        }
    }
    if (named.step && named.lesson.empty())
        return fail(unexpected("step"));
    return named;
}

} // namespace

Result<void> openAddress(Session& session, std::string_view address) {
    if (isSceneLink(address))
        return openSceneLink(session, address);
    const Result<Named> named = parse(address);
    if (!named)
        return fail(named.error());
    const auto choose = [&named](Session& s) {
        if (named->layout && (s.lesson || !named->isEmbedded))
            chooseLayout(s.settings.workspace, *named->layout);
        else if (named->layout)
            s.settings.workspace = workspaceOf(*named->layout);
        if (named->isEmbedded)
            s.window.tour.reset();
    };
    if (named->lesson.empty()) {
        choose(session);
        return {};
    }
    const Result<lesson::Lesson> lesson =
        lesson::LessonFolder::builtIn(named->lesson).and_then(lesson::readLesson);
    if (!lesson)
        return fail(lesson.error());
    if (named->step && *named->step >= lesson->steps.size())
        return fail(
            ErrorCode::OutOfRange,
            Sentence("expected a number from 1 to {0}, found {1}", lesson->steps.size(), *named->step + 1),
            atName("step"));
    askLesson(session, named->lesson, named->step);
    choose(session);
    return {};
}

} // namespace texplorer::ui
