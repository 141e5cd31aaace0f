package robotran.robolang.run

import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allExpressions

/**
 * Which sensor ports a program sets up before its first statement: those whose sensors it uses, and no others.
 * The interpreter and the translation to leJOS both follow it, so that they make the same ROM calls.
 */
internal class SensorPorts(tree: SyntaxTree) {
    private val setting = tree.robot?.lightSensor
    private val uses = allExpressions(tree).filterIsInstance<Expression.Sense>()
    private val lightUse = uses.filter { it.sense == Sense.Light }.minByOrNull { it.range.line }

    /** The port of the light sensor, 1..3, even if the program does not use it. */
    val lightPort: Int = setting?.port ?: RobotConstants.LIGHT_PORT

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

    /** A bumper on [port], 1..3, that the program uses on [line] first. */
    class Bumper(val port: Int, val line: Int)

    private fun bumperPort(sense: Sense): Int? = when (sense) {
        Sense.LeftBumper -> RobotConstants.LEFT_BUMPER_PORT
        Sense.RightBumper -> RobotConstants.RIGHT_BUMPER_PORT
        Sense.Light, is Sense.Sensor, is Sense.Button, Sense.Timer, Sense.Battery -> null
    }
}
