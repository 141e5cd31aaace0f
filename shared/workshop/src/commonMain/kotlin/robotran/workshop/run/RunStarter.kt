package robotran.workshop.run

import robotran.brick.program.StepKind
import robotran.simulation.Breakpoint
import robotran.simulation.RecordedInput
import robotran.simulation.startInputs
import robotran.workshop.service.ProgramsToRun
import robotran.workshop.service.Services
import robotran.workshop.state.CompileStatus
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.world.World
import robotran.world.robot.draftError

/** What to do after a program has started. */
internal sealed interface StartAction {
    /** Runs it and shows the sheet. */
    data object Play : StartAction

    /** Runs it after Run was pressed on the brick, which stays visible. */
    data object PlayFromBrick : StartAction

    /** Stops before its first line. */
    data object StopBeforeFirstStatement : StartAction

    /** Runs until it reaches [line]. */
    data class PlayTo(val line: Breakpoint) : StartAction
}

/**
 * Begins runs on an empty sheet; that of a program that Run starts waits until it is compiled.
 *
 * @property recording the recorded inputs of the project, which can be replayed.
 */
internal class RunStarter(
    private val run: DebuggedRun,
    private val programs: ProgramsToRun,
    private val drawer: DrawerStateHolder,
    private val services: Services,
    recording: List<RecordedInput>,
) {
    var recording = recording
        private set

    /** The programs that were started in the [recording], whichever are shown since. */
    private var recordedSlots = run.firstSlots

    val tries = AttemptRecorder(run)

    /** Whether no program has been run in this world. */
    var isUntouched = true

    /** The slot of the program that waits for the compiler, and what follows; null if none waits. */
    private var pending: Pair<Int, StartAction>? = null

    /** The program that waits for the compiler does not start any more. */
    fun cancel() {
        pending = null
    }

    /** Presses Run on an empty sheet with the program in [slot], and then performs [what]. Returns whether it did. */
    fun start(slot: Int, what: StartAction): Boolean {
        if (!isReady(slot, what)) return false
        startNewRun(slot)
        tries.begin()
        isUntouched = false
        val player = run.player
        run.world.startInputs().forEach(player::apply)
        when (what) {
            StartAction.Play, StartAction.PlayFromBrick -> player.play()

            // Java loads its classes before the first statement. Until then there is no line to show.
            StartAction.StopBeforeFirstStatement ->
                if (player.session.isBeforeStatement) player.pause() else player.step(StepKind.INTO)

            is StartAction.PlayTo -> player.play(what.line)
        }
        if (what == StartAction.Play) services.navigator.show(Pane.WORLD)
        return true
    }

    /** Whether the program in [slot] can start now. If it is not compiled, it starts by itself then, and [what] follows. */
    fun isReady(slot: Int, what: StartAction): Boolean {
        if (isRefused()) return false
        pending = if (programs.isCompiled(slot)) null else slot to what
        return programs.canStart(slot)
    }

    /** Called when the programs were compiled, or compilation failed or began. */
    fun programsCompiled(status: CompileStatus) {
        if (!status.isOver) return
        val waiting = pending
        pending = null
        if (status != CompileStatus.DONE) return
        val isStarted = waiting != null && start(waiting.first, waiting.second)
        if (!isStarted && isUntouched) startNewRun(run.slotOnBrick)
    }

    /** Tells why, if a robot is impossible. */
    fun isRefused(): Boolean {
        val draft = draftError(run.world) ?: return false
        pending = null
        services.notices.show(Notice.RobotImpossible(draft))
        return true
    }

    fun startOver() {
        pending = null
        startNewRun(run.slotOnBrick)
    }

    /** Puts the robots into [world] with the current programs, and with [recording] for replay. */
    fun changeWorld(world: World, recording: List<RecordedInput>) {
        this.recording = recording
        startNewRun(programs.slotsBeginning(programs.slotToRun), world)
        recordedSlots = run.firstSlots
        isUntouched = true
    }

    fun playRecording() {
        if (recording.isEmpty() || isRefused()) return
        startNewRun(recordedSlots, inputs = recording)
        isUntouched = false
        services.navigator.show(Pane.WORLD)
    }

    fun startNewRun(slot: Int) = startNewRun(programs.slotsBeginning(slot))

    private fun startNewRun(
        firstSlots: List<Int>,
        world: World = run.world,
        inputs: List<RecordedInput> = emptyList(),
    ) {
        run.startNewRun(firstSlots, world, inputs)
        tries.leave()
        drawer.startNewRun()
    }
}
