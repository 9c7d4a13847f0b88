<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
<context>
    <name>Corner</name>
    <message>
        <source>sharp</source>
        <translation>尖角</translation>
    </message>
    <message>
        <source>blunt</source>
        <translation>钝角</translation>
    </message>
    <message>
        <source>concave</source>
        <translation>凹角</translation>
    </message>
    <message>
        <source>transition</source>
        <translation>过渡</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>绕角</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>exact stop</source>
        <translation>准停</translation>
    </message>
    <message>
        <source>Sharp: on a transition path the wheel lifts clear of the tip.</source>
        <translation>尖角：磨轮沿过渡路径离开尖端。</translation>
    </message>
    <message>
        <source>Sharp, but the wheel cannot lift clear of the tip: it takes the transition path all the same.</source>
        <translation>尖角，但磨轮无法完全离开尖端；仍沿过渡路径运行。</translation>
    </message>
    <message>
        <source>Blunt, so not fragile: the wheel rolls round the corner.</source>
        <translation>钝角，不易崩边：磨轮绕角滚过。</translation>
    </message>
    <message>
        <source>from the angle</source>
        <translation>由角度决定</translation>
    </message>
    <message>
        <source>limited by the X axis</source>
        <translation>受 X 轴限制</translation>
    </message>
    <message>
        <source>limited by the Y axis</source>
        <translation>受 Y 轴限制</translation>
    </message>
    <message>
        <source>scaled by the corner speed</source>
        <translation>按转角速度缩放</translation>
    </message>
    <message>
        <source>Other glass is in the way of a transition path: the wheel rolls round the corner.</source>
        <translation>过渡路径被其他玻璃挡住：磨轮绕角滚过。</translation>
    </message>
    <message>
        <source>Concave, but shallow: an arc takes the place of the path&apos;s kink.</source>
        <translation>凹角，但较平缓：以圆弧代替路径的折点。</translation>
    </message>
    <message>
        <source>Concave: the wheel stops where it touches both edges.</source>
        <translation>凹角：磨轮在同时接触两条边处停止。</translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>The emergency stop has tripped.</source>
        <translation>急停已触发。</translation>
    </message>
    <message>
        <source>Somebody pressed it, or its circuit is open.</source>
        <translation>急停按钮被按下，或急停回路断开。</translation>
    </message>
    <message>
        <source>Make the machine safe, release the button, acknowledge.</source>
        <translation>确保机床安全，松开急停按钮，确认报警。</translation>
    </message>
    <message>
        <source>The encoder of {axis} gives no signal.</source>
        <translation>{axis} 轴编码器无信号。</translation>
    </message>
    <message>
        <source>A cable is broken or loose, or the encoder is dirty.</source>
        <translation>电缆断开或松动，或编码器脏污。</translation>
    </message>
    <message>
        <source>The axes report nothing any more.</source>
        <translation>各轴无反馈。</translation>
    </message>
    <message>
        <source>The connection to the drives is broken.</source>
        <translation>与驱动器的连接中断。</translation>
    </message>
    <message>
        <source>A set-point of {axis} was no number, or jumped by {value} mm/s² more than the axis can follow.</source>
        <translation>{axis} 轴设定值无效，或其跳变超出该轴跟随能力 {value} mm/s²。</translation>
    </message>
    <message>
        <source>A fault in Arris.</source>
        <translation>Arris 内部故障。</translation>
    </message>
    <message>
        <source>Save a support bundle and report it. Acknowledge to go on.</source>
        <translation>保存技术支持包并上报。确认报警后可继续。</translation>
    </message>
    <message>
        <source>{axis} stands {value} mm away from its set-point.</source>
        <translation>{axis} 轴偏离设定值 {value} mm。</translation>
    </message>
    <message>
        <source>The axis is blocked, or its drive is too weak.</source>
        <translation>轴卡住，或驱动力不足。</translation>
    </message>
    <message>
        <source>Free the axis, check the drive, acknowledge.</source>
        <translation>排除卡阻，检查驱动器，确认报警。</translation>
    </message>
    <message>
        <source>The drive of {axis} reports a fault.</source>
        <translation>{axis} 轴驱动器故障。</translation>
    </message>
    <message>
        <source>Overload, overheating, or a fault in the supply.</source>
        <translation>过载、过热或电源故障。</translation>
    </message>
    <message>
        <source>The drive of {axis} is not ready.</source>
        <translation>{axis} 轴驱动器未就绪。</translation>
    </message>
    <message>
        <source>Its supply is off, or a safety circuit is open.</source>
        <translation>驱动器电源未接通，或安全回路断开。</translation>
    </message>
    <message>
        <source>{axis} has hit a limit switch.</source>
        <translation>{axis} 轴碰到限位开关。</translation>
    </message>
    <message>
        <source>The axis ran past the end of its travel.</source>
        <translation>轴超出行程终点。</translation>
    </message>
    <message>
        <source>Acknowledge, jog the axis back, home again.</source>
        <translation>确认报警，点动退回该轴，重新回零。</translation>
    </message>
    <message>
        <source>{axis} would leave its travel.</source>
        <translation>{axis} 轴将超出行程。</translation>
    </message>
    <message>
        <source>The origin was moved, or the pattern lies too far out.</source>
        <translation>原点被移动，或图样位置过于靠外。</translation>
    </message>
    <message>
        <source>Acknowledge, set the origin, load the job again.</source>
        <translation>确认报警，设定原点，重新加载任务。</translation>
    </message>
    <message>
        <source>{axis} has not found its reference switch.</source>
        <translation>{axis} 轴未找到回零开关。</translation>
    </message>
    <message>
        <source>The switch is broken, or the axis did not move.</source>
        <translation>开关损坏，或轴未移动。</translation>
    </message>
    <message>
        <source>Check the switch and the axis, acknowledge, home again.</source>
        <translation>检查开关和轴，确认报警，重新回零。</translation>
    </message>
    <message>
        <source>The rotary buffers ran dry; the wheel was stopped on its path.</source>
        <translation>循环缓冲区已空；磨轮已在路径上停止。</translation>
    </message>
    <message>
        <source>The computer was too busy to supply the controller.</source>
        <translation>计算机负载过高，未能及时向控制器供给数据。</translation>
    </message>
    <message>
        <source>Close other programs, acknowledge, resume the job.</source>
        <translation>关闭其他程序，确认报警，继续任务。</translation>
    </message>
    <message>
        <source>The axes report late, by {value} ms.</source>
        <translation>各轴反馈延迟 {value} ms。</translation>
    </message>
    <message>
        <source>The computer or the connection to the drives is overloaded.</source>
        <translation>计算机或与驱动器的连接过载。</translation>
    </message>
    <message>
        <source>The axes had no set-point for {value} periods.</source>
        <translation>各轴连续 {value} 个周期无设定值。</translation>
    </message>
    <message>
        <source>The computer was too busy to supply them in time.</source>
        <translation>计算机负载过高，未能及时提供设定值。</translation>
    </message>
    <message>
        <source>The operator&apos;s side has not answered for half a second.</source>
        <translation>操作端已有半秒无响应。</translation>
    </message>
    <message>
        <source>The program hangs or has ended.</source>
        <translation>程序无响应或已退出。</translation>
    </message>
    <message>
        <source>Start Arris again, resume the job.</source>
        <translation>重新启动 Arris，继续任务。</translation>
    </message>
    <message>
        <source>The spindle has lost its speed on the glass.</source>
        <translation>磨削中主轴失速。</translation>
    </message>
    <message>
        <source>The wheel is overloaded or blocked, or the spindle&apos;s drive has a fault.</source>
        <translation>磨轮过载或卡住，或主轴驱动器故障。</translation>
    </message>
    <message>
        <source>Check wheel and spindle, acknowledge, resume the job.</source>
        <translation>检查磨轮和主轴，确认报警，继续任务。</translation>
    </message>
    <message>
        <source>The coolant has stopped flowing on the glass.</source>
        <translation>磨削中冷却液断流。</translation>
    </message>
    <message>
        <source>The tank is empty, or the pump or a filter is blocked.</source>
        <translation>水箱已空，或泵或过滤器堵塞。</translation>
    </message>
    <message>
        <source>The vacuum does not hold the glass.</source>
        <translation>真空未吸住玻璃。</translation>
    </message>
    <message>
        <source>A cup leaks, or the pump is off.</source>
        <translation>吸盘漏气，或真空泵未开。</translation>
    </message>
    <message>
        <source>Check cups and pump, place the glass again, acknowledge.</source>
        <translation>检查吸盘和真空泵，重新放置玻璃，确认报警。</translation>
    </message>
    <message>
        <source>The spindle does not reach its speed.</source>
        <translation>主轴未达到设定转速。</translation>
    </message>
    <message>
        <source>The spindle&apos;s drive is off or has a fault.</source>
        <translation>主轴驱动器未接通或故障。</translation>
    </message>
    <message>
        <source>Check the spindle, acknowledge, start again.</source>
        <translation>检查主轴，确认报警，重新启动。</translation>
    </message>
    <message>
        <source>The coolant does not flow.</source>
        <translation>无冷却液流动。</translation>
    </message>
    <message>
        <source>The tank is empty, a valve is closed, or the pump is off.</source>
        <translation>水箱已空、阀门关闭或泵未开。</translation>
    </message>
    <message>
        <source>Check the coolant, acknowledge, start again.</source>
        <translation>检查冷却液，确认报警，重新启动。</translation>
    </message>
    <message>
        <source>an axis</source>
        <translation>某</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 mm/s²</source>
        <translation>%1 mm/s²</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 periods</source>
        <translation>%1 个周期</translation>
    </message>
    <message>
        <source>Repair the encoder or its cable, acknowledge, home again.</source>
        <translation>修复编码器或其电缆，确认报警，重新回零。</translation>
    </message>
    <message>
        <source>Restore the connection, acknowledge, home again.</source>
        <translation>恢复连接，确认报警，重新回零。</translation>
    </message>
    <message>
        <source>Read the drive&apos;s display, clear its fault, acknowledge.</source>
        <translation>查看驱动器显示，排除故障，然后确认报警。</translation>
    </message>
    <message>
        <source>Switch its supply on, close the safety circuit, acknowledge.</source>
        <translation>接通驱动器供电，闭合安全回路，然后确认报警。</translation>
    </message>
    <message>
        <source>Restore the coolant, acknowledge, resume the job.</source>
        <translation>恢复冷却液，确认报警，继续任务。</translation>
    </message>
</context>
<context>
    <name>JobSheet</name>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>X %1, Y %2 mm</source>
        <translation>X %1，Y %2 mm</translation>
    </message>
    <message>
        <source>chosen by the program</source>
        <translation>由程序选择</translation>
    </message>
    <message>
        <source>Job sheet: %1</source>
        <translation>任务单：%1</translation>
    </message>
    <message>
        <source>X reversed</source>
        <translation>X 反向</translation>
    </message>
    <message>
        <source>Y reversed</source>
        <translation>Y 反向</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>英尺</translation>
    </message>
    <message>
        <source>Accelerations bind</source>
        <translation>加速度限制方式</translation>
    </message>
    <message>
        <source>each axis on its own</source>
        <translation>各轴单独</translation>
    </message>
    <message>
        <source>X and Y together</source>
        <translation>X、Y 合成</translation>
    </message>
    <message>
        <source>Direction round outlines</source>
        <translation>外轮廓磨削方向</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>顺时针</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>逆时针</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>Unit of the drawing</source>
        <translation>图纸单位</translation>
    </message>
    <message>
        <source>as its file says</source>
        <translation>按文件注明</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>What the wheel cannot reach may stay unground</source>
        <translation>磨轮磨不到的部分允许不磨</translation>
    </message>
    <message>
        <source>Start nearest to</source>
        <translation>起点最靠近</translation>
    </message>
    <message>
        <source>Lower left of the pane</source>
        <translation>玻璃左下角</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>行程</translation>
    </message>
    <message>
        <source>Greatest speed</source>
        <translation>最大速度</translation>
    </message>
    <message>
        <source>Greatest acceleration</source>
        <translation>最大加速度</translation>
    </message>
    <message>
        <source>Park position</source>
        <translation>停放位置</translation>
    </message>
    <message>
        <source>Feed when going down</source>
        <translation>下降进给速度</translation>
    </message>
    <message>
        <source>Period of the axes</source>
        <translation>各轴周期</translation>
    </message>
    <message>
        <source>Back-off from the glass</source>
        <translation>退离玻璃</translation>
    </message>
    <message>
        <source>%1 mm after %2 s</source>
        <translation>%2 s 后 %1 mm</translation>
    </message>
    <message>
        <source>Following error allowed</source>
        <translation>允许的跟随误差</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>转角</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Angle β</source>
        <translation>角度 β</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Treatment</source>
        <translation>处理方式</translation>
    </message>
    <message>
        <source>Speed v, mm/s</source>
        <translation>速度 v，mm/s</translation>
    </message>
    <message>
        <source>Time t, s</source>
        <translation>时间 t，s</translation>
    </message>
    <message>
        <source>Relief margin, mm</source>
        <translation>脱离余量，mm</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>转角</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>无。</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>The pattern cannot be ground.</source>
        <translation>图样无法磨削。</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>占比</translation>
    </message>
    <message>
        <source>Grinding, lead-in to lead-out</source>
        <translation>磨削（从切入到切出）</translation>
    </message>
    <message>
        <source>Whole program</source>
        <translation>整个程序</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Repairs of the drawing</source>
        <translation>图纸的修复</translation>
    </message>
    <message>
        <source>%1, continued</source>
        <translation>%1（续）</translation>
    </message>
