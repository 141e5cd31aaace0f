package robotran.programs

import robotran.brick.kind.BrickKind
import robotran.brick.program.BrickProgram
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.nxt.log.CallOrigin
import robotran.nxt.log.NxtLogEntry
import robotran.nxt.program.NxtNative
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.simulation.Session
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.pressRun
import robotran.tinyvm.config.TinyVmSpeed
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import kotlin.math.abs
import kotlin.math.hypot

/**
 * Runs Robolang programs and their translations for leJOS NXJ, compiled and linked for the virtual machine, on the NXT
 * of a robot in a world. Both must make the same calls one after the other and leave the robot at the same place.
 */
internal class NxtComparison {
    private val compiler =
        ProgramCompiler(nxtTestTarget, JavaSettings(speed = TinyVmSpeed.UNLIMITED), language = Language.ENGLISH)

    /** How they differ, a line for each program that does. */
    val differences = mutableListOf<String>()

    /** How many programs were compared. */
    var compared = 0
        private set

    /** How many of them have come to their end. */
    var ended = 0
        private set

    suspend fun compare(programs: Map<String, String>): NxtComparison {
        val physics = loadPhysicsEngine()
        for ((path, text) in programs - UNCERTAIN) compare(path, text, physics)
        return this
    }

    private suspend fun compare(path: String, text: String, physics: PhysicsEngine) {
        val interpreted =
            (
                compileRobolang(
                    path,
                    text,
                    nxtTestTarget,
                    messages = RobolangMessages.of(Language.ENGLISH),
                ) as? RobolangResult.Success
            )?.program
                ?: return
        val translated = when (
            val result = compiler.compileTranslation(
                Program(path, ProgramLanguage.ROBOLANG, text),
            )
        ) {
            is ProgramResult.Success -> result.program

            is ProgramResult.Failure -> {
                differences += "$path: ${result.diagnostics.first().message}"
                return
            }
        }
        val one = drive(interpreted, physics, MILLISECONDS)
        if (one.isFailed) return
        val other = drive(translated, physics, if (one.isEnded) MILLISECONDS else ENDLESS_MILLISECONDS)
        compared++
        if (one.isEnded) ended++
        differenceOf(one, other)?.let { differences += "$path: $it" }
    }

    private fun drive(program: BrickProgram, physics: PhysicsEngine, milliseconds: Int): Drive {
        val session = Session(BuiltInWorlds.plainFor(BrickKind.NXT), listOf(program), physics, Language.ENGLISH)
        session.pressRun()
        while (session.milliseconds < milliseconds && session.callLog.entries.size < ENOUGH_CALLS) {
            session.advance(PART)
            if (session.state.brick.run.let { it is RunState.Ended || it is RunState.Failed }) break
        }
        // Until the wheels stand.
        session.advance(PART * PART)
        val calls = session.callLog.entries.filterIsInstance<NxtLogEntry>().filter(::isByProgram)
        session.close()
        return Drive(session.state.robot.pose, session.state.brick.run, calls)
    }

    /** What a regulator does to its motor follows from the calls that set it going. Only Java logs that it ends. */
    private fun isByProgram(entry: NxtLogEntry) = entry.origin != CallOrigin.FIRMWARE &&
        entry.call.native != NxtNative.CONTROL_MOTOR && entry.call.native != NxtNative.EXIT

    private fun differenceOf(interpreted: Drive, translated: Drive): String? {
        // Of two endless programs, one has made more calls after the same time than the other.
        val max = if (interpreted.isEnded && translated.isEnded) {
            Int.MAX_VALUE
        } else {
            minOf(interpreted.calls.size, translated.calls.size)
        }
        val one = interpreted.calls.take(max).map { it.callText }
        val other = translated.calls.take(max).map { it.callText }
        val same = one.zip(other).takeWhile { (left, right) -> left == right }.size
        if (same < one.size || same < other.size) {
            val calls = listOf(interpreted, translated).map { it.calls.drop(same).take(3) }
            return "after $same calls ${calls[0]}, translated ${calls[1]}"
        }
        // The interpreter takes a step for what the machine does in a few bytecodes, so it may not get to the end.
        if (!interpreted.isEnded) return null
        if (!translated.isEnded) return "${interpreted.run}, translated ${translated.run}"
        return differenceOf(interpreted.pose, translated.pose)
    }

    private fun differenceOf(interpreted: Pose, translated: Pose): String? {
        val distance = hypot(interpreted.x - translated.x, interpreted.y - translated.y)
        val turned = abs(interpreted.heading - translated.heading).let { minOf(it, FULL_TURN - it) }
        val isSame = distance <= MAX_CENTIMETRES && turned <= MAX_DEGREES
        return "$interpreted, translated $translated".takeUnless { isSame }
    }

    private class Drive(val pose: Pose, val run: RunState, val calls: List<NxtLogEntry>) {
        val isEnded = run is RunState.Ended
        val isFailed = run is RunState.Failed
    }

    private companion object {
        /** Most programs that end by themselves do so before. */
        const val MILLISECONDS = 60_000
        const val PART = 20

        /** How long the translation of a program runs that does not end. */
        const val ENDLESS_MILLISECONDS = 4_000

        /** Of a program that does not end. */
        const val ENOUGH_CALLS = 4_000
        const val MAX_CENTIMETRES = 0.2
        const val MAX_DEGREES = 1.0
        const val FULL_TURN = 360.0

        /** Two have conditions that hold for no time at all, and one shows a time, which may be a millisecond more. */
        val UNCERTAIN = setOf(
            "behaviours/interrupts-between-statements.robo",
            "behaviours/an-action-that-ends-its-own-condition.robo",
            "sensing/timer.robo",
        )
    }
}
