#pragma once
/// Whether there can be pictures here.

#include <string>

namespace holdfast {

/// Empty where pictures can be drawn; else why not and what to do. VTK ends the process where it finds no X server or
/// no OpenGL: a child process tries first. Call it before threads of much work run. Takes about a tenth of a second.
[[nodiscard]] std::string whyNoPictures();

}  // namespace holdfast
