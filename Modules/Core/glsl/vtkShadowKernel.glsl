// A kernel of taps over the image of the emitter: n taps along an edge, window coordinates [-1, 1]^2.

uniform int emitterDisk;       // taps outside the unit circle do not belong to a disk
uniform int kernelGaussian;    // weights N(0, 0.5) over the whole light's window, else the mean
uniform vec4 emitterWindow;    // centre and half size of this emitter in the whole light's window

// Window coordinate of tap i of n: cell-centred, so that equal weights integrate the emitter.
float tapCoordinate(int i, int n)
{
  return (2.0 * float(i) + 1.0) / float(n) - 1.0;
}

// Zero for taps that are not part of the emitter.
float tapWeight(vec2 tap)
{
  if (emitterDisk == 1 && dot(tap, tap) > 1.0)
  {
    return 0.0;
  }
  vec2 window = emitterWindow.xy + emitterWindow.zw * tap;
  // exp(-x^2 / (2 sigma^2)), sigma = 0.5
  return kernelGaussian == 1 ? exp(-2.0 * dot(window, window)) : 1.0;
}
