#pragma once

namespace texplorer {

/// The calling thread, and those that it starts from here on, give way to the others of the machine: where
/// all processors are busy, they get about a tenth of what another thread gets. For long work beside a window
/// that has to keep up with the display. Where the system has no such thing, nothing happens.
void giveWay();

} // namespace texplorer
