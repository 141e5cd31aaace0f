package robotran.robolang.python

import robotran.language.source.SourceRange
import robotran.robolang.check.ValueType
import robotran.robolang.robot.SensorPorts
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
    private val robot: PybricksRobot,
    private val header: RobotHeader?,
    private val ports: SensorPorts,
    private val devices: PybricksDevices,
    private val uses: PythonUses,
    private val notes: PythonNotes,
) {
    private val hub = robot.hub
    private val messages = notes.messages

    /** What writes them; set before the first one. */
    lateinit var expressions: PythonExpressions

    fun written(sense: Sense, expression: Expression): PythonText = when (sense) {
        Sense.LeftBumper, Sense.RightBumper -> bumper(sense, expression.range)
        Sense.Light -> light(sensorFor(sense), expression.range)
        is Sense.Sensor -> onPort(sense.port, expression)
        is Sense.Button -> button(sense.button, expression.range)
        Sense.Timer -> PythonText("${devices.timer()}.time() / 1000", PythonStrength.PRODUCT)
        Sense.Battery -> PythonText("${devices.hub()}.battery.voltage() / 1000", PythonStrength.PRODUCT)
        Sense.Distance -> distance(sensorFor(sense), expression.range)
        Sense.Loudness -> loudness(sensorFor(sense), expression.range)
        Sense.Colour -> colour(sensorFor(sense), expression.range)
        is Sense.Turned -> primary("${devices.motor(sense.port.name.single(), isCounted = true)}.angle()")
    }

    /** Whether a reading takes time, so that a task awaits it. */
    fun isAwaited(sense: Sense): Boolean {
        val sensor = if (sense is Sense.Sensor) at(sense.port) else sensorFor(sense)
        return sensor != null && sensor.kind.isAwaitedOn(hub)
    }

    private fun at(port: Int): PybricksSensor? = robot.sensors.firstOrNull { it.port == port }

    /** The sensor that a word reads; null if it reads none or the robot has none. */
    private fun sensorFor(sense: Sense): PybricksSensor? {
        val kinds = KINDS[sense] ?: return null
        val all = robot.sensors.filter { it.kind in kinds }.sortedBy { it.port }
        if (sense == Sense.RightBumper) return all.getOrNull(1)
        val named = header?.let { ports.portOf(sense) }
        return all.firstOrNull { it.port == named && ports.settingAt(it.port) == sense } ?: all.firstOrNull()
    }

    private fun nothing(range: SourceRange, message: String): PythonText {
        notes.lost(range, message)
        return primary("0")
    }

    private fun read(device: String, reading: String, kind: PybricksSensorKind): PythonText =
        expressions.waiting("$device.$reading()", expressions.isInTask && kind.isAwaitedOn(hub))

    private fun bumper(sense: Sense, range: SourceRange): PythonText {
        val sensor = sensorFor(sense) ?: return nothing(range, messages.noBumper())
        return touched(sensor)
    }

    private fun touched(sensor: PybricksSensor): PythonText {
        val reading = if (sensor.kind == PybricksSensorKind.FORCE) "touched" else "pressed"
        return read(devices.sensor(sensor), reading, sensor.kind)
    }

    private fun light(sensor: PybricksSensor?, range: SourceRange): PythonText {
        if (sensor == null) return nothing(range, messages.noLightSensor())
        notes.tell(range, messages.otherLight())
        val isAhead = header?.lightSensor?.facing == Facing.FORWARD
        val device = devices.sensor(sensor, header?.lightSensor?.range?.line ?: LineMap.NO_LINE)
        val isDecimal = isAhead || sensor.kind == PybricksSensorKind.LIGHT
        val value = read(device, if (isAhead) "ambient" else "reflection", sensor.kind)
        return if (isDecimal && hub != PybricksHub.EV3) primary("round(${value.text})") else value
    }

    private fun distance(sensor: PybricksSensor?, range: SourceRange): PythonText {
        if (sensor == null) return nothing(range, messages.noSonar())
        val device = devices.sensor(sensor, lineOf(Sense.Distance))
        if (hub.hasLetters) return expressions.waiting("${uses.use(PythonHelper.DISTANCE)}()")
        return PythonText("${read(device, "distance", sensor.kind).text} // 10", PythonStrength.PRODUCT)
    }

    private fun loudness(sensor: PybricksSensor?, range: SourceRange): PythonText {
        if (sensor == null) return nothing(range, messages.noSoundSensor())
        return read(devices.sensor(sensor, lineOf(Sense.Loudness)), "intensity", sensor.kind)
    }

    private fun colour(sensor: PybricksSensor?, range: SourceRange): PythonText {
        if (sensor == null || sensor.kind != PybricksSensorKind.COLOR) return nothing(range, messages.noColourSensor())
        return read(devices.colourSensor(sensor, lineOf(Sense.Colour)), "color", sensor.kind)
    }

    /** The line of the header that says where a sensor is. */
    private fun lineOf(sense: Sense): Int =
        header?.nxtSensors?.firstOrNull { ports.settingAt(it.port) == sense }?.range?.line ?: LineMap.NO_LINE

    private fun onPort(port: Int, expression: Expression): PythonText {
        val sensor = at(port) ?: return nothing(expression.range, messages.nothingOnPort(hub.sensorPort(port)))
        val range = expression.range
        return when (sensor.kind) {
            PybricksSensorKind.COLOR, PybricksSensorKind.LIGHT -> {
                if (expressions.typeOf(expression) == ValueType.COLOUR) colour(sensor, range) else light(sensor, range)
            }

            PybricksSensorKind.ULTRASONIC -> distance(sensor, range)
            PybricksSensorKind.SOUND -> loudness(sensor, range)
            PybricksSensorKind.FORCE, PybricksSensorKind.TOUCH -> primary("int(${touched(sensor).text})")
        }
    }

    private fun button(button: BrickButton, range: SourceRange): PythonText {
        val name = when (button) {
            BrickButton.LEFT, BrickButton.PRGM -> "LEFT"
            BrickButton.RIGHT, BrickButton.VIEW -> "RIGHT"
            BrickButton.ENTER, BrickButton.RUN -> "CENTER"
            BrickButton.ESCAPE -> return nothing(range, messages.stopButton())
        }
        if (name == "CENTER") {
            freeMiddleButton(range)
        } else if (!hub.hasArrows) {
            return nothing(range, messages.noButton())
        }
        return PythonText(
            "${uses.parameter("Button.$name")} in ${devices.hub()}.buttons.pressed()",
            PythonStrength.COMPARISON,
        )
    }

    private fun freeMiddleButton(range: SourceRange) {
        if (hub.stopButton == null) return
        devices.freeMiddleButton()
        notes.tell(range, if (hub.hasArrows) messages.middleButton() else messages.onlyButton())
    }

    private companion object {
        val KINDS = mapOf(
            Sense.LeftBumper to PybricksDevices.BUMPERS,
            Sense.RightBumper to PybricksDevices.BUMPERS,
            Sense.Light to PybricksDevices.EYES,
            Sense.Colour to setOf(PybricksSensorKind.COLOR),
            Sense.Distance to setOf(PybricksSensorKind.ULTRASONIC),
            Sense.Loudness to setOf(PybricksSensorKind.SOUND),
        )
    }
}
