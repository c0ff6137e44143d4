#include "app/ui/widgets/text_field.h"

#include "app/ui/language/translate.h"

namespace texplorer::ui {

bool textField(const char* label, std::string& text, ImGuiInputTextFlags flags, const char* hint) {
    const auto resize = [](ImGuiInputTextCallbackData* data) {
        if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
            auto& resized = *static_cast<std::string*>(data->UserData);
            resized.resize(static_cast<std::size_t>(data->BufTextLen));
            data->Buf = resized.data();
        }
        return 0;
    };
    return ImGui::InputTextWithHint(label, tr(hint), text.data(), text.capacity() + 1,
                                    flags | ImGuiInputTextFlags_CallbackResize, resize, &text);
}

} // namespace texplorer::ui
