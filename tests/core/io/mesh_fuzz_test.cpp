#include <functional>

#include <gtest/gtest.h>

#include <holdfast/io/formats/formats.h>
#include <holdfast/words/error.h>

#include "support/mesh_examples.h"
#include "support/random.h"

namespace holdfast {
namespace {

using test::MeshExample;

MeshDocument read(const std::string& extension, const std::string& bytes)
{
  if (extension == ".obj") return readObj(bytes, "fuzzed");
  if (extension == ".off") return readOff(bytes, "fuzzed");
  if (extension == ".ply") return readPly(bytes, "fuzzed");
  if (extension == ".vtp") return readVtp(bytes, "fuzzed");
  return readStl(bytes, "fuzzed");
}

void expectSound(const Mesh& mesh)
{
  ASSERT_GT(mesh.vertexCount(), 0);
  ASSERT_GT(mesh.faces.size(), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    for (const Index corner : mesh.faces[f]) ASSERT_TRUE(corner >= 0 && corner < mesh.vertexCount());
  }
}

/// What could be read can be written with other positions and read again.
void expectWritable(const std::string& extension, const MeshDocument& document)
{
  const Positions positions = (1.5 * document.mesh.positions.array() + 1).matrix();
  try {
    const MeshDocument again = read(extension, document.source->withPositions(document.mesh, positions).bytes);
    ASSERT_EQ(again.mesh.faces, document.mesh.faces);
    ASSERT_EQ(again.mesh.vertexCount(), document.mesh.vertexCount());
  } catch (const OutputError&) {
    ASSERT_EQ(extension, ".stl");  // a coordinate beyond single precision
  }
}

/// True if it was read; every other outcome must be an InputError that names the file and says why.
bool isReadOrRefused(const std::string& extension, const std::string& bytes)
{
  try {
    const MeshDocument document = read(extension, bytes);
    expectSound(document.mesh);
    expectWritable(extension, document);
    return true;
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().file, "fuzzed");
    EXPECT_FALSE(error.reason().empty());
    return false;
  }
}

char randomByte(test::Random& random)
{
  // Bytes that mean something to one of the formats do more harm than others.
  constexpr std::string_view kTelling = "0123456789+-.eE#\\/ \t\r\nvfnan";
  const bool isTelling = random.integer(0, 1) == 0;
  return isTelling ? kTelling[random.integer(0, kTelling.size() - 1)] : static_cast<char>(random.integer(-128, 127));
}

std::string mutated(std::string bytes, test::Random& random)
{
  const long changes = random.integer(1, 4);
  for (long i = 0; i < changes && !bytes.empty(); ++i) {
    const std::size_t at = random.integer(0, static_cast<long>(bytes.size()) - 1);
    switch (random.integer(0, 3)) {
      case 0:
        bytes.insert(at, 1, randomByte(random));
        break;
      case 1:
        bytes.erase(at, random.integer(1, 8));
        break;
      default:
        bytes[at] = randomByte(random);
    }
  }
  return bytes;
}

class MeshFuzz : public testing::TestWithParam<MeshExample> {};

TEST_P(MeshFuzz, TheExampleItselfIsRead)
{
  EXPECT_TRUE(isReadOrRefused(GetParam().extension, GetParam().file()));
}

TEST_P(MeshFuzz, EveryTruncationIsReadOrRefused)
{
  const std::string file = GetParam().file();
  for (std::size_t size = 0; size < file.size(); ++size) {
    SCOPED_TRACE(size);
    isReadOrRefused(GetParam().extension, file.substr(0, size));
    if (HasFatalFailure()) return;
  }
}

TEST_P(MeshFuzz, EveryMutationIsReadOrRefused)
{
  constexpr int kTrials = 1500;
  test::Random random(20240607);
  const std::string file = GetParam().file();
  int refused = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const std::string bytes = mutated(file, random);
    SCOPED_TRACE(testing::PrintToString(bytes));
    refused += isReadOrRefused(GetParam().extension, bytes) ? 0 : 1;
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(refused, kTrials / 20) << "the mutations hardly harm the file";
}

INSTANTIATE_TEST_SUITE_P(Formats, MeshFuzz, testing::ValuesIn(test::meshExamples()), testing::PrintToStringParamName());

}  // namespace
}  // namespace holdfast
