#pragma once

#include "app/screenshot/gl/gl_module.h"
#include "app/screenshot/shots/shot_list.h"
#include "texplorer/base/result.h"

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::screenshot {

/// What a call's pictures are and what was said of them, as a document for programs. Any thread may add.
class ShotReport {
public:
    /// One that was drawn, into `file`.
    void add(std::size_t index, const std::string& file, const ShotList::Entry& entry,
             const ShotList::Case& picture, const ShotRequest& request, const Shot& shot,
             const std::vector<Error>& warnings);
    /// One that couldn't be.
    void add(std::size_t index, const std::string& file, const ShotList::Entry& entry,
             const ShotList::Case& picture, const Error& error);

    /// All files that there will be are written.
    void finish() { finished_ = true; }
    [[nodiscard]] bool isFinished() const { return finished_; }

    /// The pictures in their order.
    [[nodiscard]] std::string json() const;

private:
    struct Row {
        std::string file;
        std::string scene;
        std::vector<std::pair<std::string, std::string>> axes; ///< paths and values
        view::Size size;
        double time = 0;
        std::string renderer;
        conform::Driver driver;
        std::string context;
        std::vector<Error> warnings;
        std::optional<Error> error; ///< none: it was drawn
    };

    static Row rowOf(const std::string& file, const ShotList::Entry& entry, const ShotList::Case& picture);
    void put(std::size_t index, Row row);

    bool finished_ = false;
    mutable std::mutex mutex_; // guards what follows
    std::map<std::size_t, Row> rows_;
};

} // namespace texplorer::screenshot
