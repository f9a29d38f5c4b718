//VTK::System::Dec
//VTK::Output::Dec

// A part of a light that nothing blocks.
uniform float weight;

void main()
{
  gl_FragData[0] = vec4(weight);
}
