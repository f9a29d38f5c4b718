// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkTracedEmbree.h
 * @brief   The few calls whose form differs between Embree 3 and Embree 4. For sources only.
 *
 * Both hand a filter function the context of the query; vtkTracedContext is what a query's own data
 * derives from.
 */

#ifndef vtkTracedEmbree_h
#define vtkTracedEmbree_h

#ifdef SOFTSHADOWS_EMBREE_4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#ifdef SOFTSHADOWS_EMBREE_4

using vtkTracedContext = RTCRayQueryContext;

inline void vtkTracedInit(vtkTracedContext& context)
{
  rtcInitRayQueryContext(&context);
}

inline void vtkTracedOccluded8(
  const int* valid, RTCScene scene, vtkTracedContext& context, RTCRay8& rays)
{
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded8(valid, scene, &rays, &arguments);
}

#else

using vtkTracedContext = RTCIntersectContext;

inline void vtkTracedInit(vtkTracedContext& context)
{
  rtcInitIntersectContext(&context);
}

inline void vtkTracedOccluded8(
  const int* valid, RTCScene scene, vtkTracedContext& context, RTCRay8& rays)
{
  rtcOccluded8(valid, scene, &context, &rays);
}

#endif

#endif
