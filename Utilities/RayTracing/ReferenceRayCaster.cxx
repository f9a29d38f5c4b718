// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceRayCaster.h"

#include "ReferenceEmbree.h"

#include <algorithm> // For std::min and std::max
#include <limits>    // For infinity
#include <stdexcept> // For the lack of a device

namespace softshadows
{
namespace
{

// More than single precision loses of a ray in the unit ball (local units). The boxes around
// triangles are wider by it, and Embree's rays start earlier and end later: it leaves out nothing
// that a ray meets, and what it offers is judged in double precision.
constexpr double FloatMargin = 1e-6;

constexpr float Infinity = std::numeric_limits<float>::infinity();

// A query as it is asked, in double precision, behind the context that Embree hands on.
struct Query
{
  QueryContext Context; // first, so that a pointer to it is a pointer to the query
  const ReferenceGeometry* Geometry = nullptr;
  ReferenceRayCaster::Ray Ray;
  double Distance = 0.0; // of the nearest hit so far, or the ray's end
  unsigned int Triangle = RTC_INVALID_GEOMETRY_ID;
  unsigned int LeftOut = RTC_INVALID_GEOMETRY_ID;
};

//--------------------------------------------------------------------------------------------------
// Distance along the ray to the triangle, or infinity if they miss each other (Moeller and Trumbore
// 1997). The edges belong to the triangle, with a rounding error's width: neighbours leave no gap.
double DistanceTo(
  const ReferenceGeometry& geometry, unsigned int index, const ReferenceRayCaster::Ray& ray)
{
  constexpr double edge = 1e-12;
  const ReferenceGeometry::Triangle& triangle = geometry.Triangles[index];
  const Vector& p0 = geometry.Points[triangle.Points[0]];
  const Vector e1 = geometry.Points[triangle.Points[1]] - p0;
  const Vector e2 = geometry.Points[triangle.Points[2]] - p0;
  const Vector p = Cross(ray.Direction, e2);
  const double determinant = Dot(e1, p);
  if (determinant == 0.0)
  {
    return std::numeric_limits<double>::infinity();
  }
  const Vector s = ray.Origin - p0;
  const double u = Dot(s, p) / determinant;
  const Vector q = Cross(s, e1);
  const double v = Dot(ray.Direction, q) / determinant;
  if (!(u >= -edge && v >= -edge && u + v <= 1.0 + edge))
  {
    return std::numeric_limits<double>::infinity();
  }
  return Dot(e2, q) / determinant;
}

//--------------------------------------------------------------------------------------------------
float FloatEnd(double distance)
{
  return static_cast<float>(distance + 2.0 * FloatMargin);
}

//--------------------------------------------------------------------------------------------------
bool Meets(Query& query, unsigned int index)
{
  const double distance = DistanceTo(*query.Geometry, index, query.Ray);
  if (!(distance > 0.0 && distance < query.Distance))
  {
    return false;
  }
  query.Distance = distance;
  query.Triangle = index;
  return true;
}

//--------------------------------------------------------------------------------------------------
void FindNearest(const RTCIntersectFunctionNArguments* arguments)
{
  auto* query = reinterpret_cast<Query*>(arguments->context);
  if (arguments->valid[0] && Meets(*query, arguments->primID))
  {
    RTCRayN* ray = RTCRayHitN_RayN(arguments->rayhit, arguments->N);
    RTCRayN_tfar(ray, arguments->N, 0) = FloatEnd(query->Distance);
  }
}

//--------------------------------------------------------------------------------------------------
void FindAny(const RTCOccludedFunctionNArguments* arguments)
{
  auto* query = reinterpret_cast<Query*>(arguments->context);
  const unsigned int index = arguments->primID;
  const ReferenceGeometry& geometry = *query->Geometry;
  if (arguments->valid[0] && index != query->LeftOut &&
    geometry.Objects[geometry.Triangles[index].Object].Casts && Meets(*query, index))
  {
    RTCRayN_tfar(arguments->ray, arguments->N, 0) = -Infinity; // ends the search
  }
}

//--------------------------------------------------------------------------------------------------
void GetBounds(const RTCBoundsFunctionArguments* arguments)
{
  const auto& geometry = *static_cast<const ReferenceGeometry*>(arguments->geometryUserPtr);
  const ReferenceGeometry::Triangle& triangle = geometry.Triangles[arguments->primID];
  const Vector& a = geometry.Points[triangle.Points[0]];
  const Vector& b = geometry.Points[triangle.Points[1]];
  const Vector& c = geometry.Points[triangle.Points[2]];
  Vector low;
  Vector high;
  for (int i = 0; i < 3; ++i)
  {
    low[i] = std::min({ a[i], b[i], c[i] }) - FloatMargin;
    high[i] = std::max({ a[i], b[i], c[i] }) + FloatMargin;
  }
  RTCBounds* bounds = arguments->bounds_o;
  bounds->lower_x = static_cast<float>(low[0]);
  bounds->lower_y = static_cast<float>(low[1]);
  bounds->lower_z = static_cast<float>(low[2]);
  bounds->upper_x = static_cast<float>(high[0]);
  bounds->upper_y = static_cast<float>(high[1]);
  bounds->upper_z = static_cast<float>(high[2]);
}

//--------------------------------------------------------------------------------------------------
// How far the origin may be moved along the ray without passing anything in the unit ball.
double FreeDistance(const ReferenceRayCaster::Ray& ray)
{
  constexpr double margin = 1.01;
  const double toNearest = -Dot(ray.Origin, ray.Direction);
  return Length(ray.Origin) > margin ? std::max(0.0, toNearest - margin) : 0.0;
}

//--------------------------------------------------------------------------------------------------
RTCRay FloatRay(const ReferenceRayCaster::Ray& ray, double distance)
{
  RTCRay result;
  result.org_x = static_cast<float>(ray.Origin[0] - FloatMargin * ray.Direction[0]);
  result.org_y = static_cast<float>(ray.Origin[1] - FloatMargin * ray.Direction[1]);
  result.org_z = static_cast<float>(ray.Origin[2] - FloatMargin * ray.Direction[2]);
  result.dir_x = static_cast<float>(ray.Direction[0]);
  result.dir_y = static_cast<float>(ray.Direction[1]);
  result.dir_z = static_cast<float>(ray.Direction[2]);
  result.tnear = 0.0F;
  result.tfar = FloatEnd(distance);
  result.time = 0.0F;
  result.mask = ~0U;
  result.id = 0;
  result.flags = 0;
  return result;
}

}

//--------------------------------------------------------------------------------------------------
class ReferenceRayCaster::Internals
{
public:
  explicit Internals(const ReferenceGeometry& geometry)
    : Geometry(geometry)
    , Device(rtcNewDevice(nullptr))
  {
    if (!this->Device)
    {
      throw std::runtime_error("Embree has no device on this machine");
    }
    this->Scene = rtcNewScene(this->Device);
    rtcSetSceneFlags(this->Scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(this->Scene, RTC_BUILD_QUALITY_HIGH);
    if (!geometry.Triangles.empty())
    {
      this->AddTriangles();
    }
    rtcCommitScene(this->Scene);
  }

  ~Internals()
  {
    rtcReleaseScene(this->Scene);
    rtcReleaseDevice(this->Device);
  }

  Internals(const Internals&) = delete;
  Internals& operator=(const Internals&) = delete;

  Query NewQuery(const Ray& ray, double distance) const
  {
    Query query;
    InitQuery(query.Context);
    query.Geometry = &this->Geometry;
    query.Ray = ray;
    query.Distance = distance;
    return query;
  }

  const ReferenceGeometry& Geometry;
  RTCDevice Device = nullptr;
  RTCScene Scene = nullptr;

private:
  void AddTriangles()
  {
    // Not Embree's own triangles: it would round their corners, and lose what is small in a large
    // scene.
    RTCGeometry mesh = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(
      mesh, static_cast<unsigned int>(this->Geometry.Triangles.size()));
    rtcSetGeometryUserData(mesh, const_cast<ReferenceGeometry*>(&this->Geometry));
    rtcSetGeometryBoundsFunction(mesh, GetBounds, nullptr);
    rtcSetGeometryIntersectFunction(mesh, FindNearest);
    rtcSetGeometryOccludedFunction(mesh, FindAny);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(this->Scene, mesh);
    rtcReleaseGeometry(mesh);
  }
};

//--------------------------------------------------------------------------------------------------
ReferenceRayCaster::ReferenceRayCaster(const ReferenceGeometry& geometry)
  : Impl(new Internals(geometry))
{
}

//--------------------------------------------------------------------------------------------------
ReferenceRayCaster::~ReferenceRayCaster() = default;

//--------------------------------------------------------------------------------------------------
bool ReferenceRayCaster::FindFirstHit(const Ray& ray, Hit& hit) const
{
  constexpr double endless = std::numeric_limits<double>::infinity();
  const Ray near{ ray.Origin + FreeDistance(ray) * ray.Direction, ray.Direction };
  Query query = this->Impl->NewQuery(near, endless);
  RTCRayHit rayHit;
  rayHit.ray = FloatRay(near, endless);
  rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rayHit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  Intersect(this->Impl->Scene, query.Context, rayHit);
  if (query.Triangle == RTC_INVALID_GEOMETRY_ID)
  {
    return false;
  }
  hit.Triangle = query.Triangle;
  const ReferenceGeometry& geometry = this->Impl->Geometry;
  hit.Point = near.Origin + query.Distance * near.Direction;
  const Vector normal = Normalized(geometry.AreaVector(geometry.Triangles[hit.Triangle]));
  hit.Normal = Dot(normal, ray.Direction) > 0.0 ? -1.0 * normal : normal;
  return true;
}

//--------------------------------------------------------------------------------------------------
bool ReferenceRayCaster::IsBlocked(const Ray& ray, double distance, unsigned int leftOut) const
{
  Query query = this->Impl->NewQuery(ray, distance);
  query.LeftOut = leftOut;
  RTCRay floatRay = FloatRay(ray, distance);
  Occluded(this->Impl->Scene, query.Context, floatRay);
  return query.Triangle != RTC_INVALID_GEOMETRY_ID;
}

}
