#include "app/ui/model/lesson_run.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace texplorer::ui {

std::string LessonRun::text(const std::string& english) const {
    return textIn(catalogue.get(), english);
}

std::string LessonRun::stepText(const std::string& english) const {
    return (numbers ? numbers->start : lesson::Numbers("…")).in(text(english));
}

std::string LessonRun::reason() const {
    const auto* predict = std::get_if<lesson::Predict>(&lesson.steps[step].task);
    return predict && numbers && answer == predict->right ? numbers->answered.in(text(predict->reason))
                                                          : std::string();
}

long percentWrong(const lesson::Grade& grade) {
    return grade.passed ? 0 : std::max(1L, std::lround(grade.share * 100));
}

} // namespace texplorer::ui
