#pragma once
/// Whether there can be pictures here.

#include <string>

namespace holdfast {

/// Empty where pictures can be drawn; else a sentence that says why not and what to do. VTK ends the process where it
/// finds no X server or no OpenGL, so a child process tries first: call it before threads of much work are running.
/// Takes about a tenth of a second.
[[nodiscard]] std::string whyNoPictures();

}  // namespace holdfast
