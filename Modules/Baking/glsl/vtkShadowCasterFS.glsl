//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) SoftShadows contributors
// SPDX-License-Identifier: BSD-3-Clause
// Depth alone.

void main()
{
}
