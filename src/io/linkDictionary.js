/**
 * What links of version 1 take as known: most of what stands in every robot file, so that a link holds little but numbers and
 * names. It must stay as it is, to the last blank, for as long as links of version 1 are to be opened, which is for ever; it need
 * not be a file, nor follow what the writer writes today. What is most frequent stands last.
 */
const RARE = `<programs>
    <program id="main" language="karel">PROGRAM main
BEGIN
END main
</program>
    <program id="main" language="fanuc-tp">/PROG  MAIN
/MN
/POS
/END
    <program id="main" language="krl">DEF main()
END
  </programs>
  <extensions>
    <x:note xmlns:x="urn:
  </extensions>
<licence>MIT</licence><licence>BSD</licence><licence>Apache-2.0</licence><author></author>
    <description></description>
  lengthUnit="m" angleUnit="rad" convention="modified" lengthUnit="cm"
 thetaText="pi/2" dText="" aText="" alphaText="-pi/2" label="J1" label="J2" label="J3" label="J4" label="J5" label="J6"
 kind="box" width="" height="" kind="none" kind="cylinder" radius="" color="#
 acceleration="" jerk="" effort=""/>
      <controller sign="-1" offset="90" coupledTo="joint_2" coupling="-1"/>
      <controller offset="-90"/> quat_xyzw="0 0 0 1"/>
    </posture>
  <frames activeUser="" activeTool="">
    <userFrame id="user_1" number="1" xyz="0 0 0" rpy="0 0 0"/>
    <toolFrame id="tool_1" number="1" xyz="0 0 0" rpy="0 0 0"/>
  </frames>
  <targets>
    <target id="target_1" frame="" configuration="" xyz="" rpy="180 0 180"/>
    <target id="t1" xyz="0 0 0" rpy="0 0 0"/>
    <target id="t2" xyz="0 0 0" rpy="0 0 0"/>
  </targets>
`;

const COMMON = `UR5ABB IRB 120KUKA KR 6 R900Planar 3RSCARARobot<manufacturer>ABB</manufacturer><manufacturer>FANUC</manufacturer>
    <manufacturer>KUKA</manufacturer>
    <manufacturer>Universal Robots</manufacturer>
    <source>Robotics Toolbox for Python 1.5.0, models/DH/</source>
    <source>Corke, Robotics, Vision and Control, data sheet</source>
    <source>Craig, Introduction to Robotics, 3rd ed., section </source>
    <source>Spong, Hutchinson and Vidyasagar, Robot Modeling and Control, section </source>
    <source>; limits as Robotics Toolbox for Python 1.5.0</source>
    <source>Corke and Armstrong-Hélouvry, ICRA 1994, pp. 1608–1613, doi:10.1109/ROBOT.1994.351360
`;

/** A file, more or less: six joints as they often are. */
const TYPICAL = `<?xml version="1.0" encoding="UTF-8"?>
<robotModel xmlns="urn:denavit:robot-model:1" version="1.0" lengthUnit="mm" angleUnit="deg" convention="standard" generator="Denavit 0.1.0">
  <info>
    <name>Puma 560</name>
  </info>
  <base xyz="0 0 0" rpy="0 0 0"/>
  <tool xyz="0 0 100" rpy="0 0 0"/>
  <chain>
    <joint id="joint_1" type="prismatic">
      <dh theta="0" d="100" a="0" alpha="-90"/>
      <limits lower="0" upper="1000" home="500"/>
    </joint>
    <joint id="joint_1" type="continuous">
      <dh theta="0" d="671.83" a="431.8" alpha="90"/>
      <limits lower="-160" upper="160" home="0" velocity="180"/>
    </joint>
    <joint id="joint_1" type="revolute">
      <dh theta="90" d="0" a="400" alpha="-90"/>
      <limits lower="-185" upper="185" home="90"/>
    </joint>
    <joint id="joint_1" type="revolute">
      <dh theta="-90" d="0" a="0" alpha="180"/>
      <limits lower="-120" upper="120" home="-90"/>
    </joint>
    <joint id="joint_1" type="revolute">
      <dh theta="0" d="0" a="300" alpha="0"/>
      <limits lower="-170" upper="170" home="0"/>
    </joint>
    <joint id="joint_2" type="revolute">
      <dh theta="0" d="0" a="0" alpha="90"/>
      <limits lower="-360" upper="360" home="45"/>
    </joint>
    <joint id="joint_3" type="revolute">
      <dh theta="0" d="0" a="0" alpha="-90"/>
      <limits lower="-180" upper="180" home="-45"/>
    </joint>
    <joint id="joint_4" type="revolute">
      <dh theta="0" d="0" a="0" alpha="90"/>
      <limits lower="-180" upper="180" home="0"/>
    </joint>
    <joint id="joint_5" type="revolute">
      <dh theta="0" d="0" a="0" alpha="-90"/>
      <limits lower="-180" upper="180" home="0"/>
    </joint>
    <joint id="joint_6" type="revolute">
      <dh theta="0" d="0" a="0" alpha="0"/>
      <limits lower="-180" upper="180" home="0"/>
    </joint>
  </chain>
  <postures>
    <posture id="current" q="0 45 -90 0 45 0"/>
    <posture id="p1" q="0 0 0 0 0 0"/>
    <posture id="p2" q="0 -90 0 0 0 0"/>
    <posture id="current" q="0 0 0 0 0 0"/>
  </postures>
</robotModel>
`;

export const LINK_DICTIONARY = `${RARE}${COMMON}${TYPICAL}`;
