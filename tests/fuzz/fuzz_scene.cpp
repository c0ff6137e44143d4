// Scene files: what is accepted is written and read again without a difference.

#include "tests/fuzz/broken.h"
#include "texplorer/scene/params/json.h"

using namespace texplorer;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const Result<Scene> scene = parseScene(text);
    if (!scene) {
        if (scene.error().message.empty() || scene.error().message.english().find('\n') != std::string::npos)
            fuzz::broken("the error isn't one line: " + scene.error().message.english());
        return 0;
    }
    const Result<Scene> again = parseScene(writeScene(*scene));
    if (!again)
        fuzz::broken("what was written can't be read: " + describe(again.error()).english());
    if (*again != *scene)
        fuzz::broken("writing and reading again gives another scene");
    return 0;
}
