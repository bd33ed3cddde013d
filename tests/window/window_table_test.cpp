#include <QCoreApplication>
#include <QScrollBar>
#include <QStyle>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <holdfast/io/mesh_file.h>
#include <holdfast/numbers/same_bits.h>
#include <holdfast/window/table/constraint_table_model.h>
#include <holdfast/window/text/number_text.h>

#include "gestures.h"
#include "support/temporary_folder.h"
#include "window_user.h"

namespace holdfast {
namespace {

using Table = ConstraintTableModel;

/// A point as an OBJ file says it, read by C alone.
std::vector<Vector3> plainVertices(const std::string& obj)
{
  std::vector<Vector3> places;
  std::istringstream lines(obj);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("v ", 0) != 0) continue;
    char* rest = line.data() + 2;
    Vector3 place;
    for (double& number : place) number = std::strtod(rest, &rest);
    places.push_back(place);
  }
  return places;
}

/// The bracket with its measured points, and a vertex held besides whose target was typed with all digits.
class TypedTarget : public test::WindowUser {
 protected:
  void SetUp() override
  {
    WindowUser::SetUp();
    open("bracket.obj", "bracket.constraints.json");
    vertex = freeVertex();
    holdVertex(vertex);
    row = static_cast<Index>(list().constraints.size()) - 1;
    const Vector3 rest = editor().model()->mesh.positions.row(vertex).transpose();
    for (int axis = 0; axis < 3; ++axis) {
      // Some way from rest, with digits that only a double holds.
      std::array<char, 40> digits{};
      std::snprintf(digits.data(), digits.size(), "%.17g", rest[axis] + 0.7 + 0.1 / 3);
      typed[axis] = std::strtod(digits.data(), nullptr);
      typeInto(row, Table::X + axis, digits.data());
    }
    ASSERT_TRUE(settle());
  }

  void expectTyped(const Vector3& place, const char* where)
  {
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_TRUE(hasSameBits(place[axis], typed[axis]))
          << where << ", axis " << axis << ": " << place[axis] << " for " << typed[axis];
  }

  test::TemporaryFolder folder;
  Index vertex = 0;
  Index row = 0;
  Vector3 typed;
};

TEST_F(TypedTarget, IsWhereTheVertexLiesToTheLastBit)
{
  EXPECT_EQ(editor().solveState(), SolveState::Current);
  expectTyped(editor().positions().row(vertex).transpose(), "on screen");
  EXPECT_EQ(shown(row, Table::Status), "met");
}

TEST_F(TypedTarget, IsInTheSavedSessionToTheLastBit)
{
  const auto path = folder.path() / "typed.holdfast";
  chooseFile(path.string());
  key(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(test::waitUntil([this] { return !window.files().isSaving(); }));
  std::ifstream file(path);
  ASSERT_TRUE(file) << "nothing was saved";
  const auto session = nlohmann::json::parse(file);
  const auto& saved = session.at("constraints").at(static_cast<std::size_t>(row));
  EXPECT_EQ(saved.at("at").at("vertex").get<Index>(), vertex);
  const auto numbers = saved.at("target").get<std::vector<double>>();
  ASSERT_EQ(numbers.size(), 3u);
  expectTyped(Vector3(numbers[0], numbers[1], numbers[2]), "in the file");
  EXPECT_FALSE(window.isWindowModified());
}

TEST_F(TypedTarget, IsInTheDeformedMeshToTheLastBit)
{
  const auto path = folder.path() / "deformed.obj";
  const Serialized written = serializeMeshFile(editor().mesh().document, editor().positions(), path);
  const auto plain = plainVertices(written.bytes);
  ASSERT_EQ(static_cast<Index>(plain.size()), editor().model()->mesh.vertexCount());
  expectTyped(plain[static_cast<std::size_t>(vertex)], "as C reads it");
  const Positions again = readMesh(folder.file("deformed.obj", written.bytes)).mesh.positions;
  expectTyped(again.row(vertex).transpose(), "read again");
  EXPECT_EQ(again, editor().positions());
}

TEST_F(TypedTarget, WouldNotSurviveSinglePrecision)
{
  for (const double number : typed) EXPECT_FALSE(hasSameBits(static_cast<float>(number), number)) << number;
}

TEST_F(TypedTarget, IsTakenBackByUndoToTheLastBit)
{
  const Positions after = editor().positions();
  for (int axis = 0; axis < 3; ++axis) key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(settle());
  const Vector3 place = editor().positions().row(vertex).transpose();
  for (int axis = 0; axis < 3; ++axis) EXPECT_FALSE(hasSameBits(place[axis], typed[axis]));
  for (int axis = 0; axis < 3; ++axis) key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(settle());
  EXPECT_EQ(editor().positions(), after);
}

class TableInWindow : public test::WindowUser {};

TEST_F(TableInWindow, TargetsResidualAndStatusAreSeenAt1280WithoutScrolling)
{
  window.resize(1280, 800);
  open("bracket.obj", "bracket.constraints.json");
  QCoreApplication::processEvents();
  const int right = table().viewport()->width();
  EXPECT_EQ(table().horizontalScrollBar()->value(), 0);
  for (const int column : {Table::On, Table::Name, Table::X, Table::Y, Table::Z, Table::Residual, Table::Status}) {
    EXPECT_FALSE(table().isColumnHidden(column)) << column;
    EXPECT_LE(table().columnViewportPosition(column) + table().columnWidth(column), right) << column;
  }
  const auto room = [this](int column) { return table().columnWidth(column) - 8; };
  const QFontMetrics metrics = table().fontMetrics();
  EXPECT_LE(metrics.horizontalAdvance("1e-16"), room(Table::Residual));
  for (Index row = 0; row < static_cast<Index>(list().constraints.size()); ++row) {
    const QString residual = fittingText(0, shown(row, Table::Residual), [&](const QString& text) {
      return metrics.horizontalAdvance(text) <= room(Table::Residual);
    });
    EXPECT_TRUE(residual.startsWith("met")) << residual.toStdString();
    EXPECT_LE(metrics.horizontalAdvance(residual), room(Table::Residual));
    for (const int column : {Table::X, Table::Y, Table::Z}) {
      const auto number = typedNumber(shown(row, column));
      if (!number) continue;
      const QString text = fittingText(*number, shown(row, column), [&](const QString& digits) {
        return metrics.horizontalAdvance(digits) <= room(column);
      });
      EXPECT_NEAR(typedNumber(text).value(), *number, 5e-4 * std::abs(*number)) << text.toStdString();
    }
  }
  // Longer ones are cut in their middle, which names that differ at their ends survive; tool tips have them whole.
  EXPECT_LE(metrics.horizontalAdvance("bolts rear left"), room(Table::Name));
  EXPECT_EQ(table().textElideMode(), Qt::ElideMiddle);
  const QModelIndex longest = table().model()->index(9, Table::Name);
  EXPECT_EQ(longest.data(Qt::ToolTipRole).toString(), "bore shoulder east");
  const int icon = table().style()->pixelMetric(QStyle::PM_SmallIconSize);
  EXPECT_LE(metrics.horizontalAdvance("conflicting") + icon + 4, room(Table::Status));
}

}  // namespace
}  // namespace holdfast