</context>
<context>
    <name>JobState</name>
    <message>
        <source>Idle</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>Queued</source>
        <translation>排队中</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>已下达</translation>
    </message>
    <message>
        <source>Initialized</source>
        <translation>已加载</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>已中断</translation>
    </message>
    <message>
        <source>Aborted</source>
        <translation>已中止</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>已结束</translation>
    </message>
</context>
<context>
    <name>Legend</name>
    <message>
        <source>Finished contour</source>
        <translation>成品轮廓</translation>
    </message>
    <message>
        <source>Not in a contour</source>
        <translation>不属于轮廓</translation>
    </message>
    <message>
        <source>Wheel path</source>
        <translation>磨轮路径</translation>
    </message>
    <message>
        <source>Corner transition</source>
        <translation>转角过渡</translation>
    </message>
    <message>
        <source>Lead-in, lead-out</source>
        <translation>切入、切出</translation>
    </message>
    <message>
        <source>Rapid above the glass</source>
        <translation>玻璃上方快移</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>Wheel down, up</source>
        <translation>磨轮下降、抬起</translation>
    </message>
    <message>
        <source>Travel of the machine</source>
        <translation>机床行程</translation>
    </message>
    <message>
        <source>Slower between these</source>
        <translation>标记之间减速</translation>
    </message>
    <message>
        <source>Roll or arc at a corner</source>
        <translation>转角处滚过或圆弧</translation>
    </message>
    <message>
        <source>Stop in a concave corner</source>
        <translation>凹角处停止</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Note, repair</source>
        <translation>提示、修复</translation>
    </message>
</context>
<context>
    <name>Machine</name>
    <message>
        <source>Feed of plunges</source>
        <translation>下降进给速度</translation>
    </message>
    <message>
        <source>Servo period</source>
        <translation>伺服周期</translation>
    </message>
    <message>
        <source>Homing: speed towards the switch</source>
        <translation>回零：趋近开关的速度</translation>
    </message>
    <message>
        <source>Homing: speed off the switch</source>
        <translation>回零：离开开关的速度</translation>
    </message>
    <message>
        <source>Fastest jog</source>
        <translation>最大点动速度</translation>
    </message>
    <message>
        <source>Set-points ahead of time</source>
        <translation>设定值提前时间</translation>
    </message>
    <message>
        <source>Greatest following error</source>
        <translation>最大跟随误差</translation>
    </message>
    <message>
        <source>Backing off in a hold</source>
        <translation>保持时的退离量</translation>
    </message>
    <message>
        <source>At rest before backing off</source>
        <translation>退离前的静止时间</translation>
    </message>
    <message>
        <source>Longest wait for spindle and coolant</source>
        <translation>等待主轴和冷却液的最长时间</translation>
    </message>
    <message>
        <source>Travel of the axes</source>
        <translation>各轴行程</translation>
    </message>
    <message>
        <source>Greatest speeds of the axes</source>
        <translation>各轴最大速度</translation>
    </message>
    <message>
        <source>Greatest accelerations of the axes</source>
        <translation>各轴最大加速度</translation>
    </message>
    <message>
        <source>Park position</source>
        <translation>停放位置</translation>
    </message>
    <message>
        <source>Reference switches</source>
        <translation>回零开关</translation>
    </message>
    <message>
        <source>Jog only while the panel&apos;s jog enable is held</source>
        <translation>仅在按住面板上的点动使能时才可点动</translation>
    </message>
</context>
<context>
    <name>Phase</name>
    <message>
        <source>Approach</source>
        <translation>趋近</translation>
    </message>
    <message>
        <source>Plunge</source>
        <translation>下降</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>切入</translation>
    </message>
    <message>
        <source>Cruise</source>
        <translation>匀速</translation>
    </message>
    <message>
        <source>Decelerate</source>
        <translation>减速</translation>
    </message>
    <message>
        <source>Transition</source>
        <translation>过渡</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>绕角</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Accelerate</source>
        <translation>加速</translation>
    </message>
    <message>
        <source>Lead-out</source>
        <translation>切出</translation>
    </message>
    <message>
        <source>Retract</source>
        <translation>抬起</translation>
    </message>
    <message>
        <source>Traverse</source>
        <translation>空移</translation>
    </message>
</context>
<context>
    <name>PreviewPage</name>
    <message>
        <source>on the table</source>
        <translation>（工作台坐标）</translation>
    </message>
    <message>
        <source>of the drawing</source>
        <translation>（图纸坐标）</translation>
    </message>
    <message>
        <source>X %1, mm</source>
        <translation>X%1，mm</translation>
    </message>
    <message>
        <source>Y %1, mm</source>
        <translation>Y%1，mm</translation>
    </message>
    <message>
        <source>Scale 1 : %1</source>
        <translation>比例 1 : %1</translation>
    </message>
    <message>
        <source>No contour</source>
        <translation>无轮廓</translation>
    </message>
    <message>
        <source>Pane %1, lower left at X %2, Y %3</source>
        <translation>玻璃 %1，左下角 X %2，Y %3</translation>
    </message>
    <message>
        <source>glass %1 mm</source>
        <translation>厚 %1 mm</translation>
    </message>
    <message>
        <source>corners: %1</source>
        <translation>转角：%1</translation>
    </message>
    <message>
        <source>Wheel R %1 mm · depth %2 mm · feed %3 mm/min · acceleration X %4, Y %5 mm/s²</source>
        <translation>磨轮 R %1 mm · 深度 %2 mm · 进给 %3 mm/min · 加速度 X %4，Y %5 mm/s²</translation>
    </message>
    <message>
        <source>Cannot be ground</source>
        <translation>无法磨削</translation>
    </message>
    <message>
        <source>Grinding %1 · whole program %2 · wheel path %3 mm</source>
        <translation>磨削 %1 · 整个程序 %2 · 磨轮路径 %3 mm</translation>
    </message>
    <message>
        <source>pieces in no contour: %1</source>
        <translation>不属于轮廓的线段：%1</translation>
    </message>
    <message>
        <source>… and %1 more kinds of findings</source>
        <translation>……另有 %1 类结果</translation>
    </message>
    <message>
        <source>Contours: %1 (outlines %2, cut-outs %3)</source>
        <translation>轮廓：%1（外轮廓 %2，开孔 %3）</translation>
    </message>
    <message>
        <source>And %1 more like it.</source>
        <translation>另有 %1 处同类。</translation>
    </message>
    <message>
        <source>Contours: %1</source>
        <translation>轮廓：%1</translation>
    </message>
