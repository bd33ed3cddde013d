#pragma once
/// These functions find out whether pictures can be drawn here.

#include <functional>
#include <string>

namespace holdfast {

/// Returns an empty text where pictures can be drawn. Otherwise it says why not and what to do. VTK ends the process
/// where it finds no X server or no OpenGL, so a child process tries first. Call it before threads of much work run. It
/// takes about a tenth of a second.
///
///     if (const std::string reason = whyNoPictures(); !reason.empty()) {
///       std::cerr << reason << '\n';
///       return 1;
///     }
[[nodiscard]] std::string whyNoPictures();

/// Runs `attempt` in a child process, which prints nothing. Tells whether it returned true. The answer is false where
/// it ended the process or took half a minute. Call it before threads of much work run.
[[nodiscard]] bool succeedsInChild(const std::function<bool()>& attempt);

}  // namespace holdfast
