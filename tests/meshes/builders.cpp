#include "builders.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "mesh/split_edges.h"
#include "point_sets.h"

namespace partwise::tests {
namespace {

/// Joins corners with equal integer lattice coordinates into one vertex.
class Lattice {
 public:
  int vertex(const Eigen::Vector3i& at) {
    const auto [entry, is_new] = index_.try_emplace({at[0], at[1], at[2]}, static_cast<int>(points_.size()));
    if (is_new) points_.push_back(at.cast<double>());
    return entry->second;
  }
  void triangle(const Eigen::Vector3i& a, const Eigen::Vector3i& b, const Eigen::Vector3i& c) {
    facets_.push_back({vertex(a), vertex(b), vertex(c)});
  }
  TriMesh mesh(double scale) {
    for (Vec3& point : points_) point *= scale;
    return TriMesh(std::move(points_), std::move(facets_));
  }

 private:
  std::map<std::array<int, 3>, int> index_;
  Points points_;
  Facets facets_;
};

TriMesh octahedron(int n) {
  Lattice lattice;
  for (int octant = 0; octant < 8; ++octant) {
    const Eigen::Vector3i sign(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
    const bool mirrored = sign.prod() < 0;
    auto corner = [&](int i, int j) {
      return Eigen::Vector3i(Eigen::Vector3i(i, j, n - i - j).cwiseProduct(sign));
    };
    auto add = [&](const auto& a, const auto& b, const auto& c) {
      if (mirrored)
        lattice.triangle(a, c, b);
      else
        lattice.triangle(a, b, c);
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n - i; ++j) {
        add(corner(i, j), corner(i + 1, j), corner(i, j + 1));
        if (j + 1 < n - i) add(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
      }
    }
  }
  return lattice.mesh(1.0 / n);
}

}  // namespace

TriMesh tetrahedron() {
  const double s = 1 / std::sqrt(3.0);
  return TriMesh({{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}},
                 {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
}

TriMesh cube(int n) {
  Lattice lattice;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-n, n}) {
      auto corner = [&](int i, int j) {
        Eigen::Vector3i at;
        at[axis] = side;
        at[(axis + 1) % 3] = 2 * i - n;
        at[(axis + 2) % 3] = 2 * j - n;
        return at;
      };
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
          if (side > 0) {
            lattice.triangle(a, b, c);
            lattice.triangle(a, c, d);
          } else {
            lattice.triangle(a, c, b);
            lattice.triangle(a, d, c);
          }
        }
      }
    }
  }
  return lattice.mesh(1.0 / n);
}

TriMesh sphere(int n) {
  const TriMesh octahedral = octahedron(n);
  return octahedral.with_points(
      mapped(octahedral.points(), [](const Vec3& p) -> Vec3 { return p.normalized(); }));
}

TriMesh bumpy_sphere(int n, double height) {
  const TriMesh round = sphere(n);
  return round.with_points(mapped(round.points(), [&](const Vec3& p) -> Vec3 {
    double radius = 1;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        const double angle = std::acos(std::clamp(side * p[axis], -1.0, 1.0));
        radius += height * std::exp(-std::pow(angle / 0.25, 2));
      }
    }
    return radius * p;
  }));
}

Points bump_directions() {
  constexpr int count = 60;
  Points directions;
  for (int i = 0; i < count; ++i) {  // a spiral from pole to pole, turning by the golden angle
    const double z = 1 - (2 * i + 1) / static_cast<double>(count),
                 turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double around = std::sqrt(1 - z * z);
    directions.emplace_back(around * std::cos(turn), around * std::sin(turn), z);
  }
  return directions;
}

TriMesh many_bumps(int n, double height) {
  const TriMesh round = sphere(n);
  const Points tips = bump_directions();
  return round.with_points(mapped(round.points(), [&](const Vec3& p) -> Vec3 {
    double radius = 1;
    for (const Vec3& tip : tips) {
      radius += height * std::exp(-std::pow(std::acos(std::clamp(p.dot(tip), -1.0, 1.0)) / 0.1, 2));
    }
    return radius * p;
  }));
}

TriMesh torus(double major_radius, double minor_radius, int around, int across) {
  Points points;
  Facets facets;
  auto vertex = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double radius = major_radius + minor_radius * std::cos(v);
      points.emplace_back(radius * std::cos(u), radius * std::sin(u), minor_radius * std::sin(v));
      facets.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      facets.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return TriMesh(std::move(points), std::move(facets));
}

TriMesh two_spheres(int n) {
  const TriMesh one = sphere(n);
  Points points = one.points();
  Facets facets = one.facets();
  const int count = one.vertex_count();
  for (const Vec3& p : one.points()) points.push_back(p + Vec3(5, 0, 0));
  for (const auto& [a, b, c] : one.facets()) facets.push_back({a + count, b + count, c + count});
  return TriMesh(std::move(points), std::move(facets));
}

