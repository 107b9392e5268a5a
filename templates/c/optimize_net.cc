// Optimizes a net that a program holds in arrays: a saddle of 20 x 20 quads becomes an asymptotic
// net.
//
//   c++ -std=c++17 optimize_net.cc $(pkg-config --cflags --libs lamella) -o optimize_net
//   ./optimize_net
//
// The exit status is 0 when the net has converged, 1 when it has not, 2 when it cannot be solved.
#include <lamella/lamella.h>

#include <array>
#include <cstdio>
#include <memory>
#include <vector>

using Session = std::unique_ptr<lam_session, decltype(&lam_session_free)>;

// Empty when memory has run out.
static Session make_session() {
  lam_session *session = nullptr;
  lam_session_new(&session);
  return Session(session, lam_session_free);
}

int main() {
  // Vertex (i, j) has the index i * side + j. Faces are counterclockwise, seen from above.
  constexpr int cells = 20, side = cells + 1;
  std::vector<lam_vec3> vertices;
  std::vector<std::array<int, 4>> faces;
  for (int i = 0; i < side; i++)
    for (int j = 0; j < side; j++) {
      double x = (i - cells / 2) * .2, y = (j - cells / 2) * .2;
      vertices.push_back({x, y, .3 * x * y + .02 * x * x * x});
    }
  for (int i = 0; i < cells; i++)
    for (int j = 0; j < cells; j++)
      faces.push_back({i * side + j, (i + 1) * side + j, (i + 1) * side + j + 1, i * side + j + 1});

  Session session = make_session();
  if (!session) return 2;

  lam_net_task task = {};
  task.net = "{kind: asymptotic, orthogonal: no}";
  task.start.vertex_count = static_cast<int>(vertices.size());
  task.start.vertices = vertices.data();
  task.start.face_count = static_cast<int>(faces.size());
  task.start.faces = reinterpret_cast<int(*)[4]>(faces.data());

  lam_net_solution solution;
  if (lam_net_solve(session.get(), &task, &solution) != LAM_OK) {
    for (auto *e = lam_session_messages(session.get()); e; e = e->next) std::puts(e->text);
    return 2;
  }

  std::printf("%s after %d iterations, residual %.1e\n", solution.reason, solution.iterations,
              solution.residual);
  for (int i = 0; i < solution.measure_count; i++) {
    const lam_measure &m = solution.measures[i];
    std::printf("  %-22s max %.3g %s\n", m.name, m.max, m.unit);
  }
  return solution.converged ? 0 : 1;
}