</context>
<context>
    <name>Problem</name>
    <message>
        <source>{file} cannot be opened: {reason}.</source>
        <translation>无法打开 {file}：{reason}。</translation>
    </message>
    <message>
        <source>{file} cannot be read: {reason}.</source>
        <translation>无法读取 {file}：{reason}。</translation>
    </message>
    <message>
        <source>{file} cannot be written: {reason}.</source>
        <translation>无法写入 {file}：{reason}。</translation>
    </message>
    <message>
        <source>{file} is not valid JSON: {reason}.</source>
        <translation>{file} 不是有效的 JSON：{reason}。</translation>
    </message>
    <message>
        <source>{file} has no &quot;{key}&quot;: it is not such a file.</source>
        <translation>{file} 没有“{key}”：不是此类文件。</translation>
    </message>
    <message>
        <source>{file} was written by a newer Arris (&quot;{key}&quot;: {version}); this one reads up to {known}.</source>
        <translation>{file} 由更新版本的 Arris 写入（“{key}”：{version}）；本版本最高可读 {known}。</translation>
    </message>
    <message>
        <source>{file} has a key &quot;{key}&quot; that Arris does not know; it is ignored.</source>
        <translation>{file} 含有 Arris 不认识的键“{key}”，已忽略。</translation>
    </message>
    <message>
        <source>{name} must be {expected}, not {value}.</source>
        <translation>{name} 必须是 {expected}，而不是 {value}。</translation>
    </message>
    <message>
        <source>{name} must be a number in {unit}, not &quot;{value}&quot;.</source>
        <translation>{name} 必须是以 {unit} 为单位的数，而不是“{value}”。</translation>
    </message>
    <message>
        <source>{name} is {value} {unit}; it must be from {least} to {most} {unit}.</source>
        <translation>{name} 为 {value} {unit}；必须在 {least} 至 {most} {unit} 之间。</translation>
    </message>
    <message>
        <source>{name} is {value} {unit}; the machine allows {most} {unit} at most.</source>
        <translation>{name} 为 {value} {unit}；机床最多允许 {most} {unit}。</translation>
    </message>
    <message>
        <source>{name} is &quot;{value}&quot;; it must be one of: {choices}.</source>
        <translation>{name} 为“{value}”；只能是：{choices}。</translation>
    </message>
    <message>
        <source>{file} is not a profile of Arris: {reason}.</source>
        <translation>{file} 不是 Arris 的速度曲线文件：{reason}。</translation>
    </message>
    <message>
        <source>The pattern file is empty.</source>
        <translation>图样文件为空。</translation>
    </message>
    <message>
        <source>This is not a DXF file: {reason}.</source>
        <translation>这不是 DXF 文件：{reason}。</translation>
    </message>
    <message>
        <source>The lines end in carriage returns alone; save the file with LF or CR LF.</source>
        <translation>文件的行尾只有回车符（CR）；请以 LF 或 CR LF 保存。</translation>
    </message>
    <message>
        <source>A group code is expected here, not {found}.</source>
        <translation>此处应为组码，而不是 {found}。</translation>
    </message>
    <message>
        <source>Group {group} must hold a finite number, not {found}.</source>
        <translation>组 {group} 必须是有限的数，而不是 {found}。</translation>
    </message>
    <message>
        <source>Group {group} holds {found}, which is absurd for a pane of glass (more than {most}).</source>
        <translation>组 {group} 的值为 {found}，对一块玻璃而言不合理（超过 {most}）。</translation>
    </message>
    <message>
        <source>The file ends early: {reason}. It was cut off.</source>
        <translation>文件提前结束：{reason}。文件不完整。</translation>
    </message>
    <message>
        <source>The sections of the file are broken: {reason}.</source>
        <translation>文件的段结构有误：{reason}。</translation>
    </message>
    <message>
        <source>{entity} announces {announced} {what} but has {found}.</source>
        <translation>{entity} 声明有 {announced} 个{what}，实际为 {found} 个。</translation>
    </message>
    <message>
        <source>{entity} lacks group {group} ({what}).</source>
        <translation>{entity} 缺少组 {group}（{what}）。</translation>
    </message>
    <message>
        <source>{entity} has {what} {value}, which cannot be.</source>
        <translation>{entity} 的{what} {value}，这不可能。</translation>
    </message>
    <message>
        <source>The file does not say its unit; millimetres are assumed.</source>
        <translation>文件未注明单位；按毫米处理。</translation>
    </message>
    <message>
        <source>The file gives its unit as number {number}, which is not mm, cm, m, inch or foot; say the unit with --units.</source>
        <translation>文件的单位编号为 {number}，不是毫米、厘米、米、英寸或英尺；请用 --units 指定单位。</translation>
    </message>
    <message>
        <source>{count} × {entity} not read yet; the contour would lack it.</source>
        <translation>{count} × {entity} 尚不支持读取；轮廓会因此缺失。</translation>
    </message>
    <message>
        <source>{count} × {entity} not flat in a plane parallel to the XY plane.</source>
        <translation>{count} × {entity} 不在与 XY 平面平行的平面内。</translation>
    </message>
    <message>
        <source>{count} × {entity} passed over: {reason}.</source>
        <translation>已略过 {count} × {entity}：{reason}。</translation>
    </message>
    <message>
        <source>{count} more of {code} are not listed.</source>
        <translation>另有 {count} 条 {code} 未列出。</translation>
    </message>
    <message>
        <source>A doubled piece of {size_mm} mm was removed.</source>
        <translation>已删除一段 {size_mm} mm 的重复线段。</translation>
    </message>
    <message>
        <source>A piece without length ({size_mm} mm) was removed.</source>
        <translation>已删除一段无长度的线段（{size_mm} mm）。</translation>
    </message>
    <message>
        <source>A gap of {size_mm} mm was closed.</source>
        <translation>已闭合 {size_mm} mm 的间隙。</translation>
    </message>
    <message>
        <source>The contour is open here: the next free end is {gap_mm} mm away (up to {tolerance_mm} mm are joined).</source>
        <translation>轮廓在此处断开：最近的自由端相距 {gap_mm} mm（{tolerance_mm} mm 以内会自动连接）。</translation>
    </message>
    <message>
        <source>{count} pieces meet here; a contour cannot branch.</source>
        <translation>此处有 {count} 段相交；轮廓不能分叉。</translation>
    </message>
    <message>
        <source>The drawing has no closed contour.</source>
        <translation>图中没有闭合轮廓。</translation>
    </message>
    <message>
        <source>The contour encloses no area.</source>
        <translation>轮廓没有围成面积。</translation>
    </message>
    <message>
        <source>The contour crosses or touches itself here.</source>
        <translation>轮廓在此处自相交或自接触。</translation>
    </message>
    <message>
        <source>The contour turns back on itself here, in a tip of {angle_deg}°; that is a mistake of the drawing.</source>
        <translation>轮廓在此处折返，尖端仅 {angle_deg}°；这是图纸错误。</translation>
    </message>
    <message>
        <source>Corner {corner}: the wheel lifts by {lift_mm} mm, less than the {depth_mm} mm of glass at the tip.</source>
        <translation>转角 {corner}：磨轮抬离 {lift_mm} mm，小于尖端处 {depth_mm} mm 的玻璃磨削量。</translation>
    </message>
    <message>
        <source>Corner {corner} takes {time_s} s.</source>
        <translation>转角 {corner} 用时 {time_s} s。</translation>
    </message>
    <message>
        <source>The overlap is {used_mm} mm, a quarter of the contour, instead of {wanted_mm} mm.</source>
        <translation>重叠长度取 {used_mm} mm（轮廓的四分之一），而不是 {wanted_mm} mm。</translation>
    </message>
    <message>
        <source>The wheel path leaves the travel of the machine by {excess_mm} mm: {what}.</source>
        <translation>磨轮路径超出机床行程 {excess_mm} mm：{what}。</translation>
    </message>
    <message>
        <source>The wheel&apos;s lower face would be {height_mm} mm above the table while grinding; it must stay {least_mm} mm above.</source>
        <translation>磨削时磨轮下端面离工作台 {height_mm} mm；至少须保持 {least_mm} mm。</translation>
    </message>
    <message>
        <source>The {what} height of {height_mm} mm is outside the travel of 0 to {most_mm} mm.</source>
        <translation>{what} {height_mm} mm 超出 0 至 {most_mm} mm 的行程。</translation>
    </message>
    <message>
        <source>The grinding height of {height_mm} mm is above the clearance height of {clearance_mm} mm.</source>
        <translation>磨削高度 {height_mm} mm 高于安全高度 {clearance_mm} mm。</translation>
    </message>
    <message>
        <source>The machine&apos;s greatest speed of the {axis} axis is below the feed; it limits the speed on the contour.</source>
        <translation>机床 {axis} 轴的最高速度低于进给速度；轮廓上的速度因此受限。</translation>
    </message>
    <message>
        <source>Internal error: {reason}.</source>
        <translation>内部错误：{reason}。</translation>
    </message>
    <message>
        <source>Axes through LinuxCNC are not available: {reason}.</source>
        <translation>LinuxCNC 轴不可用：{reason}。</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>提示</translation>
    </message>
    <message>
        <source>A single piece, its ends {length_mm} mm apart, belongs to no contour; it may lie on top of another.</source>
        <translation>一个单独的图元（两端相距 {length_mm} mm）不属于任何轮廓；它可能与另一图元重叠。</translation>
    </message>
    <message>
        <source>The wheel cannot {what} here: it needs {needed_mm} mm between its centre and the glass and has {distance_mm} mm. Start on a longer edge away from sharp corners, or change the lead&apos;s radius.</source>
        <translation>磨轮无法在此处{what}：磨轮中心与玻璃之间需要 {needed_mm} mm，实际为 {distance_mm} mm。请在远离尖角的较长边上起始，或更改引入半径。</translation>
    </message>
    <message>
        <source>At the park position the wheel&apos;s lower face would be {height_mm} mm above the table, over or beside the glass; it must be {least_mm} mm above.</source>
        <translation>在停放位置，磨轮下表面将高于工作台 {height_mm} mm，位于玻璃上方或旁边；必须高出 {least_mm} mm。</translation>
    </message>
    <message>
        <source>The binary DXF file is damaged: {reason}.</source>
        <translation>二进制 DXF 文件已损坏：{reason}。</translation>
    </message>
    <message>
        <source>Block {block} is defined twice, first on line {first}; give one of them another name.</source>
        <translation>块 {block} 被定义了两次，第一次在第 {first} 行；请给其中一个改名。</translation>
    </message>
    <message>
        <source>{count} × INSERT of block {entity}, which the file does not have; explode it before saving.</source>
        <translation>{count} 个 INSERT 引用块 {entity}，而文件中没有该块；请在保存前分解。</translation>
    </message>
    <message>
        <source>Block {block} inserts itself here, or blocks are nested more than {most} deep; explode it before saving.</source>
        <translation>块 {block} 在此处插入自身，或块的嵌套超过 {most} 层；请在保存前分解。</translation>
    </message>
    <message>
        <source>INSERT of block {entity} would make more than {most} pieces of the drawing; draw fewer copies.</source>
        <translation>块 {entity} 的 INSERT 会产生超过 {most} 个图形段；请减少副本。</translation>
    </message>
    <message>
        <source>The SPLINE is no curve: {reason}.</source>
        <translation>SPLINE 不构成曲线：{reason}。</translation>
    </message>
    <message>
        <source>From here on the curves of the drawing are too long or too many to follow with arcs ({most} steps).</source>
        <translation>从此处起，图中的曲线过长或过多，无法用圆弧逼近（{most} 步）。</translation>
    </message>
    <message>
        <source>{entity} lies {distance_mm} mm away, which is absurd for a pane of glass (more than {most_mm} mm).</source>
        <translation>{entity} 位于 {distance_mm} mm 之外，对玻璃来说不合理（超过 {most_mm} mm）。</translation>
    </message>
    <message>
        <source>A piece ends here on another one, between that one&apos;s ends; a contour cannot branch. Remove one of them.</source>
        <translation>一段在此处终止于另一段的中间；轮廓不能分叉。请删除其中一段。</translation>
    </message>
    <message>
        <source>Contours {first} and {second} cross or touch here; move them apart in the drawing.</source>
        <translation>轮廓 {first} 和 {second} 在此处相交或接触；请在图中将其分开。</translation>
    </message>
    <message>
        <source>The {count} joints from here on look like the chords of a curve but stay corners: they are joined from a smoothing tolerance of {needed_mm} mm on (now {tolerance_mm} mm).</source>
        <translation>从此处起的 {count} 个连接点像是曲线的弦，但仍作为转角：平滑公差达到 {needed_mm} mm 时才会连成曲线（现为 {tolerance_mm} mm）。</translation>
    </message>
    <message>
        <source>The wheel of {wheel_mm} mm radius does not reach {length_mm} mm of the contour here; up to {left_mm} mm of glass would stay. Take a wheel of at most {largest_mm} mm, or accept that this stays unground.</source>
        <translation>半径 {wheel_mm} mm 的磨轮在此处有 {length_mm} mm 轮廓磨不到；最多会留下 {left_mm} mm 玻璃。请使用半径不超过 {largest_mm} mm 的磨轮，或允许此处不磨。</translation>
    </message>
    <message>
        <source>The wheel of {wheel_mm} mm radius does not reach {length_mm} mm of the contour here; up to {left_mm} mm of glass stay. A wheel of at most {largest_mm} mm would.</source>
        <translation>半径 {wheel_mm} mm 的磨轮在此处有 {length_mm} mm 轮廓磨不到；最多留下 {left_mm} mm 玻璃。半径不超过 {largest_mm} mm 的磨轮可以磨到。</translation>
    </message>
    <message>
        <source>The wheel of {wheel_mm} mm radius does not reach this contour of {length_mm} mm at all. Take a wheel of less than {largest_mm} mm, or accept that it stays unground.</source>
        <translation>半径 {wheel_mm} mm 的磨轮完全磨不到这条 {length_mm} mm 的轮廓。请使用半径小于 {largest_mm} mm 的磨轮，或允许其不磨。</translation>
    </message>
    <message>
        <source>This contour of {length_mm} mm stays unground: the wheel of {wheel_mm} mm radius does not reach it. A wheel of less than {largest_mm} mm would.</source>
        <translation>这条 {length_mm} mm 的轮廓不磨：半径 {wheel_mm} mm 的磨轮磨不到。半径小于 {largest_mm} mm 的磨轮可以磨到。</translation>
    </message>
    <message>
        <source>The wheel of {wheel_mm} mm radius reaches no contour at all.</source>
        <translation>半径 {wheel_mm} mm 的磨轮磨不到任何轮廓。</translation>
    </message>
    <message>
        <source>Corner {corner} is concave: the wheel leaves {fillet_mm} mm of glass before it, and {unground_mm} mm of its edges are not ground.</source>
        <translation>转角 {corner} 为凹角：磨轮在其前留下 {fillet_mm} mm 玻璃，其边有 {unground_mm} mm 未磨。</translation>
    </message>
    <message>
        <source>Corner {corner}: a transition would touch other glass here; the wheel rolls round the corner instead.</source>
        <translation>转角 {corner}：过渡路径会碰到其他玻璃；磨轮改为绕角滚过。</translation>
    </message>
    <message>
        <source>A size correction of {correction_mm} mm would change the shape of the contour here.</source>
        <translation>{correction_mm} mm 的尺寸修正会改变此处轮廓的形状。</translation>
    </message>
    <message>
        <source>The wheel cannot {what} here: it needs {needed_mm} mm between its centre and the glass and has {distance_mm} mm. What it would grind from here stays unground.</source>
        <translation>磨轮无法在此处{what}：磨轮中心与玻璃之间需要 {needed_mm} mm，实际为 {distance_mm} mm。从此处要磨的部分不磨。</translation>
    </message>
    <message>
        <source>(line %1 of the file, at X %2, Y %3 mm)</source>
        <translation>（文件第 %1 行，位于 X %2，Y %3 mm）</translation>
    </message>
    <message>
        <source>(line %1 of the file)</source>
        <translation>（文件第 %1 行）</translation>
    </message>
    <message>
        <source>(at X %1, Y %2 mm)</source>
        <translation>（位于 X %1，Y %2 mm）</translation>
    </message>
    <message>
        <source>From here on so many contours lie over or within each other that they cannot be checked (more than {most} comparisons); draw fewer.</source>
        <translation>从此处起，相互重叠或嵌套的轮廓过多，无法检查（比较超过 {most} 次）；请减少轮廓。</translation>
    </message>
    <message>
        <source>{file} is not the record of a run: {reason}.</source>
        <translation>{file} 不是运行记录：{reason}。</translation>
    </message>
    <message>
        <source>{file} is not whole: {reason} at byte {byte}. What can be read is used.</source>
        <translation>{file} 不完整：{reason}（自第 {byte} 字节起）。可读取的部分将被使用。</translation>
    </message>
    <message>
        <source>{file} is damaged and was kept as {kept}; hours and metres are counted from zero.</source>
        <translation>{file} 已损坏，已另存为 {kept}；小时数和米数从零开始计。</translation>
    </message>
    <message>
        <source>{file} is not a back-up that can be restored: {reason}.</source>
        <translation>{file} 不是可恢复的备份：{reason}。</translation>
    </message>
    <message>
        <source>The job that was broken off is of another pattern or an earlier state of it: {file} had the fingerprint {was}, now it has {is}.</source>
        <translation>中断的任务属于另一图样或该图样的较早版本：{file} 当时的指纹为 {was}，现在为 {is}。</translation>
    </message>
    <message>
        <source>The job that was broken off was planned for another machine: {key} was {was}, now it is {is}.</source>
        <translation>中断的任务是为另一台机床规划的：{key} 当时为 {was}，现在为 {is}。</translation>
    </message>
    <message>
        <source>The place where the job was broken off (segment {segment}, {lambda_mm} mm) is not on the job as it is planned now.</source>
        <translation>任务的中断位置（第 {segment} 段，{lambda_mm} mm）不在当前规划的任务上。</translation>
    </message>
    <message>
        <source>{file} is damaged and has no effect; it was kept as {aside}.</source>
        <translation>{file} 已损坏，不起作用；已另存为 {aside}。</translation>
    </message>
    <message>
        <source>It was given up before it was done.</source>
        <translation>已在完成前取消。</translation>
    </message>
