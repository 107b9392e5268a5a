// Parts: choosing, joining, placing and showing them. Functions and modules only: pull it in with use <parts.scad>.
// Millimeters. A solid is [points, faces]: triangles, clockwise seen from outside. A record is [name, family, ...]; the
// family is 0 (A), 1 (B) or -1 (none).

// The records that a choice shows: "one part", "one outline" and "one engraving" the one called part, "family A",
// "family B", "nodes" (what belongs to no family), anything else all of them.
function chosen(records, show, part) =
  show == "one part" || show == "one outline" || show == "one engraving" ? [for (r = records) if (r[0] == part) r] :
  show == "family A" ? of_family(records, 0) :
  show == "family B" ? of_family(records, 1) :
  show == "nodes" ? of_family(records, -1) : records;
function of_family(records, family) = [for (r = records) if (r[1] == family) r];
function is_outline(show) = show == "flat outlines" || show == "one outline";
function is_engraving(show) = show == "engraving" || show == "one engraving";
function is_flat(show) = is_outline(show) || is_engraving(show);

// starts[i] is the sum of the first i counts.
function starts(counts) = [for (i = 0, sum = 0; i < len(counts); sum = sum + counts[i], i = i + 1) sum];

// One solid of many: nothing is merged, so it costs next to nothing. Solids that touch or overlap stay separate shells.
function joined(solids) = let(first = starts([for (s = solids) len(s[0])])) [
  [for (s = solids) each s[0]],
  [for (i = [0 : 1 : len(solids) - 1]) each first[i] == 0 ? solids[i][1] :
    let(step = first[i] * [1, 1, 1]) [for (f = solids[i][1]) f + step]]];
function moved(solid, by) = by == [0, 0, 0] ? solid : [[for (p = solid[0]) p + by], solid[1]];

// The copies of solid records [name, family, points, faces, frames]: a frame is [origin, x axis, y axis, z axis].
function placed(records) = [for (r = records) let(local = [for (p = r[2]) [1, p.x, p.y, p.z]])
  each [for (frame = r[4]) [local * frame, r[3]]]];
// One copy of each, where it was drawn.
function unplaced(records) = [for (r = records) [r[2], r[3]]];

// ---- showing ----
module solid(s) { if (len(s[1]) > 0) polyhedron(points = s[0], faces = s[1], convexity = 10); }

// Lists of solids of family A, of family B and of the rest, each list raised by `raise` above the one before. A preview
// is colored; a render is a single polyhedron, which OpenSCAD exports as it is, in seconds: no union is computed.
module show_solids(families, raise = 0) {
  lifted = [for (i = [0 : 1 : len(families) - 1]) [for (s = families[i]) moved(s, [0, 0, i * raise])]];
  colors = [[.76, .78, .80], [.58, .66, .74], [.92, .70, .28]];
  if ($preview) for (i = [0 : 1 : len(lifted) - 1]) color(colors[i % 3]) solid(joined(lifted[i]));
  else solid(joined([for (solids = lifted) each solids]));
}

// Outlines are [name, polygon, marks, pitch]: a mark is [text, [x, y], angle, size], pitch the room that the outline
// needs in y. They are laid out in rows. The outlines and the lettering (when show asks for the engraving) are drawn
// in the same place. The cutting tool takes kerf away: outlines grow by half of it.
module show_flat(show, outlines, kerf = 0) {
  y = starts([for (o = outlines) o[3]]);
  for (i = [0 : 1 : len(outlines) - 1]) translate([0, -y[i]])
    if (is_engraving(show)) marks(outlines[i][2]);
    else offset(delta = kerf / 2) polygon(outlines[i][1]);
}
module marks(marks) {
  for (m = marks) translate(m[1]) rotate(m[2]) text(m[0], size = m[3], halign = "center", valign = "center");
}
// Outlines as plates of the given thickness, laid out in the same way.
module show_plates(outlines, thickness, kerf = 0) {
  linear_extrude(thickness) show_flat("flat outlines", outlines, kerf);
}
