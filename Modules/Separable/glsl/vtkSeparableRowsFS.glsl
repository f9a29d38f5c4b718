//VTK::System::Dec
//VTK::Output::Dec

// Step 1: each receiver's map coordinates, its hard shadow, and the middle row of its blocker search.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowLight
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowKernel
//SoftShadows::Include vtkShadowBlocker
//Separable::Rows

uniform mat4 viewToMap;
uniform int provedByFootprint; // 1: the pixels of this draw were proved lit or blocked

const float leastReach = 1e-12; // 0 says that there is no receiver

// Sum and number of the row's blockers, up to the node and beyond it.
vec4 searchRow(MapPoint point, float reach)
{
  vec4 row = vec4(0.0);
  vec2 halfRow = rowAxis * (scaleAlong(rowAxis) * reach);
  for (int i = 0; i < searchWidth; ++i)
  {
    float x = tapCoordinate(i, searchWidth);
    vec2 st = point.std.xy + x * halfRow;
    float depth = mapDepth(st, mapLayer);
    if (isBlocker(point, st, depth) && reaches(point, x * halfRow, depth))
    {
      vec2 blocker = lineWeight(x, rowAxis) * vec2(linearDepth(depth), 1.0);
      row += abs(x) < searchNode ? vec4(blocker, 0.0, 0.0) : vec4(0.0, 0.0, blocker);
    }
  }
  return row;
}

void main()
{
  Receiver receiver;
  if (!loadReceiver(ivec2(gl_FragCoord.xy), receiver) || !lightReaches(receiver.positionVs))
  {
    discard;
  }
  MapPoint point = toMap(viewToMap, receiver.positionVs, receiver.normalVs);
  bool blocked = isBlocked(point, point.std.xy, mapLayer);
  // No ray to the light meets a blocker where a pixel was proved lit.
  bool lit = provedByFootprint == 1 && !blocked && point.facesCenter;
  float reach = 0.0;
  vec4 row = vec4(0.0);
  if (!lit)
  {
    reach = searchReach(point);
    row = searchRow(point, reach);
  }
  gl_FragData[0] = vec4(point.std, (blocked ? -1.0 : 1.0) * max(reach, leastReach));
  gl_FragData[1] = row;
}
