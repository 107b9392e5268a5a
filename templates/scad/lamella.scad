// Lamellas: strips of sheet that stand on a net and cross in half-lap slots. Functions only: pull it in with
// use <lamella.scad>. Millimeters and degrees.
//
// A record is [name, family, stations]. A station is a cross-section of the strip:
//   [x, y, z,  tx, ty, tz,  mx, my, mz,  s, partner, slot_angle, slot_low, slot_high,  heading]
// a point of the middle line, the unit direction of travel t, the unit height direction m, the arc length s; at a
// crossing the index of the partner (otherwise -1), the smallest angle between the two while the grid is erected, and
// how far the partner's middle line moves along t meanwhile; the direction of travel in the flat pattern (0 throughout
// when the strip is cut straight). With b = m x t the material is
//   { x + h m + y b : |h| <= height/2, |y| <= thickness/2 }, interpolated between stations.
use <parts.scad>

// The least clearance, for parts must not touch.
hair = 0.01;
function free(clearance) = clearance >= hair ? clearance :
  echo(str("clearance ", clearance, " would let parts touch: ", hair, " is used")) hair;

// A slot leaves room for the partner and its shadow at an angle: thickness (1 + |cos a|) / sin a + 2 clearance.
function slot_width(angle, thickness, clearance) = thickness * (1 + abs(cos(angle))) / sin(angle) + 2 * clearance;
// Where the slot of a crossing station begins and ends along t.
function slot(q, thickness, clearance) = let(half = slot_width(q[11], thickness, clearance) / 2)
  [q[12] - half, q[13] + half];
function is_crossing(q) = q[10] >= 0;
// Stations between nodes only follow the bend of the strip: those that slots reach, when these are made wider, are left
// out. A pass from the start against the slots before a station, and one from the end against those after it.
function past(stations, high) = [for (i = 0, edge = -1e9; i < len(stations);
    edge = is_crossing(stations[i]) ? high[i] : edge, i = i + 1)
  if (is_crossing(stations[i]) || i == 0 || i == len(stations) - 1 || stations[i][9] > edge) stations[i]];
function reversed(list) = [for (i = [len(list) - 1 : -1 : 0]) list[i]];
function clear(stations, thickness, clearance) =
  let(ahead = past(stations, [for (q = stations) is_crossing(q) ? q[9] + slot(q, thickness, clearance)[1] : 0]),
      back = [for (q = reversed(ahead)) [for (i = [0 : 1 : len(q) - 1]) i == 9 ? -q[9] : q[i]]],
      kept = past(back, [for (q = back) is_crossing(q) ? q[9] - slot(q, thickness, clearance)[0] : 0]))
  [for (q = reversed(kept)) [for (i = [0 : 1 : len(q) - 1]) i == 9 ? -q[9] : q[i]]];
// Says which strips have slots that run into each other or past an end; gives the stations.
function checked(name, stations, thickness, clearance) =
  let(at = [for (q = stations) is_crossing(q) ? q[9] * [1, 1] + slot(q, thickness, clearance) : q[9] * [1, 1]],
      bad = [for (i = [1 : 1 : len(at) - 1]) if (at[i][0] <= at[i - 1][1]) round(at[i][0])])
  len(bad) == 0 ? stations :
    echo(str("the slots of ", name, " leave no material at ", bad, " mm from its start")) stations;
// Slots of family A open up, those of family B open down; their floors leave the clearance between the two.
function floor_height(family, clearance) = family == 0 ? -clearance : clearance;

// ---- solids ----
// A section has six points: 2 level + side, the levels at the bottom, the floor of the slots and the top. A crossing
// has two sections, at the edges of its slot.
function section_count(stations) = len(stations) + len([for (q = stations) if (is_crossing(q)) 1]);

function strip_points(stations, section, thickness, clearance) = [for (q = stations) let(
  x = [q[0], q[1], q[2]], t = [q[3], q[4], q[5]], m = [q[6], q[7], q[8]], b = cross(m, t))
  each is_crossing(q) ?
    let(edge = slot(q, thickness, clearance))
      concat(section * [x + edge[0] * t, m, b], section * [x + edge[1] * t, m, b]) :
    section * [x, m, b]];

// Faces from one section to the next, as indices from the first point of the section.
function side_faces(level) = let(a = 2 * level, c = a + 2)
  [[a + 1, a + 7, c + 7], [a + 1, c + 7, c + 1], [a, c + 6, a + 6], [a, c, c + 6]];
function up_faces(level) = let(a = 2 * level) [[a, a + 1, a + 7], [a, a + 7, a + 6]];
function down_faces(level) = let(a = 2 * level) [[a, a + 7, a + 1], [a, a + 6, a + 7]];
// Faces across a section, looking along t and against it.
function front_faces(level) = let(a = 2 * level) [[a, a + 2, a + 3], [a, a + 3, a + 1]];
function back_faces(level) = let(a = 2 * level) [[a, a + 3, a + 2], [a, a + 1, a + 3]];
function shifted(faces, sections) = [for (f = faces) f + 6 * sections * [1, 1, 1]];

// A cell with both levels, and with one level only.
function full_cell() = concat(side_faces(0), side_faces(1), down_faces(0), up_faces(2));
function half_cell(level) = concat(side_faces(level), down_faces(level), up_faces(level + 1));

