// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceTracer.h"

#include "ReferenceSnapshot.h"

#include <algorithm> // For std::min
#include <cmath>     // For NaN
#include <limits>    // For NaN
#include <stdexcept> // For bad arguments
#include <thread>    // For all cores

namespace softshadows
{
namespace
{

constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

//--------------------------------------------------------------------------------------------------
// Numbers in [0, 1) that depend on nothing but their place (the finaliser of SplitMix64, Steele,
// Lea and Flood 2014, over a counter).
class Jitter
{
public:
  Jitter(std::uint64_t pixel, std::uint64_t light)
    : State(Mix(pixel + Mix(light + 1)))
  {
  }

  double Next()
  {
    this->State += 0x9e3779b97f4a7c15U;
    constexpr double perUnit = 1.0 / 9007199254740992.0; // 2^-53
    return perUnit * static_cast<double>(Mix(this->State) >> 11);
  }

private:
  static std::uint64_t Mix(std::uint64_t x)
  {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
  }

  std::uint64_t State;
};

//--------------------------------------------------------------------------------------------------
// Off the surface, in local units: some hundred times what double precision loses of a hit in the
// unit ball. What stands out of a plane by more than that is there.
constexpr double Offset = 1e-13;

//--------------------------------------------------------------------------------------------------
struct Receiver
{
  ReferenceRayCaster::Hit Hit;
  std::uint64_t Pixel = 0;
};

//--------------------------------------------------------------------------------------------------
// What is the same for all pixels.
class Scene
{
public:
  explicit Scene(const ReferenceSnapshot& snapshot)
    : Geometry(snapshot.GetGeometry())
    , Caster(snapshot.GetCaster())
    , Camera(snapshot.GetCamera())
    , Lights(snapshot.GetLights())
    , CastsShadow(snapshot.GetCastsShadow())
  {
  }

  bool FindReceiver(int column, int row, Receiver& receiver) const
  {
    return this->Caster.FindFirstHit(this->Camera.GetRay(column, row), receiver.Hit);
  }

  const ReferenceGeometry::Object& GetObject(const Receiver& receiver) const
  {
    return this->Geometry.Objects[this->Geometry.Triangles[receiver.Hit.Triangle].Object];
  }

  /// 1 if nothing stands between the receiver and the sample of the light.
  bool IsLit(const Receiver& receiver, const ReferenceLight& light, const Vector& place) const
  {
    const Vector toLight = light.IsDirectional() ? place : place - receiver.Hit.Point;
    if (Dot(toLight, receiver.Hit.Normal) < 0.0)
    {
      return false; // behind the side that the camera sees: the surface itself is in the way
    }
    ReferenceRayCaster::Ray ray;
    ray.Origin = receiver.Hit.Point + Offset * receiver.Hit.Normal;
    double distance = std::numeric_limits<double>::infinity();
    ray.Direction = place;
    if (!light.IsDirectional())
    {
      // What lies in the light's own surface does not block it.
      constexpr double beforeLight = 1.0 - 1e-9;
      ray.Direction = place - ray.Origin;
      distance = beforeLight * Length(ray.Direction);
      ray.Direction = Normalized(ray.Direction);
    }
    return !this->Caster.IsBlocked(ray, distance, receiver.Hit.Triangle);
  }

  const ReferenceGeometry& Geometry;
  const ReferenceRayCaster& Caster;
  const ReferenceCamera& Camera;
  const std::vector<ReferenceLight>& Lights;
  const std::vector<bool>& CastsShadow;
};

//--------------------------------------------------------------------------------------------------
double SampleLight(const Scene& scene, const Receiver& receiver, size_t index, int perAxis)
{
  const ReferenceLight& light = scene.Lights[index];
  Jitter jitter(receiver.Pixel, index);
  double lit = 0.0;
  double all = 0.0;
  for (int j = 0; j < perAxis; ++j)
  {
    for (int i = 0; i < perAxis; ++i)
    {
      const double s = (i + jitter.Next()) / perAxis;
      const double t = (j + jitter.Next()) / perAxis;
      const ReferenceLight::Sample sample = light.GetSample(s, t);
      all += sample.Weight;
      if (scene.IsLit(receiver, light, sample.Place))
      {
        lit += sample.Weight;
      }
    }
  }
  return lit / all;
}

//--------------------------------------------------------------------------------------------------
void Allocate(const Scene& scene, ReferenceVisibility& images)
{
  const size_t pixels = static_cast<size_t>(images.Width) * images.Height;
  images.Visibility.assign(scene.Lights.size(), std::vector<float>(pixels, NaN));
  images.Depth.assign(pixels, NaN);
  images.Normal.assign(pixels, { { NaN, NaN, NaN } });
  images.Object.assign(pixels, -1);
  for (const ReferenceGeometry::Object& object : scene.Geometry.Objects)
  {
    images.Props.push_back(object.Prop);
  }
}

//--------------------------------------------------------------------------------------------------
// Traces rows until none is left; what one thread does.
class Worker
{
public:
  Worker(const Scene& scene, int perAxis, int pilotPerAxis, const std::atomic<bool>* cancelled,
    ReferenceVisibility& images)
    : TheScene(scene)
    , PerAxis(perAxis)
    , PilotPerAxis(pilotPerAxis)
    , Cancelled(cancelled)
    , Images(images)
  {
  }