</context>
<context>
    <name>ProblemWord</name>
    <message>
        <source>No such file or directory</source>
        <translation>文件或文件夹不存在</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>没有权限</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>这是一个文件夹</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>输入/输出错误</translation>
    </message>
    <message>
        <source>it holds NUL bytes</source>
        <translation>含有 NUL 字节</translation>
    </message>
    <message>
        <source>it is a DWG drawing; save it as DXF</source>
        <translation>这是 DWG 图纸，请另存为 DXF</translation>
    </message>
    <message>
        <source>it is UTF-16 text; save it as ASCII DXF</source>
        <translation>这是 UTF-16 文本，请另存为 ASCII DXF</translation>
    </message>
    <message>
        <source>it begins with {} and not with a group code</source>
        <translation>开头是 {}，而不是组码</translation>
    </message>
    <message>
        <source>an empty line</source>
        <translation>空行</translation>
    </message>
    <message>
        <source>the last group code has no value</source>
        <translation>最后一个组码没有值</translation>
    </message>
    <message>
        <source>there is no EOF</source>
        <translation>缺少 EOF</translation>
    </message>
    <message>
        <source>there is no EOF; the last POLYLINE has no SEQEND</source>
        <translation>缺少 EOF；最后的 POLYLINE 没有 SEQEND</translation>
    </message>
    <message>
        <source>there is no EOF, and section {} has no ENDSEC</source>
        <translation>缺少 EOF，且段 {} 没有 ENDSEC</translation>
    </message>
    <message>
        <source>section {} has no ENDSEC before the next SECTION</source>
        <translation>段 {} 在下一个 SECTION 之前没有 ENDSEC</translation>
    </message>
    <message>
        <source>section {} has no ENDSEC before EOF</source>
        <translation>段 {} 在 EOF 之前没有 ENDSEC</translation>
    </message>
    <message>
        <source>ENDSEC without a SECTION</source>
        <translation>有 ENDSEC 而没有 SECTION</translation>
    </message>
    <message>
        <source>the section has no name</source>
        <translation>段没有名称</translation>
    </message>
    <message>
        <source>the POLYLINE of line {} has no SEQEND</source>
        <translation>第 {} 行的 POLYLINE 没有 SEQEND</translation>
    </message>
    <message>
        <source>the POLYLINE of line {} has no SEQEND before {}</source>
        <translation>第 {} 行的 POLYLINE 没有 SEQEND，其后是 {}</translation>
    </message>
    <message>
        <source>{} without a POLYLINE before it</source>
        <translation>{} 之前没有 POLYLINE</translation>
    </message>
    <message>
        <source>group {} belongs to no entity</source>
        <translation>组 {} 不属于任何图元</translation>
    </message>
    <message>
        <source>group {} stands outside of any section</source>
        <translation>组 {} 不在任何段内</translation>
    </message>
    <message>
        <source>{} stands outside of any section</source>
        <translation>{} 不在任何段内</translation>
    </message>
    <message>
        <source>group {}</source>
        <translation>组 {}</translation>
    </message>
    <message>
        <source>twice</source>
        <translation>出现两次</translation>
    </message>
    <message>
        <source>X of its start</source>
        <translation>起点 X</translation>
    </message>
    <message>
        <source>Y of its start</source>
        <translation>起点 Y</translation>
    </message>
    <message>
        <source>X of its end</source>
        <translation>终点 X</translation>
    </message>
    <message>
        <source>Y of its end</source>
        <translation>终点 Y</translation>
    </message>
    <message>
        <source>X of its centre</source>
        <translation>圆心 X</translation>
    </message>
    <message>
        <source>Y of its centre</source>
        <translation>圆心 Y</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>start angle</source>
        <translation>起始角</translation>
    </message>
    <message>
        <source>end angle</source>
        <translation>终止角</translation>
    </message>
    <message>
        <source>the radius</source>
        <translation>半径为</translation>
    </message>
    <message>
        <source>a bulge of</source>
        <translation>凸度为</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>on layer {}, which is never plotted</source>
        <translation>位于从不打印的图层 {}</translation>
    </message>
    <message>
        <source>layer {} is frozen</source>
        <translation>图层 {} 已冻结</translation>
    </message>
    <message>
        <source>layer {} is off</source>
        <translation>图层 {} 已关闭</translation>
    </message>
    <message>
        <source>in paper space</source>
        <translation>位于图纸空间</translation>
    </message>
    <message>
        <source>no part of a contour</source>
        <translation>不是轮廓的一部分</translation>
    </message>
    <message>
        <source>invisible</source>
        <translation>不可见</translation>
    </message>
    <message>
        <source>go down</source>
        <translation>下降</translation>
    </message>
    <message>
        <source>come up</source>
        <translation>抬起</translation>
    </message>
    <message>
        <source>lead in</source>
        <translation>切入</translation>
    </message>
    <message>
        <source>lead out</source>
        <translation>切出</translation>
    </message>
    <message>
        <source>the lead-in</source>
        <translation>切入路径</translation>
    </message>
    <message>
        <source>the lead-out</source>
        <translation>切出路径</translation>
    </message>
    <message>
        <source>the transition at corner {}</source>
        <translation>转角 {} 的过渡</translation>
    </message>
    <message>
        <source>the roll round corner {}</source>
        <translation>绕转角 {} 的滚动</translation>
    </message>
    <message>
        <source>the way along the contour</source>
        <translation>沿轮廓的路径</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>安全高度</translation>
    </message>
    <message>
        <source>grinding</source>
        <translation>磨削高度</translation>
    </message>
    <message>
        <source>this Arris was built without them; install linuxcnc-uspace-dev and build it again</source>
        <translation>本 Arris 构建时未包含该功能；请安装 linuxcnc-uspace-dev 后重新构建</translation>
    </message>
    <message>
        <source>install linuxcnc-uspace; {}</source>
        <translation>请安装 linuxcnc-uspace；{}</translation>
    </message>
    <message>
        <source>the module is of another version of Arris</source>
        <translation>该模块属于另一版本的 Arris</translation>
    </message>
    <message>
        <source>another Arris drives them already</source>
        <translation>另一个 Arris 已在控制这些轴</translation>
    </message>
    <message>
        <source>this user may not reach the HAL session</source>
        <translation>当前用户无权访问 HAL 会话</translation>
    </message>
    <message>
        <source>HAL has no memory left</source>
        <translation>HAL 内存不足</translation>
    </message>
    <message>
        <source>no HAL session for Arris runs; start one with packaging/hal/start.sh</source>
        <translation>没有为 Arris 运行的 HAL 会话；请用 packaging/hal/start.sh 启动</translation>
    </message>
    <message>
        <source>the HAL session has no signal {} that fits; compare its file with packaging/hal</source>
        <translation>HAL 会话没有匹配的信号 {}；请将其文件与 packaging/hal 中的文件对照</translation>
    </message>
    <message>
        <source>the HAL session lacks streamer cfg=ffff or sampler cfg=fffff; compare its file with packaging/hal</source>
        <translation>HAL 会话缺少 streamer cfg=ffff 或 sampler cfg=fffff；请将其文件与 packaging/hal 中的文件对照</translation>
    </message>
    <message>
        <source>an Arris that died has left the HAL session unfinished; start it again with packaging/hal/start.sh</source>
        <translation>异常终止的 Arris 留下了未完成的 HAL 会话；请用 packaging/hal/start.sh 重新启动</translation>
    </message>
    <message>
        <source>the threads of the HAL session do not run</source>
        <translation>HAL 会话的线程未运行</translation>
    </message>
    <message>
        <source>the HAL session&apos;s streamer is not emptied, or somebody else fills it</source>
        <translation>HAL 会话的 streamer 未被清空，或有其他程序在写入</translation>
    </message>
    <message>
        <source>the HAL session&apos;s period is {} s, the machine&apos;s {} s</source>
        <translation>HAL 会话的周期为 {} s，机床的周期为 {} s</translation>
    </message>
    <message>
        <source>knots</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>control points</source>
        <translation>控制点</translation>
    </message>
    <message>
        <source>fit points</source>
        <translation>拟合点</translation>
    </message>
    <message>
        <source>X of its major axis</source>
        <translation>长轴的 X</translation>
    </message>
    <message>
        <source>Y of its major axis</source>
        <translation>长轴的 Y</translation>
    </message>
    <message>
        <source>ratio of its axes</source>
        <translation>两轴之比</translation>
    </message>
    <message>
        <source>a ratio of axes of</source>
        <translation>两轴之比</translation>
    </message>
    <message>
        <source>name of the block</source>
        <translation>块名</translation>
    </message>
    <message>
        <source>a major axis of</source>
        <translation>长轴</translation>
    </message>
    <message>
        <source>layer {} is not chosen</source>
        <translation>图层 {} 未选择</translation>
    </message>
    <message>
        <source>block {} has no ENDBLK</source>
        <translation>块 {} 没有 ENDBLK</translation>
    </message>
    <message>
        <source>{} stands outside of any block</source>
        <translation>{} 不在任何块内</translation>
    </message>
    <message>
        <source>ENDBLK without a BLOCK</source>
        <translation>ENDBLK 之前没有 BLOCK</translation>
    </message>
    <message>
        <source>its first line is broken</source>
        <translation>首行损坏</translation>
    </message>
    <message>
        <source>byte {} begins no group</source>
        <translation>字节 {} 处不是组的开头</translation>
    </message>
    <message>
        <source>it ends within the group at byte {}</source>
        <translation>文件在字节 {} 处的组中间结束</translation>
    </message>
    <message>
        <source>its degree is {}; up to {} are read</source>
        <translation>其阶数为 {}；最多读取 {} 阶</translation>
    </message>
    <message>
        <source>it has {} control points and needs {}</source>
        <translation>有 {} 个控制点，需要 {} 个</translation>
    </message>
    <message>
        <source>it has {} knots and needs {}</source>
        <translation>有 {} 个节点，需要 {} 个</translation>
    </message>
    <message>
        <source>its knots fall from {} to {}</source>
        <translation>节点值从 {} 降到 {}</translation>
    </message>
    <message>
        <source>its knots are all the same</source>
        <translation>所有节点值相同</translation>
    </message>
    <message>
        <source>it has {} weights and needs {}</source>
        <translation>有 {} 个权值，需要 {} 个</translation>
    </message>
    <message>
        <source>it has a weight of {}, which is not positive</source>
        <translation>有权值 {}，不是正数</translation>
    </message>
    <message>
        <source>its weights reach from {} to {}</source>
        <translation>权值从 {} 到 {}</translation>
    </message>
    <message>
        <source>it breaks apart</source>
        <translation>曲线断开</translation>
    </message>
    <message>
        <source>it does not begin like one</source>
        <translation>文件开头不符</translation>
    </message>
    <message>
        <source>its header is damaged</source>
        <translation>文件头已损坏</translation>
    </message>
    <message>
        <source>it breaks off</source>
        <translation>文件中断</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>数据已损坏</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>文件过大</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>it has no rows</source>
        <translation>没有数据行</translation>
    </message>
    <message>
        <source>the time does not increase</source>
        <translation>时间没有递增</translation>
    </message>
    <message>
        <source>the column {} is missing</source>
        <translation>缺少列 {}</translation>
    </message>
    <message>
        <source>the column {} stands twice</source>
        <translation>列 {} 出现两次</translation>
    </message>
    <message>
        <source>{} fields instead of {}</source>
        <translation>有 {} 个字段，应为 {} 个</translation>
    </message>
    <message>
        <source>distance_mm must be empty where corner is 0</source>
        <translation>corner 为 0 时 distance_mm 必须为空</translation>
    </message>
    <message>
        <source>{} must be a finite number, not {}</source>
        <translation>{} 必须是有限数值，而不是 {}</translation>
    </message>
    <message>
        <source>{} must be a whole number from 0 on, not {}</source>
        <translation>{} 必须是不小于 0 的整数，而不是 {}</translation>
    </message>
    <message>
        <source>{} is no phase</source>
        <translation>{} 不是任何阶段</translation>
    </message>
    <message>
        <source>it is no archive of Arris</source>
        <translation>不是 Arris 的归档文件</translation>
    </message>
    <message>
        <source>it is damaged or cut off</source>
        <translation>文件已损坏或不完整</translation>
    </message>
    <message>
        <source>it is larger than a back-up can be</source>
        <translation>文件大于备份可能的大小</translation>
    </message>
    <message>
        <source>it does not say what it is</source>
        <translation>文件未注明其类型</translation>
    </message>
    <message>
        <source>it is a support bundle</source>
        <translation>这是支持包</translation>
    </message>
    <message>
        <source>{} is no plain file</source>
        <translation>{} 不是普通文件</translation>
    </message>
    <message>
        <source>{} stands there twice</source>
        <translation>{} 出现两次</translation>
    </message>
    <message>
        <source>{} is no part of a back-up</source>
        <translation>{} 不属于备份</translation>
    </message>
    <message>
        <source>{} is not valid</source>
        <translation>{} 无效</translation>
    </message>
