#!/usr/bin/env python3
"""Writes an OpenFOAM case: one cell of a simple-cubic array of spheres, Stokes flow.

    make_case.py <folder> <c> <cells per edge> [relaxation of U]

Edge 1, density 1, kinematic viscosity 1, body force 1e-3 along x (Reynolds number < 1e-4).
"""
import math
import os
import sys

HEADER = 'FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n'


def write(case, path, kind, text):
    full = os.path.join(case, path)
    os.makedirs(os.path.dirname(full), exist_ok=True)
    with open(full, 'w') as f:
        f.write(HEADER.format(kind, os.path.basename(path)) + text)


def main():
    case, c, n = sys.argv[1], float(sys.argv[2]), int(sys.argv[3])
    relax = float(sys.argv[4]) if len(sys.argv) > 4 else 0.9
    radius = (3 * c / (4 * math.pi)) ** (1 / 3)

    # Vertices 0-7: bit 0 = x, bit 1 = y, bit 2 = z; the sphere sits in the middle.
    vertices = ' '.join(f'({i & 1} {i >> 1 & 1} {i >> 2 & 1})' for i in range(8))
    faces = {'x0': ('x1', '0 4 6 2'), 'x1': ('x0', '1 3 7 5'), 'y0': ('y1', '0 1 5 4'),
             'y1': ('y0', '2 6 7 3'), 'z0': ('z1', '0 2 3 1'), 'z1': ('z0', '4 5 7 6')}
    patches = ''.join(f'{name} {{ type cyclic; neighbourPatch {other}; faces (({face})); }}\n'
                      for name, (other, face) in faces.items())
    write(case, 'system/blockMeshDict', 'dictionary',
          f'vertices ({vertices});\n'
          f'blocks (hex (0 1 3 2 4 5 7 6) ({n} {n} {n}) simpleGrading (1 1 1));\n'
          f'edges ();\nboundary (\n{patches});\n')

    write(case, 'system/snappyHexMeshDict', 'dictionary', f'''
castellatedMesh true; snap true; addLayers false;
geometry {{ sphere {{ type searchableSphere; centre (0.5 0.5 0.5); radius {radius!r}; }} }}
castellatedMeshControls
{{
    maxLocalCells 10000000; maxGlobalCells 10000000; minRefinementCells 0;
    nCellsBetweenLevels 1; features (); resolveFeatureAngle 30; refinementRegions {{}};
    refinementSurfaces {{ sphere {{ level (0 0); }} }}
    locationInMesh (0.0123 0.0234 0.0345); allowFreeStandingZoneFaces true;
}}
snapControls
{{
    nSmoothPatch 3; tolerance 2.0; nSolveIter 50; nRelaxIter 5; nFeatureSnapIter 0;
}}
addLayersControls {{ layers {{}} relativeSizes true; expansionRatio 1; finalLayerThickness 0.3;
    minThickness 0.1; nGrow 0; featureAngle 60; nRelaxIter 3; nSmoothSurfaceNormals 1;
    nSmoothNormals 3; nSmoothThickness 10; maxFaceThicknessRatio 0.5;
    maxThicknessToMedialRatio 0.3; minMedianAxisAngle 90; nBufferCellsNoExtrude 0; nLayerIter 50; }}
meshQualityControls
{{
    maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80;
    minVol 1e-30; minTetQuality 1e-30; minArea -1; minTwist 0.02; minDeterminant 0.001;
    minFaceWeight 0.02; minVolRatio 0.01; minTriangleTwist -1; nSmoothScale 4;
    errorReduction 0.75;
}}
mergeTolerance 1e-6;
''')
    write(case, 'system/controlDict', 'dictionary', '''
application simpleFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 4000;
deltaT 1; writeControl timeStep; writeInterval 100000; timePrecision 8;
runTimeModifiable false;
functions
{
    flux
    {
        type volFieldValue; libs (fieldFunctionObjects); fields (U);
        operation volIntegrate; regionType all; writeFields false; log true;
        writePrecision 12;
    }
}
''')
    write(case, 'system/fvSchemes', 'dictionary', '''
ddtSchemes { default steadyState; }
gradSchemes { default leastSquares; }
divSchemes { default none; div(phi,U) Gauss linear;
    div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
''')
    write(case, 'system/fvSolution', 'dictionary', f'''
solvers
{{
    p {{ solver PCG; preconditioner {{ preconditioner GAMG; smoother GaussSeidel;
         tolerance 1e-12; relTol 0; nVcycles 1; }} tolerance 1e-14; relTol 0.01; }}
    U {{ solver PBiCGStab; preconditioner DILU; tolerance 1e-14; relTol 0.01; }}
}}
SIMPLE
{{
    consistent yes; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0;
}}
relaxationFactors {{ equations {{ U {relax}; }} fields {{ p 1; }} }}
''')
    write(case, 'constant/transportProperties', 'dictionary',
          'transportModel Newtonian;\nnu 1;\n')
    write(case, 'constant/turbulenceProperties', 'dictionary', 'simulationType laminar;\n')
    write(case, 'constant/fvOptions', 'dictionary', '''
drive
{
    type vectorSemiImplicitSource; selectionMode all; volumeMode specific;
    injectionRateSuSp { U ((1e-3 0 0) 0); }
}
''')
    cyclic = '"[xyz][01]" { type cyclic; }'
    write(case, '0/U', 'volVectorField',
          'dimensions [0 1 -1 0 0 0 0];\ninternalField uniform (0 0 0);\n'
          f'boundaryField {{ {cyclic} sphere {{ type noSlip; }} }}\n')
    write(case, '0/p', 'volScalarField',
          'dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\n'
          f'boundaryField {{ {cyclic} sphere {{ type zeroGradient; }} }}\n')


if __name__ == '__main__':
    main()
