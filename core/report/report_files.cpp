#include "texplorer/report/report_files.h"

#include "texplorer/report/page_assets.h"
#include "texplorer/text/base64.h"
#include "texplorer/text/printable.h"
#include "texplorer/text/utf8.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <set>

namespace texplorer::report {

namespace {

constexpr const char* scriptName = "report.js";
constexpr const char* dataName = "report-data.js";

using Json = nlohmann::ordered_json;

// What a script holds of outside texts is JSON in ASCII without '<': nothing in it ends a string, a line or a
// script.
std::string asScript(const Json& json) {
    std::string text = json.dump(-1, ' ', true);
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
        text.replace(at, 1, "\\u003c"); // it stands in strings alone
    return text;
}

Bytes bytesOf(std::string_view text) {
    const auto* data = reinterpret_cast<const std::byte*>(text.data());
    return {data, data + text.size()};
}

std::string shown(std::string_view text) {
    return printable(text, LineBreaks::Keep);
}

/// A number that JSON has: infinity and NaN are none.
Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json();
}

Result<void> checkFile(std::string_view file) {
    if (staysInside(file))
        return {};
    return fail(
        ErrorCode::OutOfRange,
        Sentence("expected the name of a file within the report's folder, found \"{0}\"", printable(file)));
}

/// One line of the list for `--accept`, and the same name when it is read back.
bool fitsList(std::string_view name) {
    return !name.empty() && isUtf8(name) && printable(name) == name && name.front() != ' ' &&
           name.back() != ' ';
}

Json asJson(const std::vector<Fact>& facts) {
    Json json = Json::array();
    for (const Fact& fact : facts)
        json.push_back({shown(fact.name), shown(fact.value)});
    return json;
}

Json asJson(const Table& table) {
    Json columns = Json::array();
    for (const Column& column : table.columns)
        columns.push_back({{"label", shown(column.label)}, {"number", column.number}});
    Json rows = Json::array();
    for (const std::vector<Cell>& cells : table.rows) {
        Json row = Json::array();
        for (const Cell& cell : cells) {
            Json each{{"text", shown(cell.text)}};
            if (cell.state)
                each["tone"] = rowOf(toneOf(*cell.state)).name;
            if (cell.leadsTo)
                each["case"] = *cell.leadsTo;
            row.push_back(std::move(each));
        }
        rows.push_back(std::move(row));
    }
    Json notes = Json::array();
    for (const std::string& note : table.notes)
        notes.push_back(shown(note));
    return {{"title", shown(table.title)}, {"columns", columns}, {"rows", rows}, {"notes", notes}};
}

Json states() {
    Json json = Json::array();
    for (const EnumRow& row : EnumTable<State>::rows)
        json.push_back({{"name", row.name},
                        {"label", row.label},
                        {"help", row.help},
                        {"tone", rowOf(toneOf(static_cast<State>(row.value))).name}});
    return json;
}

/// A page that is becoming files.
class FolderWriter {
public:
    explicit FolderWriter(const Page& page)
        : page_(page) {}

    Result<std::vector<File>> write();

private:
    Result<Json> asJson(const Case& each, std::size_t index);
    Result<Json> asJson(const Picture& picture, std::string_view role, std::size_t index);
    Result<void> add(File file);

    const Page& page_;
    std::vector<File> files_;
    std::set<std::string> names_;
};

Result<void> FolderWriter::add(File file) {
    if (!names_.insert(file.name).second)
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected a name of its own for each file of the report, found \"{0}\" twice",
                             file.name));
    files_.push_back(std::move(file));
    return {};
}

Result<Json> FolderWriter::asJson(const Picture& picture, std::string_view role, std::size_t index) {
    const std::string file = picture.file.empty() && !picture.png.empty()
                                 ? fmt::format("{:04}-{}.png", index + 1, role)
                                 : picture.file;
    if (const Result<void> inside = checkFile(file); !inside)
        return fail(inside.error());
    if (!picture.png.empty()) {
        if (const Result<void> added = add({file, picture.png}); !added)
            return fail(added.error());
        if (const Result<void> added = add(pixelsOf(file, picture.png)); !added)
            return fail(added.error());
    }
    return Json{{"role", role},
                {"label", shown(picture.label)},
                {"file", file},
                {"pixels", picture.pixels || !picture.png.empty()}};
}

