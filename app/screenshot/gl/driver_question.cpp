#include "app/screenshot/gl/driver_question.h"

#include "app/screenshot/output/sent_error.h"
#include "app/screenshot/workers/pool.h"
#include "app/screenshot/workers/signal_text.h"
#include "app/screenshot/workers/work_loop.h"
#include "texplorer/text/printable.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <sys/wait.h>

namespace texplorer::screenshot {
namespace {

using nlohmann::json;

// A question is {"ask": "contexts" or "driver", "of": "egl:0"}, an answer {"contexts": […]}, {"driver": {…}}
// or {"error": {…}}.
constexpr const char* processCommand =
    "drivers";                         // which help knows; with workers::workerWord it is no user's call
constexpr std::size_t maxQuoted = 200; // bytes of what a driver said
constexpr const char* invalidAnswer = N_("the driver's process sent an invalid answer");

json asJson(const DriverReport& report) {
    return {{"renderer", report.renderer},
            {"vendor", report.vendor},
            {"version", report.version},
            {"shadingLanguage", report.shadingLanguage},
            {"isCore", report.isCore},
            {"maxTextureSize", report.maxTextureSize},
            {"maxAnisotropy", report.maxAnisotropy},
            {"s3tc", report.s3tc},
            {"textureBorders", report.textureBorders},
            {"extensions", report.extensions},
            {"lack", sentJson({ErrorCode::Driver, report.lack, {}})}};
}

/// Throws where something else was sent.
DriverReport reportIn(const json& sent) {
    DriverReport report;
    sent.at("renderer").get_to(report.renderer);
    sent.at("vendor").get_to(report.vendor);
    sent.at("version").get_to(report.version);
    sent.at("shadingLanguage").get_to(report.shadingLanguage);
    sent.at("isCore").get_to(report.isCore);
    sent.at("maxTextureSize").get_to(report.maxTextureSize);
    sent.at("maxAnisotropy").get_to(report.maxAnisotropy);
    sent.at("s3tc").get_to(report.s3tc);
    sent.at("textureBorders").get_to(report.textureBorders);
    sent.at("extensions").get_to(report.extensions);
    report.lack = sentError(sent.at("lack")).message;
    return report;
}

std::string questionAbout(const char* what, const view::ContextChoice& choice) {
    return json{{"ask", what}, {"of", choice.text()}}.dump();
}

json answerTo(const json& question) {
    const Result<view::ContextChoice> choice =
        view::ContextChoice::parse(question.at("of").get<std::string>(), "of");
    if (!choice)
        return {{"error", sentJson(choice.error())}};
    if (question.at("ask") == "contexts") {
        const Result<std::vector<view::ContextChoice>> contexts = contextsOf(*choice);
        if (!contexts)
            return {{"error", sentJson(contexts.error())}};
        json names = json::array();
        for (const view::ContextChoice& each : *contexts)
            names.push_back(each.text());
        return {{"contexts", names}};
    }
    const Result<DriverReport> report = reportDriver(*choice);
    return report ? json{{"driver", asJson(*report)}} : json{{"error", sentJson(report.error())}};
}

std::string answer(const std::string& question) {
    // What a driver calls itself may be no UTF-8.
    return answerTo(json::parse(question)).dump(-1, ' ', false, json::error_handler_t::replace);
}

/// The last line that a driver printed.
std::string lastLine(std::string_view words) {
    while (words.ends_with('\n'))
        words.remove_suffix(1);
    words.remove_prefix(words.rfind('\n') + 1); // npos + 1 is 0
    return printable(words.substr(0, maxQuoted));
}

/// What became of a question that got no answer.
Error errorOf(const workers::Outcome& outcome) {
    using End = workers::Outcome::End;
    Sentence text;
    if (outcome.end == End::Hung)
        text = Sentence("the driver hangs: there is no answer after {0:.0f} s", outcome.took.count());
    else if (outcome.end == End::Killed)
        text = N_(
            "the process of the driver was killed, twice (SIGKILL, as the system does when memory runs out)");
    else if (outcome.end == End::Garbled)
        text = invalidAnswer;
    else if (WIFSIGNALED(outcome.status))
        text = Sentence("the driver crashed: {0}", workers::signalText(WTERMSIG(outcome.status)));
    else
        text = Sentence("the driver ended its process with status {0}", WEXITSTATUS(outcome.status));
    if (const std::string said = lastLine(outcome.lastWords); !said.empty())
        text = Sentence("{0}; the last that it printed is \"{1}\"", text, ProperName{said});
    return {ErrorCode::Driver, text, {}};
}

Result<json> answerIn(const workers::Outcome& outcome) {
    if (outcome.end != workers::Outcome::End::Answered)
        return fail(errorOf(outcome));
    json answer = json::parse(outcome.answer, nullptr, false);
    try {
        if (answer.is_object() && answer.contains("error"))
            return fail(sentError(answer["error"]));
    } catch (const json::exception&) {
        return fail(ErrorCode::Driver, invalidAnswer);
    }
    return answer;
}

/// A process for each: two libraries of OpenGL, or two drivers, may not get on with each other.
Result<std::vector<Result<json>>> ask(const std::vector<std::string>& questions, int seconds) {
    workers::PoolSetup setup;
    setup.command.arguments = {"texshot", processCommand};
    setup.processes = static_cast<unsigned>(std::clamp<std::size_t>(questions.size(), 1, 4));
    setup.maxJobs = 1;
    workers::Pool pool(std::move(setup));
    std::vector<Result<json>> answers(questions.size());
    std::size_t next = 0;
    const Result<void> done = pool.run(
        [&]() -> std::optional<workers::Job> {
            if (next == questions.size())
                return std::nullopt;
            const std::size_t number = next++;
            return workers::Job{
                .number = number, .message = questions[number], .limit = std::chrono::seconds(seconds)};
        },
        [&](const workers::Outcome& outcome) { answers[outcome.number] = answerIn(outcome); });
    if (!done)
        return fail(done.error());
    return answers;
}

tl::unexpected<Error> noAnswer() {
    return fail(ErrorCode::Driver, invalidAnswer);
}

Result<DriverReport> reportOf(const Result<json>& answer) {
    if (!answer)
        return fail(answer.error());
    try {
        return reportIn(answer->at("driver"));
    } catch (const json::exception&) {
        return noAnswer();
    }
}

Result<std::vector<view::ContextChoice>> contextsIn(const Result<json>& answer) {
    if (!answer)
        return fail(answer.error());
    std::vector<view::ContextChoice> contexts;
    try {
        for (const json& name : answer->at("contexts")) {
            const Result<view::ContextChoice> context =
                view::ContextChoice::parse(name.get<std::string>(), "contexts");
            if (!context)
                return noAnswer();
            contexts.push_back(*context);
        }
    } catch (const json::exception&) {
        return noAnswer();
    }
    return contexts;
}

} // namespace

Result<std::vector<DriverAnswer>> askDrivers(int seconds) {
    const std::vector<view::ContextChoice> libraries = builtContexts();
    std::vector<std::string> questions;
    questions.reserve(libraries.size());
    for (const view::ContextChoice& library : libraries)
        questions.push_back(questionAbout("contexts", library));
    const Result<std::vector<Result<json>>> lists = ask(questions, seconds);
    if (!lists)
        return fail(lists.error());

    std::vector<DriverAnswer> answers;
    questions.clear();
    for (std::size_t i = 0; i < libraries.size(); ++i) {
        const Result<std::vector<view::ContextChoice>> contexts = contextsIn((*lists)[i]);
        if (!contexts) {
            answers.push_back({libraries[i], fail(contexts.error())});
            continue;
        }
        for (const view::ContextChoice& context : *contexts) {
            answers.push_back({context, DriverReport()});
            questions.push_back(questionAbout("driver", context));
        }
    }
    const Result<std::vector<Result<json>>> reports = ask(questions, seconds);
    if (!reports)
        return fail(reports.error());
    auto report = reports->begin();
    for (DriverAnswer& each : answers) {
        if (each.report)
            each.report = reportOf(*report++);
    }
    return answers;
}

Result<DriverReport> askDriver(const view::ContextChoice& choice, int seconds) {
    const Result<std::vector<Result<json>>> answers = ask({questionAbout("driver", choice)}, seconds);
    return answers ? reportOf(answers->front()) : fail(answers.error());
}

std::optional<int> answerQuestions(int argc, const char* const* argv) {
    if (argc < 2 || std::strcmp(argv[1], processCommand) != 0)
        return std::nullopt;
    const std::optional<int> socket = workers::workerSocket(argc - 1, argv + 1);
    if (!socket)
        return std::nullopt;
    workers::workLoop(*socket, answer);
    return 0;
}

} // namespace texplorer::screenshot
