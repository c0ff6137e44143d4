#pragma once

namespace texplorer {

/// Lowers the priority of the calling thread and of the threads that it starts afterwards: if all processors
/// are busy, they get about a tenth of the time of other threads. For long work in a program that must keep
/// up with the display. Does nothing where the system has no such priority.
void giveWay();

} // namespace texplorer
