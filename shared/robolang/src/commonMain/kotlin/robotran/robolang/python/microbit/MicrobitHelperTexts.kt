package robotran.robolang.python.microbit

import robotran.brick.kind.WheelTrim
import robotran.microbit.buggy.I2cWheels
import robotran.microbit.model.MicrobitButton
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.robot.MicrobitUses
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.allExpressions
import robotran.robolang.template.fillIn

/** The Python of the functions of a translation for this robot. */
internal class MicrobitHelperTexts(
    private val robot: RobotTarget.Microbit,
    private val context: PythonContext,
    private val state: MicrobitState,
    private val wheels: MicrobitWheels,
    private val watched: WatchedVariables,
) {
    private val uses = context.uses
    private val messages = context.notes.messages
    private val isReacting = context.isReacting

    private val usesButtonA = allExpressions(context.tree)
        .any { (it as? Expression.Sense)?.sense?.let(MicrobitUses::buttonOf) == MicrobitButton.A }

    /** Marks what the functions that are used import. */
    fun useImports() {
        start()
        frames()
        if (MicrobitHelper.SERVO in uses) robot.buggy.pen?.let(wheels::linesOf)
        if (MicrobitHelper.DISTANCE in uses) sonarPins()
    }

    /** The lines that make the buggy ready. */
    private fun start(): List<String> {
        val pen = if (MicrobitHelper.SERVO in uses) robot.buggy.pen?.start.orEmpty() else emptyList()
        return (robot.buggy.wheels.start + pen).map(wheels::lineOf) + "wheels(0, 0)"
    }

    private fun frames(): List<String> = wheels.linesOf(robot.buggy.wheels)

    private fun sonarPins(): Pair<String, String> {
        val pins = checkNotNull(robot.buggy.sonar) { "Only a buggy with a distance sensor hears." }
        return wheels.pin(pins.trigger) to wheels.pin(pins.echo)
    }

    fun textOf(helper: MicrobitHelper): String {
        val values = valuesOf(helper)
        // A placeholder in a line of its own with nothing to stand there leaves no line.
        return helper.template(variantOf(helper)).lines().filter { line ->
            val name = WHOLE_LINE.matchEntire(line)?.groupValues?.get(1)
            name == null || values.getValue(name).isNotEmpty()
        }.joinToString("\n").fillIn(values).trimEnd()
    }

    private fun variantOf(helper: MicrobitHelper): String? = when (helper) {
        MicrobitHelper.START -> "I2C".takeIf { robot.buggy.wheels is I2cWheels }
        MicrobitHelper.WHEELS -> "powers".takeIf { state.remembersWheels }
        MicrobitHelper.GO -> "behaviours".takeIf { isReacting }
        else -> null
    }

    private fun valuesOf(helper: MicrobitHelper): Map<String, String> = when (helper) {
        MicrobitHelper.FAIL -> mapOf("LINE" to messages.lineWord())

        MicrobitHelper.STOP -> mapOf("QUIET" to if (state.makesSounds) "\n    music.stop()" else "")

        MicrobitHelper.START -> mapOf(
            "BEGIN" to indented(start(), if (robot.buggy.wheels is I2cWheels) 2 else 1),
            "BUGGY" to messages.isBuggyOn(),
            "RELEASE" to if (usesButtonA) "\n    while button_a.is_pressed():\n        sleep(10)" else "",
        )

        MicrobitHelper.WHEELS -> mapOf(
            "FRAMES" to indented(frames(), 1),
            "LEFT" to power("left", robot.trim.left),
            "RIGHT" to power("right", robot.trim.right),
        )

        MicrobitHelper.SERVO -> mapOf("SERVO" to indented(robot.buggy.pen?.let(wheels::linesOf).orEmpty(), 1))

        MicrobitHelper.READY -> mapOf(
            "GUARD" to if (watched.callRoutines) GUARD else "",
            "UNGUARD" to if (watched.callRoutines) "\n    acting = was" else "",
        )

        MicrobitHelper.LOOK -> mapOf(
            "DRIVING" to if (state.drives) ", driving" else "",
            "CUT" to if (state.drives) CUT else "",
        )

        MicrobitHelper.GO -> mapOf("BACK" to if (state.goesBack) BACK else "")

        MicrobitHelper.FORWARD, MicrobitHelper.BACKWARD, MicrobitHelper.TURN_LEFT, MicrobitHelper.TURN_RIGHT -> mapOf(
            "AHEAD" to if (robot.isReversed) "-1" else "1",
            "BEHIND" to if (robot.isReversed) "1" else "-1",
        )

        MicrobitHelper.PEN_DOWN, MicrobitHelper.PEN_UP -> mapOf(
            "SLEEP" to if (isReacting) "pause" else "sleep",
            "LOOK" to if (isReacting) "\n    look()" else "",
        )

        MicrobitHelper.PLAY -> mapOf("PIN" to state.pin, "WAIT" to if (isReacting) "wait" else "sleep")

        MicrobitHelper.DISTANCE -> sonarPins().let { (trigger, echo) ->
            mapOf(
                "TRIGGER" to trigger,
                "ECHO" to echo,
                "LISTEN" to if (trigger == echo) "\n        $echo.read_digital()" else "",
            )
        }

        else -> emptyMap()
    }

    /** The percent of the power of a wheel. */
    private fun power(side: String, factor: Double): String {
        val percent = "POWERS[${side}_power]"
        if (robot.trim == WheelTrim.NONE || factor == 1.0) return percent
        return "int($percent * TRIM_${side.uppercase()} + 0.5)"
    }

    private fun indented(lines: List<String>, depth: Int): String =
        lines.joinToString("\n") { "    ".repeat(depth) + it }

    private companion object {
        val WHOLE_LINE = Regex("@([A-Z_]+)@")
        const val BACK = "    if time < 0:\n        left, right, time = -left, -right, -time"
        const val CUT = "    if driving:\n        driving = False\n        wheels(0, 0)"
        const val GUARD = "\n    # Nothing acts while it asks.\n    global acting\n    was = acting\n" +
            "    acting = len(behaviours)"
    }
}
