# From PLY2, as Gmsh writes it, to OFF with `comment` in its second line. Vertices that no face uses,
# such as the centers of arcs, are left out.
NR == 1 { vertices = $1; next }
NR == 2 { faces = $1; next }
NR <= vertices + 2 { place[NR - 3] = $0; next }
{ face[count++] = $0; for (k = 2; k <= NF; ++k) used[$k] = 1 }
END {
  for (v = 0; v < vertices; ++v) if (v in used) id[v] = kept++
  print "OFF\n# " comment
  print kept, faces, 0
  for (v = 0; v < vertices; ++v) if (v in used) print place[v]
  for (f = 0; f < count; ++f) {
    $0 = face[f]
    for (k = 2; k <= NF; ++k) $k = id[$k]
    print
  }
}
