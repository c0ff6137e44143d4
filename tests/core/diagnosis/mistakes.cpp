#include "tests/core/diagnosis/mistakes.h"

#include <ostream>

namespace texplorer::test {

void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}

std::vector<Mistake> mistakes() {
    std::vector<Mistake> all;
    for (const auto& part :
         {textureMistakes(), levelMistakes(), uploadMistakes(), formatMistakes(), settingMistakes(),
          unitMistakes(), passMistakes(), vertexMistakes(), depthMistakes(), pictureMistakes()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

void castShadows(Subject& s) {
    s.texture().source = SourceKind::LightDepth;
    s.texture().mipmaps = MipPolicy::None;
    s.texture().internalFormat = InternalFormat::DepthComponent24;
    s.texture().minFilter = MinFilter::Linear;
    s.texture().compareMode = CompareMode::RToTexture;
    s.unit().matrix = {{.op = MatrixOp::Translate, .amount = {0, 0, -0.005F}}, {.op = MatrixOp::Projector}};
    int axis = 0;
    for (TexGen* each : {&s.unit().texGenS, &s.unit().texGenT, &s.unit().texGenR, &s.unit().texGenQ}) {
        each->enabled = true;
        each->eyePlane = glm::vec4(0);
        each->eyePlane[axis++] = 1;
    }
}

} // namespace texplorer::test
