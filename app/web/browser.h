#pragma once

// What the page does for the program (page/panels.mjs, page/texplorer.mjs). Texts are UTF-8 with a length in
// bytes. Calls that take memory have read it when they return.

#define TEXPLORER_BROWSER(name) __attribute__((import_module("browser"), import_name(#name)))

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

/// Lets the user choose files: they are given by filesGiven.
TEXPLORER_BROWSER(chooseFiles) void chooseFiles(bool scene);
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
