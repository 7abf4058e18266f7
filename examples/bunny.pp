<!DOCTYPE PickedPoints>
<PickedPoints>
 <DocumentData>
  <DataFileName name="bunny.obj"/>
  <templateName name=""/>
 </DocumentData>
 <point x="0.120000" y="0.330000" z="0.481696" active="1" name="0"/>
 <point x="0.165000" y="0.185000" z="0.488207" active="1" name="1"/>
 <point x="0.290000" y="0.205000" z="0.490448" active="1" name="2"/>
 <point x="0.430000" y="0.265000" z="0.462532" active="1" name="3"/>
 <point x="0.545000" y="0.110000" z="0.436417" active="1" name="4"/>
 <point x="0.420000" y="0.000000" z="0.512757" active="1" name="5"/>
 <point x="0.325000" y="0.075000" z="0.531270" active="1" name="6"/>
 <point x="0.385000" y="0.145000" z="0.542499" active="1" name="7"/>
</PickedPoints>
