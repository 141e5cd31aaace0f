package robotran.robolang.python

import robotran.robolang.template.fillIn
import robotran.robolang.template.sectionsOf
import robotran.robolang.template.templates

/**
 * A function that a translation contains only if it is used; `src/brick/python` has its Python.
 *
 * @property called its name.
 * @property needs what it uses, which is above it.
 * @property imports what it imports, such as `umath:floor`.
 * @property others what it has in the program besides itself.
 */
internal enum class PythonHelper(
    val called: String,
    val needs: List<PythonHelper> = emptyList(),
    val imports: List<String> = emptyList(),
    private val others: List<String> = emptyList(),
) {
    DIVIDE("divide"),
    REMAINDER("remainder", listOf(DIVIDE)),
    DECIMAL_REMAINDER("decimal_remainder"),
    RANDOM("random", imports = listOf("urandom:randint")),
    COUNT("count"),
    PEN_DOWN("pen_down"),
    PEN_UP("pen_up"),
    SET_POWER("set_power", others = listOf("speed", "turn_rate")),
    SHOW("show"),
    BLINK("blink", imports = listOf("pybricks.parameters:Color", "pybricks.tools:wait")),
    DISTANCE("distance"),
    MY_TURN("my_turn", imports = listOf("pybricks.tools:wait"), others = listOf("acting")),
    WHENEVER("whenever", imports = listOf("pybricks.tools:wait"), others = listOf("acting")),
    ;

    val names: List<String> get() = others + called

    /** Its Python for [robot]; in tasks if [isReacting]. */
    fun textFor(robot: PybricksRobot, isReacting: Boolean): String {
        val text = (if (robot.hub.hasScreen) SECTIONS["$name, screen"] else null) ?: SECTIONS.getValue(name)
        val values = mapOf(
            "ASYNC" to if (isReacting) "async " else "",
            "AWAIT" to if (isReacting) "await " else "",
            "SPEED" to decimalFigure(POWER_TO_SPEED * robot.wheelDiameter),
            "RATE" to decimalFigure(POWER_TO_RATE * robot.wheelDiameter / robot.track),
        )
        return text.fillIn(values)
    }

    private companion object {
        const val POWER_TO_SPEED = PybricksFigures.SPEED_OF_POWER * kotlin.math.PI / PybricksFigures.FULL_TURN
        const val POWER_TO_RATE = PybricksFigures.SPEED_OF_POWER.toDouble()
        val SECTIONS: Map<String, String> by lazy { sectionsOf(templates.getValue("python/helpers.py")) }
    }
}
