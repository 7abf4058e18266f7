<!DOCTYPE PickedPoints>
<PickedPoints>
 <DocumentData>
  <DataFileName name="bunny.obj"/>
  <templateName name=""/>
 </DocumentData>
 <point x="0.100000" y="0.110000" z="0.469543" active="1" name="0"/>
 <point x="0.250000" y="0.225000" z="0.473064" active="1" name="1"/>
 <point x="0.430000" y="0.265000" z="0.462532" active="1" name="2"/>
 <point x="0.545000" y="0.110000" z="0.436417" active="1" name="3"/>
 <point x="0.420000" y="0.000000" z="0.512757" active="1" name="4"/>
 <point x="0.325000" y="0.080000" z="0.532522" active="1" name="5"/>
 <point x="0.400000" y="0.155000" z="0.537699" active="1" name="6"/>
</PickedPoints>
