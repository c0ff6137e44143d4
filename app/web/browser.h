#pragma once

// What the page does for the program (page/panels.mjs, page/scene.mjs, page/texplorer.mjs). Texts are UTF-8
// with a length in bytes. Calls that take memory have read it when they return.

// A function of the page, and one that the page calls.
#define TEXPLORER_BROWSER(name) __attribute__((import_module("browser"), import_name(#name)))
#define TEXPLORER_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace texplorer::web::browser {

extern "C" {
/// A texture of Rgba8 pixels, `width * height * 4` bytes, edges clamped: filtered linearly when it is drawn
/// smaller, and also when it is drawn larger unless `enlarged`. 0: it is too large, or the context is lost.
TEXPLORER_BROWSER(makeTexture) unsigned makeTexture(const void* pixels, int width, int height, bool enlarged);
TEXPLORER_BROWSER(dropTexture) void dropTexture(unsigned texture);

/// Clears the canvas, which gets this size in pixels; what follows is in units of `density` pixels.
TEXPLORER_BROWSER(beginPanels)
void beginPanels(int width, int height, float density, float red, float green, float blue);
/// The vertices (ImDrawVert) and the indices (16 bits) of the triangles that follow.
TEXPLORER_BROWSER(panelList)
void panelList(const void* vertices, int vertexCount, const void* indices, int indexCount);
/// Triangles within a rectangle, in pixels from the top left.
TEXPLORER_BROWSER(panelTriangles)
void panelTriangles(unsigned texture, int firstIndex, int count, int left, int top, int right, int bottom);
TEXPLORER_BROWSER(setBlending) void setBlending(bool on);
/// The canvas's pixels, Rgba8, bottom row first.
TEXPLORER_BROWSER(readPanels) void readPanels(void* pixels, int width, int height);

// What WebDevice needs (app/gles/device.h), by page/scene.mjs.
TEXPLORER_BROWSER(maxTextureSize) int maxTextureSize();
TEXPLORER_BROWSER(maxPointSize) int maxPointSize();
TEXPLORER_BROWSER(makeTexels) unsigned makeTexels(const void* texels, int width, int height, bool floats);
TEXPLORER_BROWSER(makeBuffer) unsigned makeBuffer(const void* bytes, int count, bool isIndices);
TEXPLORER_BROWSER(dropBuffer) void dropBuffer(unsigned buffer);
/// 0: the sources are not accepted, and `programLog` writes why, up to `room` bytes. Returns its length.
TEXPLORER_BROWSER(makeProgram)
unsigned makeProgram(const char* vertex, int vertexLength, const char* fragment, int fragmentLength);
TEXPLORER_BROWSER(programLog) int programLog(char* text, int room);
TEXPLORER_BROWSER(dropProgram) void dropProgram(unsigned program);
/// A texture that can be drawn into and shown by `panelTriangles`.
TEXPLORER_BROWSER(makeTarget) unsigned makeTarget(int width, int height);
TEXPLORER_BROWSER(dropTarget) void dropTarget(unsigned target);
TEXPLORER_BROWSER(readTarget) void readTarget(unsigned target, void* pixels, int width, int height);
TEXPLORER_BROWSER(beginScene)
void beginScene(unsigned target, int width, int height, float red, float green, float blue, float alpha);
TEXPLORER_BROWSER(setFragmentTests)
void setFragmentTests(bool depthTest, unsigned depthFunc, bool blend, unsigned source, unsigned destination);
TEXPLORER_BROWSER(useProgram) void useProgram(unsigned program);
/// `kind` is a gles::UniformKind.
TEXPLORER_BROWSER(setUniform)
void setUniform(const char* name, int nameLength, int kind, const void* values, int count);
TEXPLORER_BROWSER(setTexels) void setTexels(int unit, unsigned texels);
TEXPLORER_BROWSER(setAttribute)
void setAttribute(unsigned location, unsigned buffer, int components, int stride, int offset);
TEXPLORER_BROWSER(setConstant)
void setConstant(unsigned location, float x, float y, float z, float w);
TEXPLORER_BROWSER(drawParts) void drawParts(int corners, unsigned indices, int first, int count);
TEXPLORER_BROWSER(endScene) void endScene();

// Web Workers that draw pictures or make files (page/workers.mjs).
/// 0: the browser gives none.
TEXPLORER_BROWSER(makeWorker) unsigned makeWorker();
TEXPLORER_BROWSER(dropWorker) void dropWorker(unsigned worker);
/// A file of the scenes that follow; a count of -1 removes it.
TEXPLORER_BROWSER(sendFile)
void sendFile(unsigned worker, const char* name, int nameLength, const void* bytes, int byteCount);
/// takePicture (exports.cpp) gets the answer. `anisotropy` and `rho`: as in a DrawRequest.
TEXPLORER_BROWSER(drawInWorker)
void drawInWorker(unsigned worker, const char* scene, int length, double time, int width, int height,
                  unsigned anisotropy, unsigned rho);
/// Called in a worker: Rgba8, bottom row first, and sentSentences of problems.
TEXPLORER_BROWSER(pictureDrawn)
void pictureDrawn(const void* pixels, int width, int height, double milliseconds, const char* problems,
                  int length);

/// A worker with a copy of the whole program, which makes that file (a ui::FileOrder). takeFile and
/// fileProgress (exports.cpp) get the answers. 0: the browser gives none.
TEXPLORER_BROWSER(makeFileInCopy) unsigned makeFileInCopy(const void* order);
/// Called in a copy: from 0 to 1.
TEXPLORER_BROWSER(fileProgressed) void fileProgressed(float share);
/// Called in a copy: the file and a remark, or why it is not made, as sentSentences.
TEXPLORER_BROWSER(fileMade)
void fileMade(bool made, const void* bytes, int byteCount, const char* sentences, int length);

/// Lets the user choose files: they are given by filesGiven.
TEXPLORER_BROWSER(chooseFiles) void chooseFiles(bool scene);
/// Fetches the font of Chinese letters into its folder, and draws a frame then.
TEXPLORER_BROWSER(fetchFont) void fetchFont();
/// Gives a file to the user, as a download.
TEXPLORER_BROWSER(saveFile)
void saveFile(const char* name, int nameLength, const void* bytes, int byteCount);
TEXPLORER_BROWSER(writeClipboard) void writeClipboard(const char* text, int length);

/// A stage::Spoken as JSON, when it has changed.
TEXPLORER_BROWSER(speak) void speak(const char* json, int length);
/// Sends a message (app/stage/messages.h) to the page around this one.
TEXPLORER_BROWSER(postMessage) void postMessage(const char* json, int length);
TEXPLORER_BROWSER(setTitle) void setTitle(const char* text, int length);
/// An ImGuiMouseCursor.
TEXPLORER_BROWSER(setCursor) void setCursor(int shape);
TEXPLORER_BROWSER(setFullScreen) void setFullScreen(bool fills);
/// Whether a text field has the keyboard.
TEXPLORER_BROWSER(setTyping) void setTyping(bool typing);
}

} // namespace texplorer::web::browser

namespace texplorer::web {

/// A length as the page takes it.
[[nodiscard]] int lengthOf(const auto& range) {
    return static_cast<int>(range.size());
}

} // namespace texplorer::web