</context>
<context>
    <name>ProfilePage</name>
    <message>
        <source>Corner with its angle: from A to C</source>
        <translation>转角及其角度：从 A 到 C</translation>
    </message>
    <message>
        <source>Braking before, accelerating after</source>
        <translation>之前减速，之后加速</translation>
    </message>
    <message>
        <source>Limit, feed, wheel radius R</source>
        <translation>限值、进给速度、磨轮半径 R</translation>
    </message>
    <message>
        <source>R + depth at the tip</source>
        <translation>R + 尖端磨削深度</translation>
    </message>
    <message>
        <source>Work %1 of %2 · wheel R %3 mm · feed %4 mm/min · acceleration X %5, Y %6 mm/s²</source>
        <translation>加工 %1，共 %2 · 磨轮 R %3 mm · 进给 %4 mm/min · 加速度 X %5，Y %6 mm/s²</translation>
    </message>
    <message>
        <source>Between contours</source>
        <translation>轮廓之间</translation>
    </message>
    <message>
        <source>End of the travel</source>
        <translation>行程终点</translation>
    </message>
    <message>
        <source>Way of the wheel&apos;s centre</source>
        <translation>磨轮中心的行进路线</translation>
    </message>
    <message>
        <source>In a corner, from A to C</source>
        <translation>转角内，从 A 到 C</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>玻璃</translation>
    </message>
</context>
<context>
    <name>Quantities</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 分 %2 秒</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 小时 %2 分</translation>
    </message>
</context>
<context>
    <name>Recipe</name>
    <message>
        <source>Wheel radius</source>
        <translation>磨轮半径</translation>
    </message>
    <message>
        <source>Thickness of the wheel</source>
        <translation>磨轮厚度</translation>
    </message>
    <message>
        <source>Fine adjustment of the grinding height</source>
        <translation>磨削高度微调</translation>
    </message>
    <message>
        <source>Normal grinding depth</source>
        <translation>法向磨削深度</translation>
    </message>
    <message>
        <source>Thickness of the glass</source>
        <translation>玻璃厚度</translation>
    </message>
    <message>
        <source>Underside of the glass above the table</source>
        <translation>玻璃下表面距工作台高度</translation>
    </message>
    <message>
        <source>Wheel&apos;s lower face above the glass when traversing</source>
        <translation>空移时磨轮下端面距玻璃高度</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>进给速度</translation>
    </message>
    <message>
        <source>Acceleration of the X axis</source>
        <translation>X 轴加速度</translation>
    </message>
    <message>
        <source>Acceleration of the Y axis</source>
        <translation>Y 轴加速度</translation>
    </message>
    <message>
        <source>Acceleration of the Z axis</source>
        <translation>Z 轴加速度</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>主轴转速</translation>
    </message>
    <message>
        <source>Transition speed at sharp corners</source>
        <translation>尖角过渡速度</translation>
    </message>
    <message>
        <source>Size correction (positive leaves the pane larger)</source>
        <translation>尺寸修正（正值使玻璃偏大）</translation>
    </message>
    <message>
        <source>Radius of the lead-in and lead-out</source>
        <translation>切入切出半径</translation>
    </message>
    <message>
        <source>Overlap past the start</source>
        <translation>越过起点的重叠长度</translation>
    </message>
    <message>
        <source>Rotation of the pattern</source>
        <translation>图样旋转角度</translation>
    </message>
    <message>
        <source>Gaps up to this are closed</source>
        <translation>自动闭合的最大间隙</translation>
    </message>
    <message>
        <source>Tolerance of fitting chopped curves</source>
        <translation>碎线段拟合公差</translation>
    </message>
    <message>
        <source>Accelerations bind</source>
        <translation>加速度限制方式</translation>
    </message>
    <message>
        <source>each axis</source>
        <translation>各轴单独</translation>
    </message>
    <message>
        <source>X and Y together</source>
        <translation>X、Y 合成</translation>
    </message>
    <message>
        <source>Direction round the pane</source>
        <translation>绕玻璃磨削方向</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>顺时针</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>逆时针</translation>
    </message>
    <message>
        <source>Mirror the pattern</source>
        <translation>图样镜像</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>left to right (X)</source>
        <translation>左右（X）</translation>
    </message>
    <message>
        <source>top to bottom (Y)</source>
        <translation>上下（Y）</translation>
    </message>
    <message>
        <source>Unit of the drawing</source>
        <translation>图纸单位</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>英尺</translation>
    </message>
</context>
<context>
    <name>Services</name>
    <message>
        <source>Spindle: %1
Coolant: %2
Vacuum: %3</source>
        <translation>主轴：%1
冷却液：%2
真空：%3</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>at speed</source>
        <translation>已达转速</translation>
    </message>
    <message>
        <source>comes up to speed</source>
        <translation>升速中</translation>
    </message>
    <message>
        <source>flows</source>
        <translation>流动正常</translation>
    </message>
    <message>
        <source>holds the glass</source>
        <translation>已吸住玻璃</translation>
    </message>
</context>
<context>
    <name>SimulatedFault</name>
    <message>
        <source>Coolant fails</source>
        <translation>冷却液故障</translation>
    </message>
    <message>
        <source>Spindle fails</source>
        <translation>主轴故障</translation>
    </message>
    <message>
        <source>Vacuum fails</source>
        <translation>真空故障</translation>
    </message>
    <message>
        <source>Drive of X fails</source>
        <translation>X 轴驱动器故障</translation>
    </message>
    <message>
        <source>X is stuck</source>
        <translation>X 轴卡住</translation>
    </message>
    <message>
        <source>Emergency stop trips</source>
        <translation>急停触发</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>Reading the drawing…</source>
        <translation>正在读取图纸…</translation>
    </message>
    <message>
        <source>Joining and fitting…</source>
        <translation>正在连接和拟合…</translation>
    </message>
    <message>
        <source>Laying the wheel path…</source>
        <translation>正在生成磨轮路径…</translation>
    </message>
    <message>
        <source>Planning the speeds…</source>
        <translation>正在规划速度…</translation>
    </message>
    <message>
        <source>Computing the profile…</source>
        <translation>正在计算速度曲线…</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <extracomment>What is under way, its number, and how many there are.</extracomment>
        <translation>%1（%2/%3）</translation>
    </message>
</context>
<context>
    <name>State</name>
    <message>
        <source>Drives off</source>
        <translation>驱动关闭</translation>
    </message>
    <message>
        <source>Not homed</source>
        <translation>未回零</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>回零中</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>启动中</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>正在保持</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>进给保持</translation>
    </message>
    <message>
        <source>Stepping</source>
        <translation>单步中</translation>
    </message>
    <message>
        <source>Jogging</source>
        <translation>点动中</translation>
    </message>
    <message>
        <source>Positioning</source>
        <translation>定位中</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>停止中</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
</context>
<context>
    <name>Wheel</name>
    <message>
        <source>%1, corner %2</source>
        <translation>%1，转角 %2</translation>
    </message>
    <message>
        <source>%1 s of %2</source>
        <translation>%1 秒 / %2</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message>
        <source>%1 mm to the corner</source>
        <translation>距转角 %1 mm</translation>
    </message>
    <message>
        <source>Planned: X %1  Y %2  Z %3 mm</source>
        <translation>计划：X %1  Y %2  Z %3 mm</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmBanner</name>
    <message>
        <source>Acknowledge</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>No job is loaded</source>
        <translation>未加载任务</translation>
    </message>
    <message>
        <source>%1 of %2 panes good</source>
        <translation>合格 %1 片，共 %2 片</translation>
    </message>
    <message>
        <source>Simulated axes</source>
        <translation>仿真轴</translation>
    </message>
    <message>
        <source>LinuxCNC: no axes</source>
        <translation>LinuxCNC：无轴</translation>
    </message>
    <message>
        <source>Axes through LinuxCNC</source>
        <translation>通过 LinuxCNC 的轴</translation>
    </message>
    <message>
        <source> (+%1 on the page Alarms)</source>
        <translation>（“报警”页另有 %1 条）</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmHistory</name>
    <message>
        <source>Reading the alarm log…</source>
        <translation>正在读取报警日志…</translation>
    </message>
    <message>
        <source>Alarms: %1</source>
        <translation>报警：%1</translation>
    </message>
    <message>
        <source>Damaged lines of the alarm log, which cannot be read: %1</source>
        <translation>报警日志中无法读取的损坏行：%1</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmModel</name>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Code, axis, value</source>
        <translation>代码、轴、数值</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>发生了什么</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmPanel</name>
    <message>
        <source>Acknowledge</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Tap an alarm to read its cause and what to do.</source>
        <translation>点按一条报警可查看其原因和处理方法。</translation>
    </message>
    <message>
        <source>No alarm is active.</source>
        <translation>当前没有报警。</translation>
    </message>
    <message>
        <source>There has been no alarm yet.</source>
        <translation>尚未发生过报警。</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmTexts</name>
    <message>
        <source>active</source>
        <translation>有效</translation>
    </message>
    <message>
        <source>acknowledged</source>
        <translation>已确认</translation>
    </message>
    <message>
        <source>not
acknowledged</source>
        <translation>未
确认</translation>
    </message>
    <message>
        <source>Cause: %1</source>
        <translation>原因：%1</translation>
    </message>
    <message>
        <source>What to do: %1</source>
        <translation>处理：%1</translation>
    </message>
    <message>
        <source>Record of the run: %1</source>
        <translation>运行记录：%1</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmsPage</name>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>输入和输出</translation>
    </message>
    <message>
        <source>Counters and back-up</source>
        <translation>计数器和备份</translation>
    </message>
</context>
<context>
    <name>arris::ui::BackUpPanel</name>
    <message>
        <source>In the machine&apos;s life</source>
        <translation>机床累计</translation>
    </message>
    <message>
        <source>So far</source>
        <translation>至今</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Keep as it is</source>
        <translation>保持原样</translation>
    </message>
    <message>
        <source>Reading or writing</source>
        <translation>正在读取或写入</translation>
    </message>
    <message>
        <source>Settings, machine, recipes and counters</source>
        <translation>设置、机床、配方和计数器</translation>
    </message>
    <message>
        <source>Back up…</source>
        <translation>备份…</translation>
    </message>
    <message>
        <source>Saves all of them in one file.</source>
        <translation>全部保存到一个文件中。</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translation>恢复…</translation>
    </message>
    <message>
        <source>Brings them back from such a file: while nothing moves and no job is loaded.</source>
        <translation>从此类文件中恢复：须在没有任何运动且未加载任务时进行。</translation>
    </message>
    <message>
        <source>Support bundle…</source>
        <translation>技术支持包…</translation>
    </message>
    <message>
        <source>Saves them with the alarm log, the last runs and versions, for whoever helps.</source>
        <translation>连同报警日志、最近的运行记录和版本信息一起保存，供技术支持人员使用。</translation>
    </message>
    <message>
        <source>Reading or writing…</source>
        <translation>正在读取或写入…</translation>
    </message>
    <message>
        <source>Archives (*.tar.gz);;All files (*)</source>
        <translation>归档文件 (*.tar.gz);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Back up</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>Support bundle</source>
        <translation>支持包</translation>
    </message>
    <message>
        <source>Restore a back-up</source>
        <translation>恢复备份</translation>
    </message>
</context>
<context>
    <name>arris::ui::BackUps</name>
    <message>
        <source>Saved: %1. It has what help needs; nothing is sent to anybody.</source>
        <translation>已保存：%1。其中包含技术支持所需的内容；不会发送给任何人。</translation>
    </message>
    <message>
        <source>There is nothing to back up yet: no settings, machine, recipes or counters have been kept so far.</source>
        <translation>尚无可备份的内容：至今未保存任何设置、机床、配方或计数器。</translation>
    </message>
    <message>
        <source>Saved: %1. Files in it: %2.</source>
        <translation>已保存：%1。其中的文件：%2。</translation>
    </message>
    <message>
        <source>Restore the back-up of %1? Its files (%2) replace settings, machine, recipes and counters of the same names. What is there now is kept as a back-up.</source>
        <translation>恢复 %1 的备份？其中的文件（%2）将替换同名的设置、机床、配方和计数器。现有内容将保留为一份备份。</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>未作任何更改。</translation>
    </message>
    <message>
        <source>What was there before is in %1.</source>
        <translation>之前的内容保存在 %1 中。</translation>
    </message>
    <message>
        <source>Restored. Close Arris and start it again: then it takes effect.</source>
        <translation>已恢复。请关闭 Arris 并重新启动，之后生效。</translation>
    </message>
