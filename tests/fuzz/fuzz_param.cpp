// setParam: an input is lines of "path=text", each set in the scene that those before it left.

#include "tests/fuzz/broken.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/params.h"

using namespace texplorer;

namespace {

void set(Scene& scene, std::string_view path, std::string_view text) {
    const Scene before = scene;
    const Result<void> done = setParam(scene, path, text);
    const Result<std::string> value = getParam(scene, path);
    if (!done) {
        if (done.error().message.empty() || describe(done.error()).english().find('\n') != std::string::npos)
            fuzz::broken("the error isn't one line: " + describe(done.error()).english());
        if (scene != before)
            fuzz::broken("a refused value changed the scene: " + describe(done.error()).english());
        return;
    }
    if (!value)
        fuzz::broken("what was set can't be read: " + describe(value.error()).english());
    Scene repeated = scene;
    if (const Result<void> again = setParam(repeated, path, *value); !again)
        fuzz::broken("what was read can't be set: " + describe(again.error()).english());
    if (repeated != scene)
        fuzz::broken("setting what was read changes the scene: " + *value);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view rest(reinterpret_cast<const char*>(data), size);
    Scene scene = defaultScene();
    while (!rest.empty()) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
        const std::size_t equals = std::min(line.find('='), line.size());
        set(scene, line.substr(0, equals), line.substr(std::min(equals + 1, line.size())));
    }
    // A scene that a file would be refused for is written all the same; its text must then be refused in
    // peace.
    const std::string written = writeScene(scene);
    if (const Result<Scene> again = parseScene(written); again && *again != scene)
        fuzz::broken("writing and reading again gives another scene");
    return 0;
}
