/* CGAL behind a C face: search trees, self-intersections and overlaps, called through solid.h and
 * solid_exact.h. One kernel: exact predicates; constructed points are rounded to double. Needs
 * -frounding-math. Nothing here allocates from an arena or lets an exception out. */
#include "core/solid/solid.h"

#include "core/solid/prism.h"
#include "core/solid/solid_exact.h"
#include "core/solid/topology.h"

/* GCC 12 suspects the empty triangles and rays that CGAL's kernel converters return, depending on
 * the options. */
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

/* GMP ends the whole program when memory runs out. What predicates take of it (Mpzf) asks for none;
 * the numbers of constructions are Boost's, which throw: fractions in lowest terms, for those that
 * never cancel grow with every step, and some overlaps took minutes. */
#include <CGAL/boost_mp.h>
#include <CGAL/Number_types/internal/Exact_type_selector.h>

namespace CGAL::internal {
template <> struct Exact_field_selector<double> {
  using Type = boost::multiprecision::cpp_rational;
};
} // namespace CGAL::internal

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <memory>
#include <new>
#include <stdexcept>
#include <vector>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Segment = Kernel::Segment_3;
using Mesh = CGAL::Surface_mesh<Point>;
using CGAL::Bbox_3;

/* CGAL reports a broken precondition through a handler that prints; here the exception says enough.
 */
const CGAL::Failure_function previous_handler =
    CGAL::set_error_handler([](const char *, const char *, const char *, int, const char *) {});

/* Runs what may throw. */
template <class Function> lam_status guarded(Function function) {
  try {
    return function();
  } catch (const std::bad_alloc &) {
    return LAM_NO_MEMORY;
  } catch (...) {
    return LAM_FAILED;
  }
}

Point point(lam_vec3 p) { return Point(p.x, p.y, p.z); }

/* Thrown out of CGAL's loops when there is more to look at than anybody would wait for. */
struct Too_many {};

/* ---- triangles in a search tree ---- */

/* Points and triangles; the tree refers to them, so a Soup stays where it is made. */
struct Soup {
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;

  Triangle triangle(int i) const {
    const auto &t = triangles[i];
    return Triangle(points[t[0]], points[t[1]], points[t[2]]);
  }
  Bbox_3 box(int i) const {
    const auto &t = triangles[i];
    return points[t[0]].bbox() + points[t[1]].bbox() + points[t[2]].bbox();
  }
  bool flat(int i) const {
    const auto &t = triangles[i];
    return CGAL::collinear(points[t[0]], points[t[1]], points[t[2]]);
  }
};

/* A triangle of a Soup, made when it is asked for. */
struct Primitive {
  using Id = int;
  using Point = Kernel::Point_3;
  using Datum = Triangle;
  const Soup *soup = nullptr;
  int index = -1;
  Primitive() = default;
  Primitive(const Soup *soup_, int index_) : soup(soup_), index(index_) {}
  explicit Primitive(std::vector<Primitive>::const_iterator other) : Primitive(*other) {}
  Id id() const { return index; }
  Datum datum() const { return soup->triangle(index); }
  Point reference_point() const { return soup->points[soup->triangles[index][0]]; }
};

using Traits = CGAL::AABB_traits<Kernel, Primitive>;
using Tree = CGAL::AABB_tree<Traits>;
using Node = CGAL::AABB_node<Traits>;

/* Triangles without area are left out: their points belong to their neighbors too. */
void build(Tree &tree, const Soup &soup) {
  std::vector<Primitive> primitives;
  primitives.reserve(soup.triangles.size());
  for (int i = 0; i < (int)soup.triangles.size(); i++)
    if (!soup.flat(i)) primitives.emplace_back(&soup, i);
  tree.insert(primitives.cbegin(), primitives.cend());
  tree.build();
}

/* ---- do the surfaces of two trees meet? ---- */

/* A walk down a tree, guided by boxes; triangles that are reached are tested exactly. */
struct Meets_triangle {
  Triangle triangle;
  Bbox_3 box;
  bool found = false;
  bool go_further() const { return !found; }
  void intersection(int, const Primitive &p) {
    found = CGAL::do_overlap(box, p.soup->box(p.index)) && CGAL::do_intersect(triangle, p.datum());
  }
  bool do_intersect(int, const Node &node) const { return CGAL::do_overlap(box, node.bbox()); }
};

