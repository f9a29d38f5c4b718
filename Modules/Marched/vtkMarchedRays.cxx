// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarchedRays.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowFailures.h"
#include "vtkShadowLightSampling.h"
#include "vtkShadowScopedState.h"
#include "vtkSoftShadowsOpenGL.h"
#include "vtkTextureObject.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Sample = vtkShadowLightSampling::Sample;

// Jitter of ray i's steps: the golden ratio's multiples are spread evenly for any prefix.
float StepJitter(int i)
{
  const double multiple = (i + 0.5) * 0.6180339887498949;
  return static_cast<float>(multiple - static_cast<int>(multiple));
}

// An edge of a shadow that crosses the light parts its rim: the outermost quarter of the samples, with
// half of the others against what is smaller than the light. Returns how many these are.
int PutDecisiveFirst(std::vector<Sample>& samples)
{
  const auto outside = [](const Sample& a, const Sample& b)
  { return a.U * a.U + a.V * a.V > b.U * b.U + b.V * b.V; };
  const std::size_t rim = (samples.size() + 3) / 4;
  std::vector<Sample> sorted = samples;
  std::nth_element(sorted.begin(), sorted.begin() + (rim - 1), sorted.end(), outside);
  const Sample last = sorted[rim - 1];
  std::stable_partition(
    samples.begin(), samples.end(), [&](const Sample& sample) { return !outside(last, sample); });
  return static_cast<int>(std::min(rim + (3 * samples.size() + 7) / 8, samples.size()));
}

// Which pixel of the pattern has that run. As in an ordered dither, digits of the run's number are
// places in halves of the pattern, halves of these, and so on, so that runs that follow each other, and
// are well spread together, lie apart.
int PixelOfRun(int run, int pattern)
{
  int pixel[2] = { 0, 0 };
  int edge = pattern;
  int divisor = 1;
  while (edge > 1)
  {
    const int base = edge % 2 == 0 ? 2 : edge;
    edge /= base;
    divisor *= base;
    const int digit = run % (base * base);
    run /= base * base;
    // Of four, those on a diagonal follow each other.
    const int x = base == 2 ? (digit ^ (digit >> 1)) & 1 : digit % base;
    const int y = base == 2 ? (digit & 1) : (digit / base + 2 * digit) % base;
    pixel[0] += x * (pattern / divisor);
    pixel[1] += y * (pattern / divisor);
  }
  return pixel[0] + pattern * pixel[1];
}
} // namespace

//------------------------------------------------------------------------------
vtkMarchedRays::vtkMarchedRays() = default;

//------------------------------------------------------------------------------
vtkMarchedRays::~vtkMarchedRays() = default;

//------------------------------------------------------------------------------
int vtkMarchedRays::Activate(vtkOpenGLRenderWindow* window, const vtkShadowEmitter& emitter,
  int count, int pattern, int weights)
{
  const int runs = pattern * pattern;
  this->Count = emitter.HasExtent() ? count : 1;
  std::vector<Sample> samples(static_cast<std::size_t>(this->Count) * runs);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    samples[i] =
      vtkShadowLightSampling::PointOfSequence(emitter, static_cast<unsigned int>(i), weights);
  }
  std::vector<float> rays(4 * samples.size());
  for (int run = 0; run < runs; ++run)
  {
    std::vector<Sample> subset(
      samples.begin() + run * this->Count, samples.begin() + (run + 1) * this->Count);
    this->FirstCount = PutDecisiveFirst(subset);
    float* ray = rays.data() + static_cast<std::size_t>(4) * this->Count * PixelOfRun(run, pattern);
    for (int i = 0; i < this->Count; ++i, ray += 4)
    {
      ray[0] = static_cast<float>(subset[i].U);
      ray[1] = static_cast<float>(subset[i].V);
      ray[2] = static_cast<float>(subset[i].Weight);
      ray[3] = StepJitter(i * runs + run);
    }
  }
  if (!this->Texture || this->Texture->GetContext() != window || this->Texture->GetHandle() == 0 ||
    rays != this->Rays)
  {
    const vtkShadowScopedPixelStore pixelStore;
    this->Rays = rays;
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
    this->Texture->SetContext(window);
    this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
    this->Texture->SetInternalFormat(GL_RGBA32F);
    this->Texture->SetFormat(GL_RGBA);
    this->Texture->SetDataType(GL_FLOAT);
    this->Texture->Create2DFromRaw(this->Count, runs, 4, VTK_FLOAT, rays.data());
    if (glGetError() == GL_OUT_OF_MEMORY)
    {
      vtkShadowFailures::Report("no memory for the directions of rays");
    }
  }
  return this->Unit.Bind(window, GL_TEXTURE_2D, this->Texture->GetHandle());
}

//------------------------------------------------------------------------------
void vtkMarchedRays::Deactivate()
{
  this->Unit.Release();
}

//------------------------------------------------------------------------------
void vtkMarchedRays::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
    this->Rays.clear();
  }
}
VTK_ABI_NAMESPACE_END
