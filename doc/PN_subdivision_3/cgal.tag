<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- Where the manual refers to CGAL's own: read by Doxygen outside of CGAL's documentation build. -->
<tagfile>
  <compound kind="group">
    <name>bgl_namedparameters</name>
    <title>Named Parameters</title>
    <filename>BGL/group__bgl__namedparameters.html</filename>
  </compound>
  <compound kind="page">
    <name>thirdparty</name>
    <title>Essential and Optional Third Party Dependencies</title>
    <filename>Manual/thirdparty.html</filename>
    <docanchor file="Manual/thirdparty.html" title="Eigen">thirdpartyEigen</docanchor>
    <docanchor file="Manual/thirdparty.html" title="Intel TBB">thirdpartyTBB</docanchor>
  </compound>
  <compound kind="page">
    <name>packages</name>
    <title>Package Overview</title>
    <filename>Manual/packages.html</filename>
    <docanchor file="Manual/packages.html" title="3D Surface Subdivision Methods">PkgSurfaceSubdivisionMethod3</docanchor>
  </compound>
</tagfile>