/* A walk that asks whether any triangle's box overlaps a box. */
struct Meets_box {
  Bbox_3 box;
  bool found = false;
  bool go_further() const { return !found; }
  void intersection(int, const Primitive &p) {
    found = CGAL::do_overlap(box, p.soup->box(p.index));
  }
  bool do_intersect(int, const Node &node) const { return CGAL::do_overlap(box, node.bbox()); }
};

/* A walk down one tree, asking the other. */
struct Meets_tree {
  const Tree &other;
  bool found = false;
  bool go_further() const { return !found; }
  void intersection(int, const Primitive &p) {
    Meets_triangle walk{p.datum(), p.soup->box(p.index)};
    other.traversal(0, walk);
    found = walk.found;
  }
  bool do_intersect(int, const Node &node) const {
    Meets_box walk{node.bbox()};
    other.traversal(0, walk);
    return walk.found;
  }
};

/* Whether two surfaces have a point in common; exact. */
bool surfaces_meet(const Tree &a, const Tree &b) {
  Meets_tree walk{b};
  a.traversal(0, walk);
  return walk.found;
}

/* ---- self-intersections ---- */

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

/* The boxes of all triangles that have an area, with their indices. */
std::vector<Box> boxes_of(const Soup &soup) {
  std::vector<Box> boxes;
  boxes.reserve(soup.triangles.size());
  for (int i = 0; i < (int)soup.triangles.size(); i++)
    if (!soup.flat(i)) boxes.emplace_back(soup.box(i), i);
  return boxes;
}

/* Two triangles meet outside what they share. With a common edge they do when they are coplanar and
 * lie on the same side of it; with a common vertex, when the edge opposite to it of one meets the
 * other: whoever walks away from the vertex inside both leaves one of them through that edge. */
bool meet_improperly(const Soup &soup, int i, int j) {
  std::array<int, 3> s = soup.triangles[i], t = soup.triangles[j];
  /* What they share is moved to the front of both. */
  int common = 0;
  for (int k = 0; k < 3; k++)
    for (int l = common; l < 3; l++)
      if (s[k] == t[l]) {
        std::swap(s[k], s[common]);
        std::swap(t[l], t[common]);
        common++;
        break;
      }

  const auto &p = soup.points;
  switch (common) {
  case 0:
    return CGAL::do_intersect(soup.triangle(i), soup.triangle(j));
  case 1:
    return CGAL::do_intersect(soup.triangle(i), Segment(p[t[1]], p[t[2]])) ||
           CGAL::do_intersect(soup.triangle(j), Segment(p[s[1]], p[s[2]]));
  case 2:
    return CGAL::coplanar(p[s[0]], p[s[1]], p[s[2]], p[t[2]]) &&
           CGAL::coplanar_orientation(p[s[0]], p[s[1]], p[s[2]], p[t[2]]) == CGAL::POSITIVE;
  default:
    return true;
  }
}

/* ---- closed surfaces ---- */

/* A component of a solid, turned so that its outside is outside; sign is -1 for a cavity. Its
 * vertices are split into fans, which makes it a manifold. A solid is the sum of its components
 * with their signs. */
struct Component {
  Soup soup;
  Tree tree;
  Bbox_3 box;
  double volume = 0;
  int sign = 1;
};

/* The signed volume of the tetrahedron o a b c. */
double corner_volume(const Point &o, const Point &a, const Point &b, const Point &c) {
  return (a - o) * CGAL::cross_product(b - o, c - o) / 6;
}

/* Bounds, volume, orientation and search tree of a component whose triangles are complete. */
void finish(Component &component) {
  Soup &soup = component.soup;
  for (const Point &p : soup.points) component.box += p.bbox();
  for (const auto &t : soup.triangles)
    component.volume +=
        corner_volume(soup.points[0], soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);

  if (component.volume < 0) {
    component.sign = -1;
    component.volume = -component.volume;
    for (auto &t : soup.triangles) std::swap(t[1], t[2]);
  }

  component.tree.do_not_accelerate_distance_queries();
  build(component.tree, soup);
}

