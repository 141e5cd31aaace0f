package robotran.robolang.python

import robotran.language.Language
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.testNxt

/** A usual driving base with a SPIKE Prime: a colour sensor looks down, a bumper and a distance sensor are in front. */
internal val sonarRobot = PybricksRobot.defaultFor(PybricksHub.PRIME)

/** The same with a second bumper instead of the distance sensor. */
internal val bumperRobot = sonarRobot.copy(
    sensors = sonarRobot.sensors.take(2) + PybricksSensor(PybricksSensorKind.FORCE, 6),
)

/** The smallest hub, with wheels alone. */
internal val essentialRobot = PybricksRobot.defaultFor(PybricksHub.ESSENTIAL)

/** An NXT with its own sensors. */
internal val nxtRobot = PybricksRobot.defaultFor(PybricksHub.NXT)

/** The robot of those above that has what [text] asks for. */
internal fun robotFor(text: String): PybricksRobot = when {
    SONAR.containsMatchIn(text) -> sonarRobot
    MOTOR_B.containsMatchIn(text) -> nxtRobot
    else -> bumperRobot
}

private val MOTOR_B = Regex("""(?m)^reset motor B$""")
private val SONAR = Regex("""\b(distance|sonar)\b""")

/** Compiled for a robot with an NXT, whose words a hub has, too; null if it has mistakes. */
internal fun programForHub(source: String, name: String = "test.robo"): RobolangProgram? {
    val result = compileRobolang(name, source, testNxt, RobolangMessages.of(Language.ENGLISH))
    return (result as? RobolangResult.Success)?.program
}

internal fun pythonOf(
    source: String,
    robot: PybricksRobot = bumperRobot,
    language: Language = Language.ENGLISH,
    name: String = "test.robo",
): PythonTranslation {
    val program = compileRobolang(name, source, testNxt, RobolangMessages.of(Language.ENGLISH))
    if (program is RobolangResult.Failure) throw AssertionError(program.diagnostics.joinToString("\n") { it.message })
    return translateToPython(
        (program as RobolangResult.Success).program,
        robot,
        PythonTranslationMessages.of(language),
    )
}

/** The lines of the translation of [source], with their indentation. */
internal fun pythonLinesOf(source: String, robot: PybricksRobot = bumperRobot): List<String> =
    pythonOf(source, robot).python.lines()

/** The lines behind the imports and the devices, without the functions of the translation itself. */
internal fun mainLinesOf(source: String, robot: PybricksRobot = bumperRobot): List<String> =
    HELPER.replace(pythonOf(source, robot).python, "").lines()
        .filter { it.isNotEmpty() && !it.startsWith("from ") && !DEVICE.containsMatchIn(it) }

private val DEVICE = Regex("""^\w+ = [A-Z]\w+\(|^\w+\.reset_angle""")
private val HELPER = Regex(
    """(?m)^(async )?def (divide|remainder|show|blink|distance|set_power|pen_\w+|my_turn|whenever)\(.*\n( .*\n)+""",
)
