package robotran.robolang.python.microbit

import robotran.robolang.python.writer.PythonHelper
import robotran.robolang.template.sectionsOf
import robotran.robolang.template.templates

/**
 * A function of a translation for a micro:bit; `src/brick/microbit` has its Python.
 *
 * @property others what it has in the program besides itself.
 */
internal enum class MicrobitHelper(
    override val called: String,
    override val needs: List<MicrobitHelper> = emptyList(),
    override val imports: List<String> = emptyList(),
    private val others: List<String> = emptyList(),
) : PythonHelper {
    BYTE("byte"),
    PULSE("pulse"),
    BRIDGE("bridge"),
    WHEELS("wheels"),
    STOP("stop", listOf(WHEELS)),
    START("start", listOf(WHEELS), listOf("button_a", "display", "sleep", "Image").map { "microbit:$it" }),
    FAIL("fail", listOf(STOP), listOf("microbit:display")),
    SET_POWER("set_power", listOf(WHEELS)),
    SERVO("servo"),
    WRAP("wrap"),
    DIVIDE("divide", listOf(FAIL)),
    REMAINDER("remainder", listOf(DIVIDE)),
    QUOTIENT("quotient"),
    DECIMAL_REMAINDER("decimal_remainder"),
    ROOT("root", listOf(FAIL), listOf("math:sqrt")),
    POWER_OF("power_of", listOf(FAIL)),
    RANDOM("random", imports = listOf("random:randint")),
    ITEM("item", listOf(FAIL)),
    PUT("put", listOf(ITEM)),
    TIMES("times", listOf(FAIL)),
    STEP("step", listOf(FAIL)),
    COUNT("count", listOf(STEP)),
    MILLISECONDS("milliseconds", listOf(FAIL)),
    POWER("power", listOf(FAIL)),
    DISTANCE(
        "distance",
        imports = listOf("machine:time_pulse_us", "microbit:running_time", "utime:sleep_us"),
        others = listOf("heard_at", "heard"),
    ),
    READY("ready", others = listOf("behaviours", "acting")),
    LOOK("look", listOf(READY), listOf("microbit:sleep"), listOf("Over", "driving")),
    TICK("tick", listOf(LOOK)),
    WAIT("wait", listOf(TICK), listOf("microbit:running_time")),
    PAUSE("pause", listOf(LOOK), listOf("microbit:running_time")),
    GO("go", listOf(WHEELS)),
    FORWARD("forward", listOf(GO), others = listOf("CM")),
    BACKWARD("backward", listOf(GO), others = listOf("CM")),
    TURN_LEFT("turn_left", listOf(GO), others = listOf("DEG")),
    TURN_RIGHT("turn_right", listOf(GO), others = listOf("DEG")),
    PEN_DOWN("pen_down", listOf(SERVO)),
    PEN_UP("pen_up", listOf(SERVO)),
    PLAY("play", imports = listOf("music")),
    SHOW("show", imports = listOf("microbit:display")),
    ;

    override val names: List<String> get() = others + called

    /** Its Python, with placeholders; a [variant] of it if there is one. */
    fun template(variant: String?): String = variant?.let { SECTIONS["$name, $it"] } ?: SECTIONS.getValue(name)

    private companion object {
        val SECTIONS: Map<String, String> by lazy { sectionsOf(templates.getValue("microbit/helpers.py")) }
    }
}
