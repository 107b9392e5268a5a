// cad_reader FILE [COPY.step COPY.igs [PART.step PART.igs]]
// Reads a STEP or IGES file with OpenCASCADE, which knows nothing of this program, writes copies of
// it and of the middle of its first face (trimmed to half of its parameters each way), and prints
// what it found in SI units:
//   faces N / shells N / closed_shells N / valid 0|1 / area A / boundary L / vertices N (of faces)
//   / edges N / free_edges N (of one face only) / loose_edges N (of none) / loose L box x0 y0 z0 x1
//   y1 z1 point FACE u v x y z             on a grid over each face's parameters curve LENGTH x0 y0
//   z0 x1 y1 z1   for each loose edge part L                           length of the boundary of
//   the trimmed face name NAME LAYER                  for each B-spline curve that has a name; its
//   layer (STEP) or level (IGES) or -
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepGeom_BSplineCurve.hxx>
#include <StepVisual_PresentationLayerAssignment.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Shell.hxx>
#include <XSControl_WorkSession.hxx>
#include <cstdio>
#include <cstring>
#include <string>

enum { cells = 4 };

static double length(const TopoDS_Edge &edge) {
  return GCPnts_AbscissaPoint::Length(BRepAdaptor_Curve(edge), 1e-12) / 1000;
}

static void print_name(const char *name, const char *layer) {
  while (*name == ' ') name++;
  if (*name) printf("name %s %s\n", name, layer);
}

static void print_iges_names(const IGESControl_Reader &reader) {
  Handle(IGESData_IGESModel) model = reader.IGESModel();
  for (int i = 1; i <= model->NbEntities(); i++) {
    Handle(IGESData_IGESEntity) entity = model->Entity(i);
    if (entity->TypeNumber() != 126 || !entity->HasShortLabel() || entity->Level() == 0) continue;
    print_name(entity->ShortLabel()->ToCString(), std::to_string(entity->Level()).c_str());
  }
}

static void print_step_names(const STEPControl_Reader &reader) {
  Handle(XSControl_WorkSession) session = reader.WS();
  Handle(Interface_InterfaceModel) model = session->Model();
  for (int i = 1; i <= model->NbEntities(); i++) {
    Handle(StepGeom_BSplineCurve) curve = Handle(StepGeom_BSplineCurve)::DownCast(model->Value(i));
    if (curve.IsNull() || curve->Name().IsNull()) continue;
    std::string layer = "-";
    Interface_EntityIterator users = session->Graph().Sharings(curve);
    for (users.Start(); users.More(); users.Next()) {
      auto found = Handle(StepVisual_PresentationLayerAssignment)::DownCast(users.Value());
      if (!found.IsNull()) layer = found->Name()->ToCString();
    }
    print_name(curve->Name()->ToCString(), layer.c_str());
  }
}

static TopoDS_Shape read(const char *path, int *roots) {
  const char *dot = strrchr(path, '.');
  if (dot && strcmp(dot, ".igs") == 0) {
    IGESControl_Reader reader;
    if (reader.ReadFile(path) != IFSelect_RetDone) return TopoDS_Shape();
    *roots = reader.TransferRoots();
    print_iges_names(reader);
    return reader.OneShape();
  }
  STEPControl_Reader reader;
  if (reader.ReadFile(path) != IFSelect_RetDone) return TopoDS_Shape();
  *roots = reader.TransferRoots();
  print_step_names(reader);
  return reader.OneShape();
}

static void print_points(const TopoDS_Face &face, int number) {
  BRepAdaptor_Surface s(face);
  double u0 = s.FirstUParameter(), u1 = s.LastUParameter(), v0 = s.FirstVParameter(),
         v1 = s.LastVParameter();
  for (int i = 0; i <= cells; i++)
    for (int j = 0; j <= cells; j++) {
      double u = u0 + (u1 - u0) * i / cells, v = v0 + (v1 - v0) * j / cells;
      gp_Pnt p = s.Value(u, v);
      printf("point %d %.17g %.17g %.17g %.17g %.17g\n", number, u, v, p.X() / 1000, p.Y() / 1000,
             p.Z() / 1000);
    }
}

static void print_curve(const TopoDS_Edge &edge) {
  BRepAdaptor_Curve c(edge);
  gp_Pnt a = c.Value(c.FirstParameter()), b = c.Value(c.LastParameter());
  printf("curve %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", length(edge), a.X() / 1000,
         a.Y() / 1000, a.Z() / 1000, b.X() / 1000, b.Y() / 1000, b.Z() / 1000);
}

