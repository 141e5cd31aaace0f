package robotran.robolang.robot

import robotran.brick.kind.BrickKind
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Facing
import robotran.robolang.syntax.LightSensorSetting
import robotran.robolang.syntax.NxtSensor
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.SensorSetting
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allExpressions
import robotran.robolang.words.BrickDialect

/**
 * Which sensor ports a program sets up before its first statement: those whose sensors it uses, and no others.
 * The interpreter and the translation to leJOS both follow it, so that they make the same calls.
 */
internal class SensorPorts(tree: SyntaxTree, kind: BrickKind) {
    private val dialect = BrickDialect.of(kind)
    private val header = tree.robot
    private val setting = header?.lightSensor
    private val settings = header?.let { it.lightSensors.map(::useOf) + it.nxtSensors.map(::useOf) }.orEmpty()
    private val uses = allExpressions(tree).filterIsInstance<Expression.Sense>()
    private val lightUse = uses.filter { it.sense == Sense.Light }.minByOrNull { it.range.line }

    val leftBumperPort = LEFT_BUMPER_PORT

    val rightBumperPort = dialect.rightBumperPort

    /** The port of the light sensor, even if the program does not use it. */
    val lightPort: Int = setting?.port ?: dialect.lightPort

    /** Whether the program uses `light`, so that its port needs power. */
    val usesLight: Boolean get() = lightUse != null

    /** The line of the header's setting of the light sensor; null if there is none. */
    val settingLine: Int? get() = setting?.range?.line

    /** The line that the powering of the light sensor belongs to; 0 if the program does not use `light`. */
    val lightLine: Int get() = if (lightUse == null) 0 else settingLine ?: lightUse.range.line

    /**
     * The bumpers that the program uses, in the order of their ports, which are set to a touch sensor. A bumper that
     * shares its port with a light sensor in use is missing: it is detected from the percentage.
     */
    val bumpers: List<Bumper> = uses
        .mapNotNull { use -> bumperPort(use.sense)?.let { Bumper(it, use.range.line) } }
        .filterNot { usesLight && it.port == lightPort }
        .sortedWith(compareBy({ it.port }, { it.line }))
        .distinctBy { it.port }

    /** A bumper on [port], from 1, that the program uses on [line] first. */
    class Bumper(val port: Int, val line: Int)

    /** The port of the sensor that [sense] reads, from 1; null if it reads none. */
    fun portOf(sense: Sense): Int? = when (sense) {
        Sense.LeftBumper, Sense.RightBumper -> bumperPort(sense)
        Sense.Light -> lightPort
        is Sense.Sensor -> sense.port
        Sense.Distance -> portOf(sense, NxtSensor.SONAR)
        Sense.Colour -> portOf(sense, NxtSensor.COLOUR)
        Sense.Loudness -> portOf(sense, NxtSensor.SOUND)
        is Sense.Button, Sense.Timer, Sense.Battery, is Sense.Turned -> null
    }

    private fun portOf(sense: Sense, sensor: NxtSensor): Int =
        settings.firstOrNull { it.sense == sense }?.port ?: sensor.port

    /**
     * What `sensor 1` and so on read on an NXT: the sensor that the program or its header has on that port, otherwise
     * the one that the robot usually has there.
     */
    fun senseAt(port: Int): Sense {
        val used = uses.map { it.sense }.filter { it !is Sense.Sensor }
        val usual = listOf(Sense.LeftBumper, Sense.RightBumper, Sense.Light, Sense.Distance)
        return used.firstOrNull { portOf(it) == port }
            ?: settingAt(port)
            ?: usual.firstOrNull { portOf(it) == port }
            ?: usual.getOrElse(port - 1) { Sense.LeftBumper }
    }

    /** The sensors of an NXT that the program uses, in the order in which it names them first. */
    val nxtSensors: List<NxtUse> by lazy(LazyThreadSafetyMode.PUBLICATION) {
        uses.mapNotNull { use ->
            val sense = (use.sense as? Sense.Sensor)?.let { senseAt(it.port) } ?: use.sense
            val port = portOf(use.sense)
            port?.let { settingOf(sense, port) ?: NxtUse(sense, port, use.range.line) }
        }.sortedWith(compareBy({ it.line }, { it.port })).distinctBy { it.port }
    }

    /**
     * The sensor on [port], from 1, that [sense] reads, and the line that its set-up belongs to.
     *
     * @property isLampOff whether it is a light sensor whose lamp is off, since it looks ahead.
     * @property isSetting whether [line] is one of the header.
     */
    class NxtUse(
        val sense: Sense,
        val port: Int,
        val line: Int,
        val isLampOff: Boolean = false,
        val isSetting: Boolean = false,
    )

    /** What the header has on [port]; null if nothing. */
    fun settingAt(port: Int): Sense? = settings.firstOrNull { it.port == port }?.sense

    private fun settingOf(sense: Sense, port: Int): NxtUse? =
        settings.firstOrNull { it.sense == sense && it.port == port }

    private fun useOf(setting: LightSensorSetting) = NxtUse(
        Sense.Light,
        setting.port,
        setting.range.line,
        isLampOff = setting.facing == Facing.FORWARD,
        isSetting = true,
    )

    private fun useOf(setting: SensorSetting): NxtUse {
        val sense = when (setting.sensor) {
            NxtSensor.SONAR -> Sense.Distance
            NxtSensor.COLOUR -> Sense.Colour
            NxtSensor.SOUND -> Sense.Loudness
        }
        return NxtUse(sense, setting.port, setting.range.line, isSetting = true)
    }

    private fun bumperPort(sense: Sense): Int? = when (sense) {
        Sense.LeftBumper -> leftBumperPort
        Sense.RightBumper -> rightBumperPort
        else -> null
    }

    private companion object {
        const val LEFT_BUMPER_PORT = 1
    }
}
