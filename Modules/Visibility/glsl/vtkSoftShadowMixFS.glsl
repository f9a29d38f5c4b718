//VTK::System::Dec
//VTK::Output::Dec

// A weighted sum of two visibilities; negative values of the first, no value, stay.

uniform sampler2DArray first;
uniform sampler2DArray second;
uniform float layer;
uniform vec2 shares;

void main()
{
  ivec3 pixel = ivec3(gl_FragCoord.xy, int(layer));
  float a = texelFetch(first, pixel, 0).r;
  // Sums of rounded weights may fall short of 0 by a few units in the last place.
  float mixed = shares.x * a + shares.y * texelFetch(second, pixel, 0).r;
  gl_FragData[0] = vec4(a < -0.5 ? -1.0 : mixed);
}
