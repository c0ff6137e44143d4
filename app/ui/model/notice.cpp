#include "app/ui/model/notice.h"

#include <utility>

namespace texplorer::ui {

void say(Session& session, const Error& error, const std::filesystem::path& file) {
    const bool contentIsWrong = error.code == ErrorCode::Malformed || error.code == ErrorCode::Unsupported;
    session.look.notice = {describe(error), contentIsWrong ? file : std::filesystem::path{}};
}

void say(Session& session, Sentence sentence) {
    session.look.notice = {std::move(sentence), {}};
}

void tell(Session& session, Sentence sentence) {
    session.look.notice = {.text = std::move(sentence), .file = {}, .isGood = true};
}

void report(Session& session, const Result<void>& result, const std::filesystem::path& file) {
    if (!result)
        say(session, result.error(), file);
}

} // namespace texplorer::ui
