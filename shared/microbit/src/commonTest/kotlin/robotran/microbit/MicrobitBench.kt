package robotran.microbit

import robotran.brick.controls.BrickButton
import robotran.brick.kind.BrickKind
import robotran.brick.kind.BuggyKind
import robotran.brick.program.BrickProgram
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.microbit.buggy.Buggy
import robotran.microbit.messages.MicrobitMessages
import robotran.microbit.model.MicrobitModel
import robotran.microbit.program.Microbit
import robotran.microbit.program.MicrobitProgram

/** A board on a buggy, with what tests do to it. */
internal class MicrobitBench(
    vararg programs: BrickProgram?,
    val model: MicrobitModel = MicrobitModel.V2,
    buggy: BuggyKind = BuggyKind.CUTEBOT,
    hasPen: Boolean = true,
) {
    val brick =
        MicrobitBrick(model, Buggy.of(buggy), hasPen, programs.toList(), MicrobitMessages.of(Language.ENGLISH))

    val calls: List<String> get() = brick.log.entries.map { it.callText }

    fun tick(milliseconds: Int) = repeat(milliseconds) { brick.tick() }

    fun tap(button: BrickButton) {
        brick.press(button)
        brick.release(button)
    }
}

/** A program whose steps are [actions]. */
internal class ScriptedProgram(
    private val model: MicrobitModel = MicrobitModel.V2,
    private val statusAtEnd: ProgramStatus = ProgramStatus.Ended,
    private vararg val actions: (Microbit) -> ProgramStatus,
) : MicrobitProgram {
    override val name: String get() = "script"
    override val kind: BrickKind get() = model.kind

    override fun start(board: Microbit): ProgramRun = object : ProgramRun {
        private var done = 0
        override val sourceLine: Int get() = minOf(done + 1, actions.size)

        override fun resume(steps: Int): ProgramStatus {
            repeat(steps) {
                if (done == actions.size) return statusAtEnd
                val status = actions[done](board)
                done++
                if (status != ProgramStatus.Running) return status
            }
            return ProgramStatus.Running
        }
    }
}