TriMesh hemisphere(int n) {
  const TriMesh whole = sphere(n);
  std::map<int, int> kept;
  Points points;
  Facets facets;
  for (const Facet& f : whole.facets()) {
    if (whole.point(f[0]).z() + whole.point(f[1]).z() + whole.point(f[2]).z() <= 0) continue;
    Facet renumbered;
    for (int i = 0; i < 3; ++i) {
      const auto [entry, is_new] = kept.try_emplace(f[i], static_cast<int>(points.size()));
      if (is_new) points.push_back(whole.point(f[i]));
      renumbered[i] = entry->second;
    }
    facets.push_back(renumbered);
  }
  return TriMesh(std::move(points), std::move(facets));
}

TriMesh grid(int n) {
  Points points;
  Facets facets;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) points.emplace_back(2.0 * i / n - 1, 2.0 * j / n - 1, 0);
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      facets.push_back({a, b, b + 1});
      facets.push_back({a, b + 1, a + 1});
    }
  }
  return TriMesh(std::move(points), std::move(facets));
}

TriMesh capsule(double length, int around, int along) {
  // A profile curve (radius, z) from the south pole to the north pole, turned around the z axis.
  Points points{{0, 0, -length / 2 - 1}};
  Facets facets;
  const double profile_length = length + std::numbers::pi;
  for (int i = 1; i < along; ++i) {
    const double s = profile_length * i / along - profile_length / 2;
    const double past_tube = std::abs(s) - length / 2;
    const double angle = past_tube > 0 ? past_tube : 0;
    const double z = std::copysign(past_tube > 0 ? length / 2 + std::sin(angle) : std::abs(s), s);
    const double radius = std::cos(angle) * (1 - 0.2 * std::exp(-z * z));
    for (int j = 0; j < around; ++j) {
      const double turn = 2 * std::numbers::pi * j / around;
      points.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z);
    }
  }
  points.emplace_back(0, 0, length / 2 + 1);
  const int north = static_cast<int>(points.size()) - 1;
  auto vertex = [&](int i, int j) { return 1 + (i - 1) * around + j % around; };
  for (int j = 0; j < around; ++j) {
    facets.push_back({0, vertex(1, j + 1), vertex(1, j)});
    for (int i = 1; i + 1 < along; ++i) {
      facets.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)});
      facets.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)});
    }
    facets.push_back({vertex(along - 1, j), vertex(along - 1, j + 1), north});
  }
  return TriMesh(std::move(points), std::move(facets));
}

TriMesh with_flat_slivers(const TriMesh& mesh, int step, double height) {
  Points points = mesh.points();
  Facets facets;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    const auto& [a, b, c] = mesh.facet(f);
    if (f % step != 0) {
      facets.push_back({a, b, c});
      continue;
    }
    const Vec3 middle = (mesh.point(a) + mesh.point(b)) / 2, along = mesh.point(b) - mesh.point(a);
    const Vec3 across = mesh.point(c) - middle;
    const Vec3 inward = (across - across.dot(along) / along.squaredNorm() * along).normalized();
    const int v = static_cast<int>(points.size());
    points.push_back(middle + height * along.norm() * inward);
    facets.insert(facets.end(), {{a, b, v}, {b, c, v}, {c, a, v}});
  }
  return TriMesh(std::move(points), std::move(facets));
}

TriMesh with_needles(const TriMesh& mesh, int step, double fraction) {
  std::vector<EdgePoint> cuts;
  int edge = 0;
  for (const auto h : mesh.half_edges().halfedges()) {
    const int a = mesh.half_edges().from_vertex_handle(h).idx(),
              b = mesh.half_edges().to_vertex_handle(h).idx();
    if (a < b && edge++ % step == 0) cuts.push_back({a, b, fraction});
  }
  return split_edges(mesh, cuts).mesh;
}

TriMesh with_opening(const TriMesh& mesh, const Vec3& direction, double size) {
  Points points = mesh.points();
  Facets facets = mesh.facets();
  auto centroid = [&](const Facet& f) { return Vec3((points[f[0]] + points[f[1]] + points[f[2]]) / 3); };
  const auto farthest = std::max_element(facets.begin(), facets.end(), [&](const Facet& f, const Facet& g) {
    return direction.dot(centroid(f)) < direction.dot(centroid(g));
  });
  const Facet outer = *farthest;
  const Vec3 centre = centroid(outer);
  const int first = static_cast<int>(points.size());
  for (const int v : outer) points.push_back(centre + size * (mesh.point(v) - centre));
  facets.erase(farthest);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    facets.insert(facets.end(), {{outer[i], outer[j], first + j}, {outer[i], first + j, first + i}});
  }
  return TriMesh(std::move(points), std::move(facets));
}

TextureCorners cylindrical_texture(const TriMesh& mesh) {
  const auto around = [](const Vec3& p) { return std::atan2(p.y(), p.x()) / (2 * std::numbers::pi) + 0.5; };
  TextureCorners corners;
  for (const auto& [a, b, c] : mesh.facets()) {
    const Vec3 corner[] = {mesh.point(a), mesh.point(b), mesh.point(c)};
    const double middle = around(corner[0] + corner[1] + corner[2]);
    std::array<double, 6>& places = corners.places.emplace_back();
    for (int i = 0; i < 3; ++i) {
      places[2 * i] = middle + std::remainder(around(corner[i]) - middle, 1.0);
      places[2 * i + 1] = corner[i].z();
    }
  }
  return corners;
}

}  // namespace partwise::tests