/* The halfedge mesh that corefinement works on. */
Mesh surface_of(const Soup &soup) {
  Mesh mesh;
  mesh.reserve(soup.points.size(), soup.triangles.size() * 3 / 2, soup.triangles.size());
  for (const Point &p : soup.points) mesh.add_vertex(p);
  for (const auto &t : soup.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  return mesh;
}

/* The volume enclosed by a closed mesh. */
double volume_of(const Mesh &mesh) {
  double sum = 0;
  if (mesh.number_of_faces() == 0) return 0;
  const Point origin = mesh.point(*mesh.vertices().begin());
  for (auto f : mesh.faces()) {
    auto h = mesh.halfedge(f);
    sum += corner_volume(origin, mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                         mesh.point(mesh.target(mesh.next(h))));
  }
  return sum;
}

/* ---- overlaps ---- */

/* A walk that counts the triangles which a segment passes through; unsure when it touches an edge.
 */
struct Crossings {
  Point from, to;
  Bbox_3 box;
  int count = 0;
  bool unsure = false;
  bool go_further() const { return !unsure; }
  void intersection(int, const Primitive &p) {
    const Triangle t = p.datum();
    if (!CGAL::do_overlap(box, p.soup->box(p.index)) || !CGAL::do_intersect(t, Segment(from, to)))
      return;
    for (int k = 0; k < 3; k++) unsure = unsure || CGAL::coplanar(from, to, t[k], t[(k + 1) % 3]);
    count++;
  }
  bool do_intersect(int, const Node &node) const { return CGAL::do_overlap(box, node.bbox()); }
};

/* A steep segment from p to a place above the surface passes through it an odd number of times when
 * p is inside. p is not on the surface. When a segment touches an edge, one that leans a little
 * more is tried. */
bool is_inside(const Component &component, const Point &p) {
  const Bbox_3 &b = component.box;
  if (!CGAL::do_overlap(b, p.bbox())) return false;
  const double height = b.zmax() - b.zmin();
  for (int attempt = 1; attempt < 100; attempt++) {
    const double lean = 1e-3 * attempt * height;
    const Point top(p.x() + lean, p.y() + 0.618 * lean, b.zmax() + height);
    Crossings walk{p, top, p.bbox() + top.bbox()};
    component.tree.traversal(0, walk);
    if (!walk.unsure) return walk.count % 2 == 1;
  }
  throw std::runtime_error("no segment avoids all edges");
}

/* The common volume by integration over prisms (prism.h). */
double prism_volume(const Soup &a, const Soup &b) {
  const Soup *const soups[2] = {&a, &b};
  std::vector<lam_vec3> vertices[2];
  std::vector<std::array<int, 3>> triangles[2];
  lam_trimesh meshes[2];
  for (int k = 0; k < 2; k++) {
    for (const Point &p : soups[k]->points) vertices[k].push_back(lam_v3(p.x(), p.y(), p.z()));
    triangles[k] = soups[k]->triangles;
    meshes[k] = {(int)vertices[k].size(), vertices[k].data(), (int)triangles[k].size(),
                 reinterpret_cast<int(*)[3]>(triangles[k].data())};
  }

  double volume = 0;
  if (lam_prism_volume(&meshes[0], &meshes[1], &volume) != LAM_OK) throw std::bad_alloc();
  return volume;
}

/* The exact boolean intersection, rounded at the end; negative where corefinement refuses: where
 * the result would not be a manifold and where a surface cuts itself. */
double corefined_volume(const Component &a, const Component &b) {
  try {
    Mesh first = surface_of(a.soup), second = surface_of(b.soup), common;
    if (PMP::corefine_and_compute_intersection(first, second, common,
                                               CGAL::parameters::throw_on_self_intersection(true)))
      return volume_of(common);
  } catch (const std::bad_alloc &) {
    throw;
  } catch (const std::exception &) {
  }
  return -1;
}

/* The sum over prisms answers where corefinement does not, and for a large mesh against a small
 * one, of which corefinement would copy the large one for every pair. */
double meeting_volume(const Component &a, const Component &b) {
  const double most = std::min(a.volume, b.volume);
  const auto counts = std::minmax({a.soup.triangles.size(), b.soup.triangles.size()});
  if (counts.second < 5000 || counts.second < 16 * counts.first) {
    double volume = corefined_volume(a, b);
    if (volume >= 0 && volume <= most * (1 + 1e-9)) return volume;
  }
  return std::min(std::max(prism_volume(a.soup, b.soup), 0.0), most);
}

/* The common volume of two components: of one of them when it lies inside the other, whose
 * surfaces then do not meet. */
double common_volume(const Component &a, const Component &b) {
  if (!CGAL::do_overlap(a.box, b.box)) return 0;
  if (surfaces_meet(a.tree, b.tree)) return meeting_volume(a, b);
  if (is_inside(a, b.soup.points[0])) return b.volume;
  if (is_inside(b, a.soup.points[0])) return a.volume;
  return 0;
}

/* A solid of the set. */
struct Solid {
  std::vector<std::unique_ptr<Component>> components;
  Bbox_3 box;
};

/* p under frame; NULL: p itself. */
Point placed(lam_vec3 p, const lam_pose *frame) {
  if (!frame) return point(p);
  lam_vec3 q = lam_along(frame->origin, p.x, frame->axis[0]);
  return point(lam_along(lam_along(q, p.y, frame->axis[1]), p.z, frame->axis[2]));
}

/* The components of a closed, oriented mesh; empty when it is not, or encloses no volume. */
Solid solid_of(const lam_trimesh &mesh, const lam_pose *frame) {
  std::vector<int> component(mesh.triangle_count);
  std::vector<std::array<int, 3>> fan(mesh.triangle_count);
  lam_topology topology;
  lam_status status = lam_topology_make(&mesh, component.data(),
                                        reinterpret_cast<int(*)[3]>(fan.data()), &topology);
  if (status == LAM_NO_MEMORY) throw std::bad_alloc();

  Solid solid;
  if (status != LAM_OK || topology.boundary_edges || !topology.oriented || !mesh.triangle_count)
    return solid;

  for (int c = 0; c < topology.components; c++)
    solid.components.push_back(std::make_unique<Component>());
  std::vector<int> number(topology.fans, -1);

  bool mirrors = frame && lam_dot(frame->axis[0], lam_cross(frame->axis[1], frame->axis[2])) < 0;
  for (int i = 0; i < mesh.triangle_count; i++) {
    Soup &soup = solid.components[component[i]]->soup;
    std::array<int, 3> t;
    for (int k = 0; k < 3; k++) {
      int &n = number[fan[i][k]];
      if (n < 0) {
        n = (int)soup.points.size();
        soup.points.push_back(placed(mesh.vertices[mesh.triangles[i][k]], frame));
      }
      t[k] = n;
    }
    if (mirrors) std::swap(t[1], t[2]);
    soup.triangles.push_back(t);
  }

  double volume = 0;
  for (auto &one : solid.components) {
    finish(*one);
    solid.box += one->box;
    volume += one->sign * one->volume;
  }
  if (!(volume > 0)) solid.components.clear();
  return solid;
}

/* ---- meshes from C ---- */

/* A copy of a mesh, all triangles. */
Soup soup_of(const lam_trimesh &mesh) {
  Soup soup;
  for (int i = 0; i < mesh.vertex_count; i++) soup.points.push_back(point(mesh.vertices[i]));
  for (int i = 0; i < mesh.triangle_count; i++)
    soup.triangles.push_back({mesh.triangles[i][0], mesh.triangles[i][1], mesh.triangles[i][2]});
  return soup;
}

/* Finite coordinates and indices in range. */
bool usable(const lam_trimesh &mesh) {
  for (int i = 0; i < mesh.vertex_count; i++)
    if (!std::isfinite(mesh.vertices[i].x) || !std::isfinite(mesh.vertices[i].y) ||
        !std::isfinite(mesh.vertices[i].z))
      return false;
  for (int i = 0; i < mesh.triangle_count; i++)
    for (int v : mesh.triangles[i])
      if (v < 0 || v >= mesh.vertex_count) return false;
  return true;
}

} // namespace

