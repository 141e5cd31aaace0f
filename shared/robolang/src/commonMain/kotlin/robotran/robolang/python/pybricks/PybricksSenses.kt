package robotran.robolang.python.pybricks

import robotran.hub.model.HubButton
import robotran.hub.model.HubDeviceKind
import robotran.language.source.SourceRange
import robotran.robolang.check.ValueType
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.PythonStrength
import robotran.robolang.python.writer.PythonText
import robotran.robolang.python.writer.primary
import robotran.robolang.robot.HubUses
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.BrickButton
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Facing
import robotran.robolang.syntax.RobotHeader
import robotran.robolang.syntax.Sense
import robotran.robolang.translate.LineMap

/**
 * Writes what a program senses. A word such as `light` reads the first sensor of its kind, or the one on the port that the
 * header names; `sensor 4` the one on that port.
 */
internal class PybricksSenses(
    private val robot: RobotTarget.Hub,
    private val header: RobotHeader?,
    private val hubUses: HubUses,
    private val devices: PybricksDevices,
    private val context: PythonContext,
) {
    private val hub = robot.model
    private val uses = context.uses
    private val notes = context.notes
    private val messages = notes.messages

    /** What writes readings that take time; set before the first one. */
    lateinit var awaiting: PybricksAwaiting

    fun written(sense: Sense, expression: Expression): PythonText = when (sense) {
        Sense.LeftBumper, Sense.RightBumper -> bumper(sense, expression.range)
        Sense.Light -> light(hubUses.portOf(sense), expression.range)
        is Sense.Sensor -> onPort(sense.port, expression)
        is Sense.Button -> button(sense.button, expression.range)
        Sense.Timer -> PythonText("${devices.timer()}.time() / 1000", PythonStrength.PRODUCT)
        Sense.Battery -> PythonText("${devices.hub()}.battery.voltage() / 1000", PythonStrength.PRODUCT)
        Sense.Distance -> distance(hubUses.portOf(sense), expression.range)
        Sense.Loudness -> loudness(hubUses.portOf(sense), expression.range)
        Sense.Colour -> colour(hubUses.portOf(sense), expression.range)
        is Sense.Turned -> primary("${devices.motor(sense.port, isCounted = true)}.angle()")
    }

    /** Whether a reading takes time, so that a task awaits it. */
    fun isAwaited(sense: Sense): Boolean = hubUses.portOf(sense)?.let { isAwaited(robot.sensors.getValue(it)) } ?: false

    private fun isAwaited(kind: HubDeviceKind): Boolean = when (kind) {
        HubDeviceKind.COLOR_SENSOR -> hub.devices.awaitsColor
        HubDeviceKind.ULTRASONIC_SENSOR, HubDeviceKind.FORCE_SENSOR -> true
        else -> false
    }

    private fun nothing(range: SourceRange, message: String): PythonText {
        notes.lost(range, message)
        return primary("0")
    }

    private fun read(device: String, reading: String, sensor: Int): PythonText =
        awaiting.waiting("$device.$reading()", awaiting.isInTask && isAwaited(robot.sensors.getValue(sensor)))

    private fun bumper(sense: Sense, range: SourceRange): PythonText {
        val sensor = hubUses.portOf(sense) ?: return nothing(range, messages.noBumper())
        return touched(sensor)
    }

    private fun touched(sensor: Int): PythonText {
        val reading = if (robot.sensors[sensor] == HubDeviceKind.FORCE_SENSOR) "touched" else "pressed"
        return read(devices.sensor(sensor), reading, sensor)
    }

    private fun light(sensor: Int?, range: SourceRange): PythonText {
        if (sensor == null) return nothing(range, messages.noLightSensor())
        notes.tell(range, messages.otherLight())
        val isAhead = header?.lightSensor?.facing == Facing.FORWARD
        val device = devices.sensor(sensor, header?.lightSensor?.range?.line ?: LineMap.NO_LINE)
        val isDecimal = isAhead || robot.sensors[sensor] == HubDeviceKind.LIGHT_SENSOR
        val value = read(device, if (isAhead) "ambient" else "reflection", sensor)
        return if (isDecimal && !hub.devices.hasWholeLight) primary("round(${value.text})") else value
    }

    private fun distance(sensor: Int?, range: SourceRange): PythonText {
        if (sensor == null) return nothing(range, messages.noSonar())
        val device = devices.sensor(sensor, lineOf(Sense.Distance))
        if (hub.kind.hasLetteredInputs) return awaiting.waiting("${uses.use(PybricksHelper.DISTANCE)}()")
        return PythonText("${read(device, "distance", sensor).text} // 10", PythonStrength.PRODUCT)
    }

    private fun loudness(sensor: Int?, range: SourceRange): PythonText {
        if (sensor == null) return nothing(range, messages.noSoundSensor())
        return read(devices.sensor(sensor, lineOf(Sense.Loudness)), "intensity", sensor)
    }

    private fun colour(sensor: Int?, range: SourceRange): PythonText {
        if (sensor == null ||
            robot.sensors[sensor] != HubDeviceKind.COLOR_SENSOR
        ) {
            return nothing(range, messages.noColourSensor())
        }
        return read(devices.colourSensor(sensor, lineOf(Sense.Colour)), "color", sensor)
    }

    /** The line of the header that says where a sensor is. */
    private fun lineOf(sense: Sense): Int =
        header?.nxtSensors?.firstOrNull { hubUses.isNamed(it.port, sense) }?.range?.line ?: LineMap.NO_LINE

    private fun onPort(port: Int, expression: Expression): PythonText {
        val range = expression.range
        return when (robot.sensors[port]) {
            null, HubDeviceKind.MOTOR -> {
                nothing(range, messages.nothingOnPort("${hub.sensorPorts.getOrNull(port - 1) ?: port}"))
            }

            HubDeviceKind.COLOR_SENSOR, HubDeviceKind.LIGHT_SENSOR -> {
                if (context.expressions.typeOf(expression) ==
                    ValueType.COLOUR
                ) {
                    colour(port, range)
                } else {
                    light(port, range)
                }
            }

            HubDeviceKind.ULTRASONIC_SENSOR -> distance(port, range)
            HubDeviceKind.SOUND_SENSOR -> loudness(port, range)
            HubDeviceKind.FORCE_SENSOR, HubDeviceKind.TOUCH_SENSOR -> primary("int(${touched(port).text})")
        }
    }

    private fun button(button: BrickButton, range: SourceRange): PythonText {
        val name = when (button) {
            BrickButton.LEFT, BrickButton.PRGM -> "LEFT"
            BrickButton.RIGHT, BrickButton.VIEW -> "RIGHT"
            BrickButton.ENTER, BrickButton.RUN -> "CENTER"
            BrickButton.ESCAPE -> return nothing(range, messages.stopButton())
        }
        if (name == "CENTER") freeMiddleButton(range)
        return PythonText(
            "${uses.parameter("Button.$name")} in ${devices.hub()}.buttons.pressed()",
            PythonStrength.COMPARISON,
        )
    }

    private fun freeMiddleButton(range: SourceRange) {
        if (hub.stopButton != HubButton.CENTER) return
        devices.freeMiddleButton()
        notes.tell(range, if (hasArrows) messages.middleButton() else messages.onlyButton())
    }

    private val hasArrows: Boolean get() = HubButton.LEFT in hub.buttons
}
