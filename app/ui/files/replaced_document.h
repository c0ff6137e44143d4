#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Replaces the document and resets how it is shown, with the renderers that the user has chosen; the rest of
/// the window stays. Cancels the loads of the old document, and closes the lesson, unless the new document
/// belongs to it.
void replaceDocument(Session& session, Document document);
/// Replaces the document by another state of it, without resetting how it is shown.
void exchangeDocument(Session& session, Document document);

/// Restores the renderers that were shown before a lesson's step chose others, unless the user has chosen
/// some since.
void endLessonPictures(Session& session);

/// Whether the tab stays open with the list of all lessons.
enum class KeepsTab : bool { No, Yes };
void closeLesson(Session& session, KeepsTab tab = KeepsTab::No);

} // namespace texplorer::ui
