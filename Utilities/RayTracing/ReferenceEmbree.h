// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReferenceEmbree.h
 * @brief The few calls whose form differs between Embree 3 and Embree 4.
 *
 * Both hand a filter function the context of the query; QueryContext is what a query's own data
 * derives from. For sources only.
 */

#ifndef SoftShadowsRayTracing_ReferenceEmbree_h
#define SoftShadowsRayTracing_ReferenceEmbree_h

#ifdef SOFTSHADOWS_EMBREE_4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace softshadows
{

#ifdef SOFTSHADOWS_EMBREE_4

using QueryContext = RTCRayQueryContext;

inline void InitQuery(QueryContext& context)
{
  rtcInitRayQueryContext(&context);
}

inline void Intersect(RTCScene scene, QueryContext& context, RTCRayHit& ray)
{
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect1(scene, &ray, &arguments);
}

inline void Occluded(RTCScene scene, QueryContext& context, RTCRay& ray)
{
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &ray, &arguments);
}

#else

using QueryContext = RTCIntersectContext;

inline void InitQuery(QueryContext& context)
{
  rtcInitIntersectContext(&context);
}

inline void Intersect(RTCScene scene, QueryContext& context, RTCRayHit& ray)
{
  rtcIntersect1(scene, &context, &ray);
}

inline void Occluded(RTCScene scene, QueryContext& context, RTCRay& ray)
{
  rtcOccluded1(scene, &context, &ray);
}

#endif

}

#endif
