<!DOCTYPE PickedPoints>
<PickedPoints>
 <DocumentData>
  <DataFileName name="bunny.obj"/>
  <templateName name=""/>
 </DocumentData>
 <point x="0.120000" y="0.330000" z="0.481696" active="1" name="0"/>
 <point x="0.085000" y="0.140000" z="0.472853" active="1" name="1"/>
 <point x="0.250000" y="0.235000" z="0.467142" active="1" name="2"/>
 <point x="0.430000" y="0.270000" z="0.460148" active="1" name="3"/>
 <point x="0.545000" y="0.110000" z="0.436417" active="1" name="4"/>
 <point x="0.420000" y="0.000000" z="0.512757" active="1" name="5"/>
 <point x="0.300000" y="0.100000" z="0.530656" active="1" name="6"/>
 <point x="0.400000" y="0.135000" z="0.541004" active="1" name="7"/>
</PickedPoints>
