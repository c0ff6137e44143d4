#include "app/screenshot/shots/sheet_report.h"

#include "app/screenshot/output/json_text.h"

#include <utility>

namespace texplorer::screenshot {
namespace {

using Json = nlohmann::ordered_json;

Json orNull(const std::string& text) {
    return text.empty() ? Json() : Json(text);
}

Json cellJson(const SheetCell& cell) {
    Json values = Json::object();
    for (const auto& [path, value] : cell.values)
        values[path] = value;
    Json document{{"x", cell.rect.x},
                  {"y", cell.rect.y},
                  {"width", cell.rect.width},
                  {"height", cell.rect.height},
                  {"values", std::move(values)}};
    if (cell.error) {
        document["error"] = problemJson(*cell.error);
        return document;
    }
    document["warnings"] = Json::array();
    for (const Error& each : cell.warnings)
        document["warnings"].push_back(problemJson(each));
    if (cell.differing)
        document["differing"] = *cell.differing;
    return document;
}

} // namespace

std::string sheetsJson(const std::vector<WrittenSheet>& sheets) {
    Json all = Json::array();
    for (const WrittenSheet& sheet : sheets) {
        Json cells = Json::array();
        for (const SheetCell& each : sheet.cells)
            cells.push_back(cellJson(each));
        all.push_back({{"file", sheet.file},
                       {"width", sheet.size.x},
                       {"height", sheet.size.y},
                       {"axes", sheet.facts.axes},
                       {"time", sheet.facts.time},
                       {"renderer", sheet.facts.renderer},
                       {"driver", orNull(sheet.facts.driver.name)},
                       {"version", orNull(sheet.facts.driver.version)},
                       {"context", orNull(sheet.facts.context)},
                       {"cells", std::move(cells)}});
    }
    return documentText(std::move(all));
}

} // namespace texplorer::screenshot
