package robotran.hub

import robotran.brick.kind.BrickKind
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.hub.model.HubModel
import robotran.hub.program.Hub
import robotran.hub.program.HubProgram

/** A program of actions, one per step; after the last one it returns [statusAtEnd]. */
internal class ScriptedProgram(
    private val statusAtEnd: ProgramStatus = ProgramStatus.Ended,
    override val name: String = "script",
    private val model: HubModel = HubModel.SPIKE_PRIME,
    private vararg val actions: (Hub) -> ProgramStatus,
) : HubProgram {
    override val kind: BrickKind get() = model.kind

    override fun start(hub: Hub): ProgramRun = object : ProgramRun {
        private var done = 0
        override val sourceLine: Int get() = minOf(done + 1, actions.size)

        override fun resume(steps: Int): ProgramStatus {
            repeat(steps) {
                if (done == actions.size) return statusAtEnd
                val status = actions[done](hub)
                done++
                if (status != ProgramStatus.Running) return status
            }
            return ProgramStatus.Running
        }
    }
}
