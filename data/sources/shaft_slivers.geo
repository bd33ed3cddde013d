// A stepped shaft on a flange with four bolt holes, meshed as programs for CAD tessellate it: many
// points around, few along, and no vertex inside flat faces. Lengths in millimetres. Written with Gmsh 4.8.4:
//   gmsh -2 -format ply2 -o shaft_slivers.ply2 shaft_slivers.geo
//   awk -v comment="Holdfast example: a shaft with slivers, mm" -f ply2_to_off.awk \
//     shaft_slivers.ply2 > shaft_slivers.off

around[] = {6, 48, 12, 30};  // parts of each quarter of a turn
thickness = 8;  // of the flange
Mesh.Algorithm = 3;  // initial mesh only: flat faces get no vertices of their own
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeMax = 1e6;

// The profile of the shaft, from the flange's upper face to its end, and the parts that each line gets.
radius[] = {10, 10, 9.9, 9.9, 6, 6, 5.9, 0};
height[] = {thickness, 50, 50.1, 52, 52, 98, 98.1, 98.1};
parts[] = {10, 1, 1, 1, 16, 1, 1};
For k In {0:7}
  Point(100 + k) = {radius[k], 0, height[k]};
EndFor
profile[] = {};
For k In {0:6}
  Line(100 + k) = {100 + k, 101 + k};
  Transfinite Curve {100 + k} = parts[k] + 1;
  profile[] += {100 + k};
EndFor
For quarter In {0:3}
  next[] = {};
  For k In {0:6}
    made[] = Extrude { {0, 0, 1}, {0, 0, 0}, -Pi / 2 } { Curve{profile[k]}; Layers{around[quarter]}; };
    next[] += {made[0]};
  EndFor
  profile[] = next[];
EndFor

// The flange: below, its outline and the bolt holes; above, the same curves moved, with the walls between.
below[] = {};
above[] = {};
Macro AddLoop  // of curves[]
  loop = newll;
  Curve Loop(loop) = curves[];
  below[] += {loop};
  moved[] = {};
  For k In {0:3}
    made[] = Extrude {0, 0, thickness} { Curve{curves[k]}; Layers{1}; };
    moved[] += {made[0]};
  EndFor
  loop = newll;
  Curve Loop(loop) = moved[];
  above[] += {loop};
Return

side = 24;
p = newp;
Point(p) = {-side, -side, 0}; Point(p + 1) = {side, -side, 0};
Point(p + 2) = {side, side, 0}; Point(p + 3) = {-side, side, 0};
c = newl;
For k In {0:3}
  Line(c + k) = {p + k, p + (k + 1) % 4};
  Transfinite Curve {c + k} = 5;
EndFor
curves[] = {c : c + 3};
Call AddLoop;

r = 3;
For sx In {-1:1:2}
  For sy In {-1:1:2}
    x = 17 * sx;
    y = 17 * sy;
    p = newp;
    Point(p) = {x, y, 0};
    Point(p + 1) = {x + r, y, 0}; Point(p + 2) = {x, y - r, 0};
    Point(p + 3) = {x - r, y, 0}; Point(p + 4) = {x, y + r, 0};
    c = newl;
    For k In {0:3}
      Circle(c + k) = {p + 1 + k, p, p + 1 + (k + 1) % 4};
      Transfinite Curve {c + k} = 13;
    EndFor
    curves[] = {c : c + 3};
    Call AddLoop;
  EndFor
EndFor
surface = news;
Plane Surface(surface) = below[];
ReverseMesh Surface {surface};

foot[] = Curve In BoundingBox {-10.1, -10.1, thickness - 0.1, 10.1, 10.1, thickness + 0.1};
loop = newll;
Curve Loop(loop) = foot[];
above[] += {loop};
surface = news;
Plane Surface(surface) = above[];
