// Suites, journals and reports of runs: what is refused is refused in one line, and what is read is written
// as it was.

#include "tests/fuzz/broken.h"
#include "texplorer/suite/plan.h"
#include "texplorer/suite/record_json.h"
#include "texplorer/suite/shard.h"

using namespace texplorer;

namespace {

template<class T>
void expectOneLine(const Result<T>& result) {
    if (!result && (result.error().message.empty() ||
                    describe(result.error()).english().find('\n') != std::string::npos))
        fuzz::broken("the error isn't one line: " + describe(result.error()).english());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    Result<suite::Suite> suite = suite::parseSuite(text);
    expectOneLine(suite);
    if (suite)
        expectOneLine(suite::planOf({*std::move(suite)}, {.renderers = {}, .only = {}, .limit = 200}));
    expectOneLine(suite::parseJournal(text));
    expectOneLine(suite::parseDurations(text));
    const Result<suite::RunRecord> run = suite::parseRun(text);
    expectOneLine(run);
    if (!run)
        return 0;
    const Result<suite::RunRecord> again = suite::parseRun(suite::asJson(*run));
    if (!again)
        fuzz::broken("what was written can't be read: " + describe(again.error()).english());
    if (*again != *run)
        fuzz::broken("writing and reading again gives another run");
    return 0;
}
