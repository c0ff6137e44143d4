#pragma once

#include <functional>
#include <string>
#include <vector>

namespace texplorer {

/// A parameter that is assigned to by PATH=VALUE, such as "textures[].minFilter", and its named values.
struct Assigned {
    std::string path; ///< a number goes between each pair of brackets
    std::vector<std::string> values;
};

/// What a shell offers for an option's value. Called only when completion is written, not when a program
/// starts. Without offers: files, if the name of the value in help says so.
struct Offers {
    std::function<std::vector<std::string>()> words = {};
    bool joined = false; ///< several values, separated by commas
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
