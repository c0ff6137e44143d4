#pragma once

#include "app/ui/model/captures.h"
#include "app/ui/model/environment_pictures.h"
#include "app/ui/model/file_writing.h"
#include "app/ui/model/files.h"
#include "app/ui/model/lesson_work.h"
#include "app/ui/model/level_pictures.h"
#include "app/ui/model/pattern_pictures.h"
#include "app/ui/model/settings_file.h"
#include "app/ui/model/sheet_pictures.h"
#include "app/ui/model/unsaved_work.h"
#include "core/emit/program_worker.h"
#include "core/reference/draw_worker.h"
#include "core/reference/level_map_worker.h"
#include "core/reference/probe_worker.h"
#include "core/texture/levels_worker.h"

#include <functional>

namespace texplorer::ui {

/// The workers of the window. Owned by the host; must outlive the session.
struct Services {
    Files& files;
    LevelsWorker& levels;                ///< of the scene's textures
    reference::DrawWorker& reference;    ///< of the reference's picture
    reference::DrawWorker& kept;         ///< of its picture of the kept state A
    reference::ProbeWorker& probe;       ///< of the pixel that is explained
    reference::LevelMapWorker& levelMap; ///< of the levels that each pixel reads
    PatternPictures& patterns;           ///< of the choice of patterns
    LevelPictures& levelPictures;        ///< of the level shown in texture space
    LessonWork& lessons;                 ///< of the open lesson
    EnvironmentPictures& environments;   ///< of the table of environments
    reference::ProbeWorker&
        plainProbe;                 ///< of the same pixel for that table, regardless of the texture's format
    SheetPictures& sheet;           ///< of the sheet of variations
    emit::ProgramWorker& programs;  ///< of the calls in the tab
    FileWriting& writing;           ///< of sheets, animations and programs
    UnsavedWork* unsaved = nullptr; ///< nullptr: unsaved work is not kept
    SettingsFile* settings = nullptr; ///< nullptr: settings are not kept
    Captures* captures = nullptr;     ///< nullptr: no pictures are written
};

/// Services that work in the background on their own threads; `wake` is called on those when the next frame
/// has something new. Textures that are compressed at run time are kept in `cache`.
class ServicesBeside {
public:
    explicit ServicesBeside(const std::function<void()>& wake = {}, const BlockCache& cache = {})
        : files_(wake)
        , levels_(LevelsWorker::When::WhenReady, wake, {cache})
        , reference_(reference::DrawWorker::When::WhenReady, wake, {cache})
        , kept_(reference::DrawWorker::When::WhenReady, wake, {cache})
        , probe_(reference::ProbeWorker::When::WhenReady, wake, {cache})
        , levelMap_(reference::LevelMapWorker::When::WhenReady, wake, {cache})
        , patterns_(When::WhenReady, wake)
        , levelPictures_(When::WhenReady, wake)
        , lessons_(When::WhenReady, wake)
        , environments_(When::WhenReady, wake)
        , plainProbe_(When::WhenReady, wake, {cache})
        , sheet_(When::WhenReady, wake, {cache})
        , programs_(When::WhenReady, wake, {cache})
        , writing_(When::WhenReady, wake, {cache}) {}

    [[nodiscard]] Services lend(UnsavedWork* unsaved = nullptr) {
        return {files_,   levels_,       reference_,  kept_,  probe_,    levelMap_, patterns_, levelPictures_,
                lessons_, environments_, plainProbe_, sheet_, programs_, writing_,  unsaved};
    }

private:
    FilesBeside files_;
    LevelsWorker levels_;
    reference::DrawWorker reference_;
    reference::DrawWorker kept_;
    reference::ProbeWorker probe_;
    reference::LevelMapWorker levelMap_;
    PatternPictures patterns_;
    LevelPictures levelPictures_;
    LessonWork lessons_;
    EnvironmentPictures environments_;
    reference::ProbeWorker plainProbe_;
    SheetPictures sheet_;
    emit::ProgramWorker programs_;
    FileWriting writing_;
};

/// The same without threads: every call blocks. For programs without a user. `work`: how textures are
/// compressed at run time.
class ServicesAtOnce {
public:
    explicit ServicesAtOnce(const LevelWork& work = {})
        : levels_(LevelsWorker::When::AtOnce, {}, work)
        , reference_(reference::DrawWorker::When::AtOnce, {}, work)
        , kept_(reference::DrawWorker::When::AtOnce, {}, work)
        , probe_(reference::ProbeWorker::When::AtOnce, {}, work)
        , levelMap_(reference::LevelMapWorker::When::AtOnce, {}, work)
        , patterns_(When::AtOnce)
        , levelPictures_(When::AtOnce)
        , lessons_(When::AtOnce)
        , environments_(When::AtOnce)
        , plainProbe_(When::AtOnce, {}, work)
        , sheet_(When::AtOnce, {}, work)
        , programs_(When::AtOnce, {}, work)
        , writing_(When::AtOnce, {}, work) {}

    [[nodiscard]] Services lend(UnsavedWork* unsaved = nullptr) {
        return {files_,   levels_,       reference_,  kept_,  probe_,    levelMap_, patterns_, levelPictures_,
                lessons_, environments_, plainProbe_, sheet_, programs_, writing_,  unsaved};
    }

private:
    FilesAtOnce files_;
    LevelsWorker levels_;
    reference::DrawWorker reference_;
    reference::DrawWorker kept_;
    reference::ProbeWorker probe_;
    reference::LevelMapWorker levelMap_;
    PatternPictures patterns_;
    LevelPictures levelPictures_;
    LessonWork lessons_;
    EnvironmentPictures environments_;
    reference::ProbeWorker plainProbe_;
    SheetPictures sheet_;
    emit::ProgramWorker programs_;
    FileWriting writing_;
};

} // namespace texplorer::ui