</context>
<context>
    <name>arris::ui::BusyRow</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>arris::ui::ByHandPanel</name>
    <message>
        <source>Origin of the table (G54)</source>
        <translation>工作台原点（G54）</translation>
    </message>
    <message>
        <source>Zero of the table in X</source>
        <translation>工作台 X 零点</translation>
    </message>
    <message>
        <source>Zero of the table in Y</source>
        <translation>工作台 Y 零点</translation>
    </message>
    <message>
        <source>Zero of the table in Z</source>
        <translation>工作台 Z 零点</translation>
    </message>
    <message>
        <source>Set here</source>
        <translation>设在此处</translation>
    </message>
    <message>
        <source>The table&apos;s zero of %1 is where the wheel is</source>
        <translation>将磨轮当前位置设为工作台 %1 零点</translation>
    </message>
    <message>
        <source>Set the typed origin</source>
        <translation>设定输入的原点</translation>
    </message>
    <message>
        <source>Support of the glass</source>
        <translation>玻璃支撑</translation>
    </message>
    <message>
        <source>Spindle and coolant by hand</source>
        <translation>手动控制主轴和冷却液</translation>
    </message>
    <message>
        <source>Spindle speed by hand</source>
        <translation>手动主轴转速</translation>
    </message>
    <message>
        <source>Spindle on</source>
        <translation>主轴开</translation>
    </message>
    <message>
        <source>Spindle off</source>
        <translation>主轴关</translation>
    </message>
    <message>
        <source>Coolant on</source>
        <translation>冷却液开</translation>
    </message>
    <message>
        <source>Coolant off</source>
        <translation>冷却液关</translation>
    </message>
    <message>
        <source>A pane was broken off: its origin stays until it has been ground or given up.</source>
        <translation>有一片玻璃加工中断：在将其磨完或放弃之前，其原点保持不变。</translation>
    </message>
    <message>
        <source>Where the zero of the table lies in machine coordinates. Whether the job still fits into the travel is checked at once.</source>
        <translation>工作台零点在机床坐标中的位置。任务是否仍在行程之内会立即检查。</translation>
    </message>
    <message>
        <source>The origin can be set when the axes are homed and at rest.</source>
        <translation>各轴已回零且静止时才可设定原点。</translation>
    </message>
    <message>
        <source>No job is loaded: its recipe says how high the glass lies.</source>
        <translation>未加载任务：玻璃的高度由任务的配方给出。</translation>
    </message>
    <message>
        <source>Of the job that is loaded: the underside of the glass lies %1 mm above the table, the glass is %2 mm thick, and the middle of the wheel grinds at Z %3 mm.</source>
        <translation>已加载的任务：玻璃下表面高出工作台 %1 mm，玻璃厚 %2 mm，磨轮中部在 Z %3 mm 处磨削。</translation>
    </message>
</context>
<context>
    <name>arris::ui::ControlStrip</name>
    <message>
        <source>FEED
HOLD</source>
        <translation>进给
保持</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Lock
30 s</source>
        <translation>锁屏
30 s</translation>
    </message>
    <message>
        <source>Lock the screen for 30 s to wipe it</source>
        <translation>锁定屏幕 30 s 以便擦拭</translation>
    </message>
</context>
<context>
    <name>arris::ui::CornerCard</name>
    <message>
        <source>Tap a corner to see its figures.</source>
        <translation>点按一个转角可查看其数据。</translation>
    </message>
    <message>
        <source>No corners.</source>
        <translation>没有转角。</translation>
    </message>
    <message>
        <source>Corner %1: %2, %3</source>
        <translation>转角 %1：%2，%3</translation>
    </message>
    <message>
        <source>Speed v&lt;sub&gt;trans&lt;/sub&gt;</source>
        <translation>速度 v&lt;sub&gt;trans&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>%1 mm/s, %2</source>
        <translation>%1 mm/s，%2</translation>
    </message>
    <message>
        <source>Blending a, t&lt;sub&gt;m&lt;/sub&gt;</source>
        <translation>过渡 a、t&lt;sub&gt;m&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>%1 mm/s²; %2 s</source>
        <translation>%1 mm/s²；%2 s</translation>
    </message>
    <message>
        <source>Widest, leg ℓ</source>
        <translation>最大距离、边长 ℓ</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>脱离</translation>
    </message>
    <message>
        <source>yes: lifts %1; needs %2 mm</source>
        <translation>可以：抬离 %1；需要 %2 mm</translation>
    </message>
    <message>
        <source>no: lifts %1; needs %2 mm</source>
        <translation>不足：抬离 %1；需要 %2 mm</translation>
    </message>
    <message>
        <source>Radius of the roll</source>
        <translation>绕角半径</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>计划</translation>
    </message>
    <message>
        <source>%1 mm/s; %2 s</source>
        <translation>%1 mm/s；%2 s</translation>
    </message>
    <message>
        <source>Slowing L&lt;sub&gt;d&lt;/sub&gt;, L&lt;sub&gt;a&lt;/sub&gt;</source>
        <translation>加减速 L&lt;sub&gt;d&lt;/sub&gt;、L&lt;sub&gt;a&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>%1; %2 mm</source>
        <translation>%1；%2 mm</translation>
    </message>
    <message>
        <source>(contour %1)</source>
        <translation>（轮廓 %1）</translation>
    </message>
    <message>
        <source>Glass left</source>
        <translation>残留玻璃</translation>
    </message>
    <message>
        <source>%1 mm before the corner</source>
        <translation>角前 %1 mm</translation>
    </message>
    <message>
        <source>Not ground</source>
        <translation>未磨</translation>
    </message>
    <message>
        <source>%1 mm of its edges</source>
        <translation>边上 %1 mm</translation>
    </message>
    <message>
        <source>Distance between wheel and corner over time</source>
        <translation>磨轮与转角的距离随时间的变化</translation>
    </message>
</context>
<context>
    <name>arris::ui::CornerModel</name>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Angle
β</source>
        <translation>角度
β</translation>
    </message>
    <message>
        <source>Treatment</source>
        <translation>处理方式</translation>
    </message>
    <message>
        <source>Speed
mm/s</source>
        <translation>速度
mm/s</translation>
    </message>
    <message>
        <source>Accel.
mm/s²</source>
        <translation>加速度
mm/s²</translation>
    </message>
    <message>
        <source>Time
s</source>
        <translation>时间
s</translation>
    </message>
    <message>
        <source>Widest
mm</source>
        <translation>最大距离
mm</translation>
    </message>
    <message>
        <source>Relief
mm</source>
        <translation>脱离
mm</translation>
    </message>
</context>
<context>
    <name>arris::ui::Diagnosis</name>
    <message>
        <source>Drive ready</source>
        <translation>驱动器就绪</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>pressed</source>
        <translation>已按下</translation>
    </message>
    <message>
        <source>released</source>
        <translation>已松开</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 小时</translation>
    </message>
    <message>
        <source>hit</source>
        <translation>已触发</translation>
    </message>
    <message>
        <source>free</source>
        <translation>未触发</translation>
    </message>
    <message>
        <source>on</source>
        <translation>接通</translation>
    </message>
    <message>
        <source>Limit switch, low end</source>
        <translation>限位开关，低端</translation>
    </message>
    <message>
        <source>Limit switch, high end</source>
        <translation>限位开关，高端</translation>
    </message>
    <message>
        <source>Reference switch</source>
        <translation>回零开关</translation>
    </message>
    <message>
        <source>Drive enable (output)</source>
        <translation>驱动使能（输出）</translation>
    </message>
    <message>
        <source>Drive fault</source>
        <translation>驱动器故障</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>编码器</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>无信号</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Following error, mm</source>
        <translation>跟随误差，mm</translation>
    </message>
    <message>
        <source>At worst since the start, mm</source>
        <translation>启动以来最大值，mm</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>tripped</source>
        <translation>已触发</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>主轴</translation>
    </message>
    <message>
        <source>at speed</source>
        <translation>已达转速</translation>
    </message>
    <message>
        <source>not at speed</source>
        <translation>未达转速</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>冷却液</translation>
    </message>
    <message>
        <source>flows</source>
        <translation>流动正常</translation>
    </message>
    <message>
        <source>does not flow</source>
        <translation>无流动</translation>
    </message>
    <message>
        <source>Vacuum</source>
        <translation>真空</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>已吸住</translation>
    </message>
    <message>
        <source>does not hold</source>
        <translation>未吸住</translation>
    </message>
    <message>
        <source>Button cycle start</source>
        <translation>循环启动按钮</translation>
    </message>
    <message>
        <source>Button feed hold</source>
        <translation>进给保持按钮</translation>
    </message>
    <message>
        <source>Button stop</source>
        <translation>停止按钮</translation>
    </message>
    <message>
        <source>Button jog enable</source>
        <translation>点动使能按钮</translation>
    </message>
    <message>
        <source>Override selector</source>
        <translation>倍率选择开关</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 r/min</source>
        <translation>%1 r/min</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>心跳</translation>
    </message>
    <message>
        <source>beats</source>
        <translation>正常跳动</translation>
    </message>
    <message>
        <source>stands still</source>
        <translation>停止不动</translation>
    </message>
    <message>
        <source>Least lead, periods</source>
        <translation>最小提前量，周期</translation>
    </message>
    <message>
        <source>Late wake-ups</source>
        <translation>延迟唤醒次数</translation>
    </message>
    <message>
        <source>Latest wake-up, ms</source>
        <translation>最大唤醒延迟，ms</translation>
    </message>
    <message>
        <source>Buffered pairs</source>
        <translation>缓冲的数据对</translation>
    </message>
    <message>
        <source>Lost reports</source>
        <translation>丢失的反馈</translation>
    </message>
    <message>
        <source>Refused commands</source>
        <translation>被拒绝的命令</translation>
    </message>
    <message>
        <source>Drives on</source>
        <translation>驱动接通时间</translation>
    </message>
    <message>
        <source>Spindle on</source>
        <translation>主轴运转时间</translation>
    </message>
    <message>
        <source>Grinding</source>
        <translation>磨削</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>已磨长度</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Panes ground</source>
        <translation>已磨片数</translation>
    </message>
    <message>
        <source>Counted since</source>
        <translation>统计起始时间</translation>
    </message>
</context>
<context>
    <name>arris::ui::DiagnosisPanel</name>
    <message>
        <source>Axes</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>输出</translation>
    </message>
</context>
<context>
    <name>arris::ui::DrawingView</name>
    <message>
        <source>Drawing</source>
        <translation>图形</translation>
    </message>
    <message>
        <source>Open a pattern (DXF), or drop one here.</source>
        <translation>打开图样（DXF），或将文件拖放到此处。</translation>
    </message>
</context>
<context>
    <name>arris::ui::FindingsPanel</name>
    <message>
        <source>Corners</source>
        <translation>转角</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>问题（%1）</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>详情</translation>
    </message>
</context>
<context>
    <name>arris::ui::HelpPage</name>
    <message>
        <source>Manual</source>
        <translation>手册</translation>
    </message>
    <message>
        <source>en</source>
        <comment>language of the manual</comment>
        <extracomment>The language that the manual is read in: that of this translation, &quot;de&quot; or &quot;zh_CN&quot;.</extracomment>
        <translation>zh_CN</translation>
    </message>
</context>
<context>
    <name>arris::ui::JobPage</name>
    <message>
        <source>Drawing</source>
        <translation>图形</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>同时显示</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>正在规划</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适合窗口</translation>
    </message>
    <message>
        <source>Fit into the view</source>
        <translation>适合窗口</translation>
    </message>
    <message>
        <source>Reading and planning…</source>
        <translation>正在读取和规划…</translation>
    </message>
    <message>
        <source>No pattern is open.</source>
        <translation>没有打开的图样。</translation>
    </message>
    <message>
        <source>Cannot be ground: see the problems.</source>
        <translation>无法磨削：请查看“问题”。</translation>
    </message>
    <message>
        <source>Cancelled. Open a pattern.</source>
        <translation>已取消。请打开图样。</translation>
    </message>
    <message>
        <source>Cancelled: no profile.
To plan: change a value.</source>
        <translation>已取消：没有曲线。
更改一个数值即可规划。</translation>
    </message>
    <message>
        <source>Cancelled: values before.
To plan: change a value.</source>
        <translation>已取消：仍为之前的数值。
更改一个数值即可规划。</translation>
    </message>
    <message>
        <source>Grinding: %1
Program: %2</source>
        <translation>磨削：%1
程序：%2</translation>
    </message>
</context>
<context>
    <name>arris::ui::Keypad</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
