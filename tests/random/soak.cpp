#include "tests/random/soak.h"

#include "tests/random/random_skip.h"
#include "texplorer/base/parallel.h"

#include <set>

namespace texplorer::random {

SoakReport soak(const Subject& subject, const SoakOptions& options) {
    Batches batches;
    batches.first = options.first;
    batches.count = options.count;
    batches.size = subject.batch;
    batches.jobs = options.jobs == 0 ? processorThreads() : options.jobs;
    batches.limitSeconds = subject.limitSeconds;
    batches.memoryLimit = subject.memoryLimit;
    const Ended ended = runBatches(batches, subject.open);

    SoakReport report;
    report.things = subject.many;
    report.count = options.count;
    std::set<int> failed;
    const auto tell = [&](int number, const std::string& what, int first) {
        failed.insert(number);
        report.failures += subject.one + " " + std::to_string(number) + ": " + what + "\n    " +
                           options.command + " " + subject.arguments + " --first " + std::to_string(first) +
                           " --count " + std::to_string(number - first + 1) + "\n";
    };
    for (const Death& death : ended.deaths)
        tell(death.number,
             death.cause + " at step \"" + death.step + "\"" +
                 (death.alone ? "" : ", only behind the " + subject.one + "s before it"),
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
    if (subject.keep)
        for (const int number : failed)
            subject.keep(number);
    return report;
}

std::string SoakReport::text() const {
    std::string all = failures;
    for (const auto& [pair, number] : agreed)
        all += pair + ": " + std::to_string(number) + " scenes agree\n";
    for (const auto& [name, number] : skipped)
        all += "skipped: " + name + ", " + std::to_string(number) + (number == 1 ? " scene: " : " scenes: ") +
               std::string(reasonOf(name.substr(name.find(": ") + 2))) + "\n";
    if (blank > 0)
        all += std::to_string(blank) + " pictures are of one colour\n";
    return all + std::to_string(count) + " " + things + ": " +
           (failures.empty() ? "all well" : "not all well") + "\n";
}

} // namespace texplorer::random
