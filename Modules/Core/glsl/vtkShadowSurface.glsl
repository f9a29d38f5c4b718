// Where filters on the screen stop. Needs vtkShadowReceiver.

// How far off the receiver's plane a tap may lie, as the sine of the angle seen from the receiver,
// and how far its normal may turn. Beyond them it belongs to something else.
const float planeLimit = 0.4;
const float leastCosine = 0.7;

// Whether a tap belongs to the receiver's surface: 1 on its plane, 0 beyond an edge or a crease.
float surfaceWeight(Receiver receiver, ivec2 pixel)
{
  vec3 positionVs;
  vec3 normalVs;
  if (!loadNeighbour(pixel, positionVs, normalVs))
  {
    return 0.0;
  }
  vec3 offset = positionVs - receiver.positionVs;
  float height = abs(dot(offset, receiver.normalVs)) / max(length(offset), 1e-30);
  float turn = (1.0 - dot(receiver.normalVs, normalVs)) / (1.0 - leastCosine);
  height /= planeLimit;
  return max(1.0 - height * height, 0.0) * max(1.0 - turn * turn, 0.0);
}
