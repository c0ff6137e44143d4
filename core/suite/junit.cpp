#include "texplorer/suite/junit.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/text/html.h"
#include "texplorer/text/utf8.h"

#include <fmt/core.h>

#include <map>
#include <unordered_map>

namespace texplorer::suite {
namespace {

/// XML 1.0, section 2.2: what a document may have, even as a reference.
bool isXmlCharacter(char32_t each) {
    return each == 0x9 || each == 0xA || each == 0xD || (each >= 0x20 && each <= 0xD7FF) ||
           (each >= 0xE000 && each <= 0xFFFD) || each >= 0x10000;
}

/// A text between tags, or as an attribute: there, line feeds and tabs are references, or they would be
/// spaces.
std::string xml(std::string_view text, bool isAttribute = true) {
    std::string plain;
    while (!text.empty()) {
        const Utf8Character next = firstCharacter(text);
        if (next.bytes > 0 && isXmlCharacter(next.character))
            plain += text.substr(0, next.bytes);
        else
            plain += "\xEF\xBF\xBD"; // U+FFFD
        text.remove_prefix(next.bytes > 0 ? next.bytes : 1);
    }
    std::string escaped;
    for (const char each : escapedHtml(plain)) {
        const bool isBlank = each == '\n' || each == '\t' || each == '\r';
        if (isBlank && (isAttribute || each == '\r'))
            escaped += fmt::format("&#{};", int{each});
        else
            escaped += each;
    }
    return escaped;
}

/// How JUnit calls a state.
enum class Outcome { Success, Failure, Error, Skipped };

Outcome outcomeOf(State state) {
    if (state == State::Skipped)
        return Outcome::Skipped;
    constexpr std::array outcomes{Outcome::Success, Outcome::Failure, Outcome::Error};
    return outcomes[static_cast<std::size_t>(rowOf(state).status)];
}

/// The cases of one suite, and how many of them came to what.
struct Group {
    std::size_t tests = 0;
    std::size_t failures = 0;
    std::size_t errors = 0;
    std::size_t skipped = 0;
    double seconds = 0;
    std::string cases{};

    void add(const Group& other) {
        tests += other.tests;
        failures += other.failures;
        errors += other.errors;
        skipped += other.skipped;
        seconds += other.seconds;
    }
};

std::string element(std::string_view tag, const CaseRecord& record) {
    std::string text = record.sentence;
    if (!record.explanation.empty())
        text += "\n\n" + record.explanation;
    return fmt::format(R"(      <{0} message="{1}" type="{2}">{3}</{0}>
)",
                       tag, xml(record.sentence), rowOf(record.state).name, xml(text, false));
}

void addCase(Group& group, std::string_view suite, std::string_view name, double seconds,
             const std::string& inside) {
    ++group.tests;
    group.seconds += seconds;
    const std::string start = fmt::format(R"(    <testcase name="{}" classname="{}" time="{:.3f}")",
                                          xml(name), xml(suite), seconds);
    group.cases += inside.empty() ? start + "/>\n" : start + ">\n" + inside + "    </testcase>\n";
}

void addRecord(Group& group, std::string_view suite, const CaseRecord& record) {
    switch (outcomeOf(record.state)) {
    case Outcome::Success:
        return addCase(group, suite, record.name, record.seconds, {});
    case Outcome::Failure:
        ++group.failures;
        return addCase(group, suite, record.name, record.seconds, element("failure", record));
    case Outcome::Error:
        ++group.errors;
        return addCase(group, suite, record.name, record.seconds, element("error", record));
    case Outcome::Skipped:
        ++group.skipped;
        return addCase(group, suite, record.name, record.seconds,
                       fmt::format("      <skipped message=\"{}\"/>\n", xml(record.sentence)));
    }
}

void addMissing(Group& group, std::string_view suite, std::string_view name) {
    ++group.errors;
    addCase(group, suite, name, 0,
            "      <error message=\"it was not run\" type=\"not-run\">it was not run</error>\n");
}

/// The suite that a case's name begins with, where a run has several.
std::string_view suiteOf(const RunRecord& run, std::string_view name) {
    if (run.suites.size() == 1)
        return run.suites.front();
    std::string_view longest = "texplorer";
    bool isFound = false;
    for (const std::string& suite : run.suites) {
        const bool begins = name.starts_with(suite) && name.substr(suite.size()).starts_with('/');
        if (begins && (!isFound || suite.size() > longest.size())) {
            longest = suite;
            isFound = true;
        }
    }
    return longest;
}

std::string counts(const Group& group) {
    return fmt::format(R"(tests="{}" failures="{}" errors="{}" skipped="{}" time="{:.3f}")", group.tests,
                       group.failures, group.errors, group.skipped, group.seconds);
}

/// "2026-11-22T02:30:00", as the schema wants it: without a zone.
std::string timestampOf(const RunRecord& run) {
    constexpr std::size_t withoutZone = 19;
    const bool isTime = run.started.size() >= withoutZone && run.started[10] == 'T';
    return isTime ? fmt::format(" timestamp=\"{}\"", xml(run.started.substr(0, withoutZone))) : std::string();
}

} // namespace

std::string asJunit(const RunRecord& run) {
    std::map<std::string_view, Group> groups;
    for (const CaseRecord& each : run.cases) {
        const std::string_view suite = suiteOf(run, each.name);
        addRecord(groups[suite], suite, each);
    }
    const std::vector<std::string> missing = run.missing();
    for (const std::string& name : missing) {
        const std::string_view suite = suiteOf(run, name);
        addMissing(groups[suite], suite, name);
    }
    Group all;
    for (const auto& [suite, group] : groups)
        all.add(group);
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"texplorer\" {}>\n", counts(all));
    for (const auto& [suite, group] : groups) {
        text += fmt::format("  <testsuite name=\"{}\" {}{}>\n", xml(suite), counts(group), timestampOf(run));
        text += fmt::format("    <properties>\n      <property name=\"program\" value=\"{}\"/>\n"
                            "      <property name=\"driver\" value=\"{}\"/>\n    </properties>\n",
                            xml(run.program), xml(run.driver));
        text += group.cases + "  </testsuite>\n";
    }
    return text + "</testsuites>\n";
}

} // namespace texplorer::suite
