#include "texplorer/suite/suite_folder.h"

#include "texplorer/files/file_io.h"
#include "texplorer/files/file_kind.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/suite/png_size.h"
#include "texplorer/text/printable.h"

#include <algorithm>

namespace texplorer::suite {
namespace {

namespace fs = std::filesystem;

/// Names of regular files below a folder, with "/", sorted. Folders that are links are not entered. What may
/// be a suite and can't be read as one is an error, not left out: a run without it would be green.
Result<std::vector<std::string>> filesBelow(const fs::path& folder) {
    std::error_code error;
    fs::path last = folder;
    fs::recursive_directory_iterator each(folder, error);
    std::vector<std::string> names;
    std::size_t looked = 0;
    for (; !error && each != fs::recursive_directory_iterator(); each.increment(error)) {
        if (++looked > maxListedFiles)
            return fail(ErrorCode::TooLarge,
                        Sentence("expected at most {0} files and folders", maxListedFiles),
                        inFile(folder.string()));
        std::error_code ignored;
        last = each->path();
        if (each->is_regular_file(ignored))
            names.push_back(last.lexically_relative(folder).generic_string());
        else if (last.string().ends_with(suiteExtension))
            return fail(ErrorCode::Unreadable, "expected a suite file, found something else or a broken link",
                        inFile(last.string()));
    }
    if (error)
        return fail(ErrorCode::Unreadable, systemText(error.value()), inFile(last.string()));
    std::ranges::sort(names);
    return names;
}

/// A golden's name stands in a pattern, where braces mean something.
bool isPlainPattern(std::string_view name) {
    return name.find_first_of("{}") == std::string_view::npos;
}

/// Whether a JSON file is a scene: package.json, for example, is not.
bool isScene(const fs::path& file) {
    const Result<std::string> text = readText(file, maxSceneBytes);
    return text && parseScene(*text).has_value();
}

/// One entry for each X.json that has X.png next to it, or is a scene: without a picture it is a new case, so
/// that a lost picture is noticed.
Suite suiteOfPairs(const fs::path& folder, const std::vector<std::string>& files) {
    constexpr std::string_view scene = ".json";
    Suite suite{.name = folder.filename().string(), .about = {}, .folder = folder, .entries = {}};
    for (const std::string& file : files) {
        if (!file.ends_with(scene) || !isPlainPattern(file))
            continue;
        const std::string name = file.substr(0, file.size() - scene.size());
        const std::string golden = name + ".png";
        if (!std::ranges::binary_search(files, golden) && !isScene(folder / file))
            continue;
        Entry entry{.name = name, .scenes = {SceneFile{file}}, .edits = {}, .axes = {}, .settings = {}};
        entry.settings.golden = GoldenFiles{{{"*", {golden}}}};
        entry.settings.sizes = {sizeOfPng(folder / golden).value_or(PictureSize())};
        suite.entries.push_back(std::move(entry));
    }
    return suite;
}

Result<std::vector<Suite>> suitesBelow(const fs::path& folder) {
    const Result<std::vector<std::string>> files = filesBelow(folder);
    if (!files)
        return fail(files.error());
    std::vector<Suite> suites;
    for (const std::string& file : *files) {
        if (!file.ends_with(suiteExtension))
            continue;
        Result<Suite> suite = readSuite(folder / file);
        if (!suite)
            return fail(suite.error());
        suite->name = file.substr(0, file.size() - suiteExtension.size());
        suites.push_back(*std::move(suite));
    }
    if (!suites.empty())
        return suites;
    suites.push_back(suiteOfPairs(folder, *files));
    if (suites.back().entries.empty())
        return fail(
            ErrorCode::NotFound,
            Sentence("expected a suite, *{0}, or scenes X.json with pictures X.png next to them, found "
                     "neither",
                     suiteExtension),
            inFile(folder.string()));
    if (suites.back().entries.size() > maxEntries)
        return fail(
            ErrorCode::TooLarge,
            Sentence("expected at most {0} scenes, found {1}", maxEntries, suites.back().entries.size()),
            inFile(folder.string()));
    return suites;
}

} // namespace

Result<std::vector<Suite>> suitesAt(const fs::path& fileOrFolder) {
    std::error_code ignored;
    if (fs::is_directory(fileOrFolder, ignored))
        return suitesBelow(fileOrFolder);
    Result<Suite> suite = readSuite(fileOrFolder);
    if (!suite)
        return fail(suite.error());
    return std::vector<Suite>{*std::move(suite)};
}

Result<void> checkInside(std::string_view name) {
    const auto refuse = [&](std::string_view what) {
        return fail(
            ErrorCode::OutOfRange,
            Sentence("expected a name within the suite's folder, found {0}: {1}", inQuotes(name), what));
    };
    if (name.empty())
        return refuse("it is empty");
    if (name.front() == '/')
        return refuse("it is absolute");
    if (name.find('\\') != std::string_view::npos)
        return refuse("folders must be separated by /");
    if (std::ranges::any_of(name, [](char each) { return static_cast<unsigned char>(each) < 0x20; }))
        return refuse("it has control characters");
    for (const fs::path& part : fs::path(name)) {
        if (part == "..")
            return refuse("it leads outside the folder");
    }
    return {};
}

Result<void> checkStays(const fs::path& folder, const fs::path& file) {
    std::error_code error;
    // Of a relative path nothing of which is there weakly_canonical makes no absolute one.
    const auto canonical = [&error](const fs::path& each) {
        const fs::path whole = error ? fs::path() : fs::absolute(each, error);
        return error ? fs::path() : fs::weakly_canonical(whole, error);
    };
    const fs::path root = canonical(folder.empty() ? fs::path(".") : folder);
    const fs::path path = canonical(file);
    if (error)
        return fail(ErrorCode::Unreadable, systemText(error.value()), inFile(file.string()));
    std::error_code ignored; // of a link to nothing, where it leads can't be told
    const bool leadsNowhere = fs::is_symlink(file, ignored) && !fs::exists(path, ignored);
    if (leadsNowhere || std::ranges::mismatch(root, path).in1 != root.end())
        return fail(
            ErrorCode::OutOfRange,
            "expected a file within the suite's folder, found one outside, or a link that leads outside or "
            "is broken",
            inFile(file.string()));
    return {};
}

Result<fs::path> pathInside(const fs::path& folder, std::string_view name) {
    if (const Result<void> inside = checkInside(name); !inside)
        return fail(inside.error());
    if (const Result<void> stays = checkStays(folder, folder / name); !stays)
        return fail(stays.error());
    return folder / name;
}

} // namespace texplorer::suite
