#include "app/screenshot/runs/run_files.h"

#include "app/screenshot/arguments/outputs_apart.h"
#include "app/screenshot/arguments/scene_argument.h"
#include "texplorer/suite/case_scene.h"
#include "texplorer/suite/suite_folder.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>

namespace texplorer::screenshot {
namespace {

namespace fs = std::filesystem;

/// Cases that differ in their renderer, size or time alone read the same.
bool readTheSame(const suite::Case& a, const suite::Case& b) {
    return a.suite == b.suite && a.entry == b.entry && a.scene == b.scene && a.edits == b.edits;
}

void addScene(const suite::Plan& plan, const suite::Case& each, std::set<std::string>& read) {
    const suite::Suite& suite = plan.suiteOf(each);
    if (const auto* lesson = std::get_if<suite::SceneLesson>(&plan.entryOf(each).scenes[each.scene])) {
        std::error_code ignored;
        const fs::path folder = suite.folder / lesson->lesson;
        if (fs::is_directory(folder, ignored))
            std::ranges::move(filesOfLesson(lesson::LessonFolder::onDisk(folder)),
                              std::inserter(read, read.end()));
    }
    const Result<suite::CaseScene> scene = suite::openScene(plan, each);
    if (!scene)
        return;
    read.insert(scene->file.string());
    std::ranges::move(imageFilesOf(scene->scene, scene->images), std::inserter(read, read.end()));
}

/// The goldens of suites; what lies in a folder is listed once.
class Goldens {
public:
    /// In whose name a driver's stands, it is every file whose name begins and ends like it.
    void add(const fs::path& folder, const std::string& golden) {
        using suite::driverPlace;
        const std::size_t place = golden.find(driverPlace);
        if (place == std::string::npos) {
            files.insert((folder / golden).string());
            return;
        }
        const std::string begin = (folder / golden.substr(0, place)).string();
        const std::string end = golden.substr(golden.rfind(driverPlace) + driverPlace.size());
        const std::vector<std::string>& there = listing(fs::path(begin).parent_path());
        for (auto each = std::ranges::lower_bound(there, begin);
             each != there.end() && each->starts_with(begin); ++each)
            if (each->ends_with(end))
                files.insert(*each);
    }

    std::set<std::string> files;

private:
    const std::vector<std::string>& listing(const fs::path& folder) {
        const auto [listed, isNew] = listings_.try_emplace(folder);
        std::error_code error;
        fs::recursive_directory_iterator each(folder.empty() ? fs::path(".") : folder, error);
        for (; isNew && !error && each != fs::recursive_directory_iterator(); each.increment(error))
            listed->second.push_back(
                (folder / each->path().lexically_relative(folder.empty() ? "." : folder)).string());
        std::ranges::sort(listed->second);
        return listed->second;
    }

    std::map<fs::path, std::vector<std::string>> listings_;
};

} // namespace

RunFiles filesOfRun(const PlannedRun& planned) {
    const RunSetup& setup = planned.setup;
    std::set<std::string> read{setup.mask};
    Goldens goldens;
    std::ranges::move(filesIn(setup.shaders), std::inserter(read, read.end()));
    for (const suite::Suite& each : planned.plan.suites)
        read.insert(each.file.string());
    const suite::Case* before = nullptr;
    for (const suite::Case& each : planned.plan.cases) {
        const fs::path& folder = planned.plan.suiteOf(each).folder;
        if (const std::string& mask = planned.plan.settingsOf(each).mask; !mask.empty())
            read.insert((folder / mask).string());
        if (before == nullptr || !readTheSame(*before, each))
            addScene(planned.plan, each, read);
        before = &each;
        for (const std::string& golden : suite::goldensOfAnyDriver(planned.plan, each))
            goldens.add(folder, golden);
    }
    if (!setup.golden.empty())
        for (const RunItem& each : planned.items) {
            read.insert((fs::path(setup.actual) / each.name).string());
            goldens.files.insert((fs::path(setup.golden) / each.name).string());
        }
    return {{read.begin(), read.end()}, {goldens.files.begin(), goldens.files.end()}};
}

} // namespace texplorer::screenshot