static void print_shells(const TopoDS_Shape &shape) {
  int shells = 0, closed = 0;
  for (TopExp_Explorer e(shape, TopAbs_SHELL); e.More(); e.Next(), shells++)
    closed += BRep_Tool::IsClosed(e.Current());
  TopTools_IndexedMapOfShape vertices;
  for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next())
    TopExp::MapShapes(e.Current(), TopAbs_VERTEX, vertices);
  printf("shells %d\nclosed_shells %d\nvertices %d\n", shells, closed, vertices.Extent());
}

static int report(const TopoDS_Shape &shape) {
  int faces = 0, edges = 0, free_edges = 0, loose_edges = 0;
  double boundary = 0, loose = 0;
  for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next())
    print_points(TopoDS::Face(e.Current()), faces++);
  TopTools_IndexedDataMapOfShapeListOfShape owners;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, owners);
  for (int i = 1; i <= owners.Extent(); i++) {
    const TopoDS_Edge &edge = TopoDS::Edge(owners.FindKey(i));
    if (BRep_Tool::Degenerated(edge)) continue;
    edges++;
    if (owners(i).Extent() == 1 && !BRep_Tool::IsClosed(edge, TopoDS::Face(owners(i).First()))) {
      free_edges++;
      boundary += length(edge);
    }
    if (owners(i).IsEmpty()) {
      loose_edges++;
      loose += length(edge);
      print_curve(edge);
    }
  }
  print_shells(shape);
  GProp_GProps area;
  BRepGProp::SurfaceProperties(shape, area, 1e-11);
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, Standard_False, Standard_False);
  double b[6];
  box.Get(b[0], b[1], b[2], b[3], b[4], b[5]);
  printf("faces %d\nvalid %d\narea %.17g\n", faces, (int)BRepCheck_Analyzer(shape).IsValid(),
         area.Mass() / 1e6);
  printf("boundary %.17g\nedges %d\nfree_edges %d\nloose_edges %d\nloose %.17g\nbox", boundary,
         edges, free_edges, loose_edges, loose);
  for (double side : b) printf(" %.17g", side / 1000);
  printf("\n");
  return 0;
}

static bool copy(const TopoDS_Shape &shape, const char *step, const char *iges) {
  STEPControl_Writer writer;
  IGESControl_Writer other("MM", 0);
  return writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
         writer.Write(step) == IFSelect_RetDone && other.AddShape(shape) && other.Write(iges);
}

static TopoDS_Shape middle(const TopoDS_Shape &shape) {
  TopoDS_Face face = TopoDS::Face(TopExp_Explorer(shape, TopAbs_FACE).Current());
  BRepAdaptor_Surface s(face);
  double u = s.FirstUParameter(), du = s.LastUParameter() - u, v = s.FirstVParameter(),
         dv = s.LastVParameter() - v;
  TopoDS_Shape part = BRepBuilderAPI_MakeFace(BRep_Tool::Surface(face), u + du / 4, u + 3 * du / 4,
                                              v + dv / 4, v + 3 * dv / 4, 1e-7)
                          .Face();
  double sum = 0;
  for (TopExp_Explorer e(part, TopAbs_EDGE); e.More(); e.Next())
    sum += length(TopoDS::Edge(e.Current()));
  printf("part %.17g\n", sum);
  return part;
}

int main(int argc, char **argv) {
  if (argc != 2 && argc != 4 && argc != 6) return 2;
  try {
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
    IGESControl_Controller::Init();
    int roots = 0;
    TopoDS_Shape shape = read(argv[1], &roots);
    if (shape.IsNull()) {
      fprintf(stderr, "%s: nothing was read\n", argv[1]);
      return 1;
    }
    printf("roots %d\n", roots);
    if ((argc >= 4 && !copy(shape, argv[2], argv[3])) ||
        (argc == 6 && !copy(middle(shape), argv[4], argv[5]))) {
      fprintf(stderr, "%s: cannot be copied\n", argv[1]);
      return 1;
    }
    return report(shape);
  } catch (const Standard_Failure &failure) {
    fprintf(stderr, "%s: %s\n", argv[1], failure.GetMessageString());
    return 1;
  }
}
