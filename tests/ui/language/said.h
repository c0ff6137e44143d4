#pragma once

#include "texplorer/base/sentence.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::test {

/// Sentences of a program, each as it was said first.
class Said {
public:
    /// Returns whether it has a key that none before it has.
    bool add(const Sentence& sentence);

    [[nodiscard]] const std::vector<Sentence>& sentences() const { return sentences_; }

    /// The texts of a folder or a file of the sources that none of them has, a line each.
    [[nodiscard]] std::string unsaidOf(std::string_view source) const;

    /// What stays English of them in the language of the window, a line each. Names in them do.
    [[nodiscard]] std::string english() const;

private:
    std::vector<Sentence> sentences_;
    std::set<std::string> keys_;
};

} // namespace texplorer::test
