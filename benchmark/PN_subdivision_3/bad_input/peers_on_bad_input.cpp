// Copyright (c) 2026  PN_subdivision_3 developers
// All rights reserved.
//
// This file is part of PN_subdivision_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: LGPL-3.0-or-later
// Author(s): PN_subdivision_3 developers
// Every bad input through CGAL, OpenMesh, OpenSubdiv, this package and its command, each in a process of its own
// (with limits on time and memory). Prints lines of: input, expected, and for each peer what came of it and why.
// scripts/compare_bad_input.py compiles this and puts the table into the manual.
//
//   right     the scheme's result          accepts   a result by a rule of its own, finite and complete
//   garbage   a wrong result, without a word         refusal   an error message, or the mesh cannot be made
//   crash     a signal                     hangs     no result within 30 seconds of a processor

#include "Bad_inputs.h"

#include <CGAL/PN_subdivision_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace {

using namespace peers;

struct Result
{
  std::vector<Triple> points;
  std::size_t faces = 0;
};

struct Refusal : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// --- CGAL and this package ---

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// as a careful program builds it; indices that are not there are the caller's own fault
Mesh surface_mesh(const Input& in)
{
  Mesh mesh;
  for (const Triple& p : in.points) mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for (const Polygon& f : in.faces) {
    std::vector<Mesh::Vertex_index> face;
    for (int v : f) face.emplace_back(Mesh::size_type(v));
    if (mesh.add_face(face) == Mesh::null_face()) throw Refusal("add_face() returns null_face()");
  }
  return mesh;
}

Result result_of(const Mesh& mesh)
{
  Result result;
  for (auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    result.points.push_back({p.x(), p.y(), p.z()});
  }
  result.faces = mesh.number_of_faces();
  return result;
}

Result by_cgal(const Input& in)
{
  Mesh mesh = surface_mesh(in);
  if (in.loop)
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
  else
    CGAL::Subdivision_method_3::CatmullClark_subdivision(mesh,
                                                         CGAL::parameters::number_of_iterations(1));
  return result_of(mesh);
}

Result by_package(const Input& in)
{
  namespace PN = CGAL::PN_subdivision_3;
  Mesh mesh = surface_mesh(in);
  if (in.loop)
    PN::Loop_subdivision(mesh);
  else
    PN::CatmullClark_subdivision(mesh);
  return result_of(mesh);
}

// --- the command ---

std::string command = "pn_subdivide";

Result by_command(const Input& in)
{
  std::string folder = (std::filesystem::temp_directory_path() / "pn_peers_XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) throw std::logic_error("no folder");
  const std::string file = folder + "/in.off", out = folder + "/out.off";
  {
    std::ofstream os(file);
    os.precision(17);
    os << "OFF\n" << in.points.size() << ' ' << in.faces.size() << " 0\n";
    for (const Triple& p : in.points) os << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for (const Polygon& f : in.faces) {
      os << f.size();
      for (int v : f) os << ' ' << v;
      os << '\n';
    }
  }
  const int status =
    std::system(("'" + command + "' surface " + file + " " + out + " --quiet --scheme " +
                 (in.loop ? "loop" : "catmull-clark") + " 2>" + folder + "/err")
                  .c_str());
  std::string message, word;
  std::ifstream err(folder + "/err");
  std::getline(err, message);
  Result result;
  std::size_t vertices = 0, edges = 0;
  std::ifstream is(out);
  if (is >> word >> vertices >> result.faces >> edges) {
    result.points.resize(vertices);
    for (Triple& p : result.points)
      for (double& x : p) {
        is >> word;
        x = std::strtod(word.c_str(), nullptr);
      }
  }
  std::filesystem::remove_all(folder);
  if (!WIFEXITED(status) || WEXITSTATUS(status) > 3) std::abort();
  if (WEXITSTATUS(status) != 0)
    throw Refusal(message.substr(message.find(": ", message.find("in.off")) + 2));
  return result;
}

// --- OpenMesh ---

struct Traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
};

template <class M, class Subdivider>
Result by_openmesh(const Input& in)
{
  M mesh;
  std::vector<typename M::VertexHandle> vertices;
  for (const Triple& p : in.points) vertices.push_back(mesh.add_vertex({p[0], p[1], p[2]}));
  for (const Polygon& f : in.faces) {
    std::vector<typename M::VertexHandle> face;
    for (int v : f) face.emplace_back(v);
    if (!mesh.add_face(face).is_valid()) throw Refusal("add_face() returns an invalid handle");
  }
  Subdivider subdivider;
  subdivider.attach(mesh);
  const bool is_done = subdivider(1);
  subdivider.detach();
  if (!is_done) throw Refusal("the subdivider returns false");
  Result result;
  for (auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    result.points.push_back({p[0], p[1], p[2]});
  }
  result.faces = mesh.n_faces();
  return result;
}

