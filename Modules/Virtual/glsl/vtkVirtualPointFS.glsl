//VTK::System::Dec
//VTK::Output::Dec

// Minimum blending keeps the finest wish and the widest kernel of a cell.

flat in vec4 wish;

void main()
{
  gl_FragData[0] = wish;
}
