package robotran.robolang.python.pybricks

import robotran.robolang.python.writer.PythonHelper
import robotran.robolang.python.writer.decimalFigure
import robotran.robolang.robot.HubFigures
import robotran.robolang.robot.RobotTarget
import robotran.robolang.robot.fastestAhead
import robotran.robolang.robot.fastestTurn
import robotran.robolang.robot.wheelSpeed
import robotran.robolang.template.fillIn
import robotran.robolang.template.sectionsOf
import robotran.robolang.template.templates

/**
 * A function of a translation for a hub; `src/brick/python` has its Python.
 *
 * @property others what it has in the program besides itself.
 */
internal enum class PybricksHelper(
    override val called: String,
    override val needs: List<PybricksHelper> = emptyList(),
    override val imports: List<String> = emptyList(),
    private val others: List<String> = emptyList(),
) : PythonHelper {
    DIVIDE("divide"),
    REMAINDER("remainder", listOf(DIVIDE)),
    DECIMAL_REMAINDER("decimal_remainder"),
    RANDOM("random", imports = listOf("urandom:randint")),
    COUNT("count"),
    PEN_DOWN("pen_down"),
    PEN_UP("pen_up"),
    SET_POWER("set_power", others = listOf("speed", "turn_rate")),
    RUN_ON("run_on"),
    SHOW("show"),
    BLINK("blink", imports = listOf("pybricks.parameters:Color", "pybricks.tools:wait")),
    DISTANCE("distance"),
    MY_TURN("my_turn", imports = listOf("pybricks.tools:wait"), others = listOf("acting")),
    WHENEVER("whenever", imports = listOf("pybricks.tools:wait"), others = listOf("acting")),
    ;

    override val names: List<String> get() = others + called

    /** Its Python for [robot]; in tasks if [isReacting]. */
    fun textFor(robot: RobotTarget.Hub, isReacting: Boolean, directions: PybricksDirections): String {
        val text = (if (robot.model.hasScreen) SECTIONS["$name, screen"] else null) ?: SECTIONS.getValue(name)
        val values = mapOf(
            "ASYNC" to if (isReacting) "async " else "",
            "AWAIT" to if (isReacting) "await " else "",
            "SPEED" to within(robot, robot.wheelSpeed(STEP), robot.fastestAhead),
            "RATE" to within(robot, STEP * robot.wheelDiameter / robot.track, robot.fastestTurn),
            "DRIVE_ON" to driveOn(directions),
        )
        return text.fillIn(values).trimEnd()
    }

    /** A speed for a power, [step] for each, and what the motors can do at most. */
    private fun within(robot: RobotTarget.Hub, step: Double, most: Int): String {
        val rounded = "round(${decimalFigure(step)} * power)"
        val isFastEnough = robot.model.motor.highestSpeed >= HubFigures.speedOf(HubFigures.HIGHEST_POWER)
        return if (isFastEnough) rounded else "min($rounded, $most)"
    }

    /** How the robot goes on with a new power. */
    private fun driveOn(directions: PybricksDirections): String {
        val only = directions.onlyOfBase
        val (condition, speeds) = when {
            !directions.driveOn -> return ""

            only == null ->
                "(${PybricksDirections.AHEAD} or ${PybricksDirections.TURN}) and " to
                    "${PybricksDirections.AHEAD} * speed, ${PybricksDirections.TURN} * turn_rate"

            else -> "" to "${times(only.first, "speed")}, ${times(only.second, "turn_rate")}"
        }
        return "    if ${condition}not robot.done():\n        robot.drive($speeds)"
    }

    private fun times(way: Int, speed: String): String = if (way == 0) {
        "0"
    } else if (way < 0) {
        "-$speed"
    } else {
        speed
    }

    private companion object {
        const val STEP = HubFigures.SPEED_OF_POWER.toDouble()
        val SECTIONS: Map<String, String> by lazy { sectionsOf(templates.getValue("python/helpers.py")) }
    }
}
