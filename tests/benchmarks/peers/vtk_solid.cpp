#include "tests/benchmarks/peers/vtk_solid.h"

#include <vtkCellArray.h>
#include <vtkClipClosedSurface.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <utility>

#include "simulator/base/check.h"

namespace hallux::benchmarks {

struct VtkSolid::Data {
  vtkSmartPointer<vtkPolyData> surface;
};

VtkSolid::VtkSolid(const simulator::IndexedMesh& mesh) : data_(std::make_unique<Data>()) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points_mm.size()));
  for (std::size_t i = 0; i < mesh.points_mm.size(); ++i) {
    const Vec3& point_mm = mesh.points_mm[i];
    points->SetPoint(static_cast<vtkIdType>(i), point_mm.x, point_mm.y, point_mm.z);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(static_cast<vtkIdType>(mesh.triangles.size()),
                           static_cast<vtkIdType>(3 * mesh.triangles.size()));
  for (const simulator::Triangle& corners : mesh.triangles) {
    const std::array<vtkIdType, 3> ids{corners[0], corners[1], corners[2]};
    triangles->InsertNextCell(3, ids.data());
  }
  data_->surface = vtkSmartPointer<vtkPolyData>::New();
  data_->surface->SetPoints(points);
  data_->surface->SetPolys(triangles);
}

VtkSolid::VtkSolid(std::unique_ptr<Data> data) : data_(std::move(data)) {}
VtkSolid::~VtkSolid() = default;
VtkSolid::VtkSolid(VtkSolid&& other) noexcept = default;

VtkSolid VtkSolid::clipped(const HalfSpace& kept) const {
  const Vec3 origin_mm = kept.offset_mm * kept.normal;
  vtkNew<vtkPlane> plane;
  // VTK keeps what lies in front of the plane.
  plane->SetNormal(-kept.normal.x, -kept.normal.y, -kept.normal.z);
  plane->SetOrigin(origin_mm.x, origin_mm.y, origin_mm.z);
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(plane);
  vtkNew<vtkClipClosedSurface> filter;
  filter->SetInputData(data_->surface);
  filter->SetClippingPlanes(planes);
  filter->Update();
  auto data = std::make_unique<Data>();
  data->surface = filter->GetOutput();
  return VtkSolid(std::move(data));
}

std::size_t VtkSolid::triangle_count() const {
  return static_cast<std::size_t>(data_->surface->GetNumberOfPolys());
}

double VtkSolid::volume_mm3() const {
  double six_volumes_mm3 = 0.0;
  vtkCellArray* polygons = data_->surface->GetPolys();
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (polygons->InitTraversal(); polygons->GetNextCell(count, ids) != 0;) {
    CHECK(count == 3);
    std::array<Vec3, 3> corners_mm{};
    for (std::size_t i = 0; i < 3; ++i) {
      data_->surface->GetPoint(ids[i], &corners_mm[i][0]);
    }
    six_volumes_mm3 += glm::dot(corners_mm[0], glm::cross(corners_mm[1], corners_mm[2]));
  }
  return six_volumes_mm3 / 6.0;
}

}  // namespace hallux::benchmarks
