//VTK::System::Dec
//VTK::Output::Dec

// Sums over points of the emitter: the share of those in front of the receiver's plane, of those that
// it sees, and how much further than its blockers it is: what the light's size is multiplied by to
// get the width of the penumbra.

//SoftShadows::Include vtkShadowReceiver
//SoftShadows::Include vtkShadowDepthMap
//SoftShadows::Include vtkShadowSamples

uniform vec2 depthToLinears[SOFT_SHADOW_SAMPLES_PER_DRAW]; // positional: 1 / z = a + b d, else z
uniform int mapDirectional;
uniform float litWeight; // of the points that see everything
uniform float madeUp;    // what -1, no value, is made up by

void main()
{
  Receiver receiver;
  loadReceiver(ivec2(gl_FragCoord.xy), receiver);
  MapFrame frame = toFrame(viewToBase, receiver.positionVs, receiver.normalVs);
  float facing = litWeight;
  float visibility = litWeight;
  float reaches = 0.0;
  float behind = 0.0; // of the points behind the plane, those that nothing else hides
  for (int i = 0; i < sampleCount; ++i)
  {
    MapPoint point = toSampleMap(frame, i);
    float depth = mapDepth(point.std.xy, firstLayer + float(i));
    bool isHidden = isBlocker(point, point.std.xy, depth);
    // A plane that the camera sees from behind is its own blocker.
    if (!point.facesCenter)
    {
      behind += isHidden ? 0.0 : sampleWeights[i];
      continue;
    }
    facing += sampleWeights[i];
    if (!isHidden)
    {
      visibility += sampleWeights[i];
      continue;
    }
    // Positional: z_q / z_o - 1. Directional: z_q - z_o.
    float difference = depthToLinears[i].y * (point.std.z - depth);
    float reach = mapDirectional == 1
      ? difference
      : -difference / (depthToLinears[i].x + depthToLinears[i].y * point.std.z);
    reaches += sampleWeights[i] * max(reach, 0.0);
  }
  gl_FragData[0] = vec4(madeUp + facing, visibility, reaches, behind);
}
