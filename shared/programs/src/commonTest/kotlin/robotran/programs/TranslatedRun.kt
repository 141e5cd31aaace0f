package robotran.programs

import robotran.brick.controls.BrickButton
import robotran.brick.program.ProgramStatus
import robotran.brick.state.RunState
import robotran.javacompiler.CompilationResult
import robotran.javacompiler.JavaCompiler
import robotran.javacompiler.loadJavaCompiler
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.log.romCalls
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.RcxProgram
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangRcxProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.robolang.translate.translateRobolang

/** The robot of the test programs, with round numbers. */
internal val testTarget = RobotTarget.Rcx(millisecondsPerCentimetre = 50.0, millisecondsPerDegree = 5.0)

/** The robot with an NXT of the test programs. */
internal val nxtTestTarget = RobotTarget.Nxt(wheelDiameter = 5.6, track = 11.4)

/** Compiles [text]; null if it has errors. */
internal fun robolangOf(name: String, text: String): RobolangRcxProgram? = (
    compileRobolang(
        name.substringAfterLast('/'),
        text,
        testTarget,
        messages = RobolangMessages.of(Language.ENGLISH),
    ) as? RobolangResult.Success
)
    ?.program as? RobolangRcxProgram

/** The leJOS translation of [program], linked. Each translation is compiled once for all tests. */
internal suspend fun ProgramCompiler.translated(program: RobolangProgram): ProgramResult {
    val translation = translateRobolang(program)
    val name = "${translation.className}.java"
    val compiler =
        javaCompiler ?: loadJavaCompiler(messages = JavaMessages.of(Language.ENGLISH)).also { javaCompiler = it }
    val compiled =
        compiledTranslations.getOrPut(translation.java) {
            compiler.compile(listOf(SourceFile(name, translation.java)), BrickLibrary.classFiles)
        }
    return when (compiled) {
        is CompilationResult.Success -> compileOrThrow(
            ProgramSource.CompiledClasses(name, compiled.classes, compiled.mainClasses.single()),
        )

        is CompilationResult.Failure -> compileOrThrow(
            Program(name, ProgramLanguage.JAVA, translation.java),
        )
    }
}

private var javaCompiler: JavaCompiler? = null
private val compiledTranslations = HashMap<String, CompilationResult>()

/** The outcome of a run on a [FixedClockRom]. */
internal sealed interface Outcome {
    /** The program ended, or reached the max number of calls or the time limit. */
    data object Done : Outcome

    data class Failed(val message: String) : Outcome

    /** An endless loop in which the clock stands still. */
    data object EndlessLoop : Outcome
}

/** Runs [program] on [rom] until it ends or reaches [maxCalls] or [lastMillisecond]. The clock skips every wait. */
internal fun run(program: RcxProgram, rom: FixedClockRom, maxCalls: Int, lastMillisecond: Long): Outcome {
    val run = program.start(rom)
    var still = 0
    while (rom.calls.size < maxCalls && rom.milliseconds <= lastMillisecond) {
        if (still++ == MAX_STILL_STEPS) return Outcome.EndlessLoop
        when (val status = run.resume(1)) {
            ProgramStatus.Running, is ProgramStatus.Paused -> continue

            is ProgramStatus.Waiting -> if (status.untilMilliseconds > rom.milliseconds) {
                still = 0.also { rom.milliseconds = status.untilMilliseconds }
            }

            ProgramStatus.Ended -> return Outcome.Done
            is ProgramStatus.ThreadFailed -> return Outcome.Failed(status.failure.message)
            is ProgramStatus.Failed -> return Outcome.Failed(status.failure.message)
        }
    }
    return Outcome.Done
}

private const val MAX_STILL_STEPS = 400_000

/** The calls that a program made on a simulated brick, and whether it ended. */
internal class BrickRun(val calls: List<TimedCall>, val isOver: Boolean)

/** Runs [program] on a simulated brick for [milliseconds] with the given [sensors]. */
internal fun runOnBrick(program: RcxProgram, sensors: List<SensorEvent>, milliseconds: Long): BrickRun {
    val brick = RcxBrick(listOf(program), messages = BrickMessages.of(Language.ENGLISH))
    sensors.filter { it.milliseconds == 0L }.forEach { brick.setRawSensorValue(it.port - 1, it.raw) }
    // The firmware reads a sensor's new value some milliseconds after it changes.
    repeat(SETTLING_MILLISECONDS) { brick.tick() }
    val start = brick.state.milliseconds
    brick.press(BrickButton.RUN)
    brick.release(BrickButton.RUN)
    for (time in 0 until milliseconds) {
        sensors.filter { it.milliseconds == time }.forEach { brick.setRawSensorValue(it.port - 1, it.raw) }
        brick.tick()
        if (brick.state.run !is RunState.Running) break
    }
    val calls = brick.log.entries.romCalls().filter {
        it.sourceLine > 0
    }.map { TimedCall(it.milliseconds - start, it.call) }
    return BrickRun(calls, isOver = brick.state.run !is RunState.Running)
}

/** The call without the memory addresses for its results, which differ between programs. */
internal fun RomCall.withoutAddresses(): RomCall = when (address) {
    RomAddress.READ_BUTTONS, RomAddress.READ_POWER_STATUS -> copy(arguments = arguments.take(1))
    else -> this
}

private const val SETTLING_MILLISECONDS = 10
