package robotran.robolang.python

import robotran.robolang.translate.LineMap

/** The devices of the robot that a program uses, each with its name in the Python. */
internal class PybricksDevices(
    private val robot: PybricksRobot,
    private val uses: PythonUses,
    private val usesColours: Boolean,
) {
    private val hub = robot.hub
    private val motors = mutableSetOf<Char>()
    private val counted = mutableSetOf<Char>()
    private val sensors = LinkedHashMap<PybricksSensor, Int>()
    private val withColours = LinkedHashSet<PybricksSensor>()
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
        get() = motors.map(::nameOf).toSet() + sensors.keys.map(::nameOf) +
            listOfNotNull(HUB.takeIf { hasHub }, BASE.takeIf { hasBase }, TIMER.takeIf { hasTimer })

    fun hub(): String = HUB.also { hasHub = true }

    fun timer(): String = TIMER.also { hasTimer = true }

    /** The driving base, with both motors of the wheels. */
    fun base(): String = BASE.also {
        hasBase = true
        motor(robot.left.port)
        motor(robot.right.port)
    }

    /** The motor on [port]; if it [isCounted], its angle begins at 0. */
    fun motor(port: Char, isCounted: Boolean = false): String {
        motors += port
        if (isCounted) counted += port
        return nameOf(port)
    }

    /** The motor of the pen, which begins up. */
    fun pen(port: Char) {
        hasPen = true
        motor(port, isCounted = true)
    }

    /** A sensor; [line] is the one of the header that names it. */
    fun sensor(sensor: PybricksSensor, line: Int = LineMap.NO_LINE): String {
        if (sensors[sensor] ?: LineMap.NO_LINE == LineMap.NO_LINE) sensors[sensor] = line
        return nameOf(sensor)
    }

    /** A colour sensor that tells Robolang's colours apart. */
    fun colourSensor(sensor: PybricksSensor, line: Int): String {
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
        for ((sensor, line) in sensors.entries.sortedBy { it.key.port }) writer.line(lineOf(sensor), line)
        if (hasTimer) writer.line("$TIMER = ${uses.tool("StopWatch")}()")
        writeSettings(writer)
    }

    private fun order(): List<Char> =
        listOfNotNull(robot.left.port, robot.right.port, robot.pen?.port).filter { it in motors }.let { usual ->
            usual + motors.sorted().filter { it !in usual }
        }

    private fun writeSettings(writer: PythonWriter) {
        hub.stopButton?.takeIf { freesMiddleButton }?.let { writer.line("$HUB.system.set_stop_button(${button(it)})") }
        // Motors with letters begin with the angle of their mark.
        if (hub.hasLetters) counted.sorted().forEach { writer.line("${nameOf(it)}.reset_angle(0)", note = noteOn(it)) }
        if (hub == PybricksHub.EV3) return
        for (sensor in withColours) {
            writer.line("${nameOf(sensor)}.detectable_colors(")
            writer.enter()
            writer.line("(${COLOURS.joinToString { uses.parameter("Color.$it") }})")
            writer.leave()
            writer.line(")")
        }
    }

    private fun noteOn(port: Char): String? = "The pen is up at the start.".takeIf { port == robot.pen?.port && hasPen }

    private fun button(name: String): String = if (name == "None") name else uses.parameter(name)

    private fun motorOf(port: Char): String {
        val motor = listOfNotNull(robot.left, robot.right, robot.pen).firstOrNull { it.port == port }
        val isWheel = port == robot.left.port || port == robot.right.port
        val direction = if (motor?.isCounterclockwise == true) uses.parameter("Direction.COUNTERCLOCKWISE") else null
        val gears = if (isWheel && robot.gears.isNotEmpty()) "gears=${robot.gears}" else null
        val arguments = listOfNotNull(uses.parameter("Port.$port"), direction, gears)
        return "${uses.import(hub.devices, "Motor")}(${arguments.joinToString()})"
    }

    private fun baseLine(): String {
        val kind = uses.import("pybricks.robotics", "DriveBase")
        val motors = "${nameOf(robot.left.port)}, ${nameOf(robot.right.port)}"
        val figures = "wheel_diameter=${decimalFigure(robot.wheelDiameter)}, axle_track=${decimalFigure(robot.track)}"
        return "$BASE = $kind($motors, $figures)"
    }

    private fun lineOf(sensor: PybricksSensor): String {
        val port = uses.parameter("Port.${hub.sensorPort(sensor.port)}")
        return "${nameOf(sensor)} = ${uses.import(hub.devices, sensor.kind.className)}($port)"
    }

    private fun nameOf(port: Char): String = when (port) {
        robot.left.port -> "left_motor"
        robot.right.port -> "right_motor"
        robot.pen?.port -> "pen_motor"
        else -> "motor_${port.lowercaseChar()}"
    }

    private fun nameOf(sensor: PybricksSensor): String {
        val ofKind = robot.sensors.filter { it.kind in likeOf(sensor.kind) }.sortedBy { it.port }
        val place = ofKind.indexOf(sensor)
        val wanted = when (sensor.kind) {
            PybricksSensorKind.FORCE, PybricksSensorKind.TOUCH -> {
                return listOf("left_bumper", "right_bumper").getOrElse(place) { "bumper_${place + 1}" }
            }

            PybricksSensorKind.COLOR -> if (usesColours) "color_sensor" else "light_sensor"
            PybricksSensorKind.LIGHT -> "light_sensor"
            PybricksSensorKind.ULTRASONIC -> "sonar"
            PybricksSensorKind.SOUND -> "sound_sensor"
        }
        return if (place > 0) "${wanted}_${place + 1}" else wanted
    }

    private fun likeOf(kind: PybricksSensorKind): Set<PybricksSensorKind> = when (kind) {
        in BUMPERS -> BUMPERS
        in EYES -> EYES
        else -> setOf(kind)
    }

    companion object {
        private const val HUB = "hub"
        private const val BASE = "robot"
        private const val TIMER = "timer"
        private val COLOURS = listOf("RED", "YELLOW", "GREEN", "BLUE", "WHITE", "BLACK")

        /** The kinds that feel a touch. */
        val BUMPERS = setOf(PybricksSensorKind.FORCE, PybricksSensorKind.TOUCH)

        /** The kinds that see light. */
        val EYES = setOf(PybricksSensorKind.COLOR, PybricksSensorKind.LIGHT)
    }
}