  bool IsCancelled() const { return this->Cancelled && *this->Cancelled; }

  void TraceRow(int row)
  {
    // Asked per pixel: a row may take a second.
    for (int column = 0; column < this->Images.Width && !this->IsCancelled(); ++column)
    {
      Receiver receiver;
      receiver.Pixel = static_cast<std::uint64_t>(row) * this->Images.Width + column;
      if (this->TheScene.FindReceiver(column, row, receiver))
      {
        this->TracePixel(receiver);
      }
    }
  }

  std::int64_t GetRays() const { return this->Rays; }

private:
  void TracePixel(const Receiver& receiver)
  {
    const size_t pixel = receiver.Pixel;
    const ReferenceRayCaster::Hit& hit = receiver.Hit;
    this->Images.Depth[pixel] = static_cast<float>(this->TheScene.Camera.GetDepth(hit.Point));
    for (int i = 0; i < 3; ++i)
    {
      this->Images.Normal[pixel][i] = static_cast<float>(hit.Normal[i]);
    }
    this->Images.Object[pixel] =
      static_cast<int>(this->TheScene.Geometry.Triangles[hit.Triangle].Object);
    if (!this->TheScene.GetObject(receiver).Receives)
    {
      return;
    }
    for (size_t light = 0; light < this->TheScene.Lights.size(); ++light)
    {
      if (!this->TheScene.CastsShadow[light])
      {
        this->Images.Visibility[light][pixel] = 1.0F;
      }
      else if (this->TheScene.Lights[light].Reaches(hit.Point))
      {
        this->Images.Visibility[light][pixel] = static_cast<float>(this->See(receiver, light));
      }
    }
  }

  double See(const Receiver& receiver, size_t light)
  {
    if (!this->TheScene.Lights[light].HasExtent())
    {
      return this->Count(receiver, light, 1);
    }
    if (this->PilotPerAxis > 0 && this->PilotPerAxis < this->PerAxis)
    {
      const double pilot = this->Count(receiver, light, this->PilotPerAxis);
      if (pilot == 0.0 || pilot == 1.0)
      {
        return pilot;
      }
    }
    return this->Count(receiver, light, this->PerAxis);
  }

  double Count(const Receiver& receiver, size_t light, int perAxis)
  {
    this->Rays += static_cast<std::int64_t>(perAxis) * perAxis;
    return SampleLight(this->TheScene, receiver, light, perAxis);
  }

  const Scene& TheScene;
  int PerAxis;
  int PilotPerAxis;
  const std::atomic<bool>* Cancelled;
  ReferenceVisibility& Images;
  std::int64_t Rays = 0;
};

}

//--------------------------------------------------------------------------------------------------
ReferenceTracer::ReferenceTracer(int width, int height, int samplesPerAxis)
  : Width(width)
  , Height(height)
  , SamplesPerAxis(samplesPerAxis)
{
  if (width < 1 || height < 1 || samplesPerAxis < 1)
  {
    throw std::invalid_argument("width, height and samples per axis must be at least 1");
  }
}

//--------------------------------------------------------------------------------------------------
ReferenceVisibility ReferenceTracer::Trace(vtkRenderer* renderer) const
{
  return this->Trace(ReferenceSnapshot(renderer, this->Width, this->Height, this->Gaussian));
}

//--------------------------------------------------------------------------------------------------
ReferenceVisibility ReferenceTracer::Trace(const ReferenceSnapshot& snapshot) const
{
  if (snapshot.GetWidth() != this->Width || snapshot.GetHeight() != this->Height)
  {
    throw std::invalid_argument("the snapshot is of another size than the tracer");
  }
  const Scene scene(snapshot);
  ReferenceVisibility images;
  images.Width = this->Width;
  images.Height = this->Height;
  Allocate(scene, images);

  std::atomic<int> next{ 0 };
  std::atomic<std::int64_t> rays{ 0 };
  double told = 0.0;
  const auto work = [&](const std::function<void(double)>& progress)
  {
    Worker worker(scene, this->SamplesPerAxis, this->PilotSamplesPerAxis, this->Cancelled, images);
    for (int row = next++; row < this->Height && !worker.IsCancelled(); row = next++)
    {
      worker.TraceRow(row);
      if (progress)
      {
        told = std::min(1.0, static_cast<double>(next) / this->Height);
        progress(told);
      }
    }
    rays += worker.GetRays();
  };

  const unsigned int wanted =
    this->NumberOfThreads > 0 ? this->NumberOfThreads : std::thread::hardware_concurrency();
  std::vector<std::thread> helpers;
  for (unsigned int i = 1; i < wanted; ++i)
  {
    helpers.emplace_back(work, nullptr);
  }
  work(this->Progress);
  for (std::thread& helper : helpers)
  {
    helper.join();
  }
  images.ShadowRays = rays;
  images.Complete = !this->Cancelled || !*this->Cancelled;
  // The last row may have been another thread's.
  if (this->Progress && images.Complete && told < 1.0)
  {
    this->Progress(1.0);
  }
  return images;
}

//--------------------------------------------------------------------------------------------------
ReferenceVisibility Trace(
  vtkRenderer* renderer, int width, int height, int samplesPerAxis, bool gaussian)
{
  ReferenceTracer tracer(width, height, samplesPerAxis);
  tracer.SetGaussian(gaussian);
  return tracer.Trace(renderer);
}

}
