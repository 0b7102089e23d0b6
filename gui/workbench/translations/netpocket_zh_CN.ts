<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>CameraNames</name>
    <message>
        <source>Oblique</source>
        <translation>斜视</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧视</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正视</translation>
    </message>
    <message>
        <source>Mouth</source>
        <translation>网口</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>From the side and a little ahead</source>
        <translation>从侧面稍偏前方</translation>
    </message>
    <message>
        <source>Square to the pocket&apos;s axis, without perspective</source>
        <translation>垂直于网袋轴线，无透视</translation>
    </message>
    <message>
        <source>Along the axis into the mouth, without perspective</source>
        <translation>沿轴线看向网口，无透视</translation>
    </message>
    <message>
        <source>Obliquely into the mouth</source>
        <translation>斜向看入网口</translation>
    </message>
    <message>
        <source>Oblique, moving with the target</source>
        <translation>斜视，随目标移动</translation>
    </message>
</context>
<context>
    <name>DisturbanceWords</name>
    <message>
        <source>the spacecraft</source>
        <translation>服务航天器</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>about</source>
        <translation>绕</translation>
    </message>
    <message>
        <source>along</source>
        <translation>沿</translation>
    </message>
    <message>
        <source>%1 %2 %3 %4 on %5 for %6 s</source>
        <translation>%5受%3 %4 轴 %1 %2，持续 %6 s</translation>
    </message>
</context>
<context>
    <name>ImagePresenter</name>
    <message>
        <source>images drawn on a thread of their own</source>
        <translation>在单独的线程中绘制图像</translation>
    </message>
</context>
<context>
    <name>Language</name>
    <message>
        <source>The preferences ask for the language “%1”, which this program does not speak, so the system&apos;s is taken; there are: %2.</source>
        <translation>首选项要求的语言“%1”本程序不支持，因此采用系统语言；可用的有：%2。</translation>
    </message>
    <message>
        <source>No installed font has the letters of the language %1, so the window speaks English; on Debian the packages fonts-wqy-microhei and fonts-noto-cjk have Chinese ones.</source>
        <translation>已安装的字体都没有语言 %1 的文字，因此窗口使用英语；在 Debian 上，软件包 fonts-wqy-microhei 和 fonts-noto-cjk 含有中文字体。</translation>
    </message>
    <message>
        <source>English</source>
        <extracomment>To be translated by what the language calls itself</extracomment>
        <translation>简体中文</translation>
    </message>
</context>
<context>
    <name>LoopReading</name>
    <message>
        <source>waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>active</source>
        <translation>作用中</translation>
    </message>
    <message>
        <source>over</source>
        <translation>已结束</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>jammed</source>
        <translation>卡死</translation>
    </message>
</context>
<context>
    <name>ParameterWords</name>
    <message>
        <source>Used for spheres and cylinders.</source>
        <translation>用于球体和圆柱体。</translation>
    </message>
    <message>
        <source>Used for boxes and satellites.</source>
        <translation>用于长方体和卫星。</translation>
    </message>
    <message>
        <source>Used for cylinders.</source>
        <translation>用于圆柱体。</translation>
    </message>
    <message>
        <source>Used for satellites.</source>
        <translation>用于卫星。</translation>
    </message>
    <message>
        <source>Used for meshes.</source>
        <translation>用于网格模型。</translation>
    </message>
    <message>
        <source>Used when inertia is given, not the shape&apos;s.</source>
        <translation>在惯量直接给定（而非由形状计算）时使用。</translation>
    </message>
    <message>
        <source>Used by the law “table”.</source>
        <translation>用于规律“table”。</translation>
    </message>
    <message>
        <source>Not used by the law “table”.</source>
        <translation>规律“table”不使用此项。</translation>
    </message>
    <message>
        <source>Used when the step is chosen, time step 0.</source>
        <translation>在自动选择步长（时间步长为 0）时使用。</translation>
    </message>
    <message>
        <source>Used with a perturbation.</source>
        <translation>在有随机扰动时使用。</translation>
    </message>
    <message>
        <source>Not used by this kind of controller.</source>
        <translation>此类控制器不使用此项。</translation>
    </message>
    <message>
        <source>Used for the separation.</source>
        <translation>用于间距。</translation>
    </message>
    <message>
        <source>Not used by the drive “prescribed”.</source>
        <translation>驱动方式“prescribed”不使用此项。</translation>
    </message>
    <message>
        <source>Not used by this drive.</source>
        <translation>此驱动方式不使用此项。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n 个点</numerusform>
        </translation>
    </message>
    <message>
        <source>Allowed: %1</source>
        <translation>允许范围：%1</translation>
    </message>
    <message>
        <source>Unit: %1</source>
        <translation>单位：%1</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>来源：%1</translation>
    </message>
    <message>
        <source>Key: %1</source>
        <translation>键名：%1</translation>
    </message>
    <message>
        <source>Used when the mode is not “none”.</source>
        <translation>在模式不是“none”时使用。</translation>
    </message>
    <message>
        <source>Used with friction.</source>
        <translation>在有摩擦时使用。</translation>
    </message>
    <message>
        <source>Used when the model is not “off”.</source>
        <translation>在模型不是“off”时使用。</translation>
    </message>
    <message>
        <source>Not used by this start.</source>
        <translation>此触发条件不使用此项。</translation>
    </message>
    <message>
        <source>Used with a tether.</source>
        <translation>在有系绳时使用。</translation>
    </message>
    <message>
        <source>Used with a winch.</source>
        <translation>在有绞车时使用。</translation>
    </message>
    <message>
        <source>Not used with a winch.</source>
        <translation>有绞车时不使用。</translation>
    </message>
    <message>
        <source>Used with a drawstring.</source>
        <translation>在有束口绳时使用。</translation>
    </message>
    <message>
        <source>Used with rings.</source>
        <translation>在束口绳穿环时使用。</translation>
    </message>
</context>
<context>
    <name>PartPresets</name>
    <message>
        <source>%1 rods, meshes %2 × %3, tip at %4 m</source>
        <translation>%1 根充气杆，网目 %2 × %3，杆端位于 %4 m</translation>
    </message>
    <message>
        <source>closing: %1, %2; towing: %3 from %4</source>
        <translation>收口：%1，%2；拖曳：%3，自 %4 起</translation>
    </message>
</context>
<context>
    <name>PickDescription</name>
    <message>
        <source>Element of %1, no. %2</source>
        <translation>%1的单元，编号 %2</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>张力</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>应变</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>Node %1</source>
        <translation>节点 %1</translation>
    </message>
    <message>
        <source>Largest tension</source>
        <translation>最大张力</translation>
    </message>
    <message>
        <source>Rigid body, %1</source>
        <translation>刚体，%1</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>质心</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>角速度</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>接触点数</translation>
    </message>
    <message>
        <source>Contact force</source>
        <translation>接触力</translation>
    </message>
</context>
<context>
    <name>PickedSeries</name>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Position (m)</source>
        <translation>位置 (m)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>Speed (m/s)</source>
        <translation>速率 (m/s)</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>张力</translation>
    </message>
    <message>
        <source>Tension (N)</source>
        <translation>张力 (N)</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>应变</translation>
    </message>
    <message>
        <source>Time *t* (s)</source>
        <translation>时间 *t* (s)</translation>
    </message>
