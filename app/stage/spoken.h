#pragma once

#include "texplorer/base/sentence.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace texplorer::ui {
struct Session; // see app/ui/model/session.h
}

namespace texplorer::stage {

/// The open lesson's step.
struct SpokenStep {
    std::string lesson; ///< its title
    std::size_t step = 0;
    std::size_t steps = 0;
    std::string title;
    std::string text;
    std::string task; ///< empty: the step has none
    std::vector<std::string> answers;
    std::optional<std::size_t> chosen; ///< of the answers
    std::string verdict;               ///< on the answer or the picture; empty: there is none yet

    bool operator==(const SpokenStep&) const = default;
};

/// What the window shows, as text, for a host whose user does not see it. Texts are in the window's
/// language.
struct Spoken {
    std::string language; ///< a BCP 47 tag: "en", "zh-CN"
    std::string status;   ///< the message of the status bar, the first finding or problem; empty: none
    std::string row;      ///< the parameter with the pointer or the keyboard focus, and its value
    std::optional<SpokenStep> step;

    bool operator==(const Spoken&) const = default;
};

/// Call it after a frame was drawn. `problems`: Loop::problems.
[[nodiscard]] Spoken spokenBy(const ui::Session& session, std::span<const Sentence> problems = {});

} // namespace texplorer::stage
