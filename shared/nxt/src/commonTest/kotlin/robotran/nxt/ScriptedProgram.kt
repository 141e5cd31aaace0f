package robotran.nxt

import robotran.brick.program.FailureFrame
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.program.NxtProgram

/** The line of calls that a test makes. */
internal const val TEST_LINE = 7

/** A program of actions, one per step; after the last one it returns [statusAtEnd]. */
internal class ScriptedProgram(
    private val actions: List<(Nxt) -> ProgramStatus>,
    private val statusAtEnd: ProgramStatus = ProgramStatus.Ended,
    override val name: String = "script",
) : NxtProgram {
    /** Number of runs started. */
    var starts = 0
        private set

    override fun start(nxt: Nxt): ProgramRun {
        starts++
        return Run(nxt)
    }

    private inner class Run(private val nxt: Nxt) : ProgramRun {
        private var done = 0
        override val sourceLine: Int get() = minOf(done + 1, actions.size)

        override fun resume(steps: Int): ProgramStatus {
            repeat(steps) {
                if (done == actions.size) return statusAtEnd
                val status = actions[done](nxt)
                done++
                if (status != ProgramStatus.Running) return status
            }
            return ProgramStatus.Running
        }
    }
}

/** An action that makes a call. */
internal fun calling(call: NxtCall): (Nxt) -> ProgramStatus = { nxt ->
    nxt.call(call, TEST_LINE)
    ProgramStatus.Running
}

/** An action that waits. */
internal fun waiting(milliseconds: Int): (Nxt) -> ProgramStatus = { nxt ->
    ProgramStatus.Waiting(nxt.milliseconds + milliseconds)
}

/** The programs that a script can load, by their names in the script. */
internal fun scriptedProgram(name: String): NxtProgram? = when (name) {
    "none" -> null
    "endless" -> ScriptedProgram(emptyList(), ProgramStatus.Running, name)
    "short" -> ScriptedProgram(listOf(waiting(100)), name = name)

    "greeting" -> ScriptedProgram(
        listOf(calling(NxtCall.drawString("Hello", 0, 0))),
        ProgramStatus.Running,
        name,
    )

    "driving" -> ScriptedProgram(listOf(DRIVE), ProgramStatus.Running, name)
    "driven" -> ScriptedProgram(listOf(DRIVE, waiting(100)), name = name)

    "failing" -> ScriptedProgram(
        listOf(DRIVE, waiting(100)),
        ProgramStatus.Failed(ProgramFailure("There is nothing to divide by.", sourceLine = 12)),
        name,
    )

    "throwing" -> ScriptedProgram(
        listOf(DRIVE, waiting(100)),
        ProgramStatus.Failed(outOfBounds(frames = 12)),
        name,
    )

    "thread" -> ScriptedProgram(
        listOf(DRIVE, { ProgramStatus.ThreadFailed(outOfBounds(frames = 1)) }),
        ProgramStatus.Running,
        name,
    )

    "orderly" -> OrderlyProgram(name)
    "tidy-thread" -> OrderlyProgram(name, fails = true)

    "switching-off" -> ScriptedProgram(
        listOf(DRIVE, waiting(100), calling(NxtCall.of(NxtNative.SHUT_DOWN))),
        ProgramStatus.Running,
        name,
    )

    else -> error("There is no program $name for scripts.")
}

private val DRIVE = calling(NxtCall.controlMotor(0, 75, brakes = true))

private fun outOfBounds(frames: Int) = ProgramFailure(
    "The list has no place 5.",
    sourceLine = 12,
    methodNumber = 50,
    exceptionNumber = 28,
    stack = List(frames) { FailureFrame(50 + it, 72, "method$it") },
    thrownText = "5 is out of bounds",
)

/** Takes 200 ms to end when it is asked to. */
private class OrderlyProgram(override val name: String, private val fails: Boolean = false) : NxtProgram {
    override fun start(nxt: Nxt): ProgramRun = object : ProgramRun {
        private var endsAt = Long.MAX_VALUE
        private var hasFailed = !fails
        override val sourceLine: Int get() = 1

        init {
            nxt.onStopRequest = { endsAt = nxt.milliseconds + 200 }
        }

        override fun resume(steps: Int): ProgramStatus {
            if (!hasFailed) {
                hasFailed = true
                return ProgramStatus.ThreadFailed(outOfBounds(frames = 1))
            }
            return if (nxt.milliseconds < endsAt) ProgramStatus.Waiting(nxt.milliseconds + 50) else ProgramStatus.Ended
        }
    }
}
