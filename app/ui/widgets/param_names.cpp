#include "app/ui/widgets/param_names.h"

namespace texplorer::ui {
namespace {

bool hasGlName(const Settings& settings, const EnumRow& choice) {
    return settings.glNames && !choice.since.empty();
}

} // namespace

std::string_view shownName(const Settings& settings, const ParamRow& row) {
    const std::string_view name = settings.glNames ? glNameOf(row) : std::string_view{};
    return name.empty() ? row.label : name;
}

std::string_view shownName(const Settings& settings, const EnumRow& choice) {
    return hasGlName(settings, choice) ? choice.name : choice.label;
}

std::string_view shownBrief(const Settings& settings, const EnumRow& choice) {
    return hasGlName(settings, choice) ? choice.name : briefOf(choice);
}

} // namespace texplorer::ui
