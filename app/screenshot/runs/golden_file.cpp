#include "app/screenshot/runs/golden_file.h"

#include "texplorer/codec/png/png.h"
#include "texplorer/files/file_io.h"
#include "texplorer/image/convert.h"
#include "texplorer/suite/suite_folder.h"

namespace texplorer::screenshot {
namespace {

namespace fs = std::filesystem;
using suite::State;

Result<void> placeGolden(const fs::path& folder, const std::string& golden, ByteView png) {
    const Result<fs::path> path = suite::pathInside(folder, golden);
    if (!path)
        return fail(path.error());
    std::error_code error;
    if (path->has_parent_path()) // a suite that is named without a folder lies in the current one
        fs::create_directories(path->parent_path(), error);
    if (error)
        return fail(ErrorCode::Unwritable, Sentence("the folder can't be made: {0}", error.message()),
                    inFile(path->parent_path().string()));
    return writeFileAtomically(*path, png);
}

} // namespace

bool isUpdatable(const suite::JudgedCase& judged) {
    const suite::CaseRecord& record = judged.record;
    const bool differs = record.state == State::Failed || record.state == State::New ||
                         record.state == State::Resized || record.state == State::Extra;
    return (differs || judged.goldenIsBroken) && record.golden != "reference";
}

WorkAnswer writeGolden(const fs::path& folder, const std::string& golden, ByteView png,
                       suite::CaseRecord record) {
    const Result<void> placed = placeGolden(folder, golden, png);
    if (!placed)
        return {.record = suite::problemOf(std::move(record), placed.error())};
    const bool isNew = record.state == State::New || record.state == State::Extra;
    record.sentence = isNew ? Sentence("the golden is new: {0}", ProperName{golden})
                            : Sentence("the golden is updated: {0}", ProperName{golden});
    record.state = State::Passed;
    record.golden = golden;
    record.code.clear();
    record.explanation.clear();
    return {.record = std::move(record), .wrote = golden};
}

WorkAnswer writeGolden(const fs::path& folder, const std::string& golden, const Image& actual,
                       suite::CaseRecord record) {
    const Result<Bytes> png = encodePng(withoutAlpha(actual));
    if (png)
        return writeGolden(folder, golden, ByteView(*png), std::move(record));
    return {.record = suite::problemOf(std::move(record), png.error())};
}

} // namespace texplorer::screenshot