</context>
<context>
    <name>PointWords</name>
    <message>
        <source>not judged</source>
        <translation>未判定</translation>
    </message>
    <message>
        <source>captured</source>
        <translation>已捕获</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>未捕获</translation>
    </message>
    <message>
        <source>&lt;b&gt;Point %1&lt;/b&gt;: %2</source>
        <translation>&lt;b&gt;样本点 %1&lt;/b&gt;：%2</translation>
    </message>
    <message>
        <source>No capture has been judged yet.</source>
        <translation>还没有已判定的捕获。</translation>
    </message>
    <message>
        <source>Probability of capture &lt;b&gt;%1&lt;/b&gt;, 95 % interval %2 to %3: %4 of %5 captured</source>
        <translation>捕获概率 &lt;b&gt;%1&lt;/b&gt;，95 % 区间 %2 至 %3：%5 次中捕获 %4 次</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 小时 %2 分钟</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save All</source>
        <translation>全部保存</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>是(&amp;Y)</translation>
    </message>
    <message>
        <source>Yes to &amp;All</source>
        <translation>全部选是(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>否(&amp;N)</translation>
    </message>
    <message>
        <source>N&amp;o to All</source>
        <translation>全部选否(&amp;O)</translation>
    </message>
    <message>
        <source>Abort</source>
        <translation>中止</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Ignore</source>
        <translation>忽略</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Restore Defaults</source>
        <translation>恢复默认值</translation>
    </message>
</context>
<context>
    <name>ScenarioDifference</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Capture system</source>
        <translation>捕获系统</translation>
    </message>
</context>
<context>
    <name>TimeMark</name>
    <message>
        <source>First contact</source>
        <translation>首次接触</translation>
    </message>
    <message>
        <source>Peak contact force, %1 N</source>
        <translation>接触力峰值，%1 N</translation>
    </message>
    <message>
        <source>Disturbance: %1</source>
        <translation>扰动：%1</translation>
    </message>
    <message>
        <source>%1 starts</source>
        <translation>%1开始</translation>
    </message>
    <message>
        <source>%1 ends</source>
        <translation>%1结束</translation>
    </message>
</context>
<context>
    <name>engine</name>
    <message>
        <source>panel %1 kink row</source>
        <translation>网面 %1 折点行</translation>
    </message>
    <message>
        <source>panel %1 mouth row</source>
        <translation>网面 %1 网口行</translation>
    </message>
    <message>
        <source>panel %1 lower row %2</source>
        <translation>网面 %1 下部第 %2 行</translation>
    </message>
    <message>
        <source>panel %1 upper row %2</source>
        <translation>网面 %1 上部第 %2 行</translation>
    </message>
    <message>
        <source>panel %1 column %2</source>
        <translation>网面 %1 第 %2 列</translation>
    </message>
    <message>
        <source>panel %1 diagonal %2 along its first rod</source>
        <translation>网面 %1 沿第一根杆的斜绳 %2</translation>
    </message>
    <message>
        <source>panel %1 diagonal %2 along its second rod</source>
        <translation>网面 %1 沿第二根杆的斜绳 %2</translation>
    </message>
    <message>
        <source>closing rope %1</source>
        <translation>收口绳 %1</translation>
    </message>
    <message>
        <source>a closing rope</source>
        <translation>收口绳</translation>
    </message>
    <message>
        <source>a rod</source>
        <translation>充气杆</translation>
    </message>
    <message>
        <source>the net</source>
        <translation>绳网</translation>
    </message>
    <message>
        <source>net</source>
        <translation>绳网</translation>
    </message>
    <message>
        <source>rods</source>
        <translation>充气杆</translation>
    </message>
    <message>
        <source>closing ropes</source>
        <translation>收口绳</translation>
    </message>
    <message>
        <source>corner threads</source>
        <translation>角部连接绳</translation>
    </message>
    <message>
        <source>corner thread %1</source>
        <translation>角部连接绳 %1</translation>
    </message>
    <message>
        <source>a corner thread</source>
        <translation>角部连接绳</translation>
    </message>
    <message>
        <source>the drawstring</source>
        <translation>束口绳</translation>
    </message>
    <message>
        <source>the tether</source>
        <translation>系绳</translation>
    </message>
    <message>
        <source>drawstring</source>
        <translation>束口绳</translation>
    </message>
    <message>
        <source>drawstring %1</source>
        <translation>束口绳 %1</translation>
    </message>
    <message>
        <source>tether</source>
        <translation>系绳</translation>
    </message>
    <message>
        <source>spacecraft</source>
        <translation>服务航天器</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>corner mass %1</source>
        <translation>角质量块 %1</translation>
    </message>
    <message>
        <source>open</source>
        <translation>张开</translation>
    </message>
    <message>
        <source>closing</source>
        <translation>收口</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>收拢</translation>
    </message>
    <message>
        <source>towing</source>
        <translation>拖曳</translation>
    </message>
    <message>
        <source>after towing</source>
        <translation>拖曳之后</translation>
    </message>
    <message>
        <source>Attitude PD</source>
        <translation>姿态 PD</translation>
    </message>
    <message>
        <source>Attitude sliding mode</source>
        <translation>姿态滑模</translation>
    </message>
    <message>
        <source>Attitude double loop</source>
        <translation>姿态双回路</translation>
    </message>
    <message>
        <source>Position PD</source>
        <translation>位置 PD</translation>
    </message>
    <message>
        <source>Position sliding mode</source>
        <translation>位置滑模</translation>
    </message>
    <message>
        <source>Spin damping</source>
        <translation>消旋</translation>
    </message>
    <message>
        <source>Tow</source>
        <translation>拖曳</translation>
    </message>
    <message>
        <source>Attitude PD %1</source>
        <translation>姿态 PD %1</translation>
    </message>
    <message>
        <source>Attitude sliding mode %1</source>
        <translation>姿态滑模 %1</translation>
    </message>
    <message>
        <source>Attitude double loop %1</source>
        <translation>姿态双回路 %1</translation>
    </message>
    <message>
        <source>Position PD %1</source>
        <translation>位置 PD %1</translation>
    </message>
    <message>
        <source>Position sliding mode %1</source>
        <translation>位置滑模 %1</translation>
    </message>
    <message>
        <source>Spin damping %1</source>
        <translation>消旋 %1</translation>
    </message>
    <message>
        <source>Tow %1</source>
        <translation>拖曳 %1</translation>
    </message>
    <message>
        <source>Winch %1</source>
        <translation>绞车 %1</translation>
    </message>
    <message>
        <source>attitude</source>
        <translation>姿态</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>angular velocity</source>
        <translation>角速度</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>separation</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>rate</source>
        <translation>收绳速率</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>张力</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>力矩</translation>
    </message>
    <message>
        <source>length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>%1, and bends of cords; shortened for contacts pressed deep</source>
        <translation>%1，以及绳的弯折；因深度压入的接触而缩短</translation>
    </message>
    <message>
        <source>%1, and bends of cords; shortened to keep account of the energy of short waves</source>
        <translation>%1，以及绳的弯折；为计入短波能量而缩短</translation>
    </message>
    <message>
        <source>%1; shortened for contacts pressed deep</source>
        <translation>%1；因深度压入的接触而缩短</translation>
    </message>
    <message>
        <source>%1; shortened to keep account of the energy of short waves</source>
        <translation>%1；为计入短波能量而缩短</translation>
    </message>
    <message>
        <source>%1, and bends of cords</source>
        <translation>%1，以及绳的弯折</translation>
    </message>
    <message>
        <source>axial waves in %1</source>
        <translation>%1的轴向波</translation>
    </message>
    <message>
        <source>bending waves in %1</source>
        <translation>%1的弯曲波</translation>
    </message>
    <message>
        <source>waves in the %1, the shorter the faster</source>
        <translation>%1中的波，越短越快</translation>
    </message>
    <message>
        <source>the full element&apos;s stiffness in %1</source>
        <translation>%1的完整单元刚度</translation>
    </message>
    <message>
        <source>the cables</source>
        <translation>索</translation>
    </message>
    <message>
        <source>a rod&apos;s kink</source>
        <translation>充气杆折点</translation>
    </message>
    <message>
        <source>a tension line</source>
        <translation>张力线</translation>
    </message>
    <message>
        <source>nothing moves</source>
        <translation>无运动部件</translation>
    </message>
    <message>
        <source>reached the time asked for</source>
        <translation>已到达要求的时刻</translation>
    </message>
    <message>
        <source>reached the requested time</source>
        <translation>已到达要求的时刻</translation>
    </message>
    <message>
        <source>stopped on request</source>
        <translation>按要求停止</translation>
    </message>
    <message>
        <source>reached the end time</source>
        <translation>已到达结束时刻</translation>
    </message>
    <message>
        <source>reached the end time; %1</source>
        <translation>已到达结束时刻；%1</translation>
    </message>
    <message>
        <source>%1 in step %2 of %3, at t = %4 s; %5</source>
        <translation>%1，第 %2 步（步长 %3），t = %4 s；%5</translation>
    </message>
    <message>
        <source>%1 (element %2), in contact with the %3, moves at %4</source>
        <translation>%1（单元 %2，与%3接触）以 %4 运动</translation>
    </message>
    <message>
        <source>%1 (element %2) moves at %3</source>
        <translation>%1（单元 %2）以 %3 运动</translation>
    </message>
    <message>
        <source>%1 (element %2) is pressed %3 m into the %4</source>
        <translation>%1（单元 %2）压入%4达 %3 m</translation>
    </message>
    <message>
        <source>the %1 moves at %2</source>
        <translation>%1以 %2 运动</translation>
    </message>
    <message>
        <source>try a solver.time_step below %1 s</source>
        <translation>请尝试小于 %1 s 的 solver.time_step</translation>
    </message>
    <message>
        <source>try solver.safety below %1</source>
        <translation>请尝试小于 %1 的 solver.safety</translation>
    </message>
    <message>
        <source>the likely cause is winch.rate_gain, which makes the motors&apos; loop unstable for these drums above %1 N s/m</source>
        <translation>可能的原因是 winch.rate_gain：对这些卷筒，超过 %1 N s/m 时电机回路失稳</translation>
    </message>
    <message>
        <source>the closing never started, since %1; nor did the towing</source>
        <translation>收口从未开始，因为%1；拖曳也未开始</translation>
    </message>
    <message>
        <source>the closing never started, since %1</source>
        <translation>收口从未开始，因为%1</translation>
    </message>
    <message>
        <source>spacecraft and target came no nearer than %1 m from %2 s on</source>
        <translation>自 %2 s 起，服务航天器与目标的距离从未小于 %1 m</translation>
    </message>
    <message>
        <source>spacecraft and target came no nearer than %1 m</source>
        <translation>服务航天器与目标的距离从未小于 %1 m</translation>
    </message>
    <message>
        <source>the target was never inside the pocket from %1 s on</source>
        <translation>自 %1 s 起，目标从未进入网袋</translation>
    </message>
    <message>
        <source>the target was never inside the pocket</source>
        <translation>目标从未进入网袋</translation>
    </message>
    <message>
        <source>the towing never started, since the mouth is closed at %1 s only</source>
        <translation>拖曳从未开始，因为网口到 %1 s 才收拢</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>a run that was opened from a file cannot be continued</source>
        <translation>从文件打开的仿真不能继续</translation>
    </message>
    <message>
        <source>it can be disturbed %1 times</source>
        <translation>最多可施加 %1 次扰动</translation>
    </message>
    <message>
        <source>acts from a restart only</source>
        <translation>重新开始后才起作用</translation>
    </message>
    <message>
        <source>the run diverged at t = %1 s</source>
        <translation>仿真在 t = %1 s 发散</translation>
    </message>
    <message>
        <source>this kind of capture system has no channel that says so</source>
        <translation>此类捕获系统没有说明捕获与否的通道</translation>
    </message>
    <message>
        <source>the run is shorter than 1 s</source>
        <translation>仿真短于 1 s</translation>
    </message>
    <message>
        <source>the target is not held at t = %1 s</source>
        <translation>t = %1 s 时目标未被抓牢</translation>
    </message>
    <message>
        <source>the recording does not say when the closing ends</source>
        <translation>记录没有说明收口何时结束</translation>
    </message>
    <message>
        <source>target outside the pocket at t = %1 s</source>
        <translation>t = %1 s 时目标在网袋之外</translation>
    </message>
    <message>
        <source>mouth open by %1 m at t = %2 s</source>
        <translation>t = %2 s 时网口张开 %1 m</translation>
    </message>
    <message>
        <source>run ends at t = %1 s, before %2 at %3 s</source>
        <translation>仿真止于 t = %1 s，早于 %3 s（%2）</translation>
    </message>
    <message>
        <source>run ends at t = %1 s, before %2 s</source>
        <translation>仿真止于 t = %1 s，早于 %2 s</translation>
    </message>
    <message>
        <source>run ends at t = %1 s, when %2</source>
        <translation>仿真止于 t = %1 s，即%2之时</translation>
    </message>
    <message>
        <source>the closing is over</source>
        <translation>收口结束</translation>
    </message>
    <message>
        <source>the first second of towing is over</source>
        <translation>拖曳满一秒</translation>
    </message>
    <message>
        <source>the scenario has no towing</source>
        <translation>场景中没有拖曳</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>未定</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>diverged</source>
        <translation>发散</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>无接触</translation>
    </message>
    <message>
        <source>no contact before the closing ends</source>
        <translation>收口结束前无接触</translation>
    </message>
    <message>
        <source>the recording has no rods with kinks</source>
        <translation>记录中没有带折点的充气杆</translation>
    </message>
    <message>
        <source>the recording has no contact points</source>
        <translation>记录中没有接触点</translation>
    </message>
    <message>
        <source>peaks |F_x| %1 N, |F_y| %2 N, |F_z| %3 N</source>
        <translation>峰值 |F_x| %1 N，|F_y| %2 N，|F_z| %3 N</translation>
    </message>
    <message>
        <source>|F| peaks with %1 N at t = %2 s, closing ends at %3 s</source>
        <translation>|F| 峰值 %1 N，t = %2 s；收口结束于 %3 s</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1，另有 %2 次</translation>
    </message>
    <message>
        <source>%1), %2</source>
        <translation>%1），%2</translation>
    </message>
    <message>
        <source>%1 N s from t = %2 s (%3 % mouth, %4 % kink row, %5 % cone; y = %6 m</source>
        <translation>%1 N s，自 t = %2 s（网口 %3 %，折点行 %4 %，锥段 %5 %；y = %6 m</translation>
    </message>
    <message>
        <source>%1 N s from t = %2 s (%3 % mouth, %4 % kink row, %5 % cone; y = %6 m)</source>
        <translation>%1 N s，自 t = %2 s（网口 %3 %，折点行 %4 %，锥段 %5 %；y = %6 m）</translation>
    </message>
    <message>
        <source>before contact target %1 m, spacecraft %2 m; then in y target %3 m, spacecraft %4 m</source>
        <translation>接触前目标 %1 m，服务航天器 %2 m；其后沿 y 目标 %3 m，服务航天器 %4 m</translation>
    </message>
    <message>
        <source>|F_y| peaks %1 N before, %2 N in towing; contact in %3 % of the frames</source>
        <translation>|F_y| 峰值：拖曳前 %1 N，拖曳中 %2 N；%3 % 的帧有接触</translation>
    </message>
    <message>
        <source>separation changes by %1 m while the spacecraft moves %2 m</source>
        <translation>间距变化 %1 m，其间服务航天器移动 %2 m</translation>
    </message>
    <message>
        <source>target %1 m, spacecraft %2 m</source>
        <translation>目标 %1 m，服务航天器 %2 m</translation>
    </message>
    <message>
        <source>inside until t = %1 s</source>
        <translation>直到 t = %1 s 都在网袋内</translation>
    </message>
    <message>
        <source>closing ends at %1 s: first contact at %2 s</source>
        <translation>收口结束于 %1 s：首次接触在 %2 s</translation>
    </message>
    <message>
        <source>closing ends at %1 s: peak |F_y| %2 N; %3</source>
        <translation>收口结束于 %1 s：|F_y| 峰值 %2 N；%3</translation>
    </message>
    <message>
        <source>closing ends at %1 s: peak |F_y| %2 N</source>
        <translation>收口结束于 %1 s：|F_y| 峰值 %2 N</translation>
    </message>
    <message>
        <source>one draw decides nothing</source>
        <translation>单次抽样不能判定</translation>
    </message>
    <message>
        <source>largest of |F_x|, |F_z|: %1 N before closing ends; |F_x| %2 N, |F_z| %3 N after; peak |F_y| %4 N</source>
        <translation>|F_x|、|F_z| 中较大者：收口结束前 %1 N；结束后 |F_x| %2 N，|F_z| %3 N；|F_y| 峰值 %4 N</translation>
    </message>
    <message>
        <source>each number must be %1, not %2</source>
        <translation>每个数必须 %1，而不是 %2</translation>
    </message>
    <message>
        <source>must be finite, not %1</source>
        <translation>必须是有限数，而不是 %1</translation>
    </message>
    <message>
        <source>has %1 characters, allowed are %2</source>
        <translation>有 %1 个字符，允许 %2</translation>
    </message>
    <message>
        <source>%1 to %2 characters</source>
        <translation>%1 至 %2 个字符</translation>
    </message>
    <message>
        <source>must be shorter than the %1 m between the open tips, not %2 m</source>
        <translation>必须小于张开时杆端间的 %1 m，而不是 %2 m</translation>
    </message>
    <message>
        <source>must be shorter than the side of %1 m, not %2 m</source>
        <translation>必须小于边长 %1 m，而不是 %2 m</translation>
    </message>
    <message>
        <source>must be below rods.pressure = %1 Pa, or there is nothing to let out</source>
        <translation>必须低于 rods.pressure = %1 Pa，否则无气可放</translation>
    </message>
    <message>
        <source>must be later than target.acts_from = %1 s, or thrust and torque never act</source>
        <translation>必须晚于 target.acts_from = %1 s，否则推力和力矩从不作用</translation>
    </message>
    <message>
        <source>must be %1, not %2</source>
        <translation>必须 %1，而不是 %2</translation>
    </message>
    <message>
        <source>&gt;= %1 and &lt;= %2</source>
        <translation>&gt;= %1 且 &lt;= %2</translation>
    </message>
    <message>
        <source>&gt; %1 and &lt;= %2</source>
        <translation>&gt; %1 且 &lt;= %2</translation>
    </message>
    <message>
        <source>expects %1, not %2; did you mean %3?</source>
        <translation>应为%1，而不是 %2；您是指 %3 吗？</translation>
    </message>
    <message>
        <source>expects %1, not %2</source>
        <translation>应为%1，而不是 %2</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>text in quotes</source>
        <translation>带引号的文本</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>%1 之一</translation>
    </message>
    <message>
        <source>a list of three numbers [x, y, z]</source>
        <translation>三个数的列表 [x, y, z]</translation>
    </message>
    <message>
        <source>a list of pairs of numbers [[a, b], ...]</source>
        <translation>数对的列表 [[a, b], ...]</translation>
    </message>
    <message>
        <source>the text %1</source>
        <translation>文本 %1</translation>
    </message>
    <message>
        <source>a list of %1</source>
        <translation>%1的列表</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>a date or time</source>
        <translation>日期或时间</translation>
    </message>
    <message>
        <source>is not %1; did you mean &apos;%2&apos;?</source>
        <translation>不是%1；您是指 &apos;%2&apos; 吗？</translation>
    </message>
    <message>
        <source>is not %1; scenarios/REFERENCE.md lists them all</source>
        <translation>不是%1；全部名称见 scenarios/REFERENCE.md</translation>
    </message>
    <message>
        <source>a table of a scenario</source>
        <translation>场景中的表</translation>
    </message>
    <message>
        <source>a parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>is a table: write [%1] and its keys on the lines below</source>
        <translation>是一个表：请写 [%1]，并在其下各行写它的键</translation>
    </message>
    <message>
        <source>is a list of tables: write [[%1]] and the keys of each on the lines below</source>
        <translation>是表的列表：请写 [[%1]]，并在其下各行写每一项的键</translation>
    </message>
    <message>
        <source>has %1 tables; %2 are allowed</source>
        <translation>有 %1 个表；最多允许 %2 个</translation>
    </message>
    <message>
        <source>%1 more problems</source>
        <translation>还有 %1 个问题</translation>
    </message>
    <message>
        <source>a wall of %1 m does not fit into the outer radius %2 m</source>
        <translation>%1 m 的壁厚超出外半径 %2 m</translation>
    </message>
    <message>
        <source>needs exactly three points (root, kink, tip), not %1</source>
        <translation>恰好需要三个点（根部、折点、杆端），而不是 %1 个</translation>
    </message>
    <message>
        <source>a rod %1 m from the axis is nearer than its diameter %2 m</source>
        <translation>充气杆距轴线 %1 m，小于其直径 %2 m</translation>
    </message>
    <message>
        <source>the heights of root, kink and tip must increase, not go %1, %2, %3 m</source>
        <translation>根部、折点和杆端的高度必须递增，而不是 %1、%2、%3 m</translation>
    </message>
    <message>
        <source>%1 rods %2 m from the axis intersect: their axes are %3 m apart, less than their diameter %4 m</source>
        <translation>距轴线 %2 m 的 %1 根充气杆相交：轴线间距 %3 m，小于直径 %4 m</translation>
    </message>
    <message>
        <source>rods, rows, columns and elements_per_side make up to %1 elements; %2 are allowed</source>
        <translation>充气杆数、行数、列数和 elements_per_side 共产生多达 %1 个单元；最多允许 %2 个</translation>
    </message>
    <message>
        <source>elements of %1 m are shorter than the cord is thick; use fewer or thinner cords</source>
        <translation>%1 m 的单元比绳的直径还短；请减少单元数或用更细的绳</translation>
    </message>
    <message>
        <source>elements of %1 m are shorter than the cord is thick</source>
        <translation>%1 m 的单元比绳的直径还短</translation>
    </message>
    <message>
        <source>a rope of %1 m has elements shorter than it is thick; at least %2 m are needed</source>
        <translation>%1 m 的绳，其单元比绳的直径还短；至少需要 %2 m</translation>
    </message>
    <message>
        <source>the law &quot;table&quot; needs at least two points [time after start, length]</source>
        <translation>规律 &quot;table&quot; 至少需要两个点 [开始后的时间, 长度]</translation>
    </message>
    <message>
        <source>must start at time 0, not %1 s</source>
        <translation>必须从时间 0 开始，而不是 %1 s</translation>
    </message>
    <message>
        <source>must start with the %1 m between the open tips (to 1 %), not %2 m</source>
        <translation>必须从张开时杆端间的 %1 m 开始（误差 1 % 以内），而不是 %2 m</translation>
    </message>
    <message>
        <source>times must increase, but %1 s follows %2 s</source>
        <translation>时间必须递增，但 %1 s 排在 %2 s 之后</translation>
    </message>
    <message>
        <source>row %1 asks for %2 m of rope, but only the %3 m between the open tips can be paid out</source>
        <translation>第 %1 行要求绳长 %2 m，但最多只能放出张开时杆端间的 %3 m</translation>
    </message>
    <message>
        <source>there is no kind of capture system called %1</source>
        <translation>没有名为 %1 的捕获系统</translation>
    </message>
    <message>
        <source>the largest moment %1 exceeds the sum %2 of the other two, which no body has</source>
        <translation>最大的转动惯量 %1 超过另两个之和 %2，任何物体都不会如此</translation>
    </message>
    <message>
        <source>%1 frames up to output.end_time are more than %2</source>
        <translation>到 output.end_time 为止有 %1 帧，超过 %2</translation>
    </message>
    <message>
        <source>must not exceed the %1 s between two frames (output.frame_rate)</source>
        <translation>不得超过两帧之间的 %1 s（output.frame_rate）</translation>
    </message>
    <message>
        <source>the closing never starts: it waits for its event from %1 s on, but the run ends at %2 s (output.end_time)</source>
        <translation>收口从不开始：它自 %1 s 起等待触发事件，但仿真止于 %2 s（output.end_time）</translation>
    </message>
    <message>
        <source>the towing never starts: the mouth is closed at %1 s at the earliest, but the run ends at %2 s (output.end_time)</source>
        <translation>拖曳从不开始：网口最早在 %1 s 收拢，但仿真止于 %2 s（output.end_time）</translation>
    </message>
    <message>
        <source>the towing never starts: the mouth is closed at %1 s, but the run ends at %2 s (output.end_time)</source>
        <translation>拖曳从不开始：网口在 %1 s 收拢，但仿真止于 %2 s（output.end_time）</translation>
    </message>
    <message>
        <source>the phase never comes: it begins at %1 s, but the run ends at %2 s (output.end_time)</source>
        <translation>该阶段从不出现：它始于 %1 s，但仿真止于 %2 s（output.end_time）</translation>
    </message>
    <message>
        <source>the rods are never deflated: that starts at %1 s, but the run ends at %2 s (output.end_time)</source>
        <translation>充气杆从不放气：放气始于 %1 s，但仿真止于 %2 s（output.end_time）</translation>
    </message>
    <message>
        <source>thrust and torque never act: the run ends at %1 s (output.end_time)</source>
        <translation>推力和力矩从不作用：仿真止于 %1 s（output.end_time）</translation>
    </message>
    <message>
        <source>the target starts inside the net: it overlaps a panel or rod by %1</source>
        <translation>目标起始时嵌入绳网：它与网面或充气杆重叠 %1</translation>
    </message>
    <message>
        <source>the target starts inside the spacecraft: they overlap by %1</source>
        <translation>目标起始时嵌入服务航天器：二者重叠 %1</translation>
    </message>
    <message>
        <source>the spacecraft&apos;s bus reaches into the pocket: it overlaps a panel or rod by %1</source>
        <translation>服务航天器本体伸入网袋：它与网面或充气杆重叠 %1</translation>
    </message>
    <message>
        <source>%1 m at (%2, %3, %4) m</source>
        <translation>%1 m，位于 (%2, %3, %4) m</translation>
    </message>
    <message>
        <source>the shape &quot;mesh&quot; needs a file, .stl, .obj, .ply or .glb</source>
        <translation>形状 &quot;mesh&quot; 需要一个文件：.stl、.obj、.ply 或 .glb</translation>
    </message>
    <message>
        <source>must exceed the bus&apos;s edge along x, %1 m (target.size), not be %2 m</source>
        <translation>必须大于本体沿 x 的边长 %1 m（target.size），而不是 %2 m</translation>
    </message>
    <message>
        <source>%1 is looked for in the scenario&apos;s folder, but the scenario has no file yet</source>
        <translation>%1 应在场景所在的文件夹中，但该场景还没有文件</translation>
    </message>
    <message>
        <source>%1 cannot be found: %2</source>
        <translation>%1 找不到：%2</translation>
    </message>
    <message>
        <source>a thruster needs a direction, not [0, 0, 0]</source>
        <translation>推力器需要方向，不能是 [0, 0, 0]</translation>
    </message>
    <message>
        <source>a reaction wheel needs an axis, not [0, 0, 0]</source>
        <translation>反作用轮需要轴，不能是 [0, 0, 0]</translation>
    </message>
    <message>
        <source>there are no thrusters: list them as [[actuators.thruster]]</source>
        <translation>没有推力器：请以 [[actuators.thruster]] 列出</translation>
    </message>
    <message>
        <source>nothing fires the thrusters, since actuators.kind is &quot;%1&quot;</source>
        <translation>没有什么启动推力器，因为 actuators.kind 是 &quot;%1&quot;</translation>
    </message>
    <message>
        <source>has no effect, since spacecraft.station_keeping = &quot;%1&quot; prescribes that motion</source>
        <translation>不起作用，因为 spacecraft.station_keeping = &quot;%1&quot; 已规定该运动</translation>
    </message>
    <message>
        <source>the phase &quot;%1&quot; never comes: %2</source>
        <translation>阶段 &quot;%1&quot; 从不出现：%2</translation>
    </message>
    <message>
        <source>the closing starts at 0 s</source>
        <translation>收口始于 0 s</translation>
    </message>
    <message>
        <source>the towing starts when the pocket is closed</source>
        <translation>拖曳在网袋收拢时开始</translation>
    </message>
    <message>
        <source>the towing starts at %1 s, before the closing ends at %2 s</source>
        <translation>拖曳始于 %1 s，早于收口结束的 %2 s</translation>
    </message>
    <message>
        <source>&quot;controlled&quot; needs a [[controller]] of the kind &quot;tow&quot;</source>
        <translation>&quot;controlled&quot; 需要一个种类为 &quot;tow&quot; 的 [[controller]]</translation>
    </message>
    <message>
        <source>&quot;tow&quot; needs towing.mode = &quot;controlled&quot;</source>
        <translation>&quot;tow&quot; 需要 towing.mode = &quot;controlled&quot;</translation>
    </message>
    <message>
        <source>a controller of the kind &quot;tow&quot; acts in the phase &quot;towing&quot; only</source>
        <translation>种类为 &quot;tow&quot; 的控制器只在阶段 &quot;towing&quot; 中作用</translation>
    </message>
    <message>
        <source>there is no towing that it could end: towing.mode is &quot;none&quot;</source>
        <translation>没有可由它结束的拖曳：towing.mode 是 &quot;none&quot;</translation>
    </message>
    <message>
        <source>towing.mode is &quot;none&quot;</source>
        <translation>towing.mode 是 &quot;none&quot;</translation>
    </message>
    <message>
        <source>sensor.%1 measures &quot;%2&quot; already</source>
        <translation>sensor.%1 已在测量 &quot;%2&quot;</translation>
    </message>
    <message>
        <source>nothing reads a sensor of &quot;%1&quot;: no controller or winch of this scenario uses it</source>
        <translation>没有什么读取 &quot;%1&quot; 的传感器：本场景的控制器和绞车都不用它</translation>
    </message>
    <message>
        <source>needs a winch.drive other than &quot;prescribed&quot;, whose ropes follow closing.law exactly</source>
        <translation>需要 &quot;prescribed&quot; 以外的 winch.drive，因为前者的绳严格遵循 closing.law</translation>
    </message>
    <message>
        <source>needs a winch.drive other than &quot;prescribed&quot;, whose ropes follow the drawstring&apos;s law exactly</source>
        <translation>需要 &quot;prescribed&quot; 以外的 winch.drive，因为前者的绳严格遵循束口绳的规律</translation>
    </message>
    <message>
        <source>row %1 names rope %2; the ropes are 1 to %3</source>
        <translation>第 %1 行指定绳 %2；绳的编号为 1 至 %3</translation>
    </message>
    <message>
        <source>names rope %1 more than once</source>
        <translation>多次指定绳 %1</translation>
    </message>
    <message>
        <source>a disturbance needs a force or a torque</source>
        <translation>扰动需要力或力矩</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>没有这个文件</translation>
    </message>
    <message>
        <source>is a folder, not a scenario file</source>
        <translation>是文件夹，不是场景文件</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>无法读取：%1</translation>
    </message>
    <message>
        <source>is %1, not a scenario</source>
        <translation>是 %1，不是场景</translation>
    </message>
    <message>
        <source>cannot write &quot;%1&quot;: %2</source>
        <translation>无法写入“%1”：%2</translation>
    </message>
    <message>
        <source>cannot read &quot;%1&quot;: %2</source>
        <translation>无法读取“%1”：%2</translation>
    </message>
    <message>
        <source>cannot make the folder &quot;%1&quot;: %2</source>
        <translation>无法创建文件夹“%1”：%2</translation>
    </message>
    <message>
        <source>cannot write into the folder &quot;%1&quot;: %2</source>
        <translation>无法写入文件夹“%1”：%2</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>它是文件夹</translation>
    </message>
    <message>
        <source>it is read-only</source>
        <translation>它是只读的</translation>
    </message>
    <message>
        <source>it is a pipe, not a file</source>
        <translation>它是管道，不是文件</translation>
    </message>
    <message>
        <source>it is a device, not a file</source>
        <translation>它是设备，不是文件</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>没有这个文件或文件夹</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>权限不够</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>磁盘空间不足</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>是文件夹</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>文件系统是只读的</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; names another format; %3 is written, which ends with %4</source>
        <translation>%1：“%2”表示另一种格式；写出的是%3，扩展名为 %4</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is %3, which %4 would destroy; name another file, or remove it first</source>
        <translation>%1：“%2”是%3，写入%4会毁掉它；请另取文件名，或先删除它</translation>
    </message>
    <message>
        <source>scenario</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>findings</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>a recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>a scenario</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>时间 (s)</translation>
    </message>
    <message>
        <source>Time *t* (s)</source>
        <translation>时间 *t* (s)</translation>
    </message>
    <message>
        <source>Distance between adjacent rod tips</source>
        <translation>相邻杆端间的距离</translation>
    </message>
    <message>
        <source>Distance *L* (m)</source>
        <translation>距离 *L* (m)</translation>
    </message>
    <message>
        <source>Closing speed</source>
        <translation>收口速率</translation>
    </message>
    <message>
        <source>Speed d*L*/d*t* (m/s)</source>
        <translation>速率 d*L*/d*t* (m/s)</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>指令</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Force %1 (N)</source>
        <translation>力 %1 (N)</translation>
    </message>
    <message>
        <source>%1 N at %2 s</source>
        <translation>%1 N，%2 s</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Spacecraft</source>
        <translation>服务航天器</translation>
    </message>
    <message>
        <source>Target: axial</source>
        <translation>目标：轴向</translation>
    </message>
    <message>
        <source>Target: lateral</source>
        <translation>目标：横向</translation>
    </message>
    <message>
        <source>Spacecraft: axial</source>
        <translation>服务航天器：轴向</translation>
    </message>
    <message>
        <source>Spacecraft: lateral</source>
        <translation>服务航天器：横向</translation>
    </message>
    <message>
        <source>%1: axial</source>
        <translation>%1：轴向</translation>
    </message>
    <message>
        <source>%1: lateral</source>
        <translation>%1：横向</translation>
    </message>
    <message>
        <source>Position *Y* (m)</source>
        <translation>位置 *Y* (m)</translation>
    </message>
    <message>
        <source>Position *X*, *Z* (m)</source>
        <translation>位置 *X*、*Z* (m)</translation>
    </message>
    <message>
        <source>Balance</source>
        <translation>平衡</translation>
    </message>
    <message>
        <source>Dissipated</source>
        <translation>耗散</translation>
    </message>
    <message>
        <source>Dissipated; parts not recorded</source>
        <translation>耗散（各部分未记录）</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>Error, below 0.001 % of the input</source>
        <translation>误差，低于输入的 0.001 %</translation>
    </message>
    <message>
        <source>Error, at most %1 % of the input</source>
        <translation>误差，至多为输入的 %1 %</translation>
    </message>
    <message>
        <source>%1: balance</source>
        <translation>%1：平衡</translation>
    </message>
    <message>
        <source>%1: dissipated</source>
        <translation>%1：耗散</translation>
    </message>
    <message>
        <source>%1: dissipated; parts not recorded</source>
        <translation>%1：耗散（各部分未记录）</translation>
    </message>
    <message>
        <source>%1: error</source>
        <translation>%1：误差</translation>
    </message>
    <message>
        <source>%1: error, below 0.001 % of the input</source>
        <translation>%1：误差，低于输入的 0.001 %</translation>
    </message>
    <message>
        <source>%1: error, at most %2 % of the input</source>
        <translation>%1：误差，至多为输入的 %2 %</translation>
    </message>
    <message>
        <source>put in</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>动能</translation>
    </message>
    <message>
        <source>strain</source>
        <translation>应变能</translation>
    </message>
    <message>
        <source>dissipated</source>
        <translation>耗散</translation>
    </message>
    <message>
        <source>contact springs</source>
        <translation>接触弹簧</translation>
    </message>
    <message>
        <source>in cords</source>
        <translation>绳内</translation>
    </message>
    <message>
        <source>at hinges</source>
        <translation>铰处</translation>
    </message>
    <message>
        <source>in contacts</source>
        <translation>接触中</translation>
    </message>
    <message>
        <source>by friction</source>
        <translation>摩擦</translation>
    </message>
    <message>
        <source>Energy (J)</source>
        <translation>能量 (J)</translation>
    </message>
    <message>
        <source>Energy error (J)</source>
        <translation>能量误差 (J)</translation>
    </message>
    <message>
        <source>Largest tension in a net cord</source>
        <translation>网绳的最大张力</translation>
    </message>
    <message>
        <source>Tension in the closing ropes, mean</source>
        <translation>收口绳的平均张力</translation>
    </message>
    <message>
        <source>Tension (N)</source>
        <translation>张力 (N)</translation>
    </message>
    <message>
        <source>%1: actual; dashed: set point</source>
        <translation>%1：实际值；虚线：设定值</translation>
    </message>
    <message>
        <source>%1: size of the error</source>
        <translation>%1：误差大小</translation>
    </message>
    <message>
        <source>%1: delivered; dashed: commanded</source>
        <translation>%1：输出；虚线：指令</translation>
    </message>
    <message>
        <source>%1: delivered</source>
        <translation>%1：输出</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>%1 error (%2)</source>
        <translation>%1误差 (%2)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>The contact force in y exceeds those in x and z.</source>
        <translation>y 向接触力大于 x 向和 z 向。</translation>
    </message>
    <message>
        <source>peak |F_y| &gt; peak |F_x| and &gt; peak |F_z| over the run; forces are means over the output interval</source>
        <translation>整个仿真中 |F_y| 的峰值大于 |F_x| 和 |F_z| 的峰值；力取输出间隔内的平均值</translation>
    </message>
    <message>
        <source>The largest contact force comes before the closing ends.</source>
        <translation>最大接触力出现在收口结束之前。</translation>
    </message>
    <message>
        <source>the frame with the largest |F| of the whole run, towing included, is not later than the end of the closing law</source>
        <translation>整个仿真（含拖曳）中 |F| 最大的一帧不晚于收口规律的结束</translation>
    </message>
    <message>
        <source>Faster closing gives a larger contact force in y.</source>
        <translation>收口越快，y 向接触力越大。</translation>
    </message>
    <message>
        <source>the peak |F_y| of a run depends on round-off, so that single runs decide nothing: of 2 draws or more for each closing time (16 in the study), made with solver.perturbation and different seeds, the mean of log peak |F_y| falls with the closing time, yes when all intervals of the differences between closing times lie on that side, no when one lies on the other (Welch&apos;s t intervals, together 95 %); one verdict for all</source>
        <translation>单个仿真的 |F_y| 峰值受舍入误差影响，因此单个仿真不能判定：对每个收口时间用 solver.perturbation 和不同种子作 2 次或更多抽样（研究中为 16 次），log |F_y| 峰值的平均值随收口时间下降；若各收口时间之差的所有区间都在该侧，则为“是”，若有一个在另一侧，则为“否”（Welch t 区间，合计 95 %）；全部共用一个判定</translation>
    </message>
    <message>
        <source>Faster closing gives an earlier first contact.</source>
        <translation>收口越快，首次接触越早。</translation>
    </message>
    <message>
        <source>over runs sorted by the end of closing, the first frame with contact comes strictly later; one verdict for all</source>
        <translation>按收口结束的先后排列各仿真，首个有接触的帧严格依次推后；全部共用一个判定</translation>
    </message>
    <message>
        <source>Forces in x and z appear only after closing; the closing time hardly changes them.</source>
        <translation>x 向和 z 向的力只在收口之后出现；收口时间对它们几乎没有影响。</translation>
    </message>
    <message>
        <source>|F_x| and |F_z| stay below 2 % of the run&apos;s peak |F_y| until closing ends and both exceed it afterwards, and the larger peaks after closing differ by less than a factor 2 between the runs; one verdict for all</source>
        <translation>收口结束前 |F_x| 和 |F_z| 低于该仿真 |F_y| 峰值的 2 %，其后二者都超过它，且各仿真收口后的较大峰值相差不到 2 倍；全部共用一个判定</translation>
    </message>
    <message>
        <source>The force in y is negative, then positive, then negative while closing (case 1).</source>
        <translation>收口过程中 y 向力先负、后正、再负（工况 1）。</translation>
    </message>
    <message>
        <source>a push down by the mouth, a push up by the cone near the spacecraft, a stop by the mouth: the first three pushes before closing ends, each with a quarter or more of the largest impulse (smaller ones between two pushes are merged into them), are -, +, -, and more than half of each acts where it should; the mouth is rods, net and ropes above the kink row, the cone those below it, where they are at the start; the impulse between two frames goes to them as the forces of their contact points in its direction at the two frames, or at the nearest within 0.1 s that have any</source>
        <translation>网口向下推、靠近服务航天器的锥段向上推、网口使其停住：收口结束前的前三次推动，每次不小于最大冲量的四分之一（两次推动之间更小的并入它们），依次为 -、+、-，且每次有一半以上作用在应有的部位；网口指折点行以上的充气杆、绳网和绳，锥段指起始时位于其下的部分；两帧之间的冲量按这两帧中接触点沿其方向的力分配，若没有则按 0.1 s 内最近的有接触的帧</translation>
    </message>
    <message>
        <source>Target and spacecraft rest until contact, then move slightly in y before closing ends.</source>
        <translation>目标和服务航天器在接触前静止，其后到收口结束前沿 y 略有移动。</translation>
    </message>
    <message>
        <source>until first contact the target moves at most 1 mm and the spacecraft 10 mm (the folding rods move it, as momentum demands); from where they are then until closing ends both move in y by more than they did before, but less than 0.1 m</source>
        <translation>首次接触前目标移动不超过 1 mm，服务航天器不超过 10 mm（折叠的充气杆按动量守恒推动它）；从那时的位置到收口结束，二者沿 y 的移动都大于此前，但小于 0.1 m</translation>
    </message>
    <message>
        <source>In towing the forces are clearly smaller but contact persists.</source>
        <translation>拖曳中力明显变小，但接触持续存在。</translation>
    </message>
    <message>
        <source>peak |F_y| after towing starts is below 50 % of that before, and more than half of the frames in towing have contact</source>
        <translation>拖曳开始后 |F_y| 的峰值低于此前的 50 %，且拖曳中一半以上的帧有接触</translation>
    </message>
    <message>
        <source>In towing spacecraft and target move together in y.</source>
        <translation>拖曳中服务航天器与目标沿 y 一起运动。</translation>
    </message>
    <message>
        <source>in towing the distance in y between the two changes by less than 20 % of the way of the spacecraft</source>
        <translation>拖曳中二者沿 y 的距离变化小于服务航天器行程的 20 %</translation>
    </message>
    <message>
        <source>In towing the lateral motion is of the order of 1e-3 m (target) and 1e-5 m (spacecraft).</source>
        <translation>拖曳中横向运动的量级为 1e-3 m（目标）和 1e-5 m（服务航天器）。</translation>
    </message>
    <message>
        <source>the largest change of x or z since towing started is within a factor 10 of 1e-3 m for the target and of 1e-5 m for the spacecraft</source>
        <translation>拖曳开始后 x 或 z 的最大变化，目标在 1e-3 m 的 10 倍以内，服务航天器在 1e-5 m 的 10 倍以内</translation>
    </message>
    <message>
        <source>The target stays captured.</source>
        <translation>目标保持被捕获。</translation>
    </message>
    <message>
        <source>target_inside is 1 in every frame from the end of the closing law to the end of the run, closing_length stays within 5 % of the commanded length or below half of its initial value in those frames, and the run goes on for 1 s or more after the closing, and for 1 s or more after towing starts</source>
        <translation>从收口规律结束到仿真结束的每一帧 target_inside 都为 1，这些帧中 closing_length 与指令长度相差不超过 5 % 或低于初始值的一半，且收口后仿真继续 1 s 或更久，拖曳开始后也持续 1 s 或更久</translation>
    </message>
    <message>
        <source>rod %1</source>
        <translation>充气杆 %1</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>第 %1 列</translation>
    </message>
    <message>
        <source>spoke %1</source>
        <translation>径向绳 %1</translation>
    </message>
    <message>
        <source>ring %1 part %2</source>
        <translation>第 %1 环第 %2 段</translation>
    </message>
    <message>
        <source>cable</source>
        <translation>索</translation>
    </message>
    <message>
        <source>rising %1</source>
        <translation>升斜绳 %1</translation>
    </message>
    <message>
        <source>falling %1</source>
        <translation>降斜绳 %1</translation>
    </message>
    <message>
        <source>tension, N</source>
        <translation>张力，N</translation>
    </message>
    <message>
        <source>strain, µm/m</source>
        <translation>应变，µm/m</translation>
    </message>
    <message>
        <source>speed, m/s</source>
        <translation>速率，m/s</translation>
    </message>
    <message>
        <source>contact force, N</source>
        <translation>接触力，N</translation>
    </message>
    <message>
        <source>row %1 names rod %2; the rods are 1 to %3</source>
        <translation>第 %1 行指定杆 %2；充气杆为 1 至 %3</translation>
    </message>
    <message>
        <source>row %1 names panel %2; the panels are 1 to %3</source>
        <translation>第 %1 行指定网面 %2；网面为 1 至 %3</translation>
    </message>
    <message>
        <source>names rod %1 more than once</source>
        <translation>多次指定杆 %1</translation>
    </message>
    <message>
        <source>names panel %1 more than once</source>
        <translation>多次指定网面 %1</translation>
    </message>
    <message>
        <source>needs rods.pressure above 0: without it rods do not wrinkle</source>
        <translation>需要 rods.pressure 大于 0：否则充气杆不起皱</translation>
    </message>
    <message>
        <source>Nothing is uncertain: add an input.</source>
        <translation>没有不确定量：请添加输入。</translation>
    </message>
    <message>
        <source>%1 is no parameter of this scenario: remove it.</source>
        <translation>%1 不是此场景的参数：请移除。</translation>
    </message>
    <message>
        <source>%1 needs a spread above 0.</source>
        <translation>%1 需要大于 0 的分散程度。</translation>
    </message>
    <message>
        <source>%1 is there twice: remove one.</source>
        <translation>%1 出现两次：请移除一个。</translation>
    </message>
    <message>
        <source>another program is running a study in &quot;%1&quot;</source>
        <translation>另一个程序正在“%1”中运行研究</translation>
    </message>
    <message>
        <source>another program is writing &quot;%1&quot;</source>
        <translation>另一个程序正在写入“%1”</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no study: there is no %2 in it</source>
        <translation>“%1”中没有研究：其中没有 %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds a damaged scenario: %2</source>
        <translation>“%1”中的场景已损坏：%2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds a damaged record of point %2</source>
        <translation>“%1”中样本点 %2 的记录已损坏</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds the study &quot;%2&quot;, not &quot;%3&quot;: name another folder</source>
        <translation>“%1”中是研究“%2”，不是“%3”：请指定另一个文件夹</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged</source>
        <translation>“%1”已损坏</translation>
    </message>
    <message>
        <source>is a scenario, not a study; a study names a scenario as its base</source>
        <translation>是场景，不是研究；研究以 base 指定一个场景</translation>
    </message>
    <message>
        <source>is %1, not a study</source>
        <translation>是%1，不是研究</translation>
    </message>
    <message>
        <source>the study has no such variant</source>
        <translation>研究中没有这个方案</translation>
    </message>
    <message>
        <source>an earlier version made the folder of %1: go on with the study once (--resume), so that the folder says what its scenario is</source>
        <translation>%1 的文件夹由较早的版本建立：请继续运行一次研究 (--resume)，使文件夹说明其场景</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>是文件夹</translation>
    </message>
    <message>
        <source>cannot read the folder &quot;%1&quot;: %2</source>
        <translation>无法读取文件夹“%1”：%2</translation>
    </message>
    <message>
        <source>cannot make the video &quot;%1&quot;: the program ffmpeg is not installed</source>
        <translation>无法生成视频“%1”：未安装程序 ffmpeg</translation>
    </message>
    <message>
        <source>cannot start ffmpeg: %1</source>
        <translation>无法启动 ffmpeg：%1</translation>
    </message>
    <message>
        <source>ffmpeg could not make the video &quot;%1&quot;: %2</source>
        <translation>ffmpeg 未能生成视频“%1”：%2</translation>
    </message>
    <message>
        <source>captured</source>
        <translation>已捕获</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>未捕获</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>估计值</translation>
    </message>
    <message>
        <source>95 % interval (Wilson)</source>
        <translation>95 % 区间 (Wilson)</translation>
    </message>
    <message>
        <source>Captures</source>
        <translation>捕获次数</translation>
    </message>
    <message>
        <source>Probability of capture</source>
        <translation>捕获概率</translation>
    </message>
    <message>
        <source>Share below</source>
        <translation>累积比例</translation>
    </message>
    <message>
        <source>Change of the probability of capture, with 95 % intervals</source>
        <translation>捕获概率的变化，附 95 % 区间</translation>
    </message>
    <message>
        <source>large against small</source>
        <translation>大值与小值之差</translation>
    </message>
    <message>
        <source>far from the median against near</source>
        <translation>远离与接近中位数之差</translation>
    </message>
    <message>
        <source>From smallest to largest</source>
        <translation>从最小到最大</translation>
    </message>
    <message>
        <source>reached the limit of %1 steps (solver.most_steps) at t = %2 s</source>
        <translation>在 t = %2 s 时达到 %1 步的上限（solver.most_steps）</translation>
    </message>
    <message>
        <source>about %1 of %2 captures drawn</source>
        <translation>绘出 %2 次捕获中的约 %1 次</translation>
    </message>
    <message>
        <source>Contours: Kriging of %1 captures, leave-one-out R² %2</source>
        <translation>等值线：对 %1 次捕获的克里金插值，留一法 R² %2</translation>
    </message>
    <message>
        <source>hub</source>
        <translation>中心盘</translation>
    </message>
    <message>
        <source>coarse mesh, axial stiffness divided by %1; bias over %2 scattered captures, 95 %: probability of capture %3 +- %4 percentage points, first contact %5 +- %6 s, impulse on the target %7 +- %8 %</source>
        <translation>粗网目，轴向刚度除以 %1；由 %2 次随机捕获得出的偏差（95 % 区间）：捕获概率 %3 ± %4 个百分点，首次接触 %5 ± %6 s，目标所受冲量 %7 ± %8 %</translation>
    </message>
    <message>
        <source>&quot;draft&quot; is for systems of the kind pocket, not %1</source>
        <translation>&quot;draft&quot; 只用于 pocket 类系统，不用于 %1</translation>
    </message>
    <message>
        <source>&quot;draft&quot; is for the evaluation mean_strain, not full</source>
        <translation>&quot;draft&quot; 只用于 mean_strain 计算方式，不用于 full</translation>
    </message>
    <message>
        <source>nothing touched the target</source>
        <translation>没有任何东西接触目标</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>没有数据</translation>
    </message>
</context>
<context>
    <name>netpocket::AboutDialog</name>
    <message>
        <source>About Netpocket</source>
        <translation>关于 Netpocket</translation>
    </message>
    <message>
        <source>Netpocket</source>
        <translation>Netpocket</translation>
    </message>
    <message>
        <source>Simulates and shows how a netted pocket captures a target in orbit.</source>
        <translation>仿真并展示网袋如何在轨捕获目标。</translation>
    </message>
    <message>
        <source>Pictures: %1</source>
        <translation>绘图：%1</translation>
    </message>
</context>
<context>
    <name>netpocket::CampaignActions</name>
    <message>
        <source>Campaign…</source>
        <translation>批量仿真…</translation>
    </message>
    <message>
        <source>Open campaign…</source>
        <translation>打开批量仿真…</translation>
    </message>
    <message>
        <source>How often the scenario catches its target when its inputs are uncertain</source>
        <translation>输入不确定时，场景有多大比例捕获目标</translation>
    </message>
    <message>
        <source>Look at the folder of a study that runs, was interrupted or is done</source>
        <translation>查看正在运行、已中断或已完成的研究文件夹</translation>
    </message>
    <message>
        <source>Campaign</source>
        <translation>批量仿真</translation>
    </message>
    <message>
        <source>Save the scenario &quot;%1&quot;?</source>
        <translation>要保存场景“%1”吗？</translation>
    </message>
    <message>
        <source>A campaign runs the scenario&apos;s file as it is saved.</source>
        <translation>批量仿真按已保存的场景文件运行。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the scenario itself: name another file for its study.</source>
        <translation>“%1”就是场景本身：请为其研究指定另一个文件。</translation>
    </message>
    <message>
        <source>Save study</source>
        <translation>保存研究</translation>
    </message>
    <message>
        <source>Studies (*.toml)</source>
        <translation>研究 (*.toml)</translation>
    </message>
    <message>
        <source>Save study and run it</source>
        <translation>保存研究并运行</translation>
    </message>
    <message>
        <source>Run study</source>
        <translation>运行研究</translation>
    </message>
    <message>
        <source>Open the folder of a study</source>
        <translation>打开研究文件夹</translation>
    </message>
    <message>
        <source>A campaign is running: stop it before another one is opened.</source>
        <translation>有批量仿真正在运行：打开另一个之前请先停止它。</translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation>%1，样本点 %2</translation>
    </message>
    <message>
        <source>point %1 of %2</source>
        <translation>%2的样本点 %1</translation>
    </message>
    <message>
        <source>The campaign &quot;%1&quot; is running.</source>
        <translation>批量仿真“%1”正在运行。</translation>
    </message>
    <message>
        <source>Closing the window stops it. Points that are done are kept; open its folder to go on later.</source>
        <translation>关闭窗口会停止它。已完成的样本点会保留；以后打开其文件夹可继续。</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>停止并关闭</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>等待</translation>
    </message>
</context>
<context>
    <name>netpocket::CampaignJob</name>
    <message>
        <source>cannot start &quot;%1&quot;</source>
        <translation>无法启动“%1”</translation>
    </message>
    <message>
        <source>the study ended unexpectedly</source>
        <translation>研究意外结束</translation>
    </message>
</context>
<context>
    <name>netpocket::CampaignView</name>
    <message>
        <source>; %1 refused as not valid</source>
        <translation>；%1 个无效而被拒绝</translation>
    </message>
    <message>
        <source>; %1 diverged</source>
        <translation>；%1 个发散</translation>
    </message>
    <message>
        <source>, %1 captures a minute</source>
        <translation>，每分钟 %1 次捕获</translation>
    </message>
    <message>
        <source>, %1 left</source>
        <translation>，剩余 %1</translation>
    </message>
    <message>
        <source>Points done</source>
        <translation>已完成的样本点</translation>
    </message>
    <message>
        <source>Other campaign…</source>
        <translation>其他批量仿真…</translation>
    </message>
    <message>
        <source>Define a campaign for the scenario, or open another one</source>
        <translation>为场景设定批量仿真，或打开另一个</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图</translation>
    </message>
    <message>
        <source>What to draw</source>
        <translation>绘制的内容</translation>
    </message>
    <message>
        <source>Map of the captures</source>
        <translation>捕获分布图</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>收敛过程</translation>
    </message>
    <message>
        <source>What decides</source>
        <translation>决定因素</translation>
    </message>
    <message>
        <source>Distributions</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>Parallel coordinates</source>
        <translation>平行坐标</translation>
    </message>
    <message>
        <source>Input to the right</source>
        <translation>横轴输入</translation>
    </message>
    <message>
        <source>The input to the right</source>
        <translation>横轴上的输入</translation>
    </message>
    <message>
        <source>Input upwards</source>
        <translation>纵轴输入</translation>
    </message>
    <message>
        <source>The input upwards</source>
        <translation>纵轴上的输入</translation>
    </message>
    <message>
        <source>Open this capture</source>
        <translation>打开此次捕获</translation>
    </message>
    <message>
        <source>Run this capture in the window (Enter)</source>
        <translation>在窗口中运行此次捕获（回车）</translation>
    </message>
    <message>
        <source>Make it the scenario</source>
        <translation>设为当前场景</translation>
    </message>
    <message>
        <source>Put the values of this point into the editor; Undo takes that back</source>
        <translation>把此样本点的值放入编辑器；可用“撤销”收回</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%2 个样本点中的 %1 个</translation>
    </message>
    <message>
        <source>no point yet</source>
        <translation>还没有样本点</translation>
    </message>
    <message>
        <source>Stopping: %1</source>
        <translation>正在停止：%1</translation>
    </message>
    <message>
        <source>Running: %1</source>
        <translation>正在运行：%1</translation>
    </message>
    <message>
        <source>Another program runs it: %1</source>
        <translation>由另一个程序运行：%1</translation>
    </message>
    <message>
        <source>Ended early, as it was told to: %1</source>
        <translation>按要求提前结束：%1</translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>已完成：%1</translation>
    </message>
    <message>
        <source>Not complete: %1</source>
        <translation>未完成：%1</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>End it; points that are done are kept, and it can go on later</source>
        <translation>结束运行；已完成的样本点会保留，以后可以继续</translation>
    </message>
    <message>
        <source>The study&apos;s file is not where it was when the folder was made</source>
        <translation>研究文件已不在建立文件夹时的位置</translation>
    </message>
    <message>
        <source>Run the points that are missing</source>
        <translation>运行缺少的样本点</translation>
    </message>
    <message>
        <source>; %1 at their limit of steps</source>
        <translation>；%1 个达到步数上限</translation>
    </message>
    <message>
        <source>&lt;b&gt;Drafts&lt;/b&gt;: %1</source>
        <translation>&lt;b&gt;草算&lt;/b&gt;：%1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Some are drafts&lt;/b&gt;: %1</source>
        <translation>&lt;b&gt;其中有草算&lt;/b&gt;：%1</translation>
    </message>
</context>
<context>
    <name>netpocket::CaptureMapView</name>
    <message>
        <source>Map of the captures</source>
        <translation>捕获分布图</translation>
    </message>
    <message>
        <source>The map fills as captures are done.</source>
        <translation>随着捕获的完成，图中会逐渐出现样本点。</translation>
    </message>
</context>
<context>
    <name>netpocket::CaptureSession</name>
    <message>
        <source>The run has diverged and stands still: %1.</source>
        <translation>仿真已发散并停止：%1。</translation>
    </message>
    <message>
        <source>The run was not disturbed: %1.</source>
        <translation>未施加扰动：%1。</translation>
    </message>
    <message>
        <source>The simulation ended: %1.</source>
        <translation>仿真结束：%1。</translation>
    </message>
</context>
<context>
    <name>netpocket::ChartView</name>
    <message>
        <source>No data</source>
        <translation>没有数据</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>图表</translation>
    </message>
</context>
<context>
    <name>netpocket::ClosingPreview</name>
    <message>
        <source>Time *t* (s)</source>
        <translation>时间 *t* (s)</translation>
    </message>
    <message>
        <source>Rope length</source>
        <translation>绳长</translation>
    </message>
    <message>
        <source>Length *L* (m)</source>
        <translation>长度 *L* (m)</translation>
    </message>
    <message>
        <source>Closing speed</source>
        <translation>收口速率</translation>
    </message>
    <message>
        <source>Speed d*L*/d*t* (m/s)</source>
        <translation>速率 d*L*/d*t* (m/s)</translation>
    </message>
    <message>
        <source>Preview of the closing law</source>
        <translation>收口规律预览</translation>
    </message>
    <message>
        <source>Rope length between adjacent rod tips and its speed, as the closing law commands them</source>
        <translation>收口规律所指令的相邻杆端间绳长及其变化速率</translation>
    </message>
    <message>
        <source>The closing law needs two points or more with increasing times.</source>
        <translation>收口规律需要两个或更多时间递增的点。</translation>
    </message>
</context>
<context>
    <name>netpocket::ControlActions</name>
    <message>
        <source>Disturb</source>
        <translation>施加扰动</translation>
    </message>
    <message>
        <source>Compare without controllers</source>
        <translation>与无控制器对比</translation>
    </message>
    <message>
        <source>A disturbance needs a size other than 0.</source>
        <translation>扰动的大小不能为 0。</translation>
    </message>
    <message>
        <source>, with loop</source>
        <translation>，有控制</translation>
    </message>
    <message>
        <source>%1, without loop</source>
        <translation>%1，无控制</translation>
    </message>
    <message>
        <source>Disturb the running simulation as the control panel says</source>
        <translation>按控制面板的设置扰动正在进行的仿真</translation>
    </message>
    <message>
        <source>This kind of capture system has no disturbances</source>
        <translation>此类捕获系统没有扰动</translation>
    </message>
    <message>
        <source>Only a run that goes on or is paused can be disturbed</source>
        <translation>只有正在进行或已暂停的仿真才能施加扰动</translation>
    </message>
    <message>
        <source>Simulate the shown run once more with its controllers off, as far as it has come, and draw both in the plots</source>
        <translation>关闭控制器，把所示仿真再算一遍到相同时刻，并在曲线中同时绘出二者</translation>
    </message>
    <message>
        <source>Pause the run first: the other one takes its place</source>
        <translation>请先暂停仿真：另一个仿真将取代它</translation>
    </message>
    <message>
        <source>Needs a run with controllers that are not off</source>
        <translation>需要一个控制器未关闭的仿真</translation>
    </message>
</context>
<context>
    <name>netpocket::ControlPanel</name>
    <message>
        <source>This system has no controllers and no winches. List them in the scenario&apos;s text as [[controller]] and [winch]; what is there is shown here.</source>
        <translation>本系统没有控制器，也没有绞车。请在场景文本中以 [[controller]] 和 [winch] 列出；有的都会显示在这里。</translation>
    </message>
    <message>
        <source>Compare without controllers</source>
        <translation>与无控制器对比</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>回路</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>负荷</translation>
    </message>
    <message>
        <source>Part of the actuators&apos; limit that is asked for; the mark is the limit</source>
        <translation>所要求的量占执行机构极限的比例；刻线为极限</translation>
    </message>
    <message>
        <source>By how much what is controlled is off; of vectors the size</source>
        <translation>被控量的偏差；矢量取其大小</translation>
    </message>
    <message>
        <source>Control loops</source>
        <translation>控制回路</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>What the chosen loop does at the shown time</source>
        <translation>所选回路在所示时刻的情况</translation>
    </message>
    <message>
        <source>Gains and set points</source>
        <translation>增益与设定值</translation>
    </message>
    <message>
        <source>Of the chosen loop; changes act on a run at once</source>
        <translation>属于所选回路；修改立即作用于仿真</translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation>扰动</translation>
    </message>
    <message>
        <source>Pushes or turns a body of the run for a while</source>
        <translation>在一段时间内推动或转动仿真中的某个物体</translation>
    </message>
    <message>
        <source>%1: controls the %2 of the %3</source>
        <translation>%1：控制%3的%2</translation>
    </message>
</context>
<context>
    <name>netpocket::DifferenceTable</name>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>键名</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>差异</translation>
    </message>
</context>
<context>
    <name>netpocket::DifferencesDialog</name>
    <message>
        <source>Here</source>
        <translation>此处</translation>
    </message>
    <message>
        <source>There</source>
        <translation>对方</translation>
    </message>
    <message>
        <source>&amp;Take selected values over</source>
        <translation>采用所选的值(&amp;T)</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>差异对比</translation>
    </message>
    <message>
        <source>The saved version</source>
        <translation>已保存的版本</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>对比</translation>
    </message>
    <message>
        <source>&amp;Compare with:</source>
        <translation>对比对象(&amp;C)：</translation>
    </message>
    <message>
        <source>Other &amp;file…</source>
        <translation>其他文件(&amp;F)…</translation>
    </message>
    <message>
        <source>Give the selected parameters their values there, as one step of the history</source>
        <translation>把所选参数改为对方的值，作为历史中的一步</translation>
    </message>
    <message>
        <source>Scenarios (*.toml)</source>
        <translation>场景 (*.toml)</translation>
    </message>
    <message>
        <source>No value of %1 differs from: %2.</source>
        <translation>%1 与以下对象没有差异：%2。</translation>
    </message>
    <message>
        <source>One value of %1 differs from: %2.</source>
        <translation>%1 与以下对象有 1 个值不同：%2。</translation>
    </message>
    <message>
        <source>%1 values of %2 differ from: %3.</source>
        <translation>%2 与以下对象有 %1 个值不同：%3。</translation>
    </message>
    <message>
        <source>take %1 values over</source>
        <translation>采用 %1 个值</translation>
    </message>
</context>
<context>
    <name>netpocket::DisturbanceForm</name>
    <message>
        <source>Disturbed body</source>
        <translation>受扰物体</translation>
    </message>
    <message>
        <source>Body on which the disturbance acts</source>
        <translation>扰动所作用的物体</translation>
    </message>
    <message>
        <source>Spacecraft</source>
        <translation>服务航天器</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Kind of disturbance</source>
        <translation>扰动种类</translation>
    </message>
    <message>
        <source>A force through the body&apos;s centre of mass, or a torque</source>
        <translation>通过物体质心的力，或力矩</translation>
    </message>
    <message>
        <source>Torque, N m</source>
        <translation>力矩，N m</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>力，N</translation>
    </message>
    <message>
        <source>Axis of the disturbance</source>
        <translation>扰动的轴</translation>
    </message>
    <message>
        <source>Axis of the body, which turns with it</source>
        <translation>物体的轴，随物体转动</translation>
    </message>
    <message>
        <source>Size of the disturbance</source>
        <translation>扰动的大小</translation>
    </message>
    <message>
        <source>Newtons or newton metres; negative: the other way</source>
        <translation>单位为牛或牛米；负值表示反向</translation>
    </message>
    <message>
        <source>Duration of the disturbance</source>
        <translation>扰动的持续时间</translation>
    </message>
    <message>
        <source>Seconds for which it acts</source>
        <translation>作用的秒数</translation>
    </message>
    <message>
        <source>Disturb</source>
        <translation>施加扰动</translation>
    </message>
    <message>
        <source>for</source>
        <translation>持续</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Disturb the running simulation from its present time on (Ctrl+D)</source>
        <translation>从当前时刻起扰动正在进行的仿真 (Ctrl+D)</translation>
    </message>
</context>
<context>
    <name>netpocket::EditActions</name>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Undo history…</source>
        <translation>编辑历史…</translation>
    </message>
    <message>
        <source>Go to any step of the edits</source>
        <translation>转到编辑过程中的任意一步</translation>
    </message>
    <message>
        <source>Revert to the saved version</source>
        <translation>恢复到已保存的版本</translation>
    </message>
    <message>
        <source>Take all unsaved edits back; can be undone</source>
        <translation>撤回所有未保存的编辑；可以撤销</translation>
    </message>
    <message>
        <source>What differs…</source>
        <translation>差异对比…</translation>
    </message>
    <message>
        <source>List what differs from case 1, the saved version or any file</source>
        <translation>列出与工况 1、已保存的版本或任意文件的差异</translation>
    </message>
    <message>
        <source>Pockets, targets, strategies…</source>
        <translation>网袋、目标、策略…</translation>
    </message>
    <message>
        <source>Put a part of a scenario that comes with the program into this one</source>
        <translation>把程序自带场景的某一部分放入当前场景</translation>
    </message>
    <message>
        <source>Reverted to the saved version; Undo takes that back.</source>
        <translation>已恢复到保存的版本；“撤销”可收回此操作。</translation>
    </message>
    <message>
        <source>Undo history</source>
        <translation>编辑历史</translation>
    </message>
    <message>
        <source>Before the first edit</source>
        <translation>首次编辑之前</translation>
    </message>
    <message>
        <source>Edits</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>Choose a step to go to it; the steps after it stay until the next edit.</source>
        <translation>选择一步即可转到该处；其后的步骤保留到下一次编辑。</translation>
    </message>
</context>
<context>
    <name>netpocket::ExportDialog</name>
    <message>
        <source>Pictures (PNG)</source>
        <translation>图片 (PNG)</translation>
    </message>
    <message>
        <source>Video (MP4)</source>
        <translation>视频 (MP4)</translation>
    </message>
    <message>
        <source>Contact sheet (PNG)</source>
        <translation>序列拼图 (PNG)</translation>
    </message>
    <message>
        <source>This moment in three dimensions (glTF)</source>
        <translation>当前时刻的三维模型 (glTF)</translation>
    </message>
    <message>
        <source>Report (HTML)</source>
        <translation>报告 (HTML)</translation>
    </message>
    <message>
        <source>Figures of the paper</source>
        <translation>论文中的图</translation>
    </message>
    <message>
        <source>Channels (CSV)</source>
        <translation>通道 (CSV)</translation>
    </message>
    <message>
        <source>ParaView series</source>
        <translation>ParaView 序列</translation>
    </message>
    <message>
        <source>ParaView files with time steps (VTKHDF)</source>
        <translation>带时间步的 ParaView 文件 (VTKHDF)</translation>
    </message>
    <message>
        <source>The whole capture in three dimensions (glTF)</source>
        <translation>整个捕获过程的三维动画 (glTF)</translation>
    </message>
    <message>
        <source>As in the view</source>
        <translation>与视图相同</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>斜视</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧视</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正视</translation>
    </message>
    <message>
        <source>Mouth</source>
        <translation>网口</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>Plain colours</source>
        <translation>素色</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>张力</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>应变</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>Contact force</source>
        <translation>接触力</translation>
    </message>
    <message>
        <source>White</source>
        <translation>白色</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>太空</translation>
    </message>
    <message>
        <source>beside each figure, as CSV</source>
        <translation>在每幅图旁附 CSV</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source> per simulated second</source>
        <translation> 帧/仿真秒</translation>
    </message>
    <message>
        <source>&amp;What:</source>
        <translation>内容(&amp;W)：</translation>
    </message>
    <message>
        <source>&amp;To:</source>
        <translation>位置(&amp;T)：</translation>
    </message>
    <message>
        <source>&amp;Pictures:</source>
        <translation>图片(&amp;P)：</translation>
    </message>
    <message>
        <source>&amp;Size:</source>
        <translation>尺寸(&amp;S)：</translation>
    </message>
    <message>
        <source>&amp;Camera:</source>
        <translation>相机(&amp;C)：</translation>
    </message>
    <message>
        <source>C&amp;olours:</source>
        <translation>颜色(&amp;O)：</translation>
    </message>
    <message>
        <source>&amp;Background:</source>
        <translation>背景(&amp;B)：</translation>
    </message>
    <message>
        <source>&amp;Format:</source>
        <translation>格式(&amp;F)：</translation>
    </message>
    <message>
        <source>&amp;Numbers:</source>
        <translation>数据(&amp;N)：</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>浏览…</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>导出到</translation>
    </message>
    <message>
        <source>&quot;%1&quot; exists already.</source>
        <translation>“%1”已经存在。</translation>
    </message>
    <message>
        <source>Files in it that have the same names will be replaced.</source>
        <translation>其中同名的文件将被替换。</translation>
    </message>
    <message>
        <source>It will be replaced.</source>
        <translation>它将被替换。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>File or folder to export to</source>
        <translation>导出到的文件或文件夹</translation>
    </message>
</context>
<context>
    <name>netpocket::ExportJob</name>
    <message>
        <source>%1: cannot start &quot;%2&quot;</source>
        <translation>%1：无法启动“%2”</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1失败</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>netpocket::ExportTray</name>
    <message>
        <source>Cancel this export</source>
        <translation>取消此次导出</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is still being exported.</source>
        <translation>“%1”仍在导出。</translation>
    </message>
    <message>
        <source>Closing the window cancels it.</source>
        <translation>关闭窗口将取消导出。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>Exporting: %1</source>
        <translation>正在导出：%1</translation>
    </message>
</context>
<context>
    <name>netpocket::FileActions</name>
    <message>
        <source>&amp;New scenario</source>
        <translation>新建场景(&amp;N)</translation>
    </message>
    <message>
        <source>Start from the defaults</source>
        <translation>从默认值开始</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a scenario (.toml) or a recording (.h5)</source>
        <translation>打开场景 (.toml) 或记录 (.h5)</translation>
    </message>
    <message>
        <source>&amp;Presets</source>
        <translation>预设(&amp;P)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近打开的文件(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Save scenario</source>
        <translation>保存场景(&amp;S)</translation>
    </message>
    <message>
        <source>Save the scenario</source>
        <translation>保存当前场景</translation>
    </message>
    <message>
        <source>Save scenario &amp;as…</source>
        <translation>场景另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save under another name</source>
        <translation>以另一个名称保存</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>没有最近的文件</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Scenarios and recordings (*.toml *.h5);;Scenarios (*.toml);;Recordings (*.h5)</source>
        <translation>场景和记录 (*.toml *.h5);;场景 (*.toml);;记录 (*.h5)</translation>
    </message>
    <message>
        <source>Save scenario</source>
        <translation>保存场景</translation>
    </message>
    <message>
        <source>Scenarios (*.toml)</source>
        <translation>场景 (*.toml)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>Save the changes to &quot;%1&quot;?</source>
        <translation>要保存对“%1”的更改吗？</translation>
    </message>
    <message>
        <source>Otherwise they are lost.</source>
        <translation>否则更改将丢失。</translation>
    </message>
</context>
<context>
    <name>netpocket::FilmActions</name>
    <message>
        <source>Save the whole window as one sees it, as a PNG picture</source>
        <translation>把所见的整个窗口保存为 PNG 图片</translation>
    </message>
    <message>
        <source>Record the &amp;window…</source>
        <translation>录制窗口(&amp;W)…</translation>
    </message>
    <message>
        <source>Make a video of the whole window until it is stopped</source>
        <translation>录制整个窗口的视频，直到停止为止</translation>
    </message>
    <message>
        <source>Stop recording the &amp;window</source>
        <translation>停止录制窗口(&amp;W)</translation>
    </message>
    <message>
        <source>Save picture of the window</source>
        <translation>保存窗口图片</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>图片 (*.png)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Record the window</source>
        <translation>录制窗口</translation>
    </message>
    <message>
        <source>Videos (*.mp4)</source>
        <translation>视频 (*.mp4)</translation>
    </message>
    <message>
        <source>Recorded %1 of the window: %2</source>
        <translation>已录制窗口 %1：%2</translation>
    </message>
    <message>
        <source>Save p&amp;icture of the window…</source>
        <translation>保存窗口图片(&amp;I)…</translation>
    </message>
</context>
<context>
    <name>netpocket::FilmIndicator</name>
    <message>
        <source>Recording of the window</source>
        <translation>窗口录制</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>End the recording of the window and keep the video</source>
        <translation>结束窗口录制并保留视频</translation>
    </message>
    <message>
        <source>Stop recording the window</source>
        <translation>停止录制窗口</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>录制中 %1</translation>
    </message>
    <message>
        <source>Finishing the video…</source>
        <translation>正在完成视频…</translation>
    </message>
</context>
<context>
    <name>netpocket::FindingsPanel</name>
    <message>
        <source>Findings F1 to F11 appear here once a run has recorded frames.</source>
        <translation>仿真记录到帧之后，这里显示结论 F1 至 F11。</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Save the findings as text or JSON</source>
        <translation>把结论保存为文本或 JSON</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>Capture not decided yet</source>
        <translation>尚未判定是否捕获</translation>
    </message>
    <message>
        <source>Captured</source>
        <translation>已捕获</translation>
    </message>
    <message>
        <source>Not captured</source>
        <translation>未捕获</translation>
    </message>
    <message>
        <source>Diverged</source>
        <translation>发散</translation>
    </message>
    <message>
        <source>not decided yet</source>
        <translation>尚未判定</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;%1: %2&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Rule: %3&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;%1：%2&lt;/b&gt;&lt;/p&gt;&lt;p&gt;判据：%3&lt;/p&gt;</translation>
    </message>
    <message>
        <source>%1 of %2 hold so far</source>
        <translation>%2 项中目前成立 %1 项</translation>
    </message>
    <message>
        <source>%1 of %2 hold</source>
        <translation>%2 项中成立 %1 项</translation>
    </message>
    <message>
        <source>Export findings</source>
        <translation>导出结论</translation>
    </message>
    <message>
        <source>Text (*.txt);;JSON (*.json)</source>
        <translation>文本 (*.txt);;JSON (*.json)</translation>
    </message>
    <message>
        <source>Undecided</source>
        <translation>未定</translation>
    </message>
</context>
<context>
    <name>netpocket::FirstCapture</name>
    <message>
        <source>Look</source>
        <translation>观察</translation>
    </message>
    <message>
        <source>Look at the pocket</source>
        <translation>观察网袋</translation>
    </message>
    <message>
        <source>Drag in the view with the left mouse button, or press the arrow keys there, to see the pocket from another side. The wheel comes nearer; F shows everything again.</source>
        <translation>在视图中按住鼠标左键拖动，或在其中按方向键，从另一侧观察网袋。滚轮拉近；F 键重新显示全部。</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>修改</translation>
    </message>
    <message>
        <source>Change one number</source>
        <translation>修改一个数</translation>
    </message>
    <message>
        <source>Change a value of the scenario, such as the duration of the closing, and press Enter. Tool tips say what a value is; Ctrl+Z takes the change back.</source>
        <translation>修改场景中的一个值，例如收口的持续时间，然后按回车。工具提示说明各值的含义；Ctrl+Z 撤回修改。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Run the simulation</source>
        <translation>运行仿真</translation>
    </message>
    <message>
        <source>Press the space bar, or the first button with a triangle. This step is done when the pocket touches the target; the run goes on.</source>
        <translation>按空格键，或按第一个带三角形的按钮。网袋碰到目标时此步完成；仿真继续进行。</translation>
    </message>
    <message>
        <source>Scrub</source>
        <translation>回看</translation>
    </message>
    <message>
        <source>Go back in time</source>
        <translation>回到过去的时刻</translation>
    </message>
    <message>
        <source>Drag in the strip of time below the view, or press the comma key: the recorded moments are shown, also while the simulation goes on.</source>
        <translation>在视图下方的时间条中拖动，或按逗号键：显示已记录的时刻，仿真进行中也可以。</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Look at the force</source>
        <translation>观察力</translation>
    </message>
    <message>
        <source>Choose “Contact force on the target” in the plots and go to another moment: click in the curve, or step through time. View and plot show the same moment.</source>
        <translation>在曲线中选择“目标所受接触力”，并转到另一时刻：在曲线上点击，或逐帧移动。视图与曲线显示同一时刻。</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>Export a picture</source>
        <translation>导出一张图片</translation>
    </message>
    <message>
        <source>Press Ctrl+E, choose what is to be written and where to, and press Export. The status bar says when it is done.</source>
        <translation>按 Ctrl+E，选择写什么、写到哪里，然后按“导出”。完成时状态栏会提示。</translation>
    </message>
    <message>
        <source>That was a capture</source>
        <translation>一次捕获完成了</translation>
    </message>
    <message>
        <source>Change what you like and run again: the panel Runs keeps all of them and draws one over the other. F1 shows all keys.</source>
        <translation>随意修改后再次运行：“仿真”面板保留所有仿真，并可叠加绘出。F1 显示所有按键。</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>指给我看</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>跳过</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>离开</translation>
    </message>
    <message>
        <source>Guided first capture</source>
        <translation>首次捕获向导</translation>
    </message>
    <message>
        <source>Go to where this step is done</source>
        <translation>转到完成此步的地方</translation>
    </message>
    <message>
        <source>Go on with the next step</source>
        <translation>进入下一步</translation>
    </message>
    <message>
        <source>Close the guide; the menu Help brings it back</source>
        <translation>关闭向导；可从“帮助”菜单再次打开</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>第 %1 步，共 %2 步：%3</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>netpocket::GainForm</name>
    <message>
        <source>The edited scenario has no such table: its gains cannot be changed here.</source>
        <translation>编辑中的场景没有这个表：其增益不能在此修改。</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
</context>
<context>
    <name>netpocket::GroupBox</name>
    <message>
        <source>1 problem</source>
        <translation>1 个问题</translation>
    </message>
    <message>
        <source>%1 problems</source>
        <translation>%1 个问题</translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation>%1 项更改</translation>
    </message>
</context>
<context>
    <name>netpocket::Headline</name>
    <message>
        <source>%1 kN</source>
        <translation>%1 kN</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Numbers of the shown moment</source>
        <translation>所示时刻的数值</translation>
    </message>
    <message>
        <source>The run that is shown</source>
        <translation>所示的仿真</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Radius of the mouth</source>
        <translation>网口半径</translation>
    </message>
    <message>
        <source>Contact force</source>
        <translation>接触力</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Not simulated yet</source>
        <translation>尚未仿真</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
</context>
<context>
    <name>netpocket::LoadBar</name>
    <message>
        <source>no limit</source>
        <translation>无极限</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>饱和</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>netpocket::LoopValues</name>
    <message>
        <source>Set point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>What the loop is to keep</source>
        <translation>回路应保持的值</translation>
    </message>
    <message>
        <source>Actual</source>
        <translation>实际值</translation>
    </message>
    <message>
        <source>What it really is, also where sensors are in error</source>
        <translation>真实的值，即使传感器有误差</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>By how much the actual value is off</source>
        <translation>实际值的偏差</translation>
    </message>
    <message>
        <source>Commanded</source>
        <translation>指令</translation>
    </message>
    <message>
        <source>Force or torque that this loop asks for</source>
        <translation>此回路要求的力或力矩</translation>
    </message>
    <message>
        <source>Delivered</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>Force or torque that the actuators exert, for all loops that ask for it</source>
        <translation>执行机构为所有相关回路实际施加的力或力矩</translation>
    </message>
    <message>
        <source>Disturbance</source>
        <translation>扰动</translation>
    </message>
    <message>
        <source>What the observer takes the disturbance to be</source>
        <translation>观测器估计的扰动</translation>
    </message>
</context>
<context>
    <name>netpocket::LostRunsBar</name>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Add them to the runs of this session</source>
        <translation>把它们加入本次的仿真列表</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>删除它们</translation>
    </message>
    <message>
        <source>A run that was not saved, of %1, was found.</source>
        <translation>发现 1 个未保存的仿真，时间为 %1。</translation>
    </message>
    <message>
        <source>%1 runs that were not saved, of %2, were found.</source>
        <translation>发现 %1 个未保存的仿真，时间为 %2。</translation>
    </message>
</context>
<context>
    <name>netpocket::MainWindow</name>
    <message>
        <source>Exported %1</source>
        <translation>已导出 %1</translation>
    </message>
    <message>
        <source>Export cancelled: %1</source>
        <translation>导出已取消：%1</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>The scenario&apos;s text has an error: see the editor.</source>
        <translation>场景文本有错误：请看编辑器。</translation>
    </message>
    <message>
        <source>This scenario cannot be simulated: %1</source>
        <translation>此场景无法仿真：%1</translation>
    </message>
    <message>
        <source>Edited scenario, not simulated yet</source>
        <translation>场景已编辑，尚未仿真</translation>
    </message>
    <message>
        <source>While a run goes on its pocket is shown: pause it to move the bodies.</source>
        <translation>仿真进行时显示的是它的网袋：要移动物体，请先暂停。</translation>
    </message>
    <message>
        <source>There is no run yet whose frames could be plotted.</source>
        <translation>还没有可绘制其帧的仿真。</translation>
    </message>
    <message>
        <source>Strategy changed</source>
        <translation>策略已更改</translation>
    </message>
    <message>
        <source>%1[*] – Netpocket</source>
        <translation>%1[*] – Netpocket</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>控制</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>结论</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>工具栏</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>仿真(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Time</source>
        <translation>时间(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Find parameter</source>
        <translation>查找参数</translation>
    </message>
    <message>
        <source>Search the scenario&apos;s parameters</source>
        <translation>搜索场景的参数</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>首选项…</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>面板</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>全屏</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>使用整个屏幕</translation>
    </message>
    <message>
        <source>Go to the view</source>
        <translation>转到视图</translation>
    </message>
    <message>
        <source>Let the keys act on the view</source>
        <translation>让按键作用于视图</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>转到“%1”</translation>
    </message>
    <message>
        <source>Show this panel and let the keys act on it</source>
        <translation>显示此面板并让按键作用于它</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>起始页</translation>
    </message>
    <message>
        <source>Recent files, scenarios as pictures, a guided first capture</source>
        <translation>最近的文件、场景图片、首次捕获向导</translation>
    </message>
    <message>
        <source>Guided first capture</source>
        <translation>首次捕获向导</translation>
    </message>
    <message>
        <source>Six steps from the pocket to a picture of its capture</source>
        <translation>从网袋到捕获图片的六个步骤</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>键盘和鼠标</translation>
    </message>
    <message>
        <source>All keys and what the mouse does</source>
        <translation>所有按键和鼠标操作</translation>
    </message>
    <message>
        <source>About Netpocket</source>
        <translation>关于 Netpocket</translation>
    </message>
    <message>
        <source>Versions, and how pictures are drawn</source>
        <translation>版本，以及绘图方式</translation>
    </message>
    <message>
        <source>Campaign</source>
        <translation>批量仿真</translation>
    </message>
    <message>
        <source>Type size, colours, language, folders, pictures, memory, drawing</source>
        <translation>字号、颜色、语言、文件夹、图片、内存、绘图</translation>
    </message>
    <message>
        <source>%1 cannot be shown: it has an error.</source>
        <translation>%1 无法显示：其中有错误。</translation>
    </message>
</context>
<context>
    <name>netpocket::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>关闭此消息</translation>
    </message>
</context>
<context>
    <name>netpocket::NumberField</name>
    <message>
        <source>“%1” is not %2.</source>
        <translation>“%1”不是%2。</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数</translation>
    </message>
</context>
<context>
    <name>netpocket::PairsField</name>
    <message>
        <source>from axis r, m</source>
        <translation>距轴线 r，m</translation>
    </message>
    <message>
        <source>height y, m</source>
        <translation>高度 y，m</translation>
    </message>
    <message>
        <source>time t, s</source>
        <translation>时间 t，s</translation>
    </message>
    <message>
        <source>length L, m</source>
        <translation>长度 L，m</translation>
    </message>
    <message>
        <source>Add a row below</source>
        <translation>在下方添加一行</translation>
    </message>
    <message>
        <source>Remove the row</source>
        <translation>删除该行</translation>
    </message>
    <message>
        <source>root</source>
        <translation>根部</translation>
    </message>
    <message>
        <source>kink</source>
        <translation>折点</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>杆端</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>“%1”不是数。</translation>
    </message>
    <message>
        <source>rope</source>
        <translation>绳</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>网面</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>系数</translation>
    </message>
    <message>
        <source>rod</source>
        <translation>杆</translation>
    </message>
</context>
<context>
    <name>netpocket::ParameterField</name>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
</context>
<context>
    <name>netpocket::ParameterForm</name>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
</context>
<context>
    <name>netpocket::ParameterRow</name>
    <message>
        <source>Back to the saved value, %1</source>
        <translation>恢复为已保存的值 %1</translation>
    </message>
    <message>
        <source>Back to the default, %1</source>
        <translation>恢复为默认值 %1</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>重置%1</translation>
    </message>
    <message>
        <source>Acts on the run at once</source>
        <translation>立即作用于仿真</translation>
    </message>
    <message>
        <source>Changed: acts after a restart. The run has %1.</source>
        <translation>已更改：重新开始后起作用。当前仿真的值为 %1。</translation>
    </message>
    <message>
        <source>Acts after a restart</source>
        <translation>重新开始后起作用</translation>
    </message>
</context>
<context>
    <name>netpocket::PartDialog</name>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Then</source>
        <translation>之后</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>应用(&amp;A)</translation>
    </message>
    <message>
        <source>Pockets, targets, strategies</source>
        <translation>网袋、目标、策略</translation>
    </message>
    <message>
        <source>Pocket</source>
        <translation>网袋</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>Part of the scenario</source>
        <translation>场景的组成部分</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>Make these changes, as one step of the history</source>
        <translation>进行这些更改，作为历史中的一步</translation>
    </message>
    <message>
        <source>In: %1</source>
        <translation>见于：%1</translation>
    </message>
    <message>
        <source>The open scenario is of another capture system.</source>
        <translation>打开的场景属于另一种捕获系统。</translation>
    </message>
    <message>
        <source>The scenario has these values already.</source>
        <translation>场景已经是这些值。</translation>
    </message>
    <message>
        <source>One value would change:</source>
        <translation>将更改 1 个值：</translation>
    </message>
    <message>
        <source>%1 values would change:</source>
        <translation>将更改 %1 个值：</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%2 的%1</translation>
    </message>
</context>
<context>
    <name>netpocket::PickPanel</name>
    <message>
        <source>Selection</source>
        <translation>选中项</translation>
    </message>
    <message>
        <source>Clear the selection (Esc)</source>
        <translation>清除选择 (Esc)</translation>
    </message>
    <message>
        <source>Clear the selection</source>
        <translation>清除选择</translation>
    </message>
    <message>
        <source>Plot over time</source>
        <translation>绘制时间曲线</translation>
    </message>
    <message>
        <source>Draw this over all frames of the run</source>
        <translation>绘出它在仿真所有帧中的变化</translation>
    </message>
</context>
<context>
    <name>netpocket::PlotsPanel</name>
    <message>
        <source>What to plot</source>
        <translation>绘制什么</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>图</translation>
    </message>
    <message>
        <source>All times</source>
        <translation>全部时间</translation>
    </message>
    <message>
        <source>Show the whole run (double click in the plot)</source>
        <translation>显示整个仿真（在图中双击）</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Save this figure as PNG, SVG or PDF</source>
        <translation>把此图保存为 PNG、SVG 或 PDF</translation>
    </message>
    <message>
        <source>Run the scenario or open a recording to see its plots here.</source>
        <translation>运行场景或打开记录后，这里显示其曲线。</translation>
    </message>
    <message>
        <source>Closing length and speed</source>
        <translation>收口绳长与速率</translation>
    </message>
    <message>
        <source>Contact force on the target</source>
        <translation>目标所受接触力</translation>
    </message>
    <message>
        <source>Positions of target and spacecraft</source>
        <translation>目标与服务航天器的位置</translation>
    </message>
    <message>
        <source>Target, run by run</source>
        <translation>目标，逐个仿真</translation>
    </message>
    <message>
        <source>Spacecraft, run by run</source>
        <translation>服务航天器，逐个仿真</translation>
    </message>
    <message>
        <source>Energy balance</source>
        <translation>能量平衡</translation>
    </message>
    <message>
        <source>Tensions</source>
        <translation>张力</translation>
    </message>
    <message>
        <source>Control loops</source>
        <translation>控制回路</translation>
    </message>
    <message>
        <source>Channels of the system</source>
        <translation>系统的通道</translation>
    </message>
    <message>
        <source>Picked items</source>
        <translation>选中的对象</translation>
    </message>
    <message>
        <source>Export figure</source>
        <translation>导出图</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;SVG (*.svg);;PNG (*.png);;Numbers (*.csv)</source>
        <translation>PDF (*.pdf);;SVG (*.svg);;PNG (*.png);;数据 (*.csv)</translation>
    </message>
</context>
<context>
    <name>netpocket::PreferencesDialog</name>
    <message>
        <source>Ask before unsaved runs are lost</source>
        <translation>未保存的仿真将丢失时先询问</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source> MiB</source>
        <translation> MiB</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>OpenGL in the window</source>
        <translation>窗口中的 OpenGL</translation>
    </message>
    <message>
        <source>Images drawn in the background</source>
        <translation>后台绘制的图像</translation>
    </message>
    <message>
        <source>&amp;Frames in memory:</source>
        <translation>内存中的帧(&amp;F)：</translation>
    </message>
    <message>
        <source>%1 MiB are in use. Older frames are read from the recording when they are shown.</source>
        <translation>已使用 %1 MiB。较早的帧在显示时从记录中读取。</translation>
    </message>
    <message>
        <source>&amp;Threads of a simulation:</source>
        <translation>仿真线程数(&amp;T)：</translation>
    </message>
    <message>
        <source>From the next run on. The result is the same for any number; one is fastest for pockets of the usual size.</source>
        <translation>从下一次仿真起生效。结果与线程数无关；对通常大小的网袋，一个线程最快。</translation>
    </message>
    <message>
        <source>&amp;Drawing:</source>
        <translation>绘图(&amp;D)：</translation>
    </message>
    <message>
        <source>From the next start on.</source>
        <translation>从下次启动起生效。</translation>
    </message>
    <message>
        <source>&amp;Language:</source>
        <translation>语言(&amp;L)：</translation>
    </message>
    <message>
        <source>Of the window, from the next start on. Commands and files stay English.</source>
        <translation>窗口的语言，从下次启动起生效。命令和文件仍用英语。</translation>
    </message>
    <message>
        <source>Kinds of preferences</source>
        <translation>首选项类别</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Pictures and videos</source>
        <translation>图片和视频</translation>
    </message>
    <message>
        <source>Simulation and drawing</source>
        <translation>仿真和绘图</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>标准</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>较大</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>跟随桌面</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>The start page</source>
        <translation>起始页</translation>
    </message>
    <message>
        <source>The file used last</source>
        <translation>上次使用的文件</translation>
    </message>
    <message>
        <source>A new scenario</source>
        <translation>新建的场景</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>浏览…</translation>
    </message>
    <message>
        <source>T&amp;ype size:</source>
        <translation>字号(&amp;Y)：</translation>
    </message>
    <message>
        <source>&amp;Colours:</source>
        <translation>颜色(&amp;C)：</translation>
    </message>
    <message>
        <source>&amp;Begin with:</source>
        <translation>启动时打开(&amp;B)：</translation>
    </message>
    <message>
        <source>F&amp;older for new files:</source>
        <translation>新文件的文件夹(&amp;O)：</translation>
    </message>
    <message>
        <source> per simulated second</source>
        <translation> 帧/仿真秒</translation>
    </message>
    <message>
        <source>%1 pictures a second</source>
        <translation>每秒 %1 帧</translation>
    </message>
    <message>
        <source>&amp;Size of exports:</source>
        <translation>导出尺寸(&amp;S)：</translation>
    </message>
    <message>
        <source>&amp;Pictures of exports:</source>
        <translation>导出帧数(&amp;P)：</translation>
    </message>
    <message>
        <source>What the export dialog proposes.</source>
        <translation>导出对话框中的默认值。</translation>
    </message>
    <message>
        <source>&amp;Videos of the window:</source>
        <translation>窗口视频(&amp;V)：</translation>
    </message>
    <message>
        <source>Folder for new files</source>
        <translation>新文件的文件夹</translation>
    </message>
</context>
<context>
    <name>netpocket::Presentation</name>
    <message>
        <source>Presenter mode</source>
        <translation>演示模式</translation>
    </message>
    <message>
        <source>The view in full screen, with large type, for an audience; Esc leaves</source>
        <translation>面向观众的全屏大字视图；按 Esc 退出</translation>
    </message>
</context>
<context>
    <name>netpocket::RunActions</name>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Run or pause the simulation</source>
        <translation>运行或暂停仿真</translation>
    </message>
    <message>
        <source>Single step</source>
        <translation>单步</translation>
    </message>
    <message>
        <source>Simulate one integration step</source>
        <translation>仿真一个积分步</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Simulate the scenario anew from the start</source>
        <translation>从头重新仿真该场景</translation>
    </message>
    <message>
        <source>Branch here</source>
        <translation>在此分支</translation>
    </message>
    <message>
        <source>Run on from the shown frame as a second run, with the strategy as edited</source>
        <translation>从所示的帧起按编辑后的策略继续，作为第二个仿真</translation>
    </message>
    <message>
        <source>Run to time…</source>
        <translation>运行到时刻…</translation>
    </message>
    <message>
        <source>Run to a simulated time</source>
        <translation>运行到某一仿真时刻</translation>
    </message>
    <message>
        <source>Run to next contact</source>
        <translation>运行到下一次接触</translation>
    </message>
    <message>
        <source>Run until the target is touched</source>
        <translation>运行到碰到目标为止</translation>
    </message>
    <message>
        <source>Run to end of closing</source>
        <translation>运行到收口结束</translation>
    </message>
    <message>
        <source>Run until the mouth is closed</source>
        <translation>运行到网口收拢为止</translation>
    </message>
    <message>
        <source>Run to start of towing</source>
        <translation>运行到拖曳开始</translation>
    </message>
    <message>
        <source>Run until towing starts</source>
        <translation>运行到拖曳开始为止</translation>
    </message>
    <message>
        <source>As fast as possible</source>
        <translation>尽可能快</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Slow motion, 1/5</source>
        <translation>慢动作，1/5</translation>
    </message>
    <message>
        <source>Slow motion, 1/20</source>
        <translation>慢动作，1/20</translation>
    </message>
    <message>
        <source>How fast the simulation may go</source>
        <translation>仿真允许的快慢</translation>
    </message>
    <message>
        <source>Pace of the simulation</source>
        <translation>仿真节奏</translation>
    </message>
    <message>
        <source>Run to time</source>
        <translation>运行到时刻</translation>
    </message>
    <message>
        <source>Simulated time, s:</source>
        <translation>仿真时间，s：</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
</context>
<context>
    <name>netpocket::RunFileActions</name>
    <message>
        <source>Save run as…</source>
        <translation>仿真另存为…</translation>
    </message>
    <message>
        <source>Save the shown run as a recording</source>
        <translation>把所示仿真保存为记录</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>Pictures, video, figures, tables of the shown run</source>
        <translation>所示仿真的图片、视频、图、表</translation>
    </message>
    <message>
        <source>There is no run to save yet.</source>
        <translation>还没有可保存的仿真。</translation>
    </message>
    <message>
        <source>Save run</source>
        <translation>保存仿真</translation>
    </message>
    <message>
        <source>Recordings (*.h5)</source>
        <translation>记录 (*.h5)</translation>
    </message>
    <message>
        <source>There is no run to export yet.</source>
        <translation>还没有可导出的仿真。</translation>
    </message>
    <message>
        <source>Cannot write &apos;%1&apos;: %2</source>
        <translation>无法写入“%1”：%2</translation>
    </message>
    <message>
        <source>Unsaved runs</source>
        <translation>未保存的仿真</translation>
    </message>
    <message>
        <source>Save the run &quot;%1&quot;?</source>
        <translation>要保存仿真“%1”吗？</translation>
    </message>
    <message>
        <source>Save %1 runs?</source>
        <translation>要保存 %1 个仿真吗？</translation>
    </message>
    <message>
        <source>Otherwise what was simulated is lost.</source>
        <translation>否则仿真结果将丢失。</translation>
    </message>
    <message>
        <source>Save runs in</source>
        <translation>仿真保存位置</translation>
    </message>
    <message>
        <source>Unsaved run</source>
        <translation>未保存的仿真</translation>
    </message>
    <message>
        <source>Remove the run &quot;%1&quot;?</source>
        <translation>要移除仿真“%1”吗？</translation>
    </message>
    <message>
        <source>It is not saved: what was simulated is lost.</source>
        <translation>它尚未保存：仿真结果将丢失。</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
</context>
<context>
    <name>netpocket::RunLibrary</name>
    <message>
        <source>%1, from %2 s</source>
        <translation>%1，自 %2 s</translation>
    </message>
    <message>
        <source>Branched from %1</source>
        <translation>由 %1 分支</translation>
    </message>
    <message>
        <source>Cannot take over &apos;%1&apos;.</source>
        <translation>无法接管“%1”。</translation>
    </message>
    <message>
        <source>%1, recovered</source>
        <translation>%1，已恢复</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is the recording of the run &quot;%2&quot; in this window: save under another name.</source>
        <translation>“%1”是本窗口中仿真“%2”的记录：请以另一个名称保存。</translation>
    </message>
</context>
<context>
    <name>netpocket::RunStatusBar</name>
    <message>
        <source>Preparing</source>
        <translation>准备中</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>已记录</translation>
    </message>
    <message>
        <source>Diverged</source>
        <translation>发散</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>step %1 ms: %2</source>
        <translation>步长 %1 ms：%2</translation>
    </message>
    <message>
        <source>step %1 µs: %2</source>
        <translation>步长 %1 µs：%2</translation>
    </message>
    <message>
        <source>energy error %1 J</source>
        <translation>能量误差 %1 J</translation>
    </message>
    <message>
        <source>energy error %1 %</source>
        <translation>能量误差 %1 %</translation>
    </message>
    <message>
        <source>What the run is doing</source>
        <translation>仿真正在做什么</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>仿真时间</translation>
    </message>
    <message>
        <source>t = %1 s</source>
        <translation>t = %1 s</translation>
    </message>
    <message>
        <source>Speed of the simulation against real time</source>
        <translation>仿真速度与实时之比</translation>
    </message>
    <message>
        <source>%1 × real time</source>
        <translation>%1 × 实时</translation>
    </message>
    <message>
        <source>Integration step, and what limits it</source>
        <translation>积分步长，以及限制它的因素</translation>
    </message>
    <message>
        <source>Contact points that touch the target</source>
        <translation>与目标接触的接触点数</translation>
    </message>
    <message>
        <source>contacts: %1</source>
        <translation>接触点：%1</translation>
    </message>
    <message>
        <source>Energy balance: its error against the energy put in</source>
        <translation>能量平衡：误差与输入能量之比</translation>
    </message>
    <message>
        <source>No run</source>
        <translation>无仿真</translation>
    </message>
    <message>
        <source>At its limit of steps</source>
        <translation>达到步数上限</translation>
    </message>
    <message>
        <source>draft: capture %1 ± %2 points, impulse %3 ± %4 %</source>
        <translation>草算：捕获概率 %1 ± %2 个百分点，冲量 %3 ± %4 %</translation>
    </message>
</context>
<context>
    <name>netpocket::RunsPanel</name>
    <message>
        <source>diverged</source>
        <translation>发散</translation>
    </message>
    <message>
        <source>preparing</source>
        <translation>准备中</translation>
    </message>
    <message>
        <source>running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>recorded</source>
        <translation>已记录</translation>
    </message>
    <message>
        <source>Runs and opened recordings are listed here.</source>
        <translation>这里列出仿真和打开的记录。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>至</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Select: show this run. Tick: draw it over the shown run in the plots. F2: rename. Del: remove</source>
        <translation>选中：显示该仿真。勾选：在曲线中叠加到所示仿真上。F2：重命名。Del：移除</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>at its limit of steps</source>
        <translation>达到步数上限</translation>
    </message>
</context>
<context>
    <name>netpocket::ScatterRow</name>
    <message>
        <source>Evenly, up to ±</source>
        <translation>均匀，至多 ±</translation>
    </message>
    <message>
        <source>Normal, deviation</source>
        <translation>正态，标准差</translation>
    </message>
    <message>
        <source>Factor, log-deviation</source>
        <translation>系数，对数标准差</translation>
    </message>
    <message>
        <source>Any direction, up to</source>
        <translation>任意方向，至多</translation>
    </message>
    <message>
        <source>All values around the scenario&apos;s are equally likely, up to this far</source>
        <translation>在场景值两侧此范围内，所有值的可能性相同</translation>
    </message>
    <message>
        <source>Normal distribution about the scenario&apos;s value, with this standard deviation</source>
        <translation>以场景值为均值、以此为标准差的正态分布</translation>
    </message>
    <message>
        <source>The scenario&apos;s value times a log-normal number about 1; the standard deviation of its logarithm</source>
        <translation>场景值乘以中位数为 1 的对数正态数；此为其对数的标准差</translation>
    </message>
    <message>
        <source>A vector in any direction, of any length up to this</source>
        <translation>任意方向、长度不超过此值的矢量</translation>
    </message>
    <message>
        <source>How %1 scatters</source>
        <translation>%1的分布方式</translation>
    </message>
    <message>
        <source>By how much %1 scatters</source>
        <translation>%1的分散程度</translation>
    </message>
    <message>
        <source>Not uncertain: remove this input</source>
        <translation>不作为不确定量：移除此输入</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除%1</translation>
    </message>
    <message>
        <source> – not in this scenario</source>
        <translation> – 此场景中没有</translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1：%2 %3</translation>
    </message>
</context>
<context>
    <name>netpocket::ScenarioDocument</name>
    <message>
        <source>set %1 to %2</source>
        <translation>将%1设为 %2</translation>
    </message>
    <message>
        <source>edit the text</source>
        <translation>编辑文本</translation>
    </message>
    <message numerus="yes">
        <source>edit the text (%n values)</source>
        <translation>
            <numerusform>编辑文本（%n 个值）</numerusform>
        </translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>revert to the saved version</source>
        <translation>恢复到已保存的版本</translation>
    </message>
    <message>
        <source>The scenario has no file yet.</source>
        <translation>场景还没有文件。</translation>
    </message>
</context>
<context>
    <name>netpocket::ScenarioEditor</name>
    <message>
        <source>Form</source>
        <translation>表单</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>搜索参数</translation>
    </message>
    <message>
        <source>Part of a name, key, unit, help or source</source>
        <translation>名称、键名、单位、说明或来源的一部分</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>已更改</translation>
    </message>
    <message>
        <source>Show only values that differ from the file</source>
        <translation>只显示与文件不同的值</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>转到该处</translation>
    </message>
    <message>
        <source>Nothing differs from the file.</source>
        <translation>与文件没有差异。</translation>
    </message>
    <message>
        <source>No parameter matches “%1”.</source>
        <translation>没有与“%1”匹配的参数。</translation>
    </message>
    <message>
        <source>1 change acts after a restart of the run.</source>
        <translation>有 1 项更改在重新开始仿真后起作用。</translation>
    </message>
    <message>
        <source>%1 changes act after a restart of the run.</source>
        <translation>有 %1 项更改在重新开始仿真后起作用。</translation>
    </message>
    <message>
        <source>The text has an error in line %1.</source>
        <translation>文本第 %1 行有错误。</translation>
    </message>
    <message>
        <source>The text has an error.</source>
        <translation>文本有错误。</translation>
    </message>
    <message>
        <source>Text (error)</source>
        <translation>文本（有错误）</translation>
    </message>
    <message>
        <source>an untitled scenario</source>
        <translation>未命名的场景</translation>
    </message>
    <message>
        <source>Unsaved changes of %1 from %2 were found.</source>
        <translation>发现 %1 未保存的更改，时间为 %2。</translation>
    </message>
    <message>
        <source>Cannot be recovered: %1</source>
        <translation>无法恢复：%1</translation>
    </message>
    <message>
        <source>%1 has an error: the form shows it once its text is mended.</source>
        <translation>%1 有错误：文本改正后表单才显示它。</translation>
    </message>
</context>
<context>
    <name>netpocket::SecondView</name>
    <message>
        <source>Second view</source>
        <translation>第二视图</translation>
    </message>
    <message>
        <source>Run of the second view</source>
        <translation>第二视图的仿真</translation>
    </message>
    <message>
        <source>Which run the second view shows, at the same time as the first</source>
        <translation>第二视图在同一时刻显示哪个仿真</translation>
    </message>
    <message>
        <source>Camera of the second view</source>
        <translation>第二视图的相机</translation>
    </message>
    <message>
        <source>Where from</source>
        <translation>观察方位</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>联动</translation>
    </message>
    <message>
        <source>Look at both views from the same place</source>
        <translation>从同一位置观察两个视图</translation>
    </message>
    <message>
        <source>Same run</source>
        <translation>同一仿真</translation>
    </message>
</context>
<context>
    <name>netpocket::ShortcutSheet</name>
    <message>
        <source>Viewport</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Left drag, arrows</source>
        <translation>左键拖动、方向键</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>环绕</translation>
    </message>
    <message>
        <source>Shift or middle drag</source>
        <translation>Shift 拖动或中键拖动</translation>
    </message>
    <message>
        <source>Pan (Shift with arrows)</source>
        <translation>平移（Shift 加方向键）</translation>
    </message>
    <message>
        <source>Ctrl drag</source>
        <translation>Ctrl 拖动</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>滚转</translation>
    </message>
    <message>
        <source>Wheel, right drag, + −</source>
        <translation>滚轮、右键拖动、+ −</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>单击</translation>
    </message>
    <message>
        <source>Pick a cord, node or body</source>
        <translation>选取绳、节点或物体</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>双击</translation>
    </message>
    <message>
        <source>Look at what is there</source>
        <translation>看向该处</translation>
    </message>
    <message>
        <source>Drag while moving bodies</source>
        <translation>移动物体时拖动</translation>
    </message>
    <message>
        <source>Move target or spacecraft</source>
        <translation>移动目标或服务航天器</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Clear the selection</source>
        <translation>清除选择</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Left, right</source>
        <translation>左、右</translation>
    </message>
    <message>
        <source>One frame back, on</source>
        <translation>后退、前进一帧</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Page Up、Page Down</translation>
    </message>
    <message>
        <source>One second back, on</source>
        <translation>后退、前进一秒</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Home、End</translation>
    </message>
    <message>
        <source>Start, end</source>
        <translation>开头、结尾</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Go to this time</source>
        <translation>转到此时刻</translation>
    </message>
    <message>
        <source>Wheel, + −</source>
        <translation>滚轮、+ −</translation>
    </message>
    <message>
        <source>Zoom in time</source>
        <translation>缩放时间</translation>
    </message>
    <message>
        <source>Drag, left, right</source>
        <translation>拖动、左、右</translation>
    </message>
    <message>
        <source>Pan in time</source>
        <translation>平移时间</translation>
    </message>
    <message>
        <source>Double click, Home</source>
        <translation>双击、Home</translation>
    </message>
    <message>
        <source>All times</source>
        <translation>全部时间</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Up, down</source>
        <translation>上、下</translation>
    </message>
    <message>
        <source>Show this run</source>
        <translation>显示该仿真</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空格</translation>
    </message>
    <message>
        <source>Draw it over the shown run in the plots</source>
        <translation>在曲线中叠加到所示仿真上</translation>
    </message>
    <message>
        <source>F2, Del</source>
        <translation>F2、Del</translation>
    </message>
    <message>
        <source>Rename, remove</source>
        <translation>重命名、移除</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>键盘和鼠标</translation>
    </message>
    <message>
        <source>All keys</source>
        <translation>所有按键</translation>
    </message>
</context>
<context>
    <name>netpocket::StartPage</name>
    <message>
        <source>&amp;Guided first capture</source>
        <translation>首次捕获向导(&amp;G)</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>最近的文件</translation>
    </message>
    <message>
        <source>Files that you open are listed here.</source>
        <translation>打开过的文件列在这里。</translation>
    </message>
    <message>
        <source>Scenarios that come with the program</source>
        <translation>程序自带的场景</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>起始页</translation>
    </message>
    <message>
        <source>Simulates how a pocket of net captures space debris.</source>
        <translation>仿真网袋如何捕获空间碎片。</translation>
    </message>
    <message>
        <source>To the &amp;window</source>
        <translation>进入窗口(&amp;W)</translation>
    </message>
    <message>
        <source>Close this page (Esc); the menu Help brings it back</source>
        <translation>关闭此页 (Esc)；可从“帮助”菜单再次打开</translation>
    </message>
    <message>
        <source>&amp;New scenario</source>
        <translation>新建场景(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Six steps from the pocket to a picture of its capture</source>
        <translation>从网袋到捕获图片的六个步骤</translation>
    </message>
    <message>
        <source>Start from the defaults</source>
        <translation>从默认值开始</translation>
    </message>
    <message>
        <source>Open a scenario (.toml) or a recording (.h5)</source>
        <translation>打开场景 (.toml) 或记录 (.h5)</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近</translation>
    </message>
</context>
<context>
    <name>netpocket::StillFigure</name>
    <message>
        <source>Figure of the campaign</source>
        <translation>批量仿真的图</translation>
    </message>
</context>
<context>
    <name>netpocket::StudyForm</name>
    <message>
        <source>How often does this scenario catch its target when its inputs are uncertain?</source>
        <translation>输入不确定时，此场景有多大比例捕获目标？</translation>
    </message>
    <message>
        <source>Uncertain inputs</source>
        <translation>不确定输入</translation>
    </message>
    <message>
        <source>Each scatters about the scenario&apos;s value</source>
        <translation>各自围绕场景值分散</translation>
    </message>
    <message>
        <source>Captures</source>
        <translation>捕获次数</translation>
    </message>
    <message>
        <source>How many, and what is estimated from them</source>
        <translation>运行多少次，以及由此估计什么</translation>
    </message>
    <message>
        <source>Add an input: type a part of its name</source>
        <translation>添加输入：键入其名称的一部分</translation>
    </message>
    <message>
        <source>Input to add</source>
        <translation>要添加的输入</translation>
    </message>
    <message>
        <source>How many captures to run</source>
        <translation>要运行的捕获次数</translation>
    </message>
    <message>
        <source>Another seed draws other values</source>
        <translation>不同的种子抽取不同的值</translation>
    </message>
    <message>
        <source>Captures at a time; each takes one processor core</source>
        <translation>同时运行的捕获数；每个占用一个处理器核</translation>
    </message>
    <message>
        <source>Sobol (even)</source>
        <translation>Sobol（均匀）</translation>
    </message>
    <message>
        <source>Latin hypercube</source>
        <translation>拉丁超立方</translation>
    </message>
    <message>
        <source>Monte Carlo</source>
        <translation>蒙特卡洛</translation>
    </message>
    <message>
        <source>How the values are drawn; with Sobol points and Monte Carlo more can be added later</source>
        <translation>取值方法；用 Sobol 点和蒙特卡洛时，以后可以增加样本点</translation>
    </message>
    <message>
        <source>What is estimated besides the probability of capture: 5 %, 50 % and 95 % quantiles</source>
        <translation>除捕获概率外还估计什么：5 %、50 % 和 95 % 分位数</translation>
    </message>
    <message>
        <source>End early at ±</source>
        <translation>提前结束于 ±</translation>
    </message>
    <message>
        <source>End when the 95 % interval of the probability of capture is no wider than this</source>
        <translation>捕获概率的 95 % 区间不宽于此值时结束</translation>
    </message>
    <message>
        <source>Half width of the interval</source>
        <translation>区间半宽</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>样本点数</translation>
    </message>
    <message>
        <source>Drawn by</source>
        <translation>取样方法</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>估计量</translation>
    </message>
    <message>
        <source>At a time</source>
        <translation>同时运行</translation>
    </message>
    <message>
        <source>Run campaign…</source>
        <translation>运行批量仿真…</translation>
    </message>
    <message>
        <source>Save this as a study and run it in the background</source>
        <translation>保存为研究并在后台运行</translation>
    </message>
    <message>
        <source>Save study…</source>
        <translation>保存研究…</translation>
    </message>
    <message>
        <source>Save this as a study (TOML) for &quot;netpocket study&quot;</source>
        <translation>保存为供 &quot;netpocket study&quot; 使用的研究 (TOML)</translation>
    </message>
    <message>
        <source>Run a study file…</source>
        <translation>运行研究文件…</translation>
    </message>
    <message>
        <source>Run a study that is a file already</source>
        <translation>运行已有的研究文件</translation>
    </message>
    <message>
        <source>Open folder…</source>
        <translation>打开文件夹…</translation>
    </message>
    <message>
        <source>Look at the folder of a study that runs, was interrupted or is done</source>
        <translation>查看正在运行、已中断或已完成的研究文件夹</translation>
    </message>
    <message>
        <source>Probability only</source>
        <translation>仅概率</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1，另有 %2 项</translation>
    </message>
</context>
<context>
    <name>netpocket::TimelineBar</name>
    <message>
        <source>To the start</source>
        <translation>到开头</translation>
    </message>
    <message>
        <source>Go to the first frame</source>
        <translation>转到第一帧</translation>
    </message>
    <message>
        <source>Play backwards</source>
        <translation>倒放</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>上一帧</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>后退一帧</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Play what is recorded</source>
        <translation>播放已记录的内容</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>下一帧</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>前进一帧</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>到结尾</translation>
    </message>
    <message>
        <source>Go to the last frame and follow the run</source>
        <translation>转到最后一帧并跟随仿真</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>循环</translation>
    </message>
    <message>
        <source>Start over when the end is reached</source>
        <translation>到结尾时从头开始</translation>
    </message>
    <message>
        <source>Add marker</source>
        <translation>添加标记</translation>
    </message>
    <message>
        <source>Mark this time</source>
        <translation>标记此时刻</translation>
    </message>
    <message>
        <source>Remove marker</source>
        <translation>移除标记</translation>
    </message>
    <message>
        <source>Remove the own marker here</source>
        <translation>移除此处自己的标记</translation>
    </message>
    <message>
        <source>Next marker</source>
        <translation>下一个标记</translation>
    </message>
    <message>
        <source>Go to the next marker</source>
        <translation>转到下一个标记</translation>
    </message>
    <message>
        <source>Previous marker</source>
        <translation>上一个标记</translation>
    </message>
    <message>
        <source>Go to the previous marker</source>
        <translation>转到上一个标记</translation>
    </message>
    <message>
        <source>Speed of playing, against real time</source>
        <translation>播放速度与实时之比</translation>
    </message>
    <message>
        <source>Speed of playing</source>
        <translation>播放速度</translation>
    </message>
    <message>
        <source>Time shown, and end of what is recorded</source>
        <translation>所示时刻，以及记录的结尾</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>%1 / %2 s</source>
        <translation>%1 / %2 s</translation>
    </message>
</context>
<context>
    <name>netpocket::TimelineStrip</name>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>%1 s – click or drag to go there</source>
        <translation>%1 s – 点击或拖动以转到该处</translation>
    </message>
</context>
<context>
    <name>netpocket::TomlEditView</name>
    <message>
        <source>Scenario as TOML</source>
        <translation>TOML 形式的场景</translation>
    </message>
</context>
<context>
    <name>netpocket::ViewActions</name>
    <message>
        <source>Where from (1 to 5)</source>
        <translation>观察方位（1 至 5）</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合窗口</translation>
    </message>
    <message>
        <source>Show everything, from where one looks now</source>
        <translation>从当前方位显示全部</translation>
    </message>
    <message>
        <source>Follow target</source>
        <translation>跟随目标</translation>
    </message>
    <message>
        <source>Let the camera move with the target</source>
        <translation>让相机随目标移动</translation>
    </message>
    <message>
        <source>Measure distance</source>
        <translation>测量距离</translation>
    </message>
    <message>
        <source>Click two points to measure their distance</source>
        <translation>点击两点以测量其距离</translation>
    </message>
    <message>
        <source>Move bodies</source>
        <translation>移动物体</translation>
    </message>
    <message>
        <source>Drag the target or the spacecraft to where the capture starts</source>
        <translation>把目标或服务航天器拖到捕获开始时的位置</translation>
    </message>
    <message>
        <source>Second view</source>
        <translation>第二视图</translation>
    </message>
    <message>
        <source>Another view beside this one, of this run or of another</source>
        <translation>在旁边再开一个视图，显示此仿真或另一个</translation>
    </message>
    <message>
        <source>Saved cameras</source>
        <translation>已存相机</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>相机 %1</translation>
    </message>
    <message>
        <source>Go back to a saved camera</source>
        <translation>回到已存的相机</translation>
    </message>
    <message>
        <source>Save as camera %1</source>
        <translation>存为相机 %1</translation>
    </message>
    <message>
        <source>Save this camera</source>
        <translation>保存此相机</translation>
    </message>
    <message>
        <source>What the colours of cords and rods show (C)</source>
        <translation>绳和充气杆的颜色表示什么 (C)</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Plain colours</source>
        <translation>素色</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>张力</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>应变</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>Contact force</source>
        <translation>接触力</translation>
    </message>
    <message>
        <source>Next colours</source>
        <translation>下一种颜色</translation>
    </message>
    <message>
        <source>Colour by the next quantity</source>
        <translation>按下一个量着色</translation>
    </message>
    <message>
        <source>Colour cords and rods</source>
        <translation>给绳和充气杆着色</translation>
    </message>
    <message>
        <source>See through the target</source>
        <translation>透视目标</translation>
    </message>
    <message>
        <source>Let what is behind the target shine through</source>
        <translation>让目标后面的物体透显出来</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Contact forces</source>
        <translation>接触力</translation>
    </message>
    <message>
        <source>Show the force of each contact as an arrow</source>
        <translation>用箭头表示每处接触的力</translation>
    </message>
    <message>
        <source>Trails</source>
        <translation>轨迹</translation>
    </message>
    <message>
        <source>Show where the centres of mass have been so far</source>
        <translation>显示质心至今经过的路径</translation>
    </message>
    <message>
        <source>Initial shape</source>
        <translation>初始形状</translation>
    </message>
    <message>
        <source>Show the pocket as it was at the start, too</source>
        <translation>同时显示网袋起始时的样子</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>图例</translation>
    </message>
    <message>
        <source>Show what the colours mean</source>
        <translation>说明颜色的含义</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Show the time in the picture</source>
        <translation>在图中显示时间</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>比例尺</translation>
    </message>
    <message>
        <source>Show how long a metre is</source>
        <translation>显示一米有多长</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>坐标轴</translation>
    </message>
    <message>
        <source>Show the world&apos;s directions</source>
        <translation>显示世界坐标系的方向</translation>
    </message>
    <message>
        <source>Smooth lines</source>
        <translation>平滑线条</translation>
    </message>
    <message>
        <source>Smooth edges; off: faster</source>
        <translation>平滑边缘；关闭则更快</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>As the window</source>
        <translation>与窗口相同</translation>
    </message>
    <message>
        <source>White</source>
        <translation>白色</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>太空</translation>
    </message>
    <message>
        <source>Background of the picture</source>
        <translation>图片的背景</translation>
    </message>
</context>
<context>
    <name>netpocket::Viewport</name>
    <message>
        <source>Viewport</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Nothing can be drawn: %1</source>
        <translation>无法绘图：%1</translation>
    </message>
    <message>
        <source>Click two points to measure their distance</source>
        <translation>点击两点以测量其距离</translation>
    </message>
    <message>
        <source>Drag the target or the spacecraft; with Shift along one axis</source>
        <translation>拖动目标或服务航天器；按住 Shift 则沿一个轴</translation>
    </message>
</context>
<context>
    <name>netpocket::WindowFilm</name>
    <message>
        <source>Recording the window has ended because the disk is nearly full; &quot;%1&quot; is whole.</source>
        <translation>因磁盘将满，窗口录制已结束；“%1”是完整的。</translation>
    </message>
    <message>
        <source>The window&apos;s recording: %1</source>
        <translation>窗口录制：%1</translation>
    </message>
</context>
<context>
    <name>parameters</name>
    <message>
        <source>Scenario</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>What the scenario is called, and what kind of system it describes.</source>
        <translation>场景的名称，以及它描述哪种系统。</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>name of the scenario, on figures and in tables; default: the file&apos;s name</source>
        <translation>场景的名称，出现在图和表中；默认为文件名</translation>
    </message>
    <message>
        <source>user&apos;s choice</source>
        <translation>由用户选择</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>what the scenario shows</source>
        <translation>场景展示的内容</translation>
    </message>
    <message>
        <source>System</source>
        <translation>系统</translation>
    </message>
    <message>
        <source>kind of capture system; it decides which tables a scenario has</source>
        <translation>捕获系统的种类；它决定场景有哪些表</translation>
    </message>
    <message>
        <source>Pocket</source>
        <translation>网袋</translation>
    </message>
    <message>
        <source>Rods and meshes of the netted pocket.</source>
        <translation>网袋的充气杆与网目。</translation>
    </message>
    <message>
        <source>Rod count</source>
        <translation>充气杆数</translation>
    </message>
    <message>
        <source>rods, on a regular polygon</source>
        <translation>充气杆数，排成正多边形</translation>
    </message>
    <message>
        <source>paper, section 2</source>
        <translation>论文第 2 节</translation>
    </message>
    <message>
        <source>Mesh columns</source>
        <translation>网目列数</translation>
    </message>
    <message>
        <source>cells across a panel at the kink; also rows of its triangular part</source>
        <translation>折点处一个网面横向的网目数；也是其三角形部分的行数</translation>
    </message>
    <message>
        <source>assumption</source>
        <translation>假设</translation>
    </message>
    <message>
        <source>Mesh rows</source>
        <translation>网目行数</translation>
    </message>
    <message>
        <source>rows of the square part of a panel, from kink to tip</source>
        <translation>网面四边形部分（从折点到杆端）的行数</translation>
    </message>
    <message>
        <source>Elements per side</source>
        <translation>每边单元数</translation>
    </message>
    <message>
        <source>cable elements on a side of a mesh</source>
        <translation>网目每边的索单元数</translation>
    </message>
    <message>
        <source>Bow</source>
        <translation>初始弯度</translation>
    </message>
    <message>
        <source>rise of a mesh side at its middle, part of its length: no cord is straight; 0 leaves it to round-off how cords buckle</source>
        <translation>网目边中点的拱高与边长之比：没有绳是笔直的；0 则由舍入误差决定绳如何屈曲</translation>
    </message>
    <message>
        <source>assumption: sensitivity to imperfections, Koiter 1945</source>
        <translation>假设：对缺陷的敏感性，Koiter 1945</translation>
    </message>
    <message>
        <source>Net cords</source>
        <translation>网绳</translation>
    </message>
    <message>
        <source>Material of the net&apos;s cords.</source>
        <translation>绳网中绳的材料。</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>diameter of a cord</source>
        <translation>绳的直径</translation>
    </message>
    <message>
        <source>paper, Table 2</source>
        <translation>论文表 2</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>杨氏模量</translation>
    </message>
    <message>
        <source>paper, Table 2, printed without unit, taken as GPa</source>
        <translation>论文表 2，原文未印单位，按 GPa 理解</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>泊松比</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio, for the contact stiffness</source>
        <translation>泊松比，用于接触刚度</translation>
    </message>
    <message>
        <source>Axial damping</source>
        <translation>轴向阻尼</translation>
    </message>
    <message>
        <source>c of the axial force EA (eps + c epsdot)</source>
        <translation>轴向力 EA (eps + c epsdot) 中的 c</translation>
    </message>
    <message>
        <source>Bending damping</source>
        <translation>弯曲阻尼</translation>
    </message>
    <message>
        <source>c of the bending moment EI (kappa + c kappadot)</source>
        <translation>弯矩 EI (kappa + c kappadot) 中的 c</translation>
    </message>
    <message>
        <source>assumption: about the loss of stranded rope</source>
        <translation>假设：约为绞合绳的损耗</translation>
    </message>
    <message>
        <source>Compression</source>
        <translation>受压比</translation>
    </message>
    <message>
        <source>fraction of EA that acts in compression; 0: tension only</source>
        <translation>受压时起作用的 EA 比例；0：只受拉</translation>
    </message>
    <message>
        <source>paper, Eq. 11: no difference between tension and compression</source>
        <translation>论文式 11：拉压无差别</translation>
    </message>
    <message>
        <source>Closing ropes</source>
        <translation>收口绳</translation>
    </message>
    <message>
        <source>Material of the ropes between adjacent rod tips.</source>
        <translation>相邻杆端之间的绳的材料。</translation>
    </message>
    <message>
        <source>diameter of a rope</source>
        <translation>绳的直径</translation>
    </message>
    <message>
        <source>assumption: as the net</source>
        <translation>假设：与绳网相同</translation>
    </message>
    <message>
        <source>Rods</source>
        <translation>充气杆</translation>
    </message>
    <message>
        <source>Shape, section and material of the inflatable rods.</source>
        <translation>充气杆的形状、截面和材料。</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>[distance from the axis, height y] of root, kink and tip of a rod</source>
        <translation>充气杆根部、折点和杆端的 [距轴线的距离, 高度 y]</translation>
    </message>
    <message>
        <source>tip: paper, section 2, diameter 15.12 m, depth 12 m; root and kink: assumption</source>
        <translation>杆端：论文第 2 节，直径 15.12 m，深 12 m；根部和折点：假设</translation>
    </message>
    <message>
        <source>Outer diameter</source>
        <translation>外径</translation>
    </message>
    <message>
        <source>outer diameter</source>
        <translation>外径</translation>
    </message>
    <message>
        <source>paper, section 2; Table 2 prints 0.01 m</source>
        <translation>论文第 2 节；表 2 印为 0.01 m</translation>
    </message>
    <message>
        <source>Wall lower</source>
        <translation>下段壁厚</translation>
    </message>
    <message>
        <source>thickness of the wall from root to kink; half the outer diameter: solid</source>
        <translation>从根部到折点的壁厚；外径的一半：实心</translation>
    </message>
    <message>
        <source>Wall upper</source>
        <translation>上段壁厚</translation>
    </message>
    <message>
        <source>thickness of the wall from kink to tip; half the outer diameter: solid</source>
        <translation>从折点到杆端的壁厚；外径的一半：实心</translation>
    </message>
    <message>
        <source>density of the wall</source>
        <translation>壁的密度</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the wall</source>
        <translation>壁的杨氏模量</translation>
    </message>
    <message>
        <source>elements of a rod between two rows of the net; 0: as pocket.elements_per_side</source>
        <translation>充气杆在绳网两行之间的单元数；0：同 pocket.elements_per_side</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>压力</translation>
    </message>
    <message>
        <source>pressure of the gas inside, beyond whose wrinkling moment pi p r^3/2 a rod softens; 0: does not wrinkle</source>
        <translation>内部气体的压力；超过其起皱弯矩 pi p r^3/2 后充气杆变软；0：不起皱</translation>
    </message>
    <message>
        <source>assumption; law: Comer &amp; Levy 1963</source>
        <translation>假设；规律：Comer &amp; Levy 1963</translation>
    </message>
    <message>
        <source>Hinge stiffness</source>
        <translation>铰刚度</translation>
    </message>
    <message>
        <source>stiffness of the joint at the kink</source>
        <translation>折点处铰的刚度</translation>
    </message>
    <message>
        <source>Hinge damping</source>
        <translation>铰阻尼</translation>
    </message>
    <message>
        <source>damping of the joint at the kink</source>
        <translation>折点处铰的阻尼</translation>
    </message>
    <message>
        <source>Tip mass</source>
        <translation>杆端质量</translation>
    </message>
    <message>
        <source>mass of the retractor at each rod tip</source>
        <translation>每个杆端的收绳器的质量</translation>
    </message>
    <message>
        <source>Spacecraft</source>
        <translation>服务航天器</translation>
    </message>
    <message>
        <source>The service spacecraft; the rods&apos; roots are clamped to it.</source>
        <translation>服务航天器；充气杆的根部固定在其上。</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>paper, Table 1</source>
        <translation>论文表 1</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>转动惯量</translation>
    </message>
    <message>
        <source>principal moments of inertia about the centre of mass, body axes</source>
        <translation>绕质心的主转动惯量，本体轴</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>centre of mass at the start</source>
        <translation>起始时的质心</translation>
    </message>
    <message>
        <source>paper, section 4.2</source>
        <translation>论文第 4.2 节</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>edges of the bus, a box about the centre of mass</source>
        <translation>本体（以质心为中心的长方体）的边长</translation>
    </message>
    <message>
        <source>Station keeping</source>
        <translation>位姿保持</translation>
    </message>
    <message>
        <source>free: nothing held; attitude: attitude held; lateral: attitude, x and z held</source>
        <translation>free：不保持；attitude：保持姿态；lateral：保持姿态以及 x 和 z</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>The body to be captured.</source>
        <translation>被捕获的物体。</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>radius of a sphere or cylinder</source>
        <translation>球体或圆柱体的半径</translation>
    </message>
    <message>
        <source>edges of a box or of a satellite&apos;s bus</source>
        <translation>长方体或卫星本体的边长</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>length of a cylinder, along its y axis</source>
        <translation>圆柱体的长度，沿其 y 轴</translation>
    </message>
    <message>
        <source>Span</source>
        <translation>翼展</translation>
    </message>
    <message>
        <source>length of a satellite from tip to tip of its solar panels, along its x axis</source>
        <translation>卫星两侧太阳翼翼尖之间的长度，沿其 x 轴</translation>
    </message>
    <message>
        <source>Panel width</source>
        <translation>太阳翼宽度</translation>
    </message>
    <message>
        <source>width of a satellite&apos;s solar panels, along its y axis</source>
        <translation>卫星太阳翼的宽度，沿其 y 轴</translation>
    </message>
    <message>
        <source>Dish diameter</source>
        <translation>天线直径</translation>
    </message>
    <message>
        <source>diameter of a satellite&apos;s dish, at the +y side of its bus</source>
        <translation>卫星抛物面天线的直径，位于本体 +y 侧</translation>
    </message>
    <message>
        <source>Mesh file</source>
        <translation>网格文件</translation>
    </message>
    <message>
        <source>mesh: STL or OBJ file in the scenario&apos;s folder or below; its centre of mass becomes the body&apos;s</source>
        <translation>mesh：场景文件夹或其下的 STL 或 OBJ 文件；其质心即物体的质心</translation>
    </message>
    <message>
        <source>Mesh unit</source>
        <translation>网格单位</translation>
    </message>
    <message>
        <source>mesh: unit of the file&apos;s coordinates</source>
        <translation>mesh：文件坐标的单位</translation>
    </message>
    <message>
        <source>Inertia from</source>
        <translation>惯量来源</translation>
    </message>
    <message>
        <source>given: target.inertia; shape: that of the shape filled evenly with the mass</source>
        <translation>given：target.inertia；shape：质量均匀充满该形状时的惯量</translation>
    </message>
    <message>
        <source>Attitude</source>
        <translation>姿态</translation>
    </message>
    <message>
        <source>rotation vector that turns the world axes into the body axes at the start</source>
        <translation>起始时把世界轴转到本体轴的旋转矢量</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>velocity of the centre of mass at the start</source>
        <translation>起始时质心的速度</translation>
    </message>
    <message>
        <source>paper, section 4.2: at rest</source>
        <translation>论文第 4.2 节：静止</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>角速度</translation>
    </message>
    <message>
        <source>angular velocity at the start, world axes</source>
        <translation>起始时的角速度，世界轴</translation>
    </message>
    <message>
        <source>Thrust</source>
        <translation>推力</translation>
    </message>
    <message>
        <source>thrust of its own through the centre of mass, body axes</source>
        <translation>自身的推力，通过质心，本体轴</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>力矩</translation>
    </message>
    <message>
        <source>torque of its own, body axes</source>
        <translation>自身的力矩，本体轴</translation>
    </message>
    <message>
        <source>Acts from</source>
        <translation>作用始于</translation>
    </message>
    <message>
        <source>time at which thrust and torque of its own begin</source>
        <translation>自身推力和力矩开始的时刻</translation>
    </message>
    <message>
        <source>Acts until</source>
        <translation>作用止于</translation>
    </message>
    <message>
        <source>time at which they end</source>
        <translation>它们结束的时刻</translation>
    </message>
    <message>
        <source>Young&apos;s modulus, for the contact stiffness</source>
        <translation>杨氏模量，用于接触刚度</translation>
    </message>
    <message>
        <source>assumption: aluminium</source>
        <translation>假设：铝</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Contact of cords, ropes and rods with target and spacecraft and among themselves, and of these two.</source>
        <translation>绳、索和充气杆与目标、服务航天器之间、它们相互之间以及后两者之间的接触。</translation>
    </message>
    <message>
        <source>Restitution</source>
        <translation>恢复系数</translation>
    </message>
    <message>
        <source>Newton&apos;s coefficient of restitution c_r of the paper&apos;s section 3.3</source>
        <translation>论文第 3.3 节的牛顿恢复系数 c_r</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>摩擦系数</translation>
    </message>
    <message>
        <source>Coulomb&apos;s coefficient of friction mu of the paper&apos;s section 3.3</source>
        <translation>论文第 3.3 节的库仑摩擦系数 mu</translation>
    </message>
    <message>
        <source>Friction velocity</source>
        <translation>摩擦速度</translation>
    </message>
    <message>
        <source>sliding speed at which friction is fully developed</source>
        <translation>摩擦完全发挥时的滑动速率</translation>
    </message>
    <message>
        <source>cords touch the spacecraft too</source>
        <translation>绳也与服务航天器接触</translation>
    </message>
    <message>
        <source>Cords</source>
        <translation>绳间接触</translation>
    </message>
    <message>
        <source>net, closing ropes and rods touch each other; false: they pass through each other</source>
        <translation>绳网、收口绳和充气杆相互接触；false：彼此穿过</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>物体间接触</translation>
    </message>
    <message>
        <source>target and spacecraft touch each other; false: they pass through each other</source>
        <translation>目标与服务航天器相互接触；false：彼此穿过</translation>
    </message>
    <message>
        <source>Closing</source>
        <translation>收口</translation>
    </message>
    <message>
        <source>How the retractors at the rod tips draw the mouth together.</source>
        <translation>杆端的收绳器如何收拢网口。</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>规律</translation>
    </message>
    <message>
        <source>how the rope length goes from open to closed; table: as closing.table says</source>
        <translation>绳长如何从张开变到收拢；table：按 closing.table</translation>
    </message>
    <message>
        <source>Starts at</source>
        <translation>触发条件</translation>
    </message>
    <message>
        <source>what starts the closing: the time closing.start; the target&apos;s centre being inside the pocket; spacecraft and target being within closing.distance</source>
        <translation>收口由什么触发：时刻 closing.start；目标中心进入网袋；服务航天器与目标的距离小于 closing.distance</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始时刻</translation>
    </message>
    <message>
        <source>time at which closing starts, or before which no event starts it</source>
        <translation>收口开始的时刻，或在此之前任何事件都不触发它</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>distance between the centres of mass of spacecraft and target that starts the closing, for starts_at distance</source>
        <translation>触发收口的服务航天器与目标质心间的距离，用于触发条件 distance</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>持续时间</translation>
    </message>
    <message>
        <source>time from open to closed; not used by the law table</source>
        <translation>从张开到收拢的时间；规律 table 不使用</translation>
    </message>
    <message>
        <source>paper, section 4.2, case 1; 7.5 s in case 2, 5 s in case 3</source>
        <translation>论文第 4.2 节，工况 1；工况 2 为 7.5 s，工况 3 为 5 s</translation>
    </message>
    <message>
        <source>Closed length</source>
        <translation>收拢长度</translation>
    </message>
    <message>
        <source>rope between adjacent rod tips when closed; not used by the law table</source>
        <translation>收拢时相邻杆端间的绳长；规律 table 不使用</translation>
    </message>
    <message>
        <source>paper, section 4.1</source>
        <translation>论文第 4.1 节</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>数据表</translation>
    </message>
    <message>
        <source>[time after start, rope length] from open to closed, for the law table; may pay out again, up to the open length</source>
        <translation>从张开到收拢的 [开始后的时间, 绳长]，用于规律 table；可再放出，但不超过张开时的长度</translation>
    </message>
    <message>
        <source>Elements</source>
        <translation>单元数</translation>
    </message>
    <message>
        <source>variable-length elements in each rope</source>
        <translation>每根绳的变长度单元数</translation>
    </message>
    <message>
        <source>Towing</source>
        <translation>拖曳</translation>
    </message>
    <message>
        <source>How the spacecraft pulls the captured target towards -Y.</source>
        <translation>服务航天器如何向 -Y 拖曳捕获的目标。</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>none; force on the spacecraft; acceleration: force per mass of spacecraft, pocket and target; velocity of the spacecraft; controlled: by a controller of the kind tow</source>
        <translation>none：无；force：作用于服务航天器的力；acceleration：力除以服务航天器、网袋和目标的总质量；velocity：服务航天器的速度；controlled：由种类为 tow 的控制器决定</translation>
    </message>
    <message>
        <source>what starts the towing: the time towing.start, or the end of the closing</source>
        <translation>拖曳由什么触发：时刻 towing.start，或收口结束</translation>
    </message>
    <message>
        <source>time at which towing starts, for starts_at time</source>
        <translation>拖曳开始的时刻，用于触发条件 time</translation>
    </message>
    <message>
        <source>length of the thrust or of the ramp</source>
        <translation>推力或斜坡的持续时间</translation>
    </message>
    <message>
        <source>size of the force, acceleration or velocity, towards -Y</source>
        <translation>力、加速度或速度的大小，指向 -Y</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>distance of the line of thrust from the axis</source>
        <translation>推力线到轴线的距离</translation>
    </message>
    <message>
        <source>Offset angle</source>
        <translation>偏移角</translation>
    </message>
    <message>
        <source>direction in which the line of thrust is off the axis, from +X towards +Z; along an axis the pocket keeps a plane of symmetry</source>
        <translation>推力线偏离轴线的方向，从 +X 转向 +Z；沿坐标轴偏移时网袋保持一个对称面</translation>
    </message>
    <message>
        <source>Abort force</source>
        <translation>中止力</translation>
    </message>
    <message>
        <source>force of the pocket on the target that ends the towing; 0: none does</source>
        <translation>使拖曳结束的网袋对目标的作用力；0：不因此结束</translation>
    </message>
    <message>
        <source>Winches</source>
        <translation>绞车</translation>
    </message>
    <message>
        <source>Retractors of the closing ropes, as drums with motor and brake.</source>
        <translation>收口绳的收绳器，视为带电机和制动器的卷筒。</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>驱动方式</translation>
    </message>
    <message>
        <source>prescribed: ropes follow closing.law exactly; length: motors follow it; rate, tension, torque: motors keep winch.rate, winch.tension or winch.torque from closing.start until the rope has its closed length</source>
        <translation>prescribed：绳严格遵循 closing.law；length：电机跟随它；rate、tension、torque：电机自 closing.start 起保持 winch.rate、winch.tension 或 winch.torque，直到绳达到收拢长度</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>speed of winding in, for the drive rate</source>
        <translation>收绳的速率，用于驱动方式 rate</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>张力</translation>
    </message>
    <message>
        <source>tension to be kept, for the drive tension</source>
        <translation>应保持的张力，用于驱动方式 tension</translation>
    </message>
    <message>
        <source>torque of the motors, for the drive torque</source>
        <translation>电机的力矩，用于驱动方式 torque</translation>
    </message>
    <message>
        <source>Drum radius</source>
        <translation>卷筒半径</translation>
    </message>
    <message>
        <source>radius of a drum</source>
        <translation>卷筒的半径</translation>
    </message>
    <message>
        <source>Drum inertia</source>
        <translation>卷筒惯量</translation>
    </message>
    <message>
        <source>moment of inertia of drum, gears and motor, referred to the drum</source>
        <translation>卷筒、齿轮和电机的转动惯量，折算到卷筒</translation>
    </message>
    <message>
        <source>Most torque</source>
        <translation>最大力矩</translation>
    </message>
    <message>
        <source>largest torque of a motor, at the drum</source>
        <translation>电机的最大力矩，折算到卷筒</translation>
    </message>
    <message>
        <source>Brake torque</source>
        <translation>制动力矩</translation>
    </message>
    <message>
        <source>largest torque of a brake; brakes are on before the closing</source>
        <translation>制动器的最大力矩；收口之前制动器抱紧</translation>
    </message>
    <message>
        <source>Fastest</source>
        <translation>最大速率</translation>
    </message>
    <message>
        <source>largest rate that a loop asks of its motor</source>
        <translation>回路向电机要求的最大速率</translation>
    </message>
    <message>
        <source>Rate gain</source>
        <translation>速率增益</translation>
    </message>
    <message>
        <source>proportional gain of the loop of the rate</source>
        <translation>速率回路的比例增益</translation>
    </message>
    <message>
        <source>Rate integral</source>
        <translation>速率积分增益</translation>
    </message>
    <message>
        <source>integral gain of the loop of the rate</source>
        <translation>速率回路的积分增益</translation>
    </message>
    <message>
        <source>Length gain</source>
        <translation>长度增益</translation>
    </message>
    <message>
        <source>wanted rate by error of the length, for the drive length</source>
        <translation>单位长度误差对应的期望速率，用于驱动方式 length</translation>
    </message>
    <message>
        <source>Tension gain</source>
        <translation>张力增益</translation>
    </message>
    <message>
        <source>wanted rate by error of the tension, for the drive tension</source>
        <translation>单位张力误差对应的期望速率，用于驱动方式 tension</translation>
    </message>
    <message>
        <source>Tension derivative</source>
        <translation>张力微分增益</translation>
    </message>
    <message>
        <source>wanted rate by rate of the tension, for the drive tension</source>
        <translation>单位张力变化率对应的期望速率，用于驱动方式 tension</translation>
    </message>
    <message>
        <source>Take up rate</source>
        <translation>松绳收紧速率</translation>
    </message>
    <message>
        <source>speed at which a slack rope is taken up at least, for the drive tension</source>
        <translation>收紧松弛的绳的最小速率，用于驱动方式 tension</translation>
    </message>
    <message>
        <source>Late</source>
        <translation>延迟的绳</translation>
    </message>
    <message>
        <source>[rope, delay]: ropes that start later than the others; not for the drive prescribed</source>
        <translation>[绳, 延迟]：比其他绳晚开始的绳；不用于驱动方式 prescribed</translation>
    </message>
    <message>
        <source>Jammed</source>
        <translation>卡死的绳</translation>
    </message>
    <message>
        <source>[rope, time]: ropes whose retractor jams at a time; not for the drive prescribed</source>
        <translation>[绳, 时刻]：收绳器在某时刻卡死的绳；不用于驱动方式 prescribed</translation>
    </message>
    <message>
        <source>Deflation</source>
        <translation>放气</translation>
    </message>
    <message>
        <source>Gas that is let out of the rods, so that they bend more easily.</source>
        <translation>从充气杆放出的气体，使其更易弯曲。</translation>
    </message>
    <message>
        <source>what starts the deflation: never; the time deflation.start; the closing&apos;s start or its end, and deflation.start after it</source>
        <translation>放气由什么触发：never：从不；time：时刻 deflation.start；收口的开始或结束，再加 deflation.start</translation>
    </message>
    <message>
        <source>time of the deflation, or how long after its event it starts</source>
        <translation>放气的时刻，或在触发事件之后多久开始</translation>
    </message>
    <message>
        <source>rate at which the pressure falls</source>
        <translation>压力下降的速率</translation>
    </message>
    <message>
        <source>pressure that stays; less than rods.pressure</source>
        <translation>保留的压力；低于 rods.pressure</translation>
    </message>
    <message>
        <source>Actuators</source>
        <translation>执行机构</translation>
    </message>
    <message>
        <source>What exerts the forces and torques that the spacecraft&apos;s controllers demand.</source>
        <translation>施加服务航天器控制器所要求的力和力矩的机构。</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>种类</translation>
    </message>
    <message>
        <source>ideal: exert at once what is demanded; box: within limits by component; thrusters: those of the list actuators.thruster. Wheels, if any, take the torque</source>
        <translation>ideal：立即施加所要求的量；box：按分量限幅；thrusters：列表 actuators.thruster 中的推力器。若有反作用轮，则由其承担力矩</translation>
    </message>
    <message>
        <source>Most force</source>
        <translation>最大力</translation>
    </message>
    <message>
        <source>box: largest size of each component of the force, body axes</source>
        <translation>box：力的每个分量的最大值，本体轴</translation>
    </message>
    <message>
        <source>box: largest size of each component of the torque, body axes</source>
        <translation>box：力矩的每个分量的最大值，本体轴</translation>
    </message>
    <message>
        <source>Time constant</source>
        <translation>时间常数</translation>
    </message>
    <message>
        <source>first-order lag of the box or of the thrusters&apos; valves; 0: none</source>
        <translation>box 或推力器阀门的一阶滞后；0：无</translation>
    </message>
    <message>
        <source>Impulse bit</source>
        <translation>最小冲量</translation>
    </message>
    <message>
        <source>thrusters: least impulse of a pulse; 0: any</source>
        <translation>thrusters：一个脉冲的最小冲量；0：任意</translation>
    </message>
    <message>
        <source>Specific impulse</source>
        <translation>比冲</translation>
    </message>
    <message>
        <source>specific impulse, for the propellant</source>
        <translation>比冲，用于计算推进剂</translation>
    </message>
    <message>
        <source>assumption: hydrazine</source>
        <translation>假设：肼</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>求解器</translation>
    </message>
    <message>
        <source>Evaluation of the elements and integration in time.</source>
        <translation>单元的计算和时间积分。</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>单元计算</translation>
    </message>
    <message>
        <source>mean_strain: one axial strain per element, lumped mass; full: Gauss points, consistent mass</source>
        <translation>mean_strain：每个单元一个轴向应变，集中质量；full：高斯点，一致质量</translation>
    </message>
    <message>
        <source>assumption; strain and curvature of full: Gerstmayr &amp; Shabana 2006</source>
        <translation>假设；full 的应变与曲率：Gerstmayr &amp; Shabana 2006</translation>
    </message>
    <message>
        <source>Pair strains</source>
        <translation>成对应变</translation>
    </message>
    <message>
        <source>the elements of a mesh side share their axial strain two by two, which allows larger steps; mean_strain and cords of full compression only</source>
        <translation>网目边的单元两两共用轴向应变，可用更大的步长；仅限 mean_strain 和完全受压的绳</translation>
    </message>
    <message>
        <source>assumption; ancf/strain_pair.h</source>
        <translation>假设；ancf/strain_pair.h</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>时间步长</translation>
    </message>
    <message>
        <source>integration step; 0: chosen from the stiffest element and contact</source>
        <translation>积分步长；0：由最刚的单元和接触决定</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>安全系数</translation>
    </message>
    <message>
        <source>fraction of the stable step that is used</source>
        <translation>所用步长与稳定步长之比</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>重力</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>重力</translation>
    </message>
    <message>
        <source>assumption: none in orbit</source>
        <translation>假设：在轨无重力</translation>
    </message>
    <message>
        <source>Perturbation</source>
        <translation>随机扰动</translation>
    </message>
    <message>
        <source>largest random displacement of a free node at the start</source>
        <translation>起始时自由节点的最大随机位移</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>seed of the random displacements</source>
        <translation>随机位移的种子</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>Length of the run and what is recorded.</source>
        <translation>仿真的长度和记录的内容。</translation>
    </message>
    <message>
        <source>End time</source>
        <translation>结束时刻</translation>
    </message>
    <message>
        <source>simulated time at which the run ends</source>
        <translation>仿真结束的仿真时刻</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>帧率</translation>
    </message>
    <message>
        <source>recorded frames per simulated second</source>
        <translation>每仿真秒记录的帧数</translation>
    </message>
    <message>
        <source>Controllers</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Controllers of the spacecraft. Their demands add up, and the actuators exert them.</source>
        <translation>服务航天器的控制器。它们的要求相加，由执行机构施加。</translation>
    </message>
    <message>
        <source>what it controls, and how; of the spacecraft</source>
        <translation>控制什么、如何控制；针对服务航天器</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>phase of the capture in which it acts</source>
        <translation>在捕获的哪个阶段作用</translation>
    </message>
    <message>
        <source>rate of its samples; its demand is held in between</source>
        <translation>采样频率；两次采样之间保持其要求</translation>
    </message>
    <message>
        <source>attitude: wanted rotation vector from world to body axes</source>
        <translation>姿态：从世界轴到本体轴的期望旋转矢量</translation>
    </message>
    <message>
        <source>position: wanted place of the centre of mass, from its place at the start</source>
        <translation>位置：质心的期望位置，相对其起始位置</translation>
    </message>
    <message>
        <source>position: velocity at which the wanted place moves</source>
        <translation>位置：期望位置移动的速度</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>坐标轴</translation>
    </message>
    <message>
        <source>position: all; lateral: x and z; axial: y</source>
        <translation>位置：all：全部；lateral：x 和 z；axial：y</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>频率</translation>
    </message>
    <message>
        <source>PD: natural frequency of the loop</source>
        <translation>PD：回路的固有频率</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>阻尼比</translation>
    </message>
    <message>
        <source>PD: damping ratio of the loop</source>
        <translation>PD：回路的阻尼比</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>滑模面斜率</translation>
    </message>
    <message>
        <source>sliding mode, double loop&apos;s outer loop: rate at which the error decays</source>
        <translation>滑模、双回路的外环：误差衰减的速率</translation>
    </message>
    <message>
        <source>Reaching</source>
        <translation>趋近速率</translation>
    </message>
    <message>
        <source>sliding mode: rate at which the surface is reached</source>
        <translation>滑模：到达滑模面的速率</translation>
    </message>
    <message>
        <source>Switching</source>
        <translation>切换增益</translation>
    </message>
    <message>
        <source>sliding mode: acceleration towards the surface; more than the disturbance keeps the state on it</source>
        <translation>滑模：指向滑模面的加速度；大于扰动时状态保持在面上</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>边界层</translation>
    </message>
    <message>
        <source>sliding mode: boundary layer in which the switching is linear</source>
        <translation>滑模：切换呈线性的边界层</translation>
    </message>
    <message>
        <source>Observer</source>
        <translation>观测器</translation>
    </message>
    <message>
        <source>sliding mode: bandwidth of the extended state observer; 0: none</source>
        <translation>滑模：扩张状态观测器的带宽；0：无</translation>
    </message>
    <message>
        <source>Feed forward</source>
        <translation>前馈</translation>
    </message>
    <message>
        <source>sliding mode: cancels the force of the target on the pocket, taken to act through the target&apos;s centre of mass</source>
        <translation>滑模：抵消目标对网袋的作用力，认为它通过目标的质心</translation>
    </message>
    <message>
        <source>Outer switching</source>
        <translation>外环切换增益</translation>
    </message>
    <message>
        <source>double loop: switching rate of the outer loop</source>
        <translation>双回路：外环的切换速率</translation>
    </message>
    <message>
        <source>Outer layer</source>
        <translation>外环边界层</translation>
    </message>
    <message>
        <source>double loop: boundary layer of the outer loop</source>
        <translation>双回路：外环的边界层</translation>
    </message>
    <message>
        <source>double loop: largest wanted rate by component</source>
        <translation>双回路：期望角速率每个分量的最大值</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>被控量</translation>
    </message>
    <message>
        <source>tow: speed of the spacecraft along -Y, or separation of the centres of spacecraft and target</source>
        <translation>拖曳：服务航天器沿 -Y 的速率，或服务航天器与目标中心的间距</translation>
    </message>
    <message>
        <source>Wanted</source>
        <translation>期望值</translation>
    </message>
    <message>
        <source>tow: wanted value of the quantity</source>
        <translation>拖曳：被控量的期望值</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>斜坡时间</translation>
    </message>
    <message>
        <source>tow: time in which the quantity goes to the wanted value</source>
        <translation>拖曳：被控量到达期望值所用的时间</translation>
    </message>
    <message>
        <source>Proportional</source>
        <translation>比例增益</translation>
    </message>
    <message>
        <source>tow: thrust by error of the quantity</source>
        <translation>拖曳：单位误差对应的推力</translation>
    </message>
    <message>
        <source>Integral</source>
        <translation>积分增益</translation>
    </message>
    <message>
        <source>tow: thrust by integral of the error</source>
        <translation>拖曳：单位误差积分对应的推力</translation>
    </message>
    <message>
        <source>Derivative</source>
        <translation>微分增益</translation>
    </message>
    <message>
        <source>tow: thrust by rate of the error of the separation</source>
        <translation>拖曳：单位间距误差变化率对应的推力</translation>
    </message>
    <message>
        <source>Most tension</source>
        <translation>最大张力</translation>
    </message>
    <message>
        <source>tow: cap of the force that pulls the target; 0: none</source>
        <translation>拖曳：拖动目标的力的上限；0：无</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>阻尼</translation>
    </message>
    <message>
        <source>spin damping: torque by angular velocity</source>
        <translation>消旋：单位角速度对应的力矩</translation>
    </message>
    <message>
        <source>spin damping: largest torque</source>
        <translation>消旋：最大力矩</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>传感器</translation>
    </message>
    <message>
        <source>What controllers know of a quantity. A quantity without a sensor is known exactly.</source>
        <translation>控制器对某个量的所知。没有传感器的量视为精确已知。</translation>
    </message>
    <message>
        <source>measured quantity: of the spacecraft, the target, the force on the target, or the tension of each closing rope</source>
        <translation>被测量：服务航天器的、目标的、目标所受的力，或每根收口绳的张力</translation>
    </message>
    <message>
        <source>rate of its samples</source>
        <translation>采样频率</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>噪声</translation>
    </message>
    <message>
        <source>standard deviation of the white noise of each component</source>
        <translation>每个分量白噪声的标准差</translation>
    </message>
    <message>
        <source>Bias</source>
        <translation>常值误差</translation>
    </message>
    <message>
        <source>constant error by component; a rope&apos;s tension has the first</source>
        <translation>各分量的常值误差；绳的张力用第一个</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>延迟</translation>
    </message>
    <message>
        <source>time from a sample to its arrival</source>
        <translation>从采样到送达的时间</translation>
    </message>
    <message>
        <source>Dropout</source>
        <translation>丢失概率</translation>
    </message>
    <message>
        <source>probability that a sample is lost</source>
        <translation>样本丢失的概率</translation>
    </message>
    <message>
        <source>seed of noise and dropouts</source>
        <translation>噪声和丢失的种子</translation>
    </message>
    <message>
        <source>Thrusters</source>
        <translation>推力器</translation>
    </message>
    <message>
        <source>Thrusters of the spacecraft.</source>
        <translation>服务航天器的推力器。</translation>
    </message>
    <message>
        <source>place of the nozzle from the spacecraft&apos;s centre of mass, body axes</source>
        <translation>喷管相对服务航天器质心的位置，本体轴</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>direction of the force on the spacecraft, body axes; any length but 0</source>
        <translation>作用于服务航天器的力的方向，本体轴；长度任意，但不为 0</translation>
    </message>
    <message>
        <source>thrust when it fires</source>
        <translation>点火时的推力</translation>
    </message>
    <message>
        <source>Reaction wheels</source>
        <translation>反作用轮</translation>
    </message>
    <message>
        <source>Reaction wheels of the spacecraft.</source>
        <translation>服务航天器的反作用轮。</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>axis, body axes; any length but 0</source>
        <translation>轴，本体轴；长度任意，但不为 0</translation>
    </message>
    <message>
        <source>largest torque</source>
        <translation>最大力矩</translation>
    </message>
    <message>
        <source>Most momentum</source>
        <translation>最大角动量</translation>
    </message>
    <message>
        <source>largest momentum relative to the spacecraft</source>
        <translation>相对服务航天器的最大角动量</translation>
    </message>
    <message>
        <source>Disturbances</source>
        <translation>扰动</translation>
    </message>
    <message>
        <source>Forces and torques that act on a body for a while, to see how controllers answer.</source>
        <translation>在一段时间内作用于物体的力和力矩，用来观察控制器的响应。</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>body on which it acts</source>
        <translation>所作用的物体</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>force through the body&apos;s centre of mass, body axes</source>
        <translation>通过物体质心的力，本体轴</translation>
    </message>
    <message>
        <source>torque, body axes</source>
        <translation>力矩，本体轴</translation>
    </message>
    <message>
        <source>time at which it begins</source>
        <translation>开始的时刻</translation>
    </message>
    <message>
        <source>how long it acts</source>
        <translation>作用多久</translation>
    </message>
    <message>
        <source>Net</source>
        <translation>绳网</translation>
    </message>
    <message>
        <source>A net of equal meshes, and its cords, which pull and do not push.</source>
        <translation>网目相同的绳网及其绳，绳只受拉、不受压。</translation>
    </message>
    <message>
        <source>square: square meshes; hexagonal: a hexagon of triangular meshes; radial: spokes and rings, as a spider&apos;s web</source>
        <translation>square：方形网目；hexagonal：由三角形网目组成的六边形；radial：径向绳与环，如蛛网</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>边长</translation>
    </message>
    <message>
        <source>side of the square or the hexagon; length of a spoke</source>
        <translation>方形或六边形的边长；径向绳的长度</translation>
    </message>
    <message>
        <source>published set-up, net thrown at a stage of 9 t</source>
        <translation>已发表的构型，飞网抛向 9 t 的火箭级</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>网目数</translation>
    </message>
    <message>
        <source>meshes along a side; rings of a radial net</source>
        <translation>每边的网目数；径向网的环数</translation>
    </message>
    <message>
        <source>Spokes</source>
        <translation>径向绳数</translation>
    </message>
    <message>
        <source>of a radial net, with a mass at the end of each</source>
        <translation>径向网的径向绳数，每根末端有一个质量块</translation>
    </message>
    <message>
        <source>damping ratio 0.106 of a mesh side of 1 m: 2 zeta L sqrt(rho/E)</source>
        <translation>1 m 网目边的阻尼比 0.106：2 zeta L sqrt(rho/E)</translation>
    </message>
    <message>
        <source>damping ratio 0.014 of a mesh side of 1 m: 2 zeta/(pi/L)^2 sqrt(rho A/(E I))</source>
        <translation>1 m 网目边的阻尼比 0.014：2 zeta/(pi/L)^2 sqrt(rho A/(E I))</translation>
    </message>
    <message>
        <source>Throw</source>
        <translation>抛射</translation>
    </message>
    <message>
        <source>The corner masses, and how the folded net starts along +Y.</source>
        <translation>角质量块，以及折叠的绳网如何向 +Y 抛出。</translation>
    </message>
    <message>
        <source>Corner mass</source>
        <translation>角质量</translation>
    </message>
    <message>
        <source>mass at each corner</source>
        <translation>每个角上的质量</translation>
    </message>
    <message>
        <source>Corner thread</source>
        <translation>角部连接绳</translation>
    </message>
    <message>
        <source>thread from a corner of the net to its mass; 0: the masses are at the corners</source>
        <translation>从网角到其质量块的连接绳；0：质量块位于网角</translation>
    </message>
    <message>
        <source>Corner thread diameter</source>
        <translation>角部连接绳直径</translation>
    </message>
    <message>
        <source>diameter of these threads; otherwise as the net&apos;s cords</source>
        <translation>这些连接绳的直径；其余同网绳</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>speed of the corner masses at the start</source>
        <translation>起始时角质量块的速率</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>between their velocities and the axis, outwards along the diagonals</source>
        <translation>其速度与轴线的夹角，沿对角线向外</translation>
    </message>
    <message>
        <source>angular velocity of the folded net and its masses about the axis</source>
        <translation>折叠的绳网及其质量块绕轴线的角速度</translation>
    </message>
    <message>
        <source>Folding</source>
        <translation>折叠比</translation>
    </message>
    <message>
        <source>size of the folded net by that of the net; its cords are slack</source>
        <translation>折叠的绳网与展开绳网的尺寸之比；其绳松弛</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>间隔</translation>
    </message>
    <message>
        <source>from the spacecraft&apos;s +y face to the folded net</source>
        <translation>从服务航天器 +y 面到折叠的绳网</translation>
    </message>
    <message>
        <source>Recoil</source>
        <translation>反冲</translation>
    </message>
    <message>
        <source>the spacecraft starts with the opposite momentum</source>
        <translation>服务航天器以相反的动量起始</translation>
    </message>
    <message>
        <source>Tether</source>
        <translation>系绳</translation>
    </message>
    <message>
        <source>The line from the middle of the net to the spacecraft.</source>
        <translation>从绳网中心到服务航天器的绳。</translation>
    </message>
    <message>
        <source>Attached</source>
        <translation>是否连接</translation>
    </message>
    <message>
        <source>a tether joins the middle of the net to the spacecraft&apos;s +y face</source>
        <translation>系绳把绳网中心与服务航天器的 +y 面相连</translation>
    </message>
    <message>
        <source>length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>cable elements</source>
        <translation>索单元数</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Drawstring</source>
        <translation>束口绳</translation>
    </message>
    <message>
        <source>The rope round the net&apos;s perimeter, which winches at the net&apos;s corners wind in; table winch says how.</source>
        <translation>绳网周边的绳，由网角的绞车收紧；方式见表 winch。</translation>
    </message>
    <message>
        <source>never: no drawstring, the perimeter is of the net&apos;s cord; time: at drawstring.start; contact: after the first touch of the target</source>
        <translation>never：无束口绳，周边为网绳；time：在 drawstring.start；contact：首次碰到目标之后</translation>
    </message>
    <message>
        <source>time at which the winches begin</source>
        <translation>绞车开始的时刻</translation>
    </message>
    <message>
        <source>from the first touch until the winches begin</source>
        <translation>从首次碰触到绞车开始</translation>
    </message>
    <message>
        <source>of the winding, by a cycloid</source>
        <translation>收绳的时间，按摆线规律</translation>
    </message>
    <message>
        <source>of a side&apos;s drawstring when closed</source>
        <translation>收拢时一边束口绳的长度</translation>
    </message>
    <message>
        <source>assumption: polyamide</source>
        <translation>假设：聚酰胺</translation>
    </message>
    <message>
        <source>assumption: braided polyamide</source>
        <translation>假设：编织聚酰胺</translation>
    </message>
    <message>
        <source>Elements per side</source>
        <comment>pocket</comment>
        <translation>每边单元数</translation>
    </message>
    <message>
        <source>Diameter</source>
        <comment>net</comment>
        <translation>直径</translation>
    </message>
    <message>
        <source>Density</source>
        <comment>net</comment>
        <translation>密度</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <comment>net</comment>
        <translation>杨氏模量</translation>
    </message>
    <message>
        <source>Diameter</source>
        <comment>rope</comment>
        <translation>直径</translation>
    </message>
    <message>
        <source>Density</source>
        <comment>rope</comment>
        <translation>密度</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <comment>rope</comment>
        <translation>杨氏模量</translation>
    </message>
    <message>
        <source>Density</source>
        <comment>rods</comment>
        <translation>密度</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <comment>rods</comment>
        <translation>杨氏模量</translation>
    </message>
    <message>
        <source>Elements per side</source>
        <comment>rods</comment>
        <translation>每边单元数</translation>
    </message>
    <message>
        <source>Pressure</source>
        <comment>rods</comment>
        <translation>压力</translation>
    </message>
    <message>
        <source>Position</source>
        <comment>spacecraft</comment>
        <translation>位置</translation>
    </message>
    <message>
        <source>Size</source>
        <comment>spacecraft</comment>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Shape</source>
        <comment>target</comment>
        <translation>形状</translation>
    </message>
    <message>
        <source>Size</source>
        <comment>target</comment>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Length</source>
        <comment>target</comment>
        <translation>长度</translation>
    </message>
    <message>
        <source>Position</source>
        <comment>target</comment>
        <translation>位置</translation>
    </message>
    <message>
        <source>Attitude</source>
        <comment>target</comment>
        <translation>姿态</translation>
    </message>
    <message>
        <source>Velocity</source>
        <comment>target</comment>
        <translation>速度</translation>
    </message>
    <message>
        <source>Spin</source>
        <comment>target</comment>
        <translation>角速度</translation>
    </message>
    <message>
        <source>Thrust</source>
        <comment>target</comment>
        <translation>推力</translation>
    </message>
    <message>
        <source>Torque</source>
        <comment>target</comment>
        <translation>力矩</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <comment>target</comment>
        <translation>杨氏模量</translation>
    </message>
    <message>
        <source>Starts at</source>
        <comment>closing</comment>
        <translation>触发条件</translation>
    </message>
    <message>
        <source>Start</source>
        <comment>closing</comment>
        <translation>开始时刻</translation>
    </message>
    <message>
        <source>Duration</source>
        <comment>closing</comment>
        <translation>持续时间</translation>
    </message>
    <message>
        <source>Closed length</source>
        <comment>closing</comment>
        <translation>收拢长度</translation>
    </message>
    <message>
        <source>Elements</source>
        <comment>closing</comment>
        <translation>每绳单元数</translation>
    </message>
    <message>
        <source>Starts at</source>
        <comment>towing</comment>
        <translation>触发条件</translation>
    </message>
    <message>
        <source>Start</source>
        <comment>towing</comment>
        <translation>开始时刻</translation>
    </message>
    <message>
        <source>Duration</source>
        <comment>towing</comment>
        <translation>持续时间</translation>
    </message>
    <message>
        <source>Size</source>
        <comment>towing</comment>
        <translation>大小</translation>
    </message>
    <message>
        <source>Rate</source>
        <comment>winch</comment>
        <translation>收绳速率</translation>
    </message>
    <message>
        <source>Torque</source>
        <comment>winch</comment>
        <translation>电机力矩</translation>
    </message>
    <message>
        <source>Most torque</source>
        <comment>winch</comment>
        <translation>最大力矩</translation>
    </message>
    <message>
        <source>Fastest</source>
        <comment>winch</comment>
        <translation>最大速率</translation>
    </message>
    <message>
        <source>Starts at</source>
        <comment>deflation</comment>
        <translation>触发条件</translation>
    </message>
    <message>
        <source>Start</source>
        <comment>deflation</comment>
        <translation>开始时刻</translation>
    </message>
    <message>
        <source>Rate</source>
        <comment>deflation</comment>
        <translation>放气速率</translation>
    </message>
    <message>
        <source>Pressure</source>
        <comment>deflation</comment>
        <translation>压力</translation>
    </message>
    <message>
        <source>Kind</source>
        <comment>actuators</comment>
        <translation>种类</translation>
    </message>
    <message>
        <source>Most torque</source>
        <comment>actuators</comment>
        <translation>最大力矩</translation>
    </message>
    <message>
        <source>Seed</source>
        <comment>solver</comment>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Kind</source>
        <comment>controller</comment>
        <translation>种类</translation>
    </message>
    <message>
        <source>Rate</source>
        <comment>controller</comment>
        <translation>采样频率</translation>
    </message>
    <message>
        <source>Attitude</source>
        <comment>controller</comment>
        <translation>期望姿态</translation>
    </message>
    <message>
        <source>Position</source>
        <comment>controller</comment>
        <translation>期望位置</translation>
    </message>
    <message>
        <source>Velocity</source>
        <comment>controller</comment>
        <translation>移动速度</translation>
    </message>
    <message>
        <source>Fastest</source>
        <comment>controller</comment>
        <translation>最大角速率</translation>
    </message>
    <message>
        <source>Most torque</source>
        <comment>controller</comment>
        <translation>最大力矩</translation>
    </message>
    <message>
        <source>Kind</source>
        <comment>sensor</comment>
        <translation>种类</translation>
    </message>
    <message>
        <source>Rate</source>
        <comment>sensor</comment>
        <translation>采样频率</translation>
    </message>
    <message>
        <source>Delay</source>
        <comment>sensor</comment>
        <translation>延迟</translation>
    </message>
    <message>
        <source>Seed</source>
        <comment>sensor</comment>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Position</source>
        <comment>actuators</comment>
        <translation>安装位置</translation>
    </message>
    <message>
        <source>Thrust</source>
        <comment>actuators</comment>
        <translation>推力</translation>
    </message>
    <message>
        <source>Torque</source>
        <comment>disturbance</comment>
        <translation>力矩</translation>
    </message>
    <message>
        <source>Start</source>
        <comment>disturbance</comment>
        <translation>开始时刻</translation>
    </message>
    <message>
        <source>Duration</source>
        <comment>disturbance</comment>
        <translation>持续时间</translation>
    </message>
    <message>
        <source>Shape</source>
        <comment>net</comment>
        <translation>网形</translation>
    </message>
    <message>
        <source>Elements per side</source>
        <comment>net</comment>
        <translation>每边单元数</translation>
    </message>
    <message>
        <source>Spin</source>
        <comment>throw</comment>
        <translation>自旋</translation>
    </message>
    <message>
        <source>Length</source>
        <comment>tether</comment>
        <translation>长度</translation>
    </message>
    <message>
        <source>Elements</source>
        <comment>tether</comment>
        <translation>单元数</translation>
    </message>
    <message>
        <source>Diameter</source>
        <comment>tether</comment>
        <translation>直径</translation>
    </message>
    <message>
        <source>Density</source>
        <comment>tether</comment>
        <translation>密度</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <comment>tether</comment>
        <translation>杨氏模量</translation>
    </message>
    <message>
        <source>Starts at</source>
        <comment>drawstring</comment>
        <translation>触发条件</translation>
    </message>
    <message>
        <source>Start</source>
        <comment>drawstring</comment>
        <translation>开始时刻</translation>
    </message>
    <message>
        <source>Delay</source>
        <comment>drawstring</comment>
        <translation>触后延迟</translation>
    </message>
    <message>
        <source>Duration</source>
        <comment>drawstring</comment>
        <translation>持续时间</translation>
    </message>
    <message>
        <source>Closed length</source>
        <comment>drawstring</comment>
        <translation>收拢长度</translation>
    </message>
    <message>
        <source>Diameter</source>
        <comment>drawstring</comment>
        <translation>直径</translation>
    </message>
    <message>
        <source>Density</source>
        <comment>drawstring</comment>
        <translation>密度</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <comment>drawstring</comment>
        <translation>杨氏模量</translation>
    </message>
    <message>
        <source>Edge radius</source>
        <translation>棱边半径</translation>
    </message>
    <message>
        <source>radius of the edges of boxes, cylinders and satellites where cords touch them, at most a quarter of a part&apos;s thickness; 0: sharp. A cord that a load presses deeper than its own radius slips off a sharp edge</source>
        <translation>绳接触长方体、圆柱体和卫星处的棱边半径，至多为部件厚度的四分之一；0：尖锐。被载荷压入深度超过自身半径的绳会从尖锐棱边滑脱</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>分散</translation>
    </message>
    <message>
        <source>Single rods and panels that are not like the others.</source>
        <translation>与其他不同的个别充气杆和网面。</translation>
    </message>
    <message>
        <source>Rod stiffness</source>
        <translation>杆刚度</translation>
    </message>
    <message>
        <source>[rod, factor]: rods with another Young&apos;s modulus than the others, times this; the kink&apos;s joint stays</source>
        <translation>[杆, 系数]：杨氏模量与其他不同的充气杆，乘以此系数；折点处的铰不变</translation>
    </message>
    <message>
        <source>Rod pressure</source>
        <translation>杆压力</translation>
    </message>
    <message>
        <source>[rod, factor]: rods with another pressure than rods.pressure, times this, in which they wrinkle</source>
        <translation>[杆, 系数]：压力与 rods.pressure 不同的充气杆，乘以此系数，由此决定起皱</translation>
    </message>
    <message>
        <source>Panel stiffness</source>
        <translation>网面刚度</translation>
    </message>
    <message>
        <source>[panel, factor]: panels whose net has another Young&apos;s modulus, times this; 0.001: all but torn</source>
        <translation>[网面, 系数]：绳网杨氏模量不同的网面，乘以此系数；0.001：几乎破裂</translation>
    </message>
    <message>
        <source>Most steps</source>
        <translation>最大步数</translation>
    </message>
    <message>
        <source>number of steps after which a run ends, wherever it is; 0: no limit. For campaigns, where a capture now and then takes a thousand times as long as the others</source>
        <translation>仿真在达到该步数后结束，无论进行到何处；0：无上限。用于批量仿真，其中偶尔有一次捕获所需时间是其他捕获的上千倍</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>对称性</translation>
    </message>
    <message>
        <source>auto: while all sectors of a pocket are alike and nothing acts across its axis, one sector is computed for all, in less than half the time and with the same result but for round-off; off: the whole is computed always</source>
        <translation>auto：只要网袋的各扇区完全相同、且没有横向于轴线的作用，就只计算一个扇区来代表全部扇区，耗时不到一半，结果除舍入误差外相同；off：始终计算整体</translation>
    </message>
    <message>
        <source>A hub with the rods that the spacecraft lets go, and the line on which it tows.</source>
        <translation>承载充气杆、由服务航天器释放的中心盘，以及拖曳它的系绳。</translation>
    </message>
    <message>
        <source>the rods stand on a hub, which the spacecraft lets go and tows on a tether</source>
        <translation>充气杆立在中心盘上；服务航天器释放中心盘并用系绳拖曳</translation>
    </message>
    <message>
        <source>Released at</source>
        <translation>释放时机</translation>
    </message>
    <message>
        <source>when the spacecraft lets the hub go. time: at tether.release_time; closed: tether.release_delay after the end of the closing</source>
        <translation>服务航天器何时释放中心盘。time：在 tether.release_time；closed：收口结束后经过 tether.release_delay</translation>
    </message>
    <message>
        <source>Release time</source>
        <translation>释放时间</translation>
    </message>
    <message>
        <source>for released_at = &quot;time&quot;</source>
        <translation>用于 released_at = &quot;time&quot;</translation>
    </message>
    <message>
        <source>Release delay</source>
        <translation>释放延迟</translation>
    </message>
    <message>
        <source>for released_at = &quot;closed&quot;</source>
        <translation>用于 released_at = &quot;closed&quot;</translation>
    </message>
    <message>
        <source>from the spacecraft&apos;s +y face to the hub</source>
        <translation>从服务航天器的 +y 面到中心盘</translation>
    </message>
    <message>
        <source>published set-up of a thrown net</source>
        <translation>已发表的飞网设置</translation>
    </message>
    <message>
        <source>assumption: braided polyester</source>
        <translation>假设：编织涤纶</translation>
    </message>
    <message>
        <source>Winch</source>
        <translation>绞车</translation>
    </message>
    <message>
        <source>for drive = &quot;rate&quot;; negative: reels in</source>
        <translation>用于 drive = &quot;rate&quot;；负值为收回</translation>
    </message>
    <message>
        <source>Slip tension</source>
        <translation>打滑张力</translation>
    </message>
    <message>
        <source>tension at which the drum&apos;s clutch slips, braked or driven</source>
        <translation>卷筒离合器打滑时的张力，制动或驱动时均如此</translation>
    </message>
    <message>
        <source>Brake at</source>
        <translation>制动时间</translation>
    </message>
    <message>
        <source>from when on the drum is braked for good</source>
        <translation>从此时起卷筒一直被制动</translation>
    </message>
    <message>
        <source>radius of the drum</source>
        <translation>卷筒半径</translation>
    </message>
    <message>
        <source>moment of inertia of all that turns with the drum</source>
        <translation>随卷筒转动的所有部件的转动惯量</translation>
    </message>
    <message>
        <source>Motor torque</source>
        <translation>电机力矩</translation>
    </message>
    <message>
        <source>largest torque of its motor</source>
        <translation>其电机的最大力矩</translation>
    </message>
    <message>
        <source>largest rate that its motor aims at</source>
        <translation>其电机的最大目标速率</translation>
    </message>
    <message>
        <source>Reserve</source>
        <translation>储备长度</translation>
    </message>
    <message>
        <source>tether on the drum at the start, besides tether.length</source>
        <translation>开始时卷筒上的系绳长度，不含 tether.length</translation>
    </message>
    <message>
        <source>Least length</source>
        <translation>最短长度</translation>
    </message>
    <message>
        <source>at which the drum stops reeling in</source>
        <translation>卷筒在此长度停止收回</translation>
    </message>
    <message>
        <source>Hub mass</source>
        <translation>中心盘质量</translation>
    </message>
    <message>
        <source>mass of the hub, a plate as wide as the rods&apos; roots</source>
        <translation>中心盘的质量；它是与充气杆根部同宽的板</translation>
    </message>
    <message>
        <source>Hub thickness</source>
        <translation>中心盘厚度</translation>
    </message>
    <message>
        <source>thickness of that plate</source>
        <translation>该板的厚度</translation>
    </message>
    <message>
        <source>Passage</source>
        <translation>穿绳方式</translation>
    </message>
    <message>
        <source>even: the drawstring is the perimeter&apos;s cord and stays evenly spread over its knots; rings: it runs along the perimeter&apos;s own cord through rings at its knots, with friction</source>
        <translation>even：束口绳就是周边的网绳，并均匀分布在各结点之间；rings：束口绳沿周边网绳穿过结点处的环，有摩擦</translation>
    </message>
    <message>
        <source>Ring friction</source>
        <translation>环的摩擦</translation>
    </message>
    <message>
        <source>coefficient of friction mu at a ring, where one tension is at most exp(mu angle) times the other</source>
        <translation>环处的摩擦系数 mu，一侧张力至多为另一侧的 exp(mu 角度) 倍</translation>
    </message>
    <message>
        <source>published friction of net on net, static</source>
        <translation>已发表的网与网之间的静摩擦</translation>
    </message>
    <message>
        <source>Ring angle</source>
        <translation>环的包角</translation>
    </message>
    <message>
        <source>angle by which the drawstring wraps each ring, besides the angle by which it turns there</source>
        <translation>束口绳绕每个环的包角，不含它在该处转折的角度</translation>
    </message>
    <message>
        <source>Ring spacing</source>
        <translation>环间距</translation>
    </message>
    <message>
        <source>drawstring that stays between two rings which are drawn together</source>
        <translation>两个环收拢后其间仍保留的束口绳长度</translation>
    </message>
    <message>
        <source>Drive</source>
        <comment>winch</comment>
        <translation>驱动方式</translation>
    </message>
    <message>
        <source>Tension</source>
        <comment>winch</comment>
        <translation>张力</translation>
    </message>
    <message>
        <source>Drum radius</source>
        <comment>winch</comment>
        <translation>卷筒半径</translation>
    </message>
    <message>
        <source>Drum inertia</source>
        <comment>winch</comment>
        <translation>卷筒惯量</translation>
    </message>
    <message>
        <source>Drive</source>
        <comment>tether</comment>
        <translation>驱动方式</translation>
    </message>
    <message>
        <source>Rate</source>
        <comment>tether</comment>
        <translation>速率</translation>
    </message>
    <message>
        <source>Tension</source>
        <comment>tether</comment>
        <translation>张力</translation>
    </message>
    <message>
        <source>Drum radius</source>
        <comment>tether</comment>
        <translation>卷筒半径</translation>
    </message>
    <message>
        <source>Drum inertia</source>
        <comment>tether</comment>
        <translation>卷筒惯量</translation>
    </message>
    <message>
        <source>Fastest</source>
        <comment>tether</comment>
        <translation>最大速率</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>轨道</translation>
    </message>
    <message>
        <source>The orbit of the world&apos;s origin, whose gravity acts on everything near it as a tide.</source>
        <translation>世界坐标系原点的轨道；其引力以潮汐力作用于附近的一切。</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>off: far from all gravity; hill: circular orbit, after Hill, Clohessy and Wiltshire; two_body: any orbit about a point mass; two_body_j2: likewise about the oblate Earth</source>
        <translation>off：远离一切引力；hill：圆轨道，按 Hill、Clohessy 与 Wiltshire；two_body：绕质点的任意轨道；two_body_j2：同上，绕扁球形的地球</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>of the perigee above the equatorial radius of 6378137 m</source>
        <translation>近地点高出赤道半径 6378137 m 的高度</translation>
    </message>
    <message>
        <source>Eccentricity</source>
        <translation>偏心率</translation>
    </message>
    <message>
        <source>eccentricity; 0 for hill</source>
        <translation>偏心率；hill 时为 0</translation>
    </message>
    <message>
        <source>Inclination</source>
        <translation>倾角</translation>
    </message>
    <message>
        <source>angle between the orbit&apos;s plane and the equator; matters to two_body_j2 only</source>
        <translation>轨道面与赤道的夹角；只对 two_body_j2 有影响</translation>
    </message>
    <message>
        <source>Perigee</source>
        <translation>近地点幅角</translation>
    </message>
    <message>
        <source>angle from the ascending node to the perigee</source>
        <translation>从升交点到近地点的角度</translation>
    </message>
    <message>
        <source>Anomaly</source>
        <translation>真近点角</translation>
    </message>
    <message>
        <source>angle from the perigee to the place at the start: the true anomaly</source>
        <translation>从近地点到起始位置的角度：真近点角</translation>
    </message>
    <message>
        <source>X along</source>
        <translation>X 轴指向</translation>
    </message>
    <message>
        <source>direction of the X axis at the start: v_bar ahead, r_bar to the Earth, h_bar against the orbit&apos;s angular momentum</source>
        <translation>起始时 X 轴的方向：v_bar 向前，r_bar 指向地球，h_bar 与轨道角动量相反</translation>
    </message>
    <message>
        <source>Y along</source>
        <translation>Y 轴指向</translation>
    </message>
    <message>
        <source>direction of the Y axis at the start, along which the net is thrown or the mouth opens; at a right angle to orbit.x_along</source>
        <translation>起始时 Y 轴的方向，绳网沿此方向抛射，或网口朝此方向张开；与 orbit.x_along 成直角</translation>
    </message>
    <message>
        <source>axes in which velocities at the start, towing thrust and held attitude count: fixed, the world&apos;s, which do not turn; local, V-bar, R-bar and H-bar, which turn with the orbit</source>
        <translation>起始速度、拖曳推力和保持的姿态所依据的坐标轴：fixed 为不转动的世界坐标轴；local 为随轨道转动的 V-bar、R-bar 与 H-bar</translation>
    </message>
    <message>
        <source>Axes</source>
        <comment>orbit</comment>
        <translation>坐标轴</translation>
    </message>
    <message>
        <source>Axes</source>
        <comment>controller</comment>
        <translation>坐标轴</translation>
    </message>
    <message>
        <source>Fidelity</source>
        <translation>精细程度</translation>
    </message>
    <message>
        <source>full; draft, for maps of many captures: at most three meshes across and three rows, one element a side, axial stiffness divided by 30, in pockets of the evaluation mean_strain only. Results of a draft state its measured bias</source>
        <translation>full：完整；draft：草算，用于由大量捕获构成的分布图：横向最多三个网目、最多三行，每边一个单元，轴向刚度除以 30，仅用于 mean_strain 计算方式的网袋。草算的结果都注明其实测偏差</translation>
    </message>
    <message>
        <source>assumption; THEORY.md 7.4</source>
        <translation>假设；THEORY.md 7.4</translation>
    </message>
    <message>
        <source>the tether is wound by a drum on the spacecraft; it is then a straight line without inertia, and half of its mass stays at either end</source>
        <translation>系绳由服务航天器上的卷筒收放；此时它是一条没有惯性的直线，其质量两端各占一半</translation>
    </message>
    <message>
        <source>brake: the drum is held, but for its clutch; rate: pays out by tether.rate; tension: keeps tether.tension; drag: a light brake lets it run out where the tension exceeds tether.tension</source>
        <translation>brake：卷筒被制动，仅离合器可打滑；rate：按 tether.rate 放出；tension：保持 tether.tension；drag：轻制动，张力超过 tether.tension 时放绳</translation>
    </message>
    <message>
        <source>for drive = &quot;tension&quot; and &quot;drag&quot;</source>
        <translation>用于 drive = &quot;tension&quot; 和 &quot;drag&quot;</translation>
    </message>
    <message>
        <source>Drive starts at</source>
        <translation>驱动触发条件</translation>
    </message>
    <message>
        <source>when the drive begins; the drum is braked before. time: at tether.drive_delay; contact: that long after the first touch of the target; closed: that long after the end of the closing</source>
        <translation>驱动何时开始；此前卷筒被制动。time：在 tether.drive_delay 时；contact：首次接触目标后再过该时长；closed：收口结束后再过该时长</translation>
    </message>
    <message>
        <source>Drive delay</source>
        <translation>驱动延迟</translation>
    </message>
    <message>
        <source>from that event; for &quot;time&quot; from the start of the run</source>
        <translation>从该事件起；对于 &quot;time&quot; 从运行开始起</translation>
    </message>
    <message>
        <source>Brake starts at</source>
        <translation>制动触发条件</translation>
    </message>
    <message>
        <source>from when on the drum is braked for good. time: from tether.brake_at; contact: tether.brake_delay after the first touch of the target; closed: that long after the end of the closing</source>
        <translation>卷筒从何时起一直被制动。time：从 tether.brake_at 起；contact：首次接触目标后 tether.brake_delay；closed：收口结束后再过该时长</translation>
    </message>
    <message>
        <source>Brake delay</source>
        <translation>制动延迟</translation>
    </message>
    <message>
        <source>for brake_starts_at = &quot;contact&quot; and &quot;closed&quot;</source>
        <translation>用于 brake_starts_at = &quot;contact&quot; 和 &quot;closed&quot;</translation>
    </message>
</context>
<context>
    <name>scenarios</name>
    <message>
        <source>A target enters 0.6 m off the axis; the closing starts when it is inside, the towing when the mouth is closed</source>
        <translation>目标偏离轴线 0.6 m 进入；目标入袋时开始收口，网口收拢时开始拖曳</translation>
    </message>
    <message>
        <source>Case 1 of Tang et al. 2023: closing in 10 s, towing from 10 s</source>
        <translation>Tang 等（2023）的工况 1：10 s 收口，自 10 s 起拖曳</translation>
    </message>
    <message>
        <source>Case 2 of Tang et al. 2023: closing in 7.5 s, towing from 10 s</source>
        <translation>Tang 等（2023）的工况 2：7.5 s 收口，自 10 s 起拖曳</translation>
    </message>
    <message>
        <source>Case 3 of Tang et al. 2023: closing in 5 s, towing from 10 s</source>
        <translation>Tang 等（2023）的工况 3：5 s 收口，自 10 s 起拖曳</translation>
    </message>
    <message>
        <source>Inflated rods without a soft kink are deflated as the closing starts, and the closing ropes have less to pull</source>
        <translation>没有柔软折点的充气杆在收口开始时放气，收口绳的拉动更轻松</translation>
    </message>
    <message>
        <source>A sphere of 3.9 m that drifts sideways at 4 cm/s and towards the spacecraft at 5 cm/s</source>
        <translation>3.9 m 的球体，以 4 cm/s 横向漂移，并以 5 cm/s 移向服务航天器</translation>
    </message>
    <message>
        <source>A 200 kg target with 20 N of thrust tries to leave through the closing mouth; sliding mode holds the spacecraft, which then tows it</source>
        <translation>200 kg 的目标以 20 N 的推力试图从正在收拢的网口逃出；滑模控制稳住服务航天器，随后将其拖走</translation>
    </message>
    <message>
        <source>Case 1 with the pocket of high_kink.toml: the spacecraft holds its attitude and lateral place by its own controllers</source>
        <translation>采用 high_kink.toml 网袋的工况 1：服务航天器用自己的控制器保持姿态和横向位置</translation>
    </message>
    <message>
        <source>Case 1 with the kink above the target&apos;s equator: pressed down, thrown back, stopped, within centimetres</source>
        <translation>折点高于目标赤道的工况 1：在几厘米之内被压下、弹回、停住</translation>
    </message>
    <message>
        <source>One of eight retractors jams at 2 s of 5 s; the mouth closes unevenly</source>
        <translation>八个收绳器之一在 5 s 收口的第 2 s 卡死；网口收拢不均匀</translation>
    </message>
    <message>
        <source>Thin rods with a low kink: the target is lifted a little and held gently</source>
        <translation>低折点的细充气杆：目标被略微托起并轻柔地抓住</translation>
    </message>
    <message>
        <source>A star tracker of 5 Hz and a gyro, both noisy and late, and thrusters with a least impulse bit hold the attitude</source>
        <translation>5 Hz 的星敏感器和陀螺均有噪声和延迟，由有最小冲量的推力器保持姿态</translation>
    </message>
    <message>
        <source>Case 1 with the mouth reaching over a sphere of 5.14 m: pushed down, thrown back, stopped</source>
        <translation>网口越过 5.14 m 球体的工况 1：被压下、弹回、停住</translation>
    </message>
    <message>
        <source>A 400 kg box that spins at 20 degrees per second is caught while reaction wheels hold the spacecraft</source>
        <translation>捕获以每秒 20 度自旋的 400 kg 长方体，其间反作用轮稳住服务航天器</translation>
    </message>
    <message>
        <source>A net of 22 m and four masses are thrown at a rocket stage of 9 t, wrap it, are drawn together and tow it</source>
        <translation>22 m 的绳网和四个质量块抛向 9 t 的火箭级，将其包裹、束紧并拖走</translation>
    </message>
    <message>
        <source>A net of 20 m without a drawstring is thrown at a body of 3.9 m that spins by 5 degrees a second</source>
        <translation>20 m 无束口绳的绳网抛向以每秒 5 度自旋的 3.9 m 物体</translation>
    </message>
    <message>
        <source>A box of 6.0 x 5.0 x 4.2 m and 400 kg that tumbles at about 12 degrees per second</source>
        <translation>6.0 x 5.0 x 4.2 m、400 kg 的长方体，以约每秒 12 度翻滚</translation>
    </message>
    <message>
        <source>A satellite of 350 kg and 8.4 m from tip to tip that tumbles at about 10 degrees per second</source>
        <translation>350 kg、翼展 8.4 m 的卫星，以约每秒 10 度翻滚</translation>
    </message>
    <message>
        <source>Closing in 5 s as in case 3; then the pocket is let go and towed on a tether of 10 m</source>
        <translation>与工况 3 一样在 5 s 内收口；随后释放网袋，用 10 m 的系绳拖曳</translation>
    </message>
    <message>
        <source>A net of 3.5 m with meshes of 0.25 m is thrown at a cube of 1 m and drawn together behind it</source>
        <translation>网目 0.25 m 的 3.5 m 绳网抛向 1 m 的立方体，并在其后方收口</translation>
    </message>
    <message>
        <source>A hexagonal net of 5 m with six masses is thrown at a light target of 1 m; winches close its neck</source>
        <translation>带六个角质量块的 5 m 六边形绳网抛向 1 m 的轻目标；绞车将网颈收拢</translation>
    </message>
    <message>
        <source>A net is thrown at a rocket stage in a low orbit, drawn together and tows it against V-bar for ten minutes</source>
        <translation>在低轨道上向一枚火箭末级抛射飞网，收口后沿 V-bar 反方向拖曳十分钟</translation>
    </message>
    <message>
        <source>A small open net of 5 m flies at 1 m/s over a ball of 2 m and wraps it by itself</source>
        <translation>一张张开的 5 m 小绳网以 1 m/s 飞向 2 m 的球，并自行将其包住</translation>
    </message>
    <message>
        <source>A net is thrown at a rocket stage; a drum pays out the tether under a light brake, holds it and gives way in the tow</source>
        <translation>飞网抛向一枚火箭级；卷筒在轻制动下放出系绳，随后锁住，并在拖曳时打滑让绳</translation>
    </message>
</context>
</TS>