struct lam_tree {
  Soup soup;
  Tree tree;
  mutable std::atomic<bool> ran_out{false};
};

struct lam_solid_set {
  std::vector<Solid> solids;
};

extern "C" {

/* Pairs of triangles whose boxes overlap are tested. */
lam_status lam_solid_self_intersections(const lam_trimesh *mesh, long *count) {
  return guarded([&] {
    if (!usable(*mesh)) return LAM_BAD_INPUT;
    const Soup soup = soup_of(*mesh);
    std::vector<Box> boxes = boxes_of(soup);
    long found = 0, left = LAM_SOLID_MOST_PAIRS + 200l * mesh->triangle_count;
    try {
      CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box &a, const Box &b) {
        if (left-- == 0) throw Too_many();
        found += meet_improperly(soup, a.info(), b.info());
      });
    } catch (const Too_many &) {
      found = -1;
    }
    *count = found;
    return LAM_OK;
  });
}

/* The tree refers to the soup next to it, so both are made in place and stay there. */
lam_tree *lam_tree_new(const lam_trimesh *mesh, lam_status *status) {
  lam_tree *result = nullptr;
  lam_status made_it = guarded([&] {
    if (!usable(*mesh)) return LAM_BAD_INPUT;
    auto made = std::make_unique<lam_tree>();
    made->soup = soup_of(*mesh);
    build(made->tree, made->soup);
    if (made->tree.empty()) return LAM_BAD_INPUT;
    made->tree.accelerate_distance_queries();
    result = made.release();
    return LAM_OK;
  });
  if (status) *status = made_it;
  return result;
}

