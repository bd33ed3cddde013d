#pragma once
/// Whether there can be pictures here.

#include <functional>
#include <string>

namespace holdfast {

/// Empty where pictures can be drawn; else why not and what to do. VTK ends the process where it finds no X server or
/// no OpenGL: a child process tries first. Call it before threads of much work run. Takes about a tenth of a second.
[[nodiscard]] std::string whyNoPictures();

/// Runs `attempt` in a child process, which prints nothing. Whether it returned true: false where it ended the process,
/// or took half a minute. Call it before threads of much work run.
[[nodiscard]] bool succeedsInChild(const std::function<bool()>& attempt);

}  // namespace holdfast
