#include "tests/random/soak.h"

#include "core/base/file_io.h"
#include "core/base/parallel.h"
#include "core/scene/params/json.h"
#include "tests/random/odd_files.h"
#include "tests/random/random_scene.h"
#include "tests/random/random_skip.h"
#include "tests/random/trial.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace texplorer::random {

namespace {

constexpr int batchSize = 25;
constexpr unsigned long long memoryOfAChild = 8ULL << 30;

void check(const Result<void>& written) {
    if (!written)
        throw std::runtime_error(describe(written.error()));
}

/// The scenes of a batch share a process, and with it what Mesa was asked for.
Precision precisionOf(int number) {
    return number / batchSize % 2 == 0 ? Precision::Exact : Precision::Usual;
}

} // namespace

SoakReport soak(const SoakOptions& options) {
    const std::vector<OddFile> files = oddFiles();
    const std::vector<std::string> names = namesOf(files);
    std::filesystem::create_directories(options.keep);
    for (const OddFile& file : files)
        check(writeFileAtomically(options.keep / file.name, file.bytes));

    Batches batches;
    batches.first = options.first;
    batches.count = options.count;
    batches.size = batchSize;
    batches.jobs = options.jobs == 0 ? processorThreads() : options.jobs;
    batches.memoryLimit = memoryOfAChild;
    const Ended ended = runBatches(batches, [&](int first) -> Work {
        Result<Trial> trial = Trial::open(precisionOf(first), options.keep, options.shaders);
        if (!trial)
            throw std::runtime_error(describe(trial.error()));
        return [&, trial = std::make_shared<Trial>(std::move(*trial))](int number, Journal& journal) {
            trial->run(randomScene(options.seed, number, names), journal);
        };
    });

    SoakReport report;
    report.scenes = options.count;
    std::set<int> failed;
    const auto tell = [&](int number, const std::string& what, int first) {
        failed.insert(number);
        report.failures += "scene " + std::to_string(number) + ": " + what + "\n    " + options.command +
                           " --seed " + std::to_string(options.seed) + " --first " + std::to_string(first) +
                           " --count " + std::to_string(number - first + 1) +
                           (options.shaders.empty() ? "" : " --shaders " + options.shaders.string()) + "\n";
    };
    for (const Death& death : ended.deaths)
        tell(death.number,
             death.cause + " at step \"" + death.step + "\"" +
                 (death.alone ? "" : ", only behind the scenes before it"),
             death.alone ? death.number : death.first);
    for (const Note& note : ended.notes) {
        if (note.kind == "agree")
            ++report.agreed[note.text];
        else if (note.kind == "skip")
            ++report.skipped[note.text];
        else if (note.kind == "blank")
            ++report.blank;
        else
            tell(note.number, note.kind + ": " + note.text, note.number);
    }
    for (const int number : failed)
        check(writeFileAtomically(options.keep / ("scene-" + std::to_string(number) + ".json"),
                                  viewBytes(writeScene(randomScene(options.seed, number, names).scene))));
    return report;
}

std::string SoakReport::text() const {
    std::string all = failures;
    for (const auto& [pair, count] : agreed)
        all += pair + ": " + std::to_string(count) + " scenes agree\n";
    for (const auto& [name, count] : skipped)
        all += "skipped: " + name + ", " + std::to_string(count) + (count == 1 ? " scene: " : " scenes: ") +
               std::string(reasonOf(name.substr(name.find(": ") + 2))) + "\n";
    if (blank > 0)
        all += std::to_string(blank) + " pictures are of one colour\n";
    return all + std::to_string(scenes) +
           " random scenes: " + (failures.empty() ? "all well" : "not all well") + "\n";
}

} // namespace texplorer::random