</context>
<context>
    <name>arris::ui::MainWindow</name>
    <message>
        <source>%1 – Arris</source>
        <translation>%1 – Arris</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>任务</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>The machine is moving</source>
        <translation>机床正在运动</translation>
    </message>
    <message>
        <source>Stop the machine and close Arris? The job can be resumed later.</source>
        <translation>停止机床并关闭 Arris？任务可稍后继续。</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>停止并关闭</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation>继续运行</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
</context>
<context>
    <name>arris::ui::NumberEdit</name>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>%1: type a number %2.</source>
        <translation>%1：请输入 %2 的数。</translation>
    </message>
    <message>
        <source>%1: “%2” can mean %3 or %4; type it that way.</source>
        <translation>%1：“%2”可以是 %3 或 %4；请按其中一种输入。</translation>
    </message>
    <message>
        <source>%1 is not a number; type one %2.</source>
        <translation>%1：输入的不是数；请输入 %2 的数。</translation>
    </message>
    <message>
        <source>%1 is out of range; it must be %2.</source>
        <translation>%1超出范围；应为 %2。</translation>
    </message>
</context>
<context>
    <name>arris::ui::OrderPanel</name>
    <message>
        <source>Good</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>The pane is good</source>
        <translation>该片玻璃合格</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>The pane is a reject</source>
        <translation>该片玻璃不合格</translation>
    </message>
    <message>
        <source>Fewer panes</source>
        <translation>减少片数</translation>
    </message>
    <message>
        <source>More panes</source>
        <translation>增加片数</translation>
    </message>
    <message>
        <source>Grind the next pane smaller</source>
        <translation>下一片磨小</translation>
    </message>
    <message>
        <source>Leave the next pane larger</source>
        <translation>下一片留大</translation>
    </message>
    <message>
        <source>Size correction, next pane</source>
        <translation>尺寸修正，下一片</translation>
    </message>
    <message>
        <source>More leaves the pane larger.</source>
        <translation>数值越大，玻璃尺寸越大。</translation>
    </message>
    <message>
        <source>Pane %1 of %2: %3 good, %4 rejected</source>
        <translation>第 %1 片，共 %2 片：合格 %3，不合格 %4</translation>
    </message>
    <message>
        <source>Load for the next pane</source>
        <translation>为下一片加载</translation>
    </message>
    <message>
        <source>Load job</source>
        <translation>加载任务</translation>
    </message>
    <message>
        <source>The pane is interrupted: resume it, or stop it, before a job is loaded.</source>
        <translation>该片玻璃已中断：请先继续或停止，再加载任务。</translation>
    </message>
    <message>
        <source>Values have changed; this pane stays as it was loaded. After it load the job for the next pane.</source>
        <translation>数值已更改；当前这片仍按加载时的数值加工。完成后请为下一片加载任务。</translation>
    </message>
    <message>
        <source>Pane %1 has ended: good or reject? Changed since it was loaded: load the job again for the next pane.</source>
        <translation>第 %1 片已结束：合格还是不合格？加载后已更改：加工下一片前请重新加载任务。</translation>
    </message>
    <message>
        <source>Changed since it was loaded: load the job again for the next pane.</source>
        <translation>加载后已更改：加工下一片前请重新加载任务。</translation>
    </message>
    <message>
        <source>Pane %1 has ended: good or reject? It counts as good when the next one begins.</source>
        <translation>第 %1 片已结束：合格还是不合格？下一片开始时按合格计。</translation>
    </message>
    <message>
        <source>The order is complete.</source>
        <translation>订单已完成。</translation>
    </message>
    <message>
        <source>The page Job shows other values than it has: nothing can be loaded before they are planned.</source>
        <translation>“任务”页显示的内容与其当前数值不符：重新规划之前无法加载。</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>片数</translation>
    </message>
    <message>
        <source>What is planned on the page Job cannot be ground: nothing can be loaded before that is put right.</source>
        <translation>“任务”页上的计划无法磨削：改正之前不能加载。</translation>
    </message>
    <message>
        <source>Pane %1 was broken off. After the alarm CYCLE START goes on with it; “Reject”, or loading a job, gives it up.</source>
        <translation>第 %1 片已中断。报警确认后，按循环启动继续磨削这一片；按“不合格”或加载任务则放弃它。</translation>
    </message>
    <message>
        <source>Pane %1 was broken off: CYCLE START goes on with it. “Reject”, or loading a job, gives it up.</source>
        <translation>第 %1 片已中断：按循环启动继续磨削这一片；按“不合格”或加载任务则放弃它。</translation>
    </message>
</context>
<context>
    <name>arris::ui::PathPlot</name>
    <message>
        <source>X, mm</source>
        <translation>X，mm</translation>
    </message>
    <message>
        <source>Y, mm</source>
        <translation>Y，mm</translation>
    </message>
</context>
<context>
    <name>arris::ui::PatternDialog</name>
    <message>
        <source>Open pattern</source>
        <translation>打开图样</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>图样</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上一级</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Here are neither drawings (*.dxf) nor folders.</source>
        <translation>此处既没有图纸（*.dxf），也没有文件夹。</translation>
    </message>
    <message>
        <source>No pattern was opened yet, or none is still there.</source>
        <translation>尚未打开过图样，或打开过的图样均已不存在。</translation>
    </message>
</context>
<context>
    <name>arris::ui::PatternPanel</name>
    <message>
        <source>Reading</source>
        <translation>正在读取</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>There is nothing to show.</source>
        <translation>没有可显示的内容。</translation>
    </message>
    <message>
        <source>Tap a pattern to see it.</source>
        <translation>点按一个图样即可查看。</translation>
    </message>
    <message>
        <source>Unit of the drawing: %1, assumed</source>
        <translation>图纸单位：%1（假定）</translation>
    </message>
    <message>
        <source>Unit of the drawing: %1</source>
        <translation>图纸单位：%1</translation>
    </message>
</context>
<context>
    <name>arris::ui::PatternView</name>
    <message>
        <source>Drawing</source>
        <translation>图形</translation>
    </message>
</context>
<context>
    <name>arris::ui::ProblemModel</name>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1：%2 %3</translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation>已修复</translation>
    </message>
</context>
<context>
    <name>arris::ui::ProfilePlot</name>
    <message>
        <source>time, s</source>
        <translation>时间（s）</translation>
    </message>
    <message>
        <source>X velocity
mm/s</source>
        <translation>X 速度
mm/s</translation>
    </message>
    <message>
        <source>v X
mm/s</source>
        <translation>v X
mm/s</translation>
    </message>
    <message>
        <source>Y velocity
mm/s</source>
        <translation>Y 速度
mm/s</translation>
    </message>
    <message>
        <source>v Y
mm/s</source>
        <translation>v Y
mm/s</translation>
    </message>
    <message>
        <source>X acceleration
mm/s²</source>
        <translation>X 加速度
mm/s²</translation>
    </message>
    <message>
        <source>a X
mm/s²</source>
        <translation>a X
mm/s²</translation>
    </message>
    <message>
        <source>Y acceleration
mm/s²</source>
        <translation>Y 加速度
mm/s²</translation>
    </message>
    <message>
        <source>a Y
mm/s²</source>
        <translation>a Y
mm/s²</translation>
    </message>
    <message>
        <source>Path speed
mm/s</source>
        <translation>路径速度
mm/s</translation>
    </message>
    <message>
        <source>v
mm/s</source>
        <translation>v
mm/s</translation>
    </message>
    <message>
        <source>Wheel to corner
mm</source>
        <translation>磨轮到转角
mm</translation>
    </message>
    <message>
        <source>L
mm</source>
        <translation>L
mm</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>限值 %1</translation>
    </message>
    <message>
        <source>feed %1</source>
        <translation>进给 %1</translation>
    </message>
    <message>
        <source>X position
mm</source>
        <translation>X 位置
mm</translation>
    </message>
    <message>
        <source>X
mm</source>
        <translation>X
mm</translation>
    </message>
    <message>
        <source>Y position
mm</source>
        <translation>Y 位置
mm</translation>
    </message>
    <message>
        <source>Y
mm</source>
        <translation>Y
mm</translation>
    </message>
    <message>
        <source>travel %1</source>
        <translation>行程 %1</translation>
    </message>
</context>
<context>
    <name>arris::ui::ProfilesPage</name>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Open an exported profile or the record of a run</source>
        <translation>打开导出的速度曲线或运行记录</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>计划</translation>
    </message>
    <message>
        <source>Back to the planned profile alone</source>
        <translation>只显示计划的速度曲线</translation>
    </message>
    <message>
        <source>Over the plan</source>
        <translation>叠加计划</translation>
    </message>
    <message>
        <source>Show the plan under the open file</source>
        <translation>在打开的文件下方显示计划</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>图片…</translation>
    </message>
    <message>
        <source>Save a picture as SVG, PNG or PDF</source>
        <translation>保存为 SVG、PNG 或 PDF 图片</translation>
    </message>
    <message>
        <source>Previous corner</source>
        <translation>上一个角</translation>
    </message>
    <message>
        <source>Next corner</source>
        <translation>下一个角</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>磨削</translation>
    </message>
    <message>
        <source>From the first lead-in to the last lead-out</source>
        <translation>从第一次切入到最后一次切出</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>正在读取</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>计划</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Reading or writing…</source>
        <translation>正在读取或写入…</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>%1, drawn thin over the plan, which is wide and pale</source>
        <translation>%1，细线叠加在计划之上；计划为浅色宽线</translation>
    </message>
    <message>
        <source>Planned: %1</source>
        <translation>计划：%1</translation>
    </message>
    <message>
        <source>Planning…</source>
        <translation>正在规划…</translation>
    </message>
    <message>
        <source>The pattern cannot be ground: there is no planned profile.</source>
        <translation>图样无法磨削：没有计划的速度曲线。</translation>
    </message>
    <message>
        <source>No pattern is open. Profiles and records of runs can be opened all the same.</source>
        <translation>没有打开的图样。仍可打开速度曲线和运行记录。</translation>
    </message>
    <message>
        <source>Open profile or record</source>
        <translation>打开速度曲线或记录</translation>
    </message>
    <message>
        <source>Records and profiles (*.arrisrun *.csv *.CSV);;All files (*)</source>
        <translation>记录和速度曲线 (*.arrisrun *.csv *.CSV);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>Profile…</source>
        <translation>速度曲线…</translation>
    </message>
    <message>
        <source>Save the profile as a table (CSV)</source>
        <translation>将速度曲线保存为表格（CSV）</translation>
    </message>
    <message>
        <source>Job sheet…</source>
        <translation>任务单…</translation>
    </message>
    <message>
        <source>Save drawing, values, corners and times of the job as PDF</source>
        <translation>将任务的图形、数值、转角和时间保存为 PDF</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Velocities, accelerations and distance to the corner over time</source>
        <translation>速度、加速度和到转角的距离随时间的变化</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>X and Y over time</source>
        <translation>X 和 Y 随时间的变化</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>The way of the wheel in the plane</source>
        <translation>磨轮在平面内的路径</translation>
    </message>
    <message>
        <source>From the start of the program to its end; of the path: all of the travel</source>
        <translation>从程序开始到结束；对于路径：整个行程</translation>
    </message>
    <message>
        <source>%1, corner %2</source>
        <translation>%1，转角 %2</translation>
    </message>
    <message>
        <source>Save the profile of the run %1</source>
        <translation>保存运行 %1 的速度曲线</translation>
    </message>
    <message>
        <source>Save the planned profile</source>
        <translation>保存计划的速度曲线</translation>
    </message>
    <message>
        <source>Save job sheet</source>
        <translation>保存任务单</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipeBook</name>
    <message>
        <source>%1, wheel R %2</source>
        <translation>%1，磨轮 R %2</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipeDialog</name>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>配方 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>加载</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>导入…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>No</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>All recipes</source>
        <translation>全部配方</translation>
    </message>
    <message>
        <source>For the glass thickness set now</source>
        <translation>适合当前玻璃厚度</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Save the values in effect as</source>
        <translation>将当前数值保存为</translation>
    </message>
    <message>
        <source>“%1” is in effect.</source>
        <translation>“%1”已生效。</translation>
    </message>
    <message>
        <source>Saved as “%1”.</source>
        <translation>已保存为“%1”。</translation>
    </message>
    <message>
        <source>Replace “%1” by the values in effect?</source>
        <translation>用当前数值替换“%1”？</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>删除“%1”？</translation>
    </message>
    <message>
        <source>“%1” is deleted.</source>
        <translation>“%1”已删除。</translation>
    </message>
    <message>
        <source>Import a recipe</source>
        <translation>导入配方</translation>
    </message>
    <message>
        <source>Imported as “%1”; it is not in effect yet.</source>
        <translation>已导入为“%1”；尚未生效。</translation>
    </message>
    <message>
        <source>Replace “%1” by the file?</source>
        <translation>用该文件替换“%1”？</translation>
    </message>
    <message>
        <source>Export a recipe</source>
        <translation>导出配方</translation>
    </message>
    <message>
        <source>“%1” is written to %2.</source>
        <translation>“%1”已写入 %2。</translation>
    </message>
    <message>
        <source>No recipe has been saved yet.</source>
        <translation>尚未保存任何配方。</translation>
    </message>
    <message>
        <source>No recipe is for this thickness of glass.</source>
        <translation>没有用于此玻璃厚度的配方。</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipeFields</name>
    <message>
        <source>Heights</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>转角</translation>
    </message>
    <message>
        <source>On the table</source>
        <translation>工作台上的位置</translation>
    </message>
    <message>
        <source>Lower left corner of the pane</source>
        <translation>玻璃左下角</translation>
    </message>
    <message>
        <source>Centred on the table</source>
        <translation>在工作台上居中</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>Start near this place</source>
        <translation>起点靠近此处</translation>
    </message>
    <message>
        <source>Left to Arris</source>
        <translation>由 Arris 选择</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>图纸</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>按文件注明</translation>
    </message>
    <message>
        <source>Leave unground what
