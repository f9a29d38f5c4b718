// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TimeSeries.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataWriter.h"

#include <cmath>

namespace
{

double Drop(const double point[3], double x, double y, double z)
{
  const double center[3] = { x, y, z };
  return std::exp(-3.5 * vtkMath::Distance2BetweenPoints(point, center));
}

bool WriteStep(int step)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(41, 41, 25);
  image->SetOrigin(-2.0, -2.0, 0.0);
  image->SetSpacing(0.1, 0.1, 0.1);
  const vtkIdType count = image->GetNumberOfPoints();
  vtkNew<vtkFloatArray> density;
  density->SetName("density");
  density->SetNumberOfTuples(count);
  vtkNew<vtkFloatArray> velocity;
  velocity->SetName("velocity");
  velocity->SetNumberOfComponents(3);
  velocity->SetNumberOfTuples(count);
  const double phase = 0.5 * vtkMath::Pi() * step / NumberOfSteps;
  const double x = 0.62 * std::cos(phase);
  const double y = 0.62 * std::sin(phase);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double point[3];
    image->GetPoint(i, point);
    density->SetValue(
      i, static_cast<float>(Drop(point, x, y, 0.9 + 0.1 * step) + Drop(point, -x, -y, 1.3)));
    velocity->SetTuple3(i, -point[1], point[0], 0.3);
  }
  image->GetPointData()->SetScalars(density);
  image->GetPointData()->SetVectors(velocity);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(StepFile(step).c_str());
  return writer->Write() == 1;
}

} // namespace

std::string StepFile(int step)
{
  return "step" + std::to_string(step) + ".vti";
}

bool WriteTimeSeries()
{
  for (int step = 0; step < NumberOfSteps; ++step)
  {
    if (!WriteStep(step))
    {
      return false;
    }
  }
  return true;
}
