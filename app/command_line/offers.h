#pragma once

#include <functional>
#include <string>
#include <vector>

namespace texplorer {

/// What is assigned to by PATH=VALUE: "textures[].minFilter", with the values that have names.
struct Assigned {
    std::string path; ///< a number belongs between each pair of brackets
    std::vector<std::string> values;
};

/// What a shell offers while an option's value is typed. Asked for when completion is written, and not when a
/// program starts. Without any: files where the value or argument is one, by its name in help.
struct Offers {
    std::function<std::vector<std::string>()> words = {};
    bool joined = false; ///< several of them, with commas between them
    std::function<std::vector<Assigned>()> assigned = {};
};

/// The names of a table's rows, for Offers::words.
template<class Rows>
[[nodiscard]] std::vector<std::string> namesIn(const Rows& rows) {
    std::vector<std::string> names;
    for (const auto& row : rows)
        names.emplace_back(row.name);
    return names;
}

} // namespace texplorer
