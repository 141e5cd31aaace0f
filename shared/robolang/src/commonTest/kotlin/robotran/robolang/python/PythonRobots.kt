package robotran.robolang.python

import robotran.brick.controls.MotorPort
import robotran.hub.model.HubDeviceKind
import robotran.hub.model.HubModel
import robotran.language.Language
import robotran.robolang.RobolangHubProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget

private const val WHEEL = 56.0
private const val TRACK = 112.0

private fun spike(model: HubModel, pen: MotorPort?, vararg sensors: Pair<Int, HubDeviceKind>) =
    RobotTarget.Hub(model, WHEEL, TRACK, MotorPort.A, MotorPort.B, pen, sensors = mapOf(*sensors))

private fun withTouches(model: HubModel, left: MotorPort, pen: MotorPort, eye: HubDeviceKind) = RobotTarget.Hub(
    model,
    WHEEL,
    TRACK,
    left,
    MotorPort.C,
    pen,
    sensors = mapOf(
        1 to HubDeviceKind.TOUCH_SENSOR,
        2 to HubDeviceKind.TOUCH_SENSOR,
        3 to eye,
        4 to HubDeviceKind.ULTRASONIC_SENSOR,
    ),
)

/** A usual driving base with a SPIKE Prime: a colour sensor looks down, a bumper and a distance sensor are in front. */
internal val sonarRobot = spike(
    HubModel.SPIKE_PRIME,
    MotorPort.C,
    4 to HubDeviceKind.COLOR_SENSOR,
    5 to HubDeviceKind.FORCE_SENSOR,
    6 to HubDeviceKind.ULTRASONIC_SENSOR,
)

/** The same with a second bumper instead of the distance sensor. */
internal val bumperRobot = sonarRobot.copy(sensors = sonarRobot.sensors + (6 to HubDeviceKind.FORCE_SENSOR))

/** The smallest hub, with wheels alone. */
internal val essentialRobot = spike(HubModel.SPIKE_ESSENTIAL, pen = null)

internal val technicRobot = spike(HubModel.TECHNIC_HUB, MotorPort.C, 4 to HubDeviceKind.COLOR_SENSOR)

internal val ev3Robot = withTouches(HubModel.EV3, MotorPort.B, MotorPort.A, HubDeviceKind.COLOR_SENSOR)

/** An NXT with its own sensors. */
internal val nxtRobot = withTouches(HubModel.NXT_PYBRICKS, MotorPort.A, MotorPort.B, HubDeviceKind.LIGHT_SENSOR)

/** The robot of those above that has what [text] asks for. */
internal fun hubRobotFor(text: String): RobotTarget.Hub = when {
    NXT.containsMatchIn(text) -> nxtRobot
    SONAR.containsMatchIn(text) -> sonarRobot
    MOTOR_B.containsMatchIn(text) -> nxtRobot
    else -> bumperRobot
}

private val MOTOR_B = Regex("""(?m)^reset motor B$""")
private val NXT = Regex("""\bbrick nxt\b""", RegexOption.IGNORE_CASE)
private val SONAR = Regex("""\b(distance|sonar)\b""")

/** Compiled for [robot]; null if it has mistakes. */
internal fun programForHub(
    source: String,
    name: String = "test.robo",
    robot: RobotTarget.Hub = hubRobotFor(source),
): RobolangHubProgram? {
    val result = compileRobolang(name, source, robot, RobolangMessages.of(Language.ENGLISH))
    return (result as? RobolangResult.Success)?.program as RobolangHubProgram?
}

internal fun pythonOf(
    source: String,
    robot: RobotTarget.Hub = bumperRobot,
    language: Language = Language.ENGLISH,
    name: String = "test.robo",
): PythonTranslation {
    val program = compileRobolang(name, source, robot, RobolangMessages.of(Language.ENGLISH))
    if (program is RobolangResult.Failure) {
        throw AssertionError("$source\n" + program.diagnostics.joinToString("\n") { it.message })
    }
    return translateToPython(
        (program as RobolangResult.Success).program,
        robot,
        PythonTranslationMessages.of(language),
    )
}

/** The lines of the translation of [source], with their indentation. */
internal fun pythonLinesOf(source: String, robot: RobotTarget.Hub = bumperRobot): List<String> =
    pythonOf(source, robot).python.lines()

/** The lines behind the imports and the devices, without the functions of the translation itself. */
internal fun mainLinesOf(source: String, robot: RobotTarget.Hub = bumperRobot): List<String> =
    HELPER.replace(pythonOf(source, robot).python, "").lines()
        .filter { it.isNotEmpty() && !it.startsWith("from ") && !DEVICE.containsMatchIn(it) }

private val DEVICE = Regex("""^\w+ = [A-Z]\w+\(|^\w+\.reset_angle""")
private val HELPER = Regex(
    """(?m)^(async )?def (divide|remainder|show|blink|distance|set_power|run_on|pen_\w+|my_turn|whenever)\(.*\n( .*\n)+""",
)