Result<Json> FolderWriter::asJson(const Case& each, std::size_t index) {
    Json pictures = Json::array();
    for (const auto& [role, picture] :
         {std::pair{"expected", &each.expected}, std::pair{"actual", &each.actual},
          std::pair{"difference", &each.difference}}) {
        if (!*picture)
            continue;
        Result<Json> json = asJson(**picture, role, index);
        if (!json)
            return json;
        pictures.push_back(std::move(*json));
    }
    Json links = Json::array();
    for (const Link& link : each.links) {
        if (const Result<void> inside = checkFile(link.file); !inside)
            return fail(inside.error());
        links.push_back({{"label", shown(link.label)}, {"file", link.file}});
    }
    Json json{
        {"name", printable(each.name)}, {"state", rowOf(each.state).name}, {"pictures", std::move(pictures)}};
    // What isn't there takes no room: there may be thousands of cases.
    const auto text = [&json](const char* key, const std::string& value) {
        if (!value.empty())
            json[key] = shown(value);
    };
    text("group", each.group);
    text("message", each.message);
    text("explanation", each.explanation);
    if (each.size[0] > 0 && each.size[1] > 0)
        json["size"] = each.size;
    if (each.worst)
        json["worst"] = *each.worst;
    if (each.distance != 0)
        json["distance"] = number(each.distance);
    if (each.seconds)
        json["seconds"] = number(*each.seconds);
    if (!each.facts.empty())
        json["facts"] = report::asJson(each.facts);
    for (const Command& command : each.commands)
        json["commands"].push_back({{"label", shown(command.label)}, {"line", shown(command.line)}});
    if (!links.empty())
        json["links"] = std::move(links);
    if (!each.legend.empty()) {
        for (const Swatch& swatch : each.legend)
            json["legend"].push_back({{"label", shown(swatch.label)}, {"color", swatch.color}});
    }
    if (each.acceptable && fitsList(each.name) && !page_.acceptCommand.empty())
        json["acceptable"] = true;
    return json;
}

/// FNV-1a: two reports in one folder, one after the other, are told apart by what they say.
std::string keyOf(std::string_view text) {
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char each : text)
        hash = (hash ^ static_cast<unsigned char>(each)) * 0x100000001B3U;
    return fmt::format("{:016x}", hash);
}

Result<std::vector<File>> FolderWriter::write() {
    // Scripts become one: a browser loads no modules from files, and the folder is to be looked at, too.
    std::string script;
    for (const Asset& asset : pageAssets()) {
        if (asset.name.ends_with(".js"))
            script += asset.text;
        else if (const Result<void> added = add({std::string(asset.name), bytesOf(asset.text)}); !added)
            return fail(added.error());
    }
    if (const Result<void> added = add({scriptName, bytesOf(script)}); !added)
        return fail(added.error());
    Json tables = Json::array();
    for (const Table& table : page_.tables)
        tables.push_back(report::asJson(table));
    Json cases = Json::array();
    for (std::size_t i = 0; i < page_.cases.size(); ++i) {
        Result<Json> json = asJson(page_.cases[i], i);
        if (!json)
            return fail(std::move(json.error()));
        cases.push_back(std::move(*json));
    }
    Json introduction = Json::array();
    for (const std::string& paragraph : page_.introduction)
        introduction.push_back(shown(paragraph));
    Json data{{"title", shown(page_.title)},
              {"verdict", shown(page_.verdict)},
              {"tone", rowOf(page_.tone).name},
              {"introduction", std::move(introduction)},
              {"madeBy", shown(page_.madeBy)},
              {"command", shown(page_.command)},
              {"acceptCommand", shown(page_.acceptCommand)},
              {"environment", report::asJson(page_.environment)},
              {"states", states()},
              {"tables", std::move(tables)},
              {"cases", std::move(cases)}};
    data["key"] = keyOf(asScript(data));
    if (const Result<void> added = add({dataName, bytesOf("texplorerReport = " + asScript(data) + ";\n")});
        !added)
        return fail(added.error());
    return std::move(files_);
}

} // namespace

bool staysInside(std::string_view file) {
    if (file.empty() || printable(file) != file || file.find_first_of("\\:") != std::string_view::npos)
        return false;
    for (std::size_t begin = 0; begin <= file.size();) {
        const std::size_t end = std::min(file.find('/', begin), file.size());
        const std::string_view part = file.substr(begin, end - begin);
        if (part.empty() || part == "." || part == "..")
            return false;
        begin = end + 1;
    }
    return true;
}

std::vector<std::string> pageFileNames() {
    std::vector<std::string> names{scriptName, dataName};
    for (const Asset& asset : pageAssets()) {
        if (!asset.name.ends_with(".js"))
            names.emplace_back(asset.name);
    }
    return names;
}

Result<std::vector<File>> filesOf(const Page& page) {
    return FolderWriter(page).write();
}

File pixelsOf(std::string_view file, ByteView png) {
    return {std::string(file) + ".js",
            bytesOf(fmt::format("texplorerPixels({},\"{}\");\n", asScript(printable(file)), base64(png)))};
}

} // namespace texplorer::report
