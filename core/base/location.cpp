#include "texplorer/base/location.h"

#include <ostream>

namespace texplorer {

std::string Location::text() const {
    std::string text;
    for (const Step& each : steps_)
        text += (text.empty() ? "" : ": ") + each.text;
    return text;
}

Location Location::inside() const {
    Location inner;
    for (std::size_t i = 1; i < steps_.size(); ++i)
        inner.steps_.push_back(steps_[i]);
    return inner;
}

Location operator/(Location outer, const Location& inner) {
    for (const Location::Step& each : inner.steps_) {
        if (each.kind == Location::Kind::Pointer && !outer.empty() && outer.steps_.back().kind == each.kind)
            outer.steps_.back().text += each.text;
        else
            outer.steps_.push_back(each);
    }
    return outer;
}

std::ostream& operator<<(std::ostream& out, const Location& location) {
    return out << location.text();
}

Location atLine(std::size_t line, std::size_t column) {
    std::string text = "line " + std::to_string(line);
    if (column > 0)
        text += ", column " + std::to_string(column);
    return Location({Location::Kind::Line, std::move(text), line, column});
}

} // namespace texplorer
