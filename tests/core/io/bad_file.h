#pragma once
/// \file
/// Files that a reader must refuse, with the place and the reason that it must give.

#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <holdfast/io/mesh_document.h>
#include <holdfast/words/error.h>

namespace holdfast::test {

/// The vertices of one triangle as lines of text.
inline const std::string kTriangleVertices = "0 0 0\n1 0 0\n0 1 0\n";

struct BadFile {
  std::string name;
  std::string bytes;
  Index line = 0;
  std::string element;  ///< "byte 84", or empty
  std::string reason;   ///< part of the message
};

inline std::ostream& operator<<(std::ostream& stream, const BadFile& file)
{
  return stream << file.name;
}

/// Expects `read` to refuse `file` for the right reason at the right place, and to say what to do after a colon.
inline void expectRefused(const BadFile& file, MeshDocument (*read)(std::string bytes, const std::string& name))
{
  try {
    static_cast<void>(read(file.bytes, "bad"));
    ADD_FAILURE() << "was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().file, "bad");
    EXPECT_EQ(error.location().line, file.line) << error.what();
    EXPECT_EQ(error.location().element, file.element) << error.what();
    EXPECT_THAT(error.reason(), testing::HasSubstr(file.reason));
    EXPECT_THAT(error.reason(), testing::ContainsRegex("[:;] .+"));
  }
}

}  // namespace holdfast::test
