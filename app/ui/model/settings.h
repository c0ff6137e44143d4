#pragma once

#include "app/ui/language/language.h"
#include "app/ui/model/workspace.h"

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::ui {

enum class Theme { Dark, Light, HighContrast };

struct ThemeRow {
    Theme theme;
    std::string_view name; ///< in the settings' file and for texshot's --theme
    const char* label;
};

inline constexpr std::array themeRows{
    ThemeRow{Theme::Dark, "dark", "Dark colours"},
    ThemeRow{Theme::Light, "light", "Light colours"},
    ThemeRow{Theme::HighContrast, "high-contrast", "High contrast"},
};

inline constexpr int tourSteps = 5; ///< of the tour at the first start

/// What became of a step of a lesson.
struct StepRecord {
    bool done = false;
    int tries = 0;   ///< answers until the right one
    int answer = -1; ///< the last of them

    bool operator==(const StepRecord&) const = default;
};

inline constexpr std::size_t mostLessonsKept = 1000;
inline constexpr std::size_t mostStepsKept = 100;
inline constexpr int mostTriesKept = 1'000'000;

/// What outlives the window and belongs to the person, not to the scene.
struct Settings {
    Theme theme = Theme::Dark;
    Language language = Language::System;
    int textPercent = 100; ///< of the text's usual size
    bool glNames = false;  ///< parameters are called as OpenGL calls them
    std::vector<std::string>
        pinned; ///< parameters that Essentials shows beside its own, as "textures[].wrapR"
    std::vector<std::filesystem::path> recentFiles; ///< scenes and images, the newest first
    bool hasSeenTour = false;
    bool helpBelow =
        true; ///< what the pointer rests on is explained in the status bar, not over its neighbours
    std::map<std::string, std::vector<StepRecord>> lessons; ///< by their names
    Workspace workspace;                                    ///< which panels are open, and where

    static constexpr int smallestText = 75;
    static constexpr int largestText = 250;

    bool operator==(const Settings&) const = default;
};

} // namespace texplorer::ui
