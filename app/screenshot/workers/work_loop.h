#pragma once

#include <functional>
#include <optional>
#include <string>

namespace texplorer::workers {

/// The worker's side: does jobs, one after the other, until the program that it works for closes the socket
/// or is gone.
void workLoop(int socket, const std::function<std::string(const std::string&)>& work);

/// The socket's number where the program was started as a worker (`texshot WORD NUMBER`); nothing: it wasn't.
[[nodiscard]] std::optional<int> workerSocket(int argc, const char* const* argv);

/// The word of that call. It is not for users: no help lists it.
inline constexpr const char* workerWord = "worker-process";

} // namespace texplorer::workers