function strip_faces(stations, family, slots, first) =
  let(open = family == 0 ? 1 : 0, // the level that slots leave out
      last = len(stations) - 1,
      section = starts([for (q = stations) is_crossing(q) ? 2 : 1]),
      from = slots && is_crossing(stations[0]), to = slots && is_crossing(stations[last]),
      plain = full_cell(),
      before = slots ? front_faces(open) : [],
      slotted = slots ? half_cell(1 - open) : plain,
      after = concat(slots ? shifted(back_faces(open), 1) : [], shifted(plain, 1)),
      crossing = concat(before, slotted, after))
  concat(
    [for (level = [0, 1]) if (!from || level != open) for (f = back_faces(level)) f + first * [1, 1, 1]],
    [for (i = [0 : 1 : last]) let(step = (first + 6 * section[i]) * [1, 1, 1])
      for (f = !is_crossing(stations[i]) ? (i < last ? plain : []) :
               i == 0 ? concat(slotted, after) : i == last ? concat(before, slotted) : crossing) f + step],
    let(end = first + 6 * (section_count(stations) - 1))
    [for (level = [0, 1]) if (!to || level != open) for (f = front_faces(level)) f + end * [1, 1, 1]]);

// The solid of records of one family.
function lamella_solid(records, height, thickness, clearance, slots = true) = len(records) == 0 ? [[], []] :
  let(gap = free(clearance), family = records[0][1], floor = floor_height(family, gap),
      section = [for (h = [-height / 2, floor, height / 2]) for (y = [-thickness / 2, thickness / 2]) [1, h, y]],
      strips = [for (r = records) clear(r[2], thickness, gap)],
      first = 6 * starts([for (stations = strips) section_count(stations)]))
  [[for (i = [0 : 1 : len(records) - 1])
      each strip_points(slots ? checked(records[i][0], strips[i], thickness, gap) : strips[i], section, thickness, gap)],
   [for (i = [0 : 1 : len(records) - 1]) each strip_faces(strips[i], family, slots, first[i])]];

// ---- flat outlines ----
// The developed strip is seen from the side that -b points to. Its middle line has steps as long as those of s, in the
// mean of the directions at their ends; the chord from end to end lies along x. A frame is [point, direction].
function direction(angle) = [cos(angle), sin(angle)];
function middle_line(stations) = [for (i = 0, p = [0, 0]; i < len(stations);
    p = i + 1 == len(stations) ? p : p + (stations[i + 1][9] - stations[i][9]) *
      direction((stations[i][14] + stations[i + 1][14]) / 2), i = i + 1) p];
function flat_frames(stations) =
  let(line = middle_line(stations), chord = line[len(line) - 1], turn = atan2(chord.y, chord.x),
      x = direction(-turn), y = direction(90 - turn))
  [for (i = [0 : 1 : len(line) - 1]) [line[i].x * x + line[i].y * y, stations[i][14] - turn]];
// The point at a distance along and across a frame.
function at_frame(frame, along, across) =
  frame[0] + along * direction(frame[1]) + across * direction(frame[1] + 90);

// From the start along the edge without slots, and back along the other one; |h| <= height/2 across the middle line.
function strip_polygon(stations, frames, family, height, thickness, clearance, slots) =
  let(last = len(stations) - 1, floor = floor_height(family, clearance), edge = family == 0 ? height / 2 : -height / 2)
  concat([for (frame = frames) at_frame(frame, 0, -edge)],
    [for (i = [last : -1 : 0]) each slots && is_crossing(stations[i]) ?
      let(at = slot(stations[i], thickness, clearance))
      [for (p = [[at[1], edge], [at[1], floor], [at[0], floor], [at[0], edge]]) at_frame(frames[i], p.x, p.y)] :
      [at_frame(frames[i], 0, edge)]]);

// Lettering [text, [x, y], angle, size]: the partner's name at each crossing, on the level without the slot, reading
// along h; the strip's own name at both ends. Letters are about .8 size wide.
function fitted(text, width, height) = min(width / (.8 * len(text)), height);
function strip_marks(name, stations, frames, names, family, height) =
  let(last = len(stations) - 1,
      at = [for (q = stations) if (is_crossing(q)) q[9]],
      end = stations[last][9], room = len(at) == 0 ? [end, end] : [at[0], end - at[len(at) - 1]],
      gaps = [for (i = [1 : 1 : len(at) - 1]) at[i] - at[i - 1]], gap = len(gaps) == 0 ? end : min(gaps),
      side = family == 0 ? -height / 4 : height / 4)
  concat(
    [for (i = [0 : 1 : last]) if (is_crossing(stations[i])) let(text = names[stations[i][10]])
      [text, at_frame(frames[i], 0, side), frames[i][1] + 90, fitted(text, .4 * height, min(.6 * gap, .15 * height))]],
    [for (k = [0, 1]) let(frame = frames[k * last], along = (k == 0 ? 1 : -1) * room[k] / 2)
      [name, at_frame(frame, along, 0), frame[1], fitted(name, .7 * room[k], .2 * height)]]);

// Outlines [name, polygon, marks, pitch] of records; names are those of all parts, which partners refer to. A bent strip
// is moved so that its box is about the x axis.
function lowered(p, by) = [p.x, p.y - by];
function lamella_outlines(records, names, height, thickness, clearance, slots = true) =
  let(gap = free(clearance))
  [for (r = records)
    let(all = clear(r[2], thickness, gap), stations = slots ? checked(r[0], all, thickness, gap) : all,
        frames = flat_frames(stations),
        polygon = strip_polygon(stations, frames, r[1], height, thickness, gap, slots),
        y = [for (p = polygon) p.y], middle = (min(y) + max(y)) / 2)
    [r[0], [for (p = polygon) lowered(p, middle)],
     [for (m = strip_marks(r[0], stations, frames, names, r[1], height)) [m[0], lowered(m[1], middle), m[2], m[3]]],
     max(y) - min(y) + .2 * height]];
