#include "texplorer/suite/picture_pairs.h"

#include "texplorer/files/file_kind.h"
#include "texplorer/suite/png_size.h"
#include "texplorer/suite/suite_folder.h"

#include <algorithm>
#include <map>

namespace texplorer::suite {
namespace {

namespace fs = std::filesystem;

bool isPng(std::string name) {
    std::ranges::transform(name, name.begin(), [](char each) {
        return each >= 'A' && each <= 'Z' ? static_cast<char>(each + 32) : each;
    });
    return name.ends_with(".png");
}

/// Calls `add` with the name of every PNG below a folder.
template<class Add>
Result<void> forEachPng(const fs::path& folder, const fs::path& leftOut, const Add& add) {
    std::error_code error;
    const fs::path root = fs::canonical(folder, error);
    if (error)
        return fail(error == std::errc::no_such_file_or_directory ? ErrorCode::NotFound
                                                                  : ErrorCode::Unreadable,
                    systemText(error.value()), inFile(folder.string()));
    if (!fs::is_directory(root, error))
        return fail(ErrorCode::Unreadable, "expected a folder, found a file", inFile(folder.string()));
    std::size_t looked = 0;
    fs::recursive_directory_iterator each(root, error);
    for (; !error && each != fs::recursive_directory_iterator(); each.increment(error)) {
        if (++looked > 2 * maxPicturePairs)
            return fail(ErrorCode::TooLarge,
                        Sentence("expected at most {0} files and folders", 2 * maxPicturePairs),
                        inFile(folder.string()));
        std::error_code ignored;
        if (!leftOut.empty() && each->is_directory(ignored) && fs::equivalent(each->path(), leftOut, ignored))
            each.disable_recursion_pending();
        if (!isPng(each->path().filename().string()) || each->is_directory(ignored))
            continue;
        add(each->path().lexically_relative(root).generic_string());
    }
    if (error)
        return fail(ErrorCode::Unreadable, systemText(error.value()), inFile(folder.string()));
    return {};
}

} // namespace

Result<std::vector<PicturePair>> pairPictures(const fs::path& actual, const fs::path& golden,
                                              const fs::path& leftOut) {
    std::map<std::string, PicturePair> pairs;
    const auto addTo = [&pairs](bool PicturePair::*member, const fs::path& folder) {
        return [&pairs, member, &folder](const std::string& name) {
            PicturePair& pair = pairs[name];
            pair.name = name;
            pair.*member = true;
            const Result<fs::path> path = pathInside(folder, name);
            if (const auto size = path ? sizeOfPng(*path) : std::nullopt)
                pair.pixels = std::max(pair.pixels, static_cast<std::uint64_t>(size->width) *
                                                        static_cast<std::uint64_t>(size->height));
        };
    };
    if (const Result<void> read = forEachPng(actual, leftOut, addTo(&PicturePair::hasActual, actual)); !read)
        return fail(read.error());
    if (const Result<void> read = forEachPng(golden, leftOut, addTo(&PicturePair::hasGolden, golden)); !read)
        return fail(read.error());
    if (pairs.empty())
        return fail(ErrorCode::OutOfRange, "expected pictures, *.png, found none in either folder",
                    inFile(actual.string()));
    if (pairs.size() > maxPicturePairs)
        return fail(ErrorCode::TooLarge,
                    Sentence("expected at most {0} pictures, found {1}", maxPicturePairs, pairs.size()),
                    inFile(actual.string()));
    std::vector<PicturePair> list;
    list.reserve(pairs.size());
    for (auto& [name, pair] : pairs)
        list.push_back(std::move(pair));
    return list;
}

} // namespace texplorer::suite
