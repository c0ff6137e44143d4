#include <core/codec/png/png.h>
#include <core/image/patterns/pattern.h>
#include <core/scene/params/json.h>
#include <cstdio>

int main() {
    const auto scene = texplorer::parseScene(R"({"version": 1, "textures": [{"minFilter": "GL_NEAREST"}]})");
    const auto png = texplorer::encodePng(texplorer::drawPattern(texplorer::Pattern::Checker));
    if (!scene || !png)
        return 1;
    std::printf("%s %zu\n", texplorer::rowOf(scene->textures[0].minFilter).name.data(), scene->models.size());
    return 0;
}
