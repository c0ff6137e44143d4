#pragma once

#include "app/ui/language/language.h"
#include "app/ui/state/workspace.h"

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
    std::string_view name; ///< in the settings file and for texshot's --theme
    const char* label;
};

inline constexpr std::array themeRows{
    ThemeRow{Theme::Dark, "dark", N_("Dark colours")},
    ThemeRow{Theme::Light, "light", N_("Light colours")},
    ThemeRow{Theme::HighContrast, "high-contrast", N_("High contrast")},
};

inline constexpr int tourSteps = 5; ///< of the tour at the first start

/// The result of a lesson's step.
struct StepRecord {
    bool done = false;
    int tries = 0;   ///< answers until the right one
    int answer = -1; ///< the last one

    bool operator==(const StepRecord&) const = default;
};

inline constexpr std::size_t maxLessonsKept = 1000;
inline constexpr std::size_t maxStepsKept = 100;
inline constexpr int maxTriesKept = 1'000'000;

inline constexpr std::size_t maxRecentFiles = 12;

/// Settings of the user, which are kept between windows.
struct Settings {
    Theme theme = Theme::Dark;
    Language language = Language::System;
    int textPercent = 100;           ///< relative to the usual text size
    bool largeControls = false;      ///< for fingers
    bool glNames = false;            ///< parameters have OpenGL's names
    std::vector<std::string> pinned; ///< additional parameters in Essentials, such as "textures[].wrapR"
    std::vector<std::filesystem::path> recentFiles; ///< scenes and images, newest first
    bool hasSeenTour = false;
    bool helpBelow = true; ///< help is shown in the status bar, not in tooltips
    std::map<std::string, std::vector<StepRecord>> lessons; ///< by their names
    Workspace workspace;                                    ///< which panels are open, and where

    static constexpr int minText = 75;
    static constexpr int maxText = 250;

    bool operator==(const Settings&) const = default;
};

} // namespace texplorer::ui
