// The parameters of a scene, all of them or those that somebody looks for.

#include "texplorer/scene/params/params.h"

#include "app/screenshot/commands/all_commands.h"
#include "app/screenshot/output/json_text.h"
#include "app/ui/model/param_match.h"
#include "texplorer/scene/params/param_listing.h"

#include <algorithm>
#include <fnmatch.h>

namespace texplorer::screenshot {
namespace {

struct ParamsOptions {
    std::string pattern;
    bool json = false;
};

/// Only stars and question marks: in a path, brackets stand for themselves.
bool fitsGlob(const std::string& pattern, const std::string& path) {
    std::string escaped;
    for (const char c : pattern)
        escaped += (c == '[' || c == ']' || c == '\\' ? "\\" : "") + std::string(1, c);
    return ::fnmatch(escaped.c_str(), path.c_str(), FNM_CASEFOLD) == 0;
}

bool isPartOfPath(std::string_view part, std::string_view path) {
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return !std::ranges::search(path, part, {}, small, small).empty();
}

/// "textures[3].minFilter" asks for "textures[].minFilter".
std::string withoutNumbers(const std::string& pattern) {
    std::string text;
    bool inside = false;
    for (const char c : pattern) {
        const bool isDigit = inside && c >= '0' && c <= '9';
        inside = c == '[' || isDigit;
        if (!isDigit)
            text += c;
    }
    return text;
}

ParamFilter filterFor(const std::string& pattern) {
    if (pattern.empty())
        return {};
    const std::string asked = withoutNumbers(pattern);
    if (asked.find_first_of("*?") != std::string::npos)
        return [asked](const std::string& path, const ParamRow& row) {
            return fitsGlob(asked, path) || fitsGlob(asked, std::string(row.key)) ||
                   fitsGlob(asked, std::string(glNameOf(row)));
        };
    return [asked](const std::string& path, const ParamRow& row) {
        return isPartOfPath(asked, path) || ui::matchOf(row, asked) > 0;
    };
}

/// The rows of a listing as JSON: parameters and the lists that they are in.
std::string rowsJson(const std::string& listing) {
    nlohmann::ordered_json listed = nlohmann::ordered_json::parse(listing);
    nlohmann::ordered_json rows = std::move(listed["parameters"]);
    for (nlohmann::ordered_json& each : listed["lists"]) {
        each["kind"] = "list";
        rows.push_back(std::move(each));
    }
    return documentText(std::move(rows));
}

ExitCode params(const ParamsOptions& options) {
    const ParamFilter filter = filterFor(options.pattern);
    std::string text = options.json ? listParamsJson(filter) : listParams(filter);
    if (text.empty())
        return complain(
            {ErrorCode::NotFound,
             Sentence("no parameter matches \"{0}\": the path, the label, OpenGL's name, the choices and "
                      "the help are searched",
                      options.pattern),
             {}});
    if (options.json)
        text = rowsJson(text);
    const auto written = print(text);
    return written ? success : complain(written.error());
}

} // namespace

void addParams(CommandLine& line) {
    Command& command = line.command("params", "List the parameters of a scene with their initial values, "
                                              "their ranges or choices, and help.");
    auto options = std::make_shared<ParamsOptions>();
    command.option(
        "PATTERN", options->pattern,
        "Only matching parameters: a part of the path, as in minFilter or units[0].combine; words of the "
        "label, OpenGL's name, the choices or the help; or a path with * and ?, as in 'textures[].wrap?'. "
        "Case is ignored.");
    command.flag(
        "--json", options->json,
        "As JSON, for programs: path, kind, group, label, help, glCall, default, range or choices of each; then, with "
        "the kind \"list\", path, minCount and maxCount of the lists that they are in.");
    command.footer("Exit status: 0 done, 1 there is no such parameter, 2 invalid arguments.");
    command.onCall([options] { return params(*options); });
}

} // namespace texplorer::screenshot
