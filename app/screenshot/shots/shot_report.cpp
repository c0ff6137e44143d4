#include "app/screenshot/shots/shot_report.h"

#include "app/screenshot/gl/picture_texts.h"
#include "app/screenshot/output/json_text.h"

#include <utility>

namespace texplorer::screenshot {

ShotReport::Row ShotReport::rowOf(const std::string& file, const ShotList::Entry& entry,
                                  const ShotList::Case& picture) {
    Row row;
    row.file = file;
    row.scene = entry.file;
    row.size = picture.size;
    row.time = picture.time;
    for (std::size_t i = 0; i < entry.axes.size(); ++i)
        row.axes.emplace_back(entry.axes[i].path, entry.axes[i].values[picture.values[i]]);
    return row;
}

void ShotReport::put(std::size_t index, Row row) {
    const std::scoped_lock lock(mutex_);
    rows_.insert_or_assign(index, std::move(row));
}

void ShotReport::add(std::size_t index, const std::string& file, const ShotList::Entry& entry,
                     const ShotList::Case& picture, const ShotRequest& request, const Shot& shot,
                     const std::vector<Error>& warnings) {
    Row row = rowOf(file, entry, picture);
    PictureFacts facts = factsOf(request, shot);
    row.renderer = std::move(facts.renderer);
    row.driver = std::move(facts.driver);
    row.context = std::move(facts.context);
    row.warnings = warnings;
    put(index, std::move(row));
}

void ShotReport::add(std::size_t index, const std::string& file, const ShotList::Entry& entry,
                     const ShotList::Case& picture, const Error& error) {
    Row row = rowOf(file, entry, picture);
    row.error = error;
    put(index, std::move(row));
}

std::string ShotReport::json() const {
    using Document = nlohmann::ordered_json;
    const std::scoped_lock lock(mutex_);
    Document pictures = Document::array();
    for (const auto& [index, row] : rows_) {
        Document values = Document::object();
        for (const auto& [path, value] : row.axes)
            values[path] = value;
        Document picture{{"file", row.file},
                         {"scene", row.scene.empty() ? Document() : Document(row.scene)},
                         {"values", std::move(values)},
                         {"width", row.size.width},
                         {"height", row.size.height},
                         {"time", row.time}};
        if (!row.error) {
            picture["renderer"] = row.renderer;
            picture["driver"] = row.driver.name.empty() ? Document() : Document(row.driver.name);
            picture["version"] = row.driver.version.empty() ? Document() : Document(row.driver.version);
            picture["context"] = row.context.empty() ? Document() : Document(row.context);
            picture["warnings"] = Document::array();
            for (const Error& each : row.warnings)
                picture["warnings"].push_back(problemJson(each));
        } else {
            picture["error"] = problemJson(*row.error);
        }
        pictures.push_back(std::move(picture));
    }
    return documentText(std::move(pictures));
}

} // namespace texplorer::screenshot