void lam_tree_free(void *tree) { delete static_cast<lam_tree *>(tree); }

/* On failure (a query that is not finite), the closest point is the query and the triangle -1. */
void lam_tree_closest(const lam_tree *tree, lam_vec3 query, lam_vec3 *closest, int *triangle) {
  *closest = query;
  *triangle = -1;
  if (!std::isfinite(query.x) || !std::isfinite(query.y) || !std::isfinite(query.z)) return;
  lam_status status = guarded([&] {
    auto found = tree->tree.closest_point_and_primitive(point(query));
    *closest = lam_v3(found.first.x(), found.first.y(), found.first.z());
    *triangle = found.second;
    return LAM_OK;
  });
  if (status == LAM_NO_MEMORY) tree->ran_out = true;
}

bool lam_tree_ran_out(const lam_tree *tree) { return tree && tree->ran_out; }

lam_solid_set *lam_solid_set_new(void) { return new (std::nothrow) lam_solid_set; }
void lam_solid_set_free(void *set) { delete static_cast<lam_solid_set *>(set); }

/* An empty solid is what solid_of refuses. */
int lam_solid_set_add(lam_solid_set *set, const lam_trimesh *solid, const lam_pose *frame) {
  int index = -1;
  lam_status status = guarded([&] {
    Solid made = solid_of(*solid, frame);
    if (made.components.empty()) return LAM_BAD_INPUT;
    set->solids.push_back(std::move(made));
    index = (int)set->solids.size() - 1;
    return LAM_OK;
  });
  return status == LAM_NO_MEMORY ? -2 : index;
}

/* Sorted, because the order in which CGAL finds the pairs is its own. */
lam_status lam_solid_set_candidates(const lam_solid_set *set, int (**pairs)[2], int *count) {
  *pairs = nullptr;
  *count = 0;
  return guarded([&] {
    std::vector<Box> boxes;
    for (int i = 0; i < (int)set->solids.size(); i++) boxes.emplace_back(set->solids[i].box, i);
    std::vector<std::array<int, 2>> found;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box &a, const Box &b) {
      found.push_back({std::min(a.info(), b.info()), std::max(a.info(), b.info())});
    });

    std::sort(found.begin(), found.end());

    *pairs =
        static_cast<int(*)[2]>(std::malloc(std::max<size_t>(1, found.size()) * sizeof **pairs));
    if (!*pairs) return LAM_NO_MEMORY;
    for (size_t i = 0; i < found.size(); i++)
      std::copy(found[i].begin(), found[i].end(), (*pairs)[i]);
    *count = (int)found.size();
    return LAM_OK;
  });
}

/* The sum over pairs of components, with cavities counted negative. */
lam_status lam_solid_set_overlap(const lam_solid_set *set, int i, int j, double *volume) {
  *volume = 0;
  return guarded([&] {
    int last = (int)set->solids.size();
    if (i < 0 || j < 0 || i >= last || j >= last || i == j) return LAM_BAD_INPUT;

    double sum = 0;
    for (const auto &a : set->solids[i].components)
      for (const auto &b : set->solids[j].components)
        sum += a->sign * b->sign * common_volume(*a, *b);

    *volume = std::max(sum, 0.0);
    return LAM_OK;
  });
}

} // extern "C"
