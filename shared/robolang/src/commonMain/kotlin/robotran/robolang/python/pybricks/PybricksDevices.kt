package robotran.robolang.python.pybricks

import robotran.brick.controls.MotorPort
import robotran.hub.model.HubButton
import robotran.hub.model.HubDeviceKind
import robotran.robolang.python.writer.PythonUses
import robotran.robolang.python.writer.PythonWriter
import robotran.robolang.python.writer.decimalFigure
import robotran.robolang.robot.HubFigures
import robotran.robolang.robot.HubUses
import robotran.robolang.robot.RobotTarget
import robotran.robolang.translate.LineMap

/** The devices of the robot that a program uses, each with its name in the Python. */
internal class PybricksDevices(
    private val robot: RobotTarget.Hub,
    private val uses: PythonUses,
    private val usesColours: Boolean,
) {
    private val hub = robot.model
    private val motors = mutableSetOf<MotorPort>()
    private val counted = mutableSetOf<MotorPort>()
    private val sensors = LinkedHashMap<Int, Int>()
    private val withColours = LinkedHashSet<Int>()
    private var hasHub = false
    private var hasBase = false
    private var hasTimer = false
    private var hasPen = false
    private var freesMiddleButton = false

    /** What is used so far, for [takeBack]. */
    fun copy(): PybricksDevices = PybricksDevices(robot, uses, usesColours).also { it.takeBack(this) }

    /** Only what [earlier] has is used: what was written since is left out. */
    fun takeBack(earlier: PybricksDevices) {
        motors.replaceBy(earlier.motors)
        counted.replaceBy(earlier.counted)
        withColours.replaceBy(earlier.withColours)
        sensors.clear()
        sensors += earlier.sensors
        hasHub = earlier.hasHub
        hasBase = earlier.hasBase
        hasTimer = earlier.hasTimer
        hasPen = earlier.hasPen
        freesMiddleButton = earlier.freesMiddleButton
    }

    private fun <T> MutableSet<T>.replaceBy(others: Set<T>) {
        clear()
        this += others
    }

    /** The names of those that are used. */
    val names: Set<String>
        get() = motors.map(::nameOf).toSet() + sensors.keys.map(::nameOfSensor) +
            listOfNotNull(HUB.takeIf { hasHub }, BASE.takeIf { hasBase }, TIMER.takeIf { hasTimer })

    fun hub(): String = HUB.also { hasHub = true }

    fun timer(): String = TIMER.also { hasTimer = true }

    /** The driving base, with both motors of the wheels. */
    fun base(): String = BASE.also {
        hasBase = true
        motor(robot.left)
        motor(robot.right)
    }

    /** The motor on [port]; if it [isCounted], its angle begins at 0. */
    fun motor(port: MotorPort, isCounted: Boolean = false): String {
        motors += port
        if (isCounted) counted += port
        return nameOf(port)
    }

    /** The motor of the pen, which begins up. */
    fun pen(port: MotorPort) {
        hasPen = true
        motor(port, isCounted = true)
    }

    /** The sensor on the port with this number; [line] is the one of the header that names it. */
    fun sensor(sensor: Int, line: Int = LineMap.NO_LINE): String {
        if (sensors[sensor] ?: LineMap.NO_LINE == LineMap.NO_LINE) sensors[sensor] = line
        return nameOfSensor(sensor)
    }

    /** A colour sensor that tells Robolang's colours apart. */
    fun colourSensor(sensor: Int, line: Int): String {
        withColours += sensor
        return sensor(sensor, line)
    }

    /** A program that asks for the button in the middle must not be stopped by it. */
    fun freeMiddleButton() {
        freesMiddleButton = true
    }

    /** Writes all, those first that others need. */
    fun write(writer: PythonWriter) {
        if (hasHub || freesMiddleButton) writer.line("$HUB = ${uses.import("pybricks.hubs", hub.className)}()")
        order().forEach { writer.line("${nameOf(it)} = ${motorOf(it)}") }
        if (hasBase) writer.line(baseLine())
        for ((sensor, line) in sensors.entries.sortedBy { it.key }) writer.line(lineOf(sensor), line)
        if (hasTimer) writer.line("$TIMER = ${uses.tool("StopWatch")}()")
        writeSettings(writer)
    }

    private fun order(): List<MotorPort> =
        listOfNotNull(robot.left, robot.right, robot.pen).filter { it in motors }.let { usual ->
            usual + motors.sorted().filter { it !in usual }
        }

    private fun writeSettings(writer: PythonWriter) {
        if (freesMiddleButton) writer.line("$HUB.system.set_stop_button(${otherButton()})")
        // Motors with letters begin with the angle of their mark.
        if (hub.kind.hasLetteredInputs) {
            counted.sorted().forEach {
                writer.line("${nameOf(it)}.reset_angle(0)", note = noteOn(it))
            }
        }
        if (!hub.devices.choosesColors) return
        for (sensor in withColours.sorted()) {
            writer.line("${nameOfSensor(sensor)}.detectable_colors(")
            writer.enter()
            writer.line("(${HubFigures.COLOURS.joinToString { uses.parameter("Color.$it") }})")
            writer.leave()
            writer.line(")")
        }
    }

    private fun noteOn(port: MotorPort): String? = "The pen is up at the start.".takeIf { port == robot.pen && hasPen }

    private fun otherButton(): String =
        if (HubButton.BLUETOOTH in hub.buttons) uses.parameter("Button.BLUETOOTH") else "None"

    private fun motorOf(port: MotorPort): String {
        val direction = "Direction.COUNTERCLOCKWISE".takeIf { robot.isCounterclockwise(port) }?.let(uses::parameter)
        val arguments = listOfNotNull(uses.parameter("Port.$port"), direction)
        return "${uses.import(hub.devices.module, "Motor")}(${arguments.joinToString()})"
    }

    private fun baseLine(): String {
        val kind = uses.import("pybricks.robotics", "DriveBase")
        val motors = "${nameOf(robot.left)}, ${nameOf(robot.right)}"
        val figures = "wheel_diameter=${decimalFigure(robot.wheelDiameter)}, axle_track=${decimalFigure(robot.track)}"
        return "$BASE = $kind($motors, $figures)"
    }

    private fun lineOf(sensor: Int): String {
        val port = uses.parameter("Port.${hub.sensorPorts[sensor - 1]}")
        val kind = robot.sensors.getValue(sensor)
        return "${nameOfSensor(sensor)} = ${uses.import(hub.devices.module, kind.className)}($port)"
    }

    private fun nameOf(port: MotorPort): String = when (port) {
        robot.left -> "left_motor"
        robot.right -> "right_motor"
        robot.pen -> "pen_motor"
        else -> "motor_${letterOf(port)}"
    }

    private fun nameOfSensor(port: Int): String {
        val kind = robot.sensors.getValue(port)
        val place = robot.sensors.filterValues { it in HubUses.likeOf(kind) }.keys.sorted().indexOf(port)
        val wanted = when (kind) {
            HubDeviceKind.FORCE_SENSOR, HubDeviceKind.TOUCH_SENSOR -> {
                return listOf("left_bumper", "right_bumper").getOrElse(place) { "bumper_${place + 1}" }
            }

            HubDeviceKind.COLOR_SENSOR -> if (usesColours) "color_sensor" else "light_sensor"
            HubDeviceKind.LIGHT_SENSOR -> "light_sensor"
            HubDeviceKind.ULTRASONIC_SENSOR -> "sonar"
            HubDeviceKind.SOUND_SENSOR -> "sound_sensor"
            HubDeviceKind.MOTOR -> error("A motor is no sensor.")
        }
        return if (place > 0) "${wanted}_${place + 1}" else wanted
    }

    companion object {
        private const val HUB = "hub"
        private const val BASE = "robot"
        private const val TIMER = "timer"
    }
}
