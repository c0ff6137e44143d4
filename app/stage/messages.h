#pragma once

#include <string>
#include <string_view>

namespace texplorer::ui {
struct Session; // see app/ui/model/session.h
}

namespace texplorer::stage {

/// The version of the messages; another one is refused.
inline constexpr int messageVersion = 1;

/// Does what another program asks for, such as the page around an embedded window, and returns the answer:
/// both are JSON objects (assets/schemas/messages.schema.json). Changes of the scene are steps of undo, made
/// with the next frame. Call it between two frames.
[[nodiscard]] std::string answerMessage(ui::Session& session, std::string_view message);

/// What has happened in the open lesson since the last call, as such an object; empty: nothing.
class LessonEvents {
public:
    [[nodiscard]] std::string take(const ui::Session& session);

private:
    std::string last_;
};

} // namespace texplorer::stage
