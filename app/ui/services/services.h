#pragma once

#include "app/ui/services/captures.h"
#include "app/ui/services/environment_pictures.h"
#include "app/ui/services/file_writing.h"
#include "app/ui/services/files.h"
#include "app/ui/services/lesson_work.h"
#include "app/ui/services/level_pictures.h"
#include "app/ui/services/pattern_pictures.h"
#include "app/ui/services/settings_file.h"
#include "app/ui/services/sheet_pictures.h"
#include "app/ui/services/unsaved_work.h"
#include "texplorer/emit/program_worker.h"
#include "texplorer/reference/draw_worker.h"
#include "texplorer/reference/level_map_worker.h"
#include "texplorer/reference/probe_worker.h"
#include "texplorer/texture/levels_worker.h"

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

/// The services of a window, which reads files with a `FilesKind`.
template<class FilesKind>
class OwnedServices {
public:
    /// `wake` is called on the workers' threads when the next frame has something new; `work`: how textures
    /// are compressed at run time.
    OwnedServices(When when, const std::function<void()>& wake, const LevelWork& work, auto&&... files)
        : files_(files...)
        , levels_(when, wake, work)
        , reference_(when, wake, work)
        , kept_(when, wake, work)
        , probe_(when, wake, work)
        , levelMap_(when, wake, work)
        , patterns_(when, wake)
        , levelPictures_(when, wake)
        , lessons_(when, wake)
        , environments_(when, wake)
        , plainProbe_(when, wake, work)
        , sheet_(when, wake, work)
        , programs_(when, wake, work)
        , writing_(when, wake, work) {}

    [[nodiscard]] Services lend(UnsavedWork* unsaved = nullptr) {
        return {files_,   levels_,       reference_,  kept_,  probe_,    levelMap_, patterns_, levelPictures_,
                lessons_, environments_, plainProbe_, sheet_, programs_, writing_,  unsaved};
    }

private:
    FilesKind files_;
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

/// Services that work in the background on their own threads. Textures that are compressed at run time are
/// kept in `cache`.
struct ServicesBeside : OwnedServices<FilesBeside> {
    explicit ServicesBeside(const std::function<void()>& wake = {}, const BlockCache& cache = {})
        : OwnedServices(When::WhenReady, wake, {cache}, wake) {}
};

/// The same without threads: every call blocks. For programs without a user.
struct ServicesAtOnce : OwnedServices<FilesAtOnce> {
    explicit ServicesAtOnce(const LevelWork& work = {})
        : OwnedServices(When::AtOnce, {}, work) {}
};

} // namespace texplorer::ui
