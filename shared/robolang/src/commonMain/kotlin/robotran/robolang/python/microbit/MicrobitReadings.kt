package robotran.robolang.python.microbit

import robotran.language.source.SourceRange
import robotran.microbit.buggy.AnalogLine
import robotran.microbit.buggy.I2cLine
import robotran.microbit.buggy.LineSensor
import robotran.microbit.buggy.MicrobitSensor
import robotran.microbit.buggy.PinLine
import robotran.microbit.model.MicrobitButton
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.PythonStrength
import robotran.robolang.python.writer.PythonText
import robotran.robolang.python.writer.primary
import robotran.robolang.robot.MicrobitFigures
import robotran.robolang.robot.MicrobitUses
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Sense

/** Writes what a program senses with a buggy, and functions for its line sensors. */
internal class MicrobitReadings(
    private val robot: RobotTarget.Microbit,
    private val context: PythonContext,
    private val state: MicrobitState,
    private val wheels: MicrobitWheels,
) {
    private val microbitUses = MicrobitUses(context.tree, robot)
    private val uses = context.uses
    private val notes = context.notes
    private val messages = notes.messages
    private val lines = mutableSetOf<Int>()

    /** The names of the functions for line sensors. */
    val names: Set<String> get() = lines.map(::nameOf).toSet()

    fun read(expression: Expression.Sense): PythonText = when (val sense = expression.sense) {
        Sense.LeftBumper, Sense.RightBumper -> {
            notes.tell(expression.range, messages.buttonsAreBumpers())
            button(checkNotNull(MicrobitUses.buttonOf(sense)))
        }

        is Sense.Button -> button(MicrobitUses.buttonOf(sense.button))

        Sense.Light -> if (microbitUses.isLightAhead) {
            level("display", "read_light_level")
        } else {
            sensor(sense, expression.range) { messages.noLineSensor() }
        }

        is Sense.Sensor -> sensor(sense, expression.range) { messages.nothingOnBuggy("${sense.port}") }

        Sense.Distance -> sensor(sense, expression.range) { messages.noSonarOnBuggy() }

        Sense.Timer -> {
            uses.import("microbit", "running_time")
            PythonText("(running_time() - ${state.timer()}) / 1000", PythonStrength.PRODUCT)
        }

        Sense.Loudness -> level("microphone", "sound_level")

        Sense.Battery, Sense.Colour, is Sense.Turned -> nothing(expression.range, messages.noWheelDegrees())
    }

    private fun nothing(range: SourceRange, message: String): PythonText {
        notes.lost(range, message)
        return primary("0")
    }

    private fun button(button: MicrobitButton): PythonText {
        uses.import("microbit", button.python.substringBefore('.'))
        return primary(button.python)
    }

    /** What [part] of the board measures, of 255, in percent. */
    private fun level(part: String, reading: String): PythonText {
        val call = "${uses.import("microbit", part)}.$reading()"
        return PythonText("$call * ${MicrobitFigures.BRIGHT} // ${MicrobitFigures.FULL_LEVEL}", PythonStrength.PRODUCT)
    }

    private fun sensor(sense: Sense, range: SourceRange, missing: () -> String): PythonText =
        when (val sensor = microbitUses.sensorOf(sense)) {
            null -> nothing(range, missing())

            MicrobitSensor.Sonar -> primary("${uses.use(MicrobitHelper.DISTANCE)}()")

            is MicrobitSensor.Line -> {
                if (!robot.buggy.lines[sensor.line].isGrey) notes.tell(range, messages.onlyLightOrDark())
                lines += sensor.line
                primary("${nameOf(sensor.line)}()")
            }
        }

    private fun nameOf(line: Int): String {
        val light = (microbitUses.sensorOf(Sense.Light) as? MicrobitSensor.Line)?.line
        if (line == light && !microbitUses.isLightAhead) return "light"
        val port = robot.sensors.entries.firstOrNull { it.value == MicrobitSensor.Line(line) }?.key
        return "sensor_${port ?: (line + 1)}"
    }

    /** The functions for the line sensors that are used. */
    fun functions(): List<List<String>> = lines.sorted().map { line ->
        val comment = if (robot.buggy.lines[line].isGrey) "# 0 is dark, 100 is light." else "# Dark is 0, light is 100."
        listOf("def ${nameOf(line)}():", "    $comment") + linesOf(robot.buggy.lines[line]).map { "    $it" }
    }

    private fun linesOf(sensor: LineSensor): List<String> = when (sensor) {
        is PinLine -> {
            val bit = "100 * ${wheels.pin(sensor.pin)}.read_digital()"
            listOf("return " + if (sensor.darkIs == 0) bit else "100 - $bit")
        }

        is AnalogLine -> {
            val level = "${wheels.pin(sensor.pin)}.read_analog() * 100 // 1023"
            listOf("return " + if (sensor.isDarkHigh) "100 - $level" else level)
        }

        is I2cLine -> {
            val i2c = uses.import("microbit", "i2c")
            val address = MicrobitWheels.hex(sensor.address)
            val ask = sensor.ask.joinToString(transform = MicrobitWheels::number)
            val values = if (sensor.darkIs == 1) "0 if bits" to "else 100" else "100 if bits" to "else 0"
            listOf(
                "$i2c.write($address, bytes([$ask]))",
                "bits = $i2c.read($address, 1)[0]",
                "return ${values.first} >> ${sensor.bit} & 1 ${values.second}",
            )
        }
    }

    fun checkpoint(): () -> Unit {
        val before = lines.toSet()
        return { lines.retainAll(before) }
    }
}