Result by_openmesh(const Input& in)
{
  using Poly = OpenMesh::PolyMesh_ArrayKernelT<Traits>;
  using Tri = OpenMesh::TriMesh_ArrayKernelT<Traits>;
  if (in.loop) return by_openmesh<Tri, OpenMesh::Subdivider::Uniform::LoopT<Tri, double>>(in);
  return by_openmesh<Poly, OpenMesh::Subdivider::Uniform::CatmullClarkT<Poly, double>>(in);
}

// --- OpenSubdiv ---

struct Peer_point
{
  Triple x{0, 0, 0};
  void Clear(void* = nullptr) { x = {0, 0, 0}; }
  template <class Weight>
  void AddWithWeight(const Peer_point& p, Weight w)
  {
    for (std::size_t k = 0; k < 3; ++k) x[k] += double(w) * p.x[k];
  }
};

Result by_opensubdiv(const Input& in)
{
  namespace Far = OpenSubdiv::Far;
  namespace Sdc = OpenSubdiv::Sdc;
  std::vector<int> degrees, corners;
  for (const Polygon& f : in.faces) {
    degrees.push_back(int(f.size()));
    corners.insert(corners.end(), f.begin(), f.end());
  }
  Far::TopologyDescriptor d;
  d.numVertices = int(in.points.size());
  d.numFaces = int(in.faces.size());
  d.numVertsPerFace = degrees.data();
  d.vertIndicesPerFace = corners.data();
  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  Factory::Options factory_options(in.loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK, options);
  factory_options.validateFullTopology = true;
  const std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(d, factory_options));
  if (!refiner) throw Refusal("TopologyRefinerFactory::Create() returns a null pointer");
  refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(1));
  std::vector<Peer_point> old, points(std::size_t(refiner->GetLevel(1).GetNumVertices()));
  for (const Triple& p : in.points) old.push_back({p});
  const Peer_point* from = old.data();
  Peer_point* to = points.data();
  Far::PrimvarRefinerReal<double>(*refiner).Interpolate(1, from, to);
  Result result;
  for (const Peer_point& p : points) result.points.push_back(p.x);
  result.faces = std::size_t(refiner->GetLevel(1).GetNumFaces());
  return result;
}

// --- one peer on one input ---

struct Peer
{
  const char* name;
  Result (*run)(const Input&);
};
const Peer all_peers[] = {{"CGAL", by_cgal},
                          {"OpenMesh", by_openmesh},
                          {"OpenSubdiv", by_opensubdiv},
                          {"PN_subdivision_3", by_package},
                          {"pn_subdivide", by_command}};

std::string judged(const Input& in, const Result& result)
{
  for (const Triple& p : result.points)
    for (double x : p)
      if (!std::isfinite(x)) return "garbage\tcoordinates that are not finite";
  const auto [vertices, faces] = in.refined();
  if (result.points.size() != vertices || result.faces != faces)
    return "garbage\t" + std::to_string(result.points.size()) + " vertices and " +
           std::to_string(result.faces) + " faces, not " + std::to_string(vertices) + " and " +
           std::to_string(faces);
  if (in.expected == Expected::refusal) return "garbage\ta mesh";
  return in.expected == Expected::either ? "accepts\t" : "right\t";
}

std::string outcome(const Peer& peer, const Input& in)
{
  int ends[2];
  if (pipe(ends) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    const rlimit time{30, 30};
    setrlimit(RLIMIT_CPU, &time);
    const rlimit memory{rlim_t(4) << 30, rlim_t(4) << 30};
    setrlimit(RLIMIT_AS, &memory);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    std::freopen("/dev/null", "w", stderr);
    std::freopen("/dev/null", "w", stdout);
    std::string text;
    try {
      text = judged(in, peer.run(in));
    } catch (const std::exception& e) {
      text = std::string("refusal\t") + e.what();
    }
    if (write(ends[1], text.data(), text.size()) < 0) _exit(1);
    _exit(0);
  }
  close(ends[1]);
  std::string text;
  char buffer[512];
  for (ssize_t n; (n = read(ends[0], buffer, sizeof(buffer))) > 0;)
    text.append(buffer, std::size_t(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
    return WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL
             ? "hangs\t"
             : std::string("crash\t") + strsignal(WTERMSIG(status));
  return text;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc > 1) command = argv[1];
  std::string table =
    "input\texpected"; // printed at last: forked children would print a buffer, too
  for (const Peer& peer : all_peers) table += std::string("\t") + peer.name + "\tbecause";
  for (const Input& in : bad_inputs()) {
    const char* const expected[] = {"result", "refusal", "either"};
    table += "\n" + in.name + "\t" + expected[int(in.expected)];
    for (const Peer& peer : all_peers) table += "\t" + outcome(peer, in);
  }
  std::printf("%s\n", table.c_str());
}
