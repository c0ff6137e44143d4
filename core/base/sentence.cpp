#include "texplorer/base/sentence.h"

#include <charconv>
#include <ostream>

namespace texplorer {

void Sentence::write(fmt::format_args arguments) {
    const std::string_view key = key_;
    english_ = fmt::vformat(key, arguments);
    for (std::size_t i = 0; i + 1 < key.size(); ++i) {
        if (key[i] != '{')
            continue;
        if (key[i + 1] == '{') {
            ++i;
            continue;
        }
        const std::string_view placeholder = key.substr(i, key.find('}', i) + 1 - i);
        std::size_t index = 0;
        std::from_chars(placeholder.data() + 1, placeholder.data() + placeholder.size(), index);
        arguments_[index].english_ = fmt::vformat(placeholder, arguments);
    }
}

std::ostream& operator<<(std::ostream& out, const Sentence& sentence) {
    return out << sentence.english_;
}

} // namespace texplorer
