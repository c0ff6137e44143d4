#include "app/ui/widgets/widget_places.h"

#include <imgui_internal.h> // the last item's ID

#include <cassert>

namespace texplorer::ui {
namespace {

WidgetPlaces* listener = nullptr;

} // namespace

WidgetPlaces::WidgetPlaces() {
    assert(!listener);
    listener = this;
}

WidgetPlaces::~WidgetPlaces() {
    listener = nullptr;
}

bool arePlacesWanted() {
    return listener != nullptr;
}

void forgetPlaces() {
    if (listener)
        listener->items.clear();
}

void noteItem(std::string_view name) {
    if (!listener)
        return;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    listener->items[std::string(name)] = {low.x, low.y, high.x, high.y, ImGui::IsItemVisible(), ImGui::GetItemID() != 0};
}

void noteDrawn(std::string_view name, ImVec2 upperLeft, ImVec2 lowerRight) {
    if (listener)
        listener->items[std::string(name)] = {upperLeft.x, upperLeft.y, lowerRight.x, lowerRight.y, true, false};
}

} // namespace texplorer::ui