the wheel cannot reach</source>
        <translation>磨轮磨不到的部分
允许不磨</translation>
    </message>
    <message>
        <source>Only these layers (none chosen: all)</source>
        <translation>仅这些图层（不选则为全部）</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>Rim speed: %1 m/s</source>
        <translation>线速度：%1 m/s</translation>
    </message>
    <message>
        <source>The drawing still shows the last valid values.</source>
        <translation>图形仍按最近的有效值显示。</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipeModel</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Glass
mm</source>
        <translation>玻璃
mm</translation>
    </message>
    <message>
        <source>Wheel
mm</source>
        <translation>磨轮
mm</translation>
    </message>
    <message>
        <source>Depth
mm</source>
        <translation>深度
mm</translation>
    </message>
    <message>
        <source>Feed
mm/min</source>
        <translation>进给
mm/min</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipePanel</name>
    <message>
        <source>No pattern yet</source>
        <translation>尚无图样</translation>
    </message>
    <message>
        <source>Grinding</source>
        <translation>磨削</translation>
    </message>
    <message>
        <source>Pane</source>
        <translation>玻璃</translation>
    </message>
    <message>
        <source>&amp;Pattern…</source>
        <translation>图样(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Recipes…</source>
        <translation>配方(&amp;R)…</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>More values</source>
        <translation>更多数值</translation>
    </message>
    <message>
        <source>Page before</source>
        <translation>上一页</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>下一页</translation>
    </message>
    <message>
        <source>Unnamed recipe</source>
        <translation>未命名配方</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1，已更改</translation>
    </message>
</context>
<context>
    <name>arris::ui::ReliefPlot</name>
    <message>
        <source>time from A, s</source>
        <translation>从 A 起的时间（s）</translation>
    </message>
    <message>
        <source>distance L, mm</source>
        <translation>距离 L，mm</translation>
    </message>
    <message>
        <source>relief
%1 mm</source>
        <translation>脱离
%1 mm</translation>
    </message>
</context>
<context>
    <name>arris::ui::ResumeBar</name>
    <message>
        <source>a power failure, or Arris ended</source>
        <translation>断电或 Arris 退出</translation>
    </message>
    <message>
        <source>Arris ended in a hold</source>
        <translation>Arris 在保持状态下退出</translation>
    </message>
    <message>
        <source>a stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>a fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>the emergency stop</source>
        <translation>急停</translation>
    </message>
    <message>
        <source>its end from the terminal</source>
        <translation>从终端结束程序</translation>
    </message>
    <message>
        <source>Resume the job of %1: %2, pane %3 of %4, interrupted by %5?</source>
        <translation>继续 %1 的任务：%2，第 %3 片，共 %4 片，因%5而中断？</translation>
    </message>
    <message>
        <source>Take it up</source>
        <translation>接续任务</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Understood</source>
        <translation>知道了</translation>
    </message>
    <message>
        <source>Discard it for good</source>
        <translation>永久丢弃</translation>
    </message>
    <message>
        <source>The job that was broken off is being read and planned…</source>
        <translation>正在读取和规划已中断的任务…</translation>
    </message>
    <message>
        <source>Discard the job that was broken off? It cannot be resumed then.</source>
        <translation>丢弃已中断的任务？丢弃后将无法继续。</translation>
    </message>
    <message>
        <source>The job that was broken off cannot be resumed.</source>
        <translation>已中断的任务无法继续。</translation>
    </message>
    <message>
        <source>The job that was broken off is not resumed; what is known of it is kept as %1.</source>
        <translation>已中断的任务未继续；其已知信息保存为 %1。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>arris::ui::RunPage</name>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Feed override</source>
        <translation>进给倍率</translation>
    </message>
    <message>
        <source>Lower feed override</source>
        <translation>降低进给倍率</translation>
    </message>
    <message>
        <source>Higher feed override</source>
        <translation>提高进给倍率</translation>
    </message>
    <message>
        <source>◀ Back</source>
        <translation>◀ 单步后退</translation>
    </message>
    <message>
        <source>RESUME</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Keep it pressed until the ring is full.</source>
        <translation>按住直至圆环填满。</translation>
    </message>
    <message>
        <source>CYCLE START
where it was broken off</source>
        <translation>循环启动
从中断处继续</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>工作台</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>To go</source>
        <translation>剩余</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>To go: to the end of the line or arc that the wheel is on.</source>
        <translation>剩余：到磨轮当前所在直线或圆弧的终点。</translation>
    </message>
    <message>
        <source>%1 of %2 mm/min</source>
        <translation>%1 / %2 mm/min</translation>
    </message>
    <message>
        <source>%1 mm/min</source>
        <translation>%1 mm/min</translation>
    </message>
    <message>
        <source>Open a pattern on the page Job, or drop one here.</source>
        <translation>请在“任务”页打开图样，或将文件拖放到此处。</translation>
    </message>
    <message>
        <source>Forward ▶</source>
        <translation>单步前进 ▶</translation>
    </message>
    <message>
        <source>CYCLE START
keep pressed</source>
        <translation>循环启动
按住</translation>
    </message>
    <message>
        <source>Done: %1 %
To grind: %2 mm
Time left: %3</source>
        <translation>已完成：%1 %
待磨削：%2 mm
剩余时间：%3</translation>
    </message>
</context>
<context>
    <name>arris::ui::SettingsPage</name>
    <message>
        <source>Set this code</source>
        <translation>设定此密码</translation>
    </message>
    <message>
        <source>Take the code away</source>
        <translation>取消密码</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>机床</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>密码</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>That of the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>长度单位</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>外观</translation>
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
        <source>Keypad on the screen</source>
        <translation>屏幕键盘</translation>
    </message>
    <message>
        <source>At a touch</source>
        <translation>触摸时</translation>
    </message>
    <message>
        <source>At a click too</source>
        <translation>点击时也显示</translation>
    </message>
    <message>
        <source>Scale, from the next start</source>
        <translation>缩放，下次启动起生效</translation>
    </message>
    <message>
        <source>What is changed here counts from the next start of Arris.</source>
        <translation>此处的更改从 Arris 下次启动起生效。</translation>
    </message>
    <message>
        <source>A code protects the machine&apos;s values and, in the recipe, the accelerations. The operator&apos;s values stay open.</source>
        <translation>密码保护机床参数，以及配方中的加速度。操作员的数值保持开放。</translation>
    </message>
    <message>
        <source>This is not the code.</source>
        <translation>密码不正确。</translation>
    </message>
    <message>
        <source>A code has %1 to %2 digits.</source>
        <translation>密码为 %1 至 %2 位数字。</translation>
    </message>
    <message>
        <source>No code is set: all values are open.</source>
        <translation>未设密码：所有数值均开放。</translation>
    </message>
    <message>
        <source>All values are open until they are locked or Arris starts again.</source>
        <translation>所有数值均开放，直至锁定或 Arris 重新启动。</translation>
    </message>
    <message>
        <source>Locked: enter the code to change the machine.</source>
        <translation>已锁定：输入密码后方可更改机床参数。</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>LinuxCNC</source>
        <translation>LinuxCNC</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>解锁</translation>
    </message>
    <message>
        <source>Lock the values now</source>
        <translation>立即锁定数值</translation>
    </message>
</context>
<context>
    <name>arris::ui::SetupPage</name>
    <message>
        <source>Drives</source>
        <translation>驱动</translation>
    </message>
    <message>
        <source>Switch drives on</source>
        <translation>接通驱动</translation>
    </message>
    <message>
        <source>Home all axes</source>
        <translation>所有轴回零</translation>
    </message>
    <message>
        <source>Switch drives off</source>
        <translation>关闭驱动</translation>
    </message>
    <message>
        <source>Ways above the glass</source>
        <translation>玻璃上方移动</translation>
    </message>
    <message>
        <source>Trace the outline at height</source>
        <translation>在安全高度沿轮廓空走</translation>
    </message>
    <message>
        <source>Go to the park position</source>
        <translation>移至停放位置</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>快速</translation>
    </message>
    <message>
        <source>Simulated machine</source>
        <translation>仿真机床</translation>
    </message>
    <message>
        <source>Next: switch the drives on.</source>
        <translation>下一步：接通驱动。</translation>
    </message>
    <message>
        <source>Next: home all axes, so that their places are known.</source>
        <translation>下一步：所有轴回零，以确定位置。</translation>
    </message>
    <message>
        <source>Next: load the job on the page Run.</source>
        <translation>下一步：在“运行”页加载任务。</translation>
    </message>
    <message>
        <source>Ready for the cycle start on the page Run.</source>
        <translation>就绪：可在“运行”页按循环启动。</translation>
    </message>
    <message>
        <source>X %1   Y %2   Z %3 mm</source>
        <translation>X %1   Y %2   Z %3 mm</translation>
    </message>
    <message>
        <source>The places are not known yet.</source>
        <translation>位置尚未确定。</translation>
    </message>
    <message>
        <source>Drives and jog</source>
        <translation>驱动与点动</translation>
    </message>
    <message>
        <source>Origin and by hand</source>
        <translation>原点与手动</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>连续</translation>
    </message>
    <message>
        <source>Jog as long as a button is pressed</source>
        <translation>按住按钮期间持续点动</translation>
    </message>
    <message>
        <source>Jog by %1 mm</source>
        <translation>每次点动 %1 mm</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Jog enable on the panel held</source>
        <translation>已按住面板上的点动使能</translation>
    </message>
    <message>
        <source>Press the jog enable on the panel and keep it pressed: without it no axis is jogged.</source>
        <translation>按住面板上的点动使能按钮不放：否则任何轴都不能点动。</translation>
    </message>
    <message>
        <source>An axis moves as long as its button is pressed.</source>
        <translation>按住轴的按钮期间，该轴移动。</translation>
    </message>
    <message>
        <source>Each press moves an axis by %1 mm.</source>
        <translation>每按一次，轴移动 %1 mm。</translation>
    </message>
    <message>
        <source>Nothing can be moved: %1</source>
        <translation>无法移动：%1</translation>
    </message>
    <message>
        <source>Clear all faults</source>
        <translation>清除所有故障</translation>
    </message>
    <message>
        <source>Read the alarm above, remove its cause, acknowledge it.</source>
        <translation>查看上方的报警，排除其原因，然后确认。</translation>
    </message>
    <message>
        <source>Held: go on with RESUME on the page Run, or STOP.</source>
        <translation>进给保持中：请在“运行”页按“继续”，或按停止。</translation>
    </message>
    <message>
        <source>Something moves: until it ends nothing is moved from here.</source>
        <translation>有轴正在运动：结束之前，此处不能操作。</translation>
    </message>
</context>
<context>
    <name>arris::ui::TimeModel</name>
    <message>
        <source>Grinding, lead-in to lead-out</source>
        <translation>磨削（从切入到切出）</translation>
    </message>
    <message>
        <source>Whole program</source>
        <translation>整个程序</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>占比</translation>
    </message>
</context>
<context>
    <name>arris::ui::WheelBar</name>
    <message>
        <source>Wheel back along its path</source>
        <translation>磨轮沿路径后退</translation>
    </message>
    <message>
        <source>Wheel on along its path</source>
        <translation>磨轮沿路径前进</translation>
    </message>
</context>
<context>
    <name>arris::ui::WipeCover</name>
    <message>
        <source>The screen is locked for wiping: %1 s
FEED HOLD and STOP work whenever something moves.</source>
        <translation>屏幕已锁定以便擦拭：%1 秒
只要有轴在运动，进给保持和停止就有效。</translation>
    </message>
</context>
</TS>
