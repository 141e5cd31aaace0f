package robotran.robolang.python.microbit

import robotran.brick.kind.BuggyKind
import robotran.brick.kind.BuggyPins
import robotran.brick.kind.PlainDrive
import robotran.brick.kind.WheelTrim
import robotran.language.Language
import robotran.microbit.buggy.Buggy
import robotran.microbit.model.MicrobitModel
import robotran.robolang.RobolangMicrobitProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.python.PythonTranslation
import robotran.robolang.python.translateToPython
import robotran.robolang.robot.RobotTarget

private const val CENTIMETRE = 50.0
private const val DEGREE = 3.3161

internal fun buggyRobot(
    kind: BuggyKind,
    model: MicrobitModel = MicrobitModel.V2,
    pins: BuggyPins? = null,
    trim: WheelTrim = WheelTrim.NONE,
) = RobotTarget.Microbit(model, Buggy.of(kind, pins), CENTIMETRE, DEGREE, trim = trim)

internal val cutebot = buggyRobot(BuggyKind.CUTEBOT)

/** One that swings to the left, so that its right wheel is slowed down. */
internal val trimmedCutebot = buggyRobot(BuggyKind.CUTEBOT, trim = WheelTrim(right = 0.983))

/** Two motors on a bridge, and a sensor for distances with one pin. */
internal val bridgeBuggy = buggyRobot(
    BuggyKind.PLAIN,
    pins = BuggyPins(PlainDrive.BRIDGE, listOf(12, 8), listOf(16, 14), listOf(0, 1), trigger = 15, echo = 15, pen = 2),
)

/** A robot for each way to drive and to sense. */
internal val allBuggies: Map<String, RobotTarget.Microbit> =
    BuggyKind.entries.associate { it.word to buggyRobot(it) } + mapOf(
        "bridge" to bridgeBuggy,
        "cutebot-trimmed" to trimmedCutebot,
        "cutebot-v1" to buggyRobot(BuggyKind.CUTEBOT, MicrobitModel.V1),
        "kitronik-move-v1" to buggyRobot(BuggyKind.KITRONIK_MOVE, MicrobitModel.V1),
        "cutebot-reversed" to cutebot.copy(isReversed = true),
    )

/** Compiled for [robot]; null if it has mistakes. */
internal fun programForBoard(
    source: String,
    name: String = "test.robo",
    robot: RobotTarget.Microbit = cutebot,
): RobolangMicrobitProgram? {
    val result = compileRobolang(name, source, robot, RobolangMessages.of(Language.ENGLISH))
    return (result as? RobolangResult.Success)?.program as RobolangMicrobitProgram?
}

internal fun boardPythonOf(
    source: String,
    robot: RobotTarget.Microbit = cutebot,
    language: Language = Language.ENGLISH,
    name: String = "test.robo",
): PythonTranslation {
    val result = compileRobolang(name, source, robot, RobolangMessages.of(Language.ENGLISH))
    if (result is RobolangResult.Failure) {
        throw AssertionError("$source\n" + result.diagnostics.joinToString("\n") { it.message })
    }
    val program = (result as RobolangResult.Success).program
    return translateToPython(program, robot, PythonTranslationMessages.of(language))
}
