// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ReferenceSource.h"

#include "ReferenceTracer.h"

#include <utility> // For std::move

namespace softshadows
{

//--------------------------------------------------------------------------------------------------
VisibilityImage TraceReference(vtkRenderer* renderer, const ReferenceRequest& request,
  const std::function<void(double)>& progress)
{
  ReferenceTracer tracer(request.Width, request.Height, request.SamplesPerAxis);
  tracer.SetGaussian(request.Gaussian);
  tracer.SetProgress(progress);
  ReferenceVisibility traced = tracer.Trace(renderer);
  return { request.Width, request.Height, std::move(traced.Visibility), std::move(traced.Depth) };
}

}
