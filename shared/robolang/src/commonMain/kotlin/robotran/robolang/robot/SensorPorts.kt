package robotran.robolang.robot

import robotran.brick.kind.BrickKind
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Facing
import robotran.robolang.syntax.NxtSensor
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allExpressions

/**
 * Which sensor ports a program sets up before its first statement: those whose sensors it uses, and no others.
 * The interpreter and the translation to leJOS both follow it, so that they make the same calls.
 */
internal class SensorPorts(tree: SyntaxTree, private val kind: BrickKind) {
    private val header = tree.robot
    private val setting = header?.lightSensor
    private val uses = allExpressions(tree).filterIsInstance<Expression.Sense>()
    private val lightUse = uses.filter { it.sense == Sense.Light }.minByOrNull { it.range.line }

    val leftBumperPort = LEFT_BUMPER_PORT

    val rightBumperPort = when (kind) {
        BrickKind.RCX -> RCX_RIGHT_BUMPER_PORT
        BrickKind.NXT -> NXT_RIGHT_BUMPER_PORT
    }

    /** The port of the light sensor, even if the program does not use it. */
    val lightPort: Int = setting?.port ?: when (kind) {
        BrickKind.RCX -> RCX_LIGHT_PORT
        BrickKind.NXT -> NXT_LIGHT_PORT
    }

    /** Whether the light sensor's lamp is off, since it looks ahead. */
    val isLampOff: Boolean get() = setting?.facing == Facing.FORWARD

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
        Sense.Distance -> portOf(NxtSensor.SONAR)
        Sense.Colour -> portOf(NxtSensor.COLOUR)
        Sense.Loudness -> portOf(NxtSensor.SOUND)
        is Sense.Button, Sense.Timer, Sense.Battery, is Sense.Turned -> null
    }

    private fun portOf(sensor: NxtSensor): Int = header?.setting(sensor)?.port ?: sensor.port

    /**
     * What `sensor 1` and so on read on an NXT: the sensor that the program or its header has on that port, otherwise
     * the one that the robot usually has there.
     */
    fun senseAt(port: Int): Sense {
        val used = uses.map { it.sense }.filter { it !is Sense.Sensor }
        val settings = listOfNotNull(
            Sense.Light.takeIf { setting != null },
            Sense.Distance.takeIf { header?.setting(NxtSensor.SONAR) != null },
            Sense.Colour.takeIf { header?.setting(NxtSensor.COLOUR) != null },
            Sense.Loudness.takeIf { header?.setting(NxtSensor.SOUND) != null },
        )
        val usual = listOf(Sense.LeftBumper, Sense.RightBumper, Sense.Light, Sense.Distance)
        return (used + settings + usual).firstOrNull { portOf(it) == port } ?: usual[port - 1]
    }

    /** The sensors of an NXT that the program uses, in the order in which it names them first. */
    val nxtSensors: List<NxtUse> by lazy(LazyThreadSafetyMode.PUBLICATION) {
        uses.mapNotNull { use ->
            val sense = (use.sense as? Sense.Sensor)?.let { senseAt(it.port) } ?: use.sense
            portOf(sense)?.let { NxtUse(sense, (use.sense as? Sense.Sensor)?.port ?: it, lineOf(sense, use)) }
        }.sortedWith(compareBy({ it.line }, { it.port })).distinctBy { it.port }
    }

    /** The sensor on [port], from 1, that [sense] reads, and the line that its set-up belongs to. */
    class NxtUse(val sense: Sense, val port: Int, val line: Int)

    private fun lineOf(sense: Sense, use: Expression.Sense): Int = settingLineOf(sense) ?: use.range.line

    /** The line of the header's setting of the sensor that [sense] reads; null if there is none. */
    fun settingLineOf(sense: Sense): Int? = when (sense) {
        Sense.Light -> setting?.range
        Sense.Distance -> header?.setting(NxtSensor.SONAR)?.range
        Sense.Colour -> header?.setting(NxtSensor.COLOUR)?.range
        Sense.Loudness -> header?.setting(NxtSensor.SOUND)?.range
        else -> null
    }?.line

    private fun bumperPort(sense: Sense): Int? = when (sense) {
        Sense.LeftBumper -> leftBumperPort
        Sense.RightBumper -> rightBumperPort
        else -> null
    }

    private companion object {
        const val LEFT_BUMPER_PORT = 1
        const val RCX_RIGHT_BUMPER_PORT = 3
        const val NXT_RIGHT_BUMPER_PORT = 2
        const val RCX_LIGHT_PORT = 2
        const val NXT_LIGHT_PORT = 3
    }
}
