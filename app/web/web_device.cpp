#include "app/web/web_device.h"

#include "app/web/browser.h"
#include "texplorer/glsl/shader_source.h"

#include <algorithm>

namespace texplorer::web {

int WebDevice::maxTextureSize() const {
    return browser::maxTextureSize();
}

int WebDevice::maxPointSize() const {
    return browser::maxPointSize();
}

unsigned WebDevice::makeTexels(std::span<const std::byte> texels, int rows, bool floats) {
    return browser::makeTexels(texels.data(), glsl::texelsPerRow, rows, floats);
}

void WebDevice::dropTexels(unsigned name) {
    browser::dropTexture(name);
}

unsigned WebDevice::makeBuffer(view::BufferKind kind, std::span<const std::byte> content) {
    return browser::makeBuffer(content.data(), lengthOf(content), kind == view::BufferKind::Indices);
}

void WebDevice::dropBuffer(unsigned name) {
    browser::dropBuffer(name);
}

gles::Device::Compiled WebDevice::makeProgram(std::string_view vertex, std::string_view fragment) {
    Compiled compiled{
        browser::makeProgram(vertex.data(), lengthOf(vertex), fragment.data(), lengthOf(fragment)), {}};
    if (compiled.program == 0) {
        compiled.log.resize(4096);
        const int length = browser::programLog(compiled.log.data(), lengthOf(compiled.log));
        compiled.log.resize(static_cast<std::size_t>(std::max(0, length)));
    }
    return compiled;
}

void WebDevice::dropProgram(unsigned name) {
    browser::dropProgram(name);
}

unsigned WebDevice::makeTarget(view::Size size) {
    return browser::makeTarget(size.width, size.height);
}

void WebDevice::dropTarget(unsigned name) {
    browser::dropTarget(name);
}

view::PictureHandle WebDevice::pictureOf(unsigned target) const {
    return static_cast<view::PictureHandle>(target);
}

void WebDevice::read(unsigned target, Image& image) {
    browser::readTarget(target, image.pixels.data(), image.width, image.height);
}

void WebDevice::begin(unsigned target, view::Size size, const glm::vec4& background) {
    browser::beginScene(target, size.width, size.height, background.r, background.g, background.b,
                        background.a);
}

void WebDevice::setFragmentTests(const Pass& pass) {
    browser::setFragmentTests(pass.depthTest, static_cast<unsigned>(pass.depthFunc), pass.blend,
                              static_cast<unsigned>(pass.blendSrc), static_cast<unsigned>(pass.blendDst));
}

void WebDevice::use(unsigned program) {
    browser::useProgram(program);
}

void WebDevice::setUniform(std::string_view name, gles::UniformKind kind, const void* values, int count) {
    browser::setUniform(name.data(), lengthOf(name), static_cast<int>(kind), values, count);
}

void WebDevice::setTexels(int unit, unsigned texels) {
    browser::setTexels(unit, texels);
}

void WebDevice::setAttribute(unsigned location, unsigned buffer, int components, int stride,
                             std::size_t offset) {
    browser::setAttribute(location, buffer, components, stride, static_cast<int>(offset));
}

void WebDevice::setAttribute(unsigned location, const glm::vec4& value) {
    browser::setConstant(location, value.x, value.y, value.z, value.w);
}

void WebDevice::draw(int corners, unsigned indices, std::size_t first, std::size_t count) {
    browser::drawParts(corners, indices, static_cast<int>(first), static_cast<int>(count));
}

void WebDevice::end() {
    browser::endScene();
}

} // namespace texplorer::web
