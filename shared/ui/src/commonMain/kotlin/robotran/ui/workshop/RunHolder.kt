package robotran.ui.workshop

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.rom.BrickButton
import robotran.ui.sound.SoundPlayer
import robotran.world.RecordedInput
import robotran.world.RunReport
import robotran.world.Session
import robotran.world.SessionInput
import robotran.world.World
import robotran.world.physics.PhysicsEngine
import robotran.world.report

/**
 * Keeps the running session; not safe for use by several threads.
 *
 * Run in the run bar begins afresh with the program that is shown: the robot is back at its start on a clean sheet, on a brick that is switched on.
 * The brick's own Run carries on from where the robot stands, as on a real one, unless a program has changed, which begins afresh too.
 */
class RunHolder(
    private var world: World,
    private val physics: PhysicsEngine,
    private val programs: ProgramsHolder,
    private val bench: Bench,
) {
    private var loaded = programs.written
    private val sound = SoundPlayer(bench.platform.speaker)
    private var session = newSession(slot = 0)
    private val frames = FrameClock()
    private val rest = RestWatch()
    private var runWhenRead = false

    var state: RunPaneState by mutableStateOf(RunPaneState(world, session.state))
        private set

    /** What was done to the session so far. */
    val inputs: List<RecordedInput> get() = session.inputs

    fun handle(event: RunEvent) {
        when (event) {
            RunEvent.RunPressed -> run()
            RunEvent.StopPressed -> stop()
            is RunEvent.ButtonPressed -> press(event.button)
            is RunEvent.ButtonReleased -> release(event.button)
            is RunEvent.SessionTouched -> session.apply(event.input)
        }
        rest.disturb()
        show()
    }

    /** Something about the programs was changed. */
    fun programsChanged() {
        runWhenRead = false
        rest.disturb()
        show()
    }

    /** The programs were read as far as [reading] says. */
    fun programsRead(reading: ProgramReading) {
        if (reading == ProgramReading.NO_COMPILER) runWhenRead = false
        if (reading == ProgramReading.DONE) {
            if (state.untouched) beginAfresh(slotOnBrick())
            if (runWhenRead) run()
        }
        rest.disturb()
        show()
    }

    /** A picture is about to be drawn, at [nanoseconds] of a clock that only goes forwards: virtual time follows it while [RunPaneState.awake]. */
    fun frame(nanoseconds: Long) {
        val milliseconds = frames.millisecondsTo(nanoseconds)
        if (state.awake && milliseconds > 0) {
            pass(milliseconds)
            sound.follow()
        }
        if (!state.awake) frames.rest()
    }

    /** Lets [milliseconds] of virtual time pass at once, too quickly to be heard. */
    fun advance(milliseconds: Int) {
        pass(milliseconds)
        sound.skip()
    }

    /** Puts the robots into [world], with the programs as they are. */
    fun changeWorld(world: World) {
        this.world = world
        beginAfresh(slot = 0)
        state = state.copy(untouched = true)
        rest.disturb()
        show()
    }

    /** What came of the run up to now. */
    fun report(): RunReport = session.report()

    /** Whether the brick's tones are to be heard. */
    fun hear(on: Boolean) {
        sound.muted = !on
    }

    /** Gives back what the session holds. Nothing may be called afterwards. */
    fun close() {
        sound.close()
        session.close()
    }

    private fun pass(milliseconds: Int) {
        session.advance(milliseconds)
        rest.passed(milliseconds, session.state)
        show()
    }

    private fun run() {
        val slot = programs.slotToRun
        if (!canStart(slot)) return
        beginAfresh(slot)
        press(BrickButton.RUN)
        release(BrickButton.RUN)
        bench.show(Pane.WORLD)
    }

    private fun stop() {
        runWhenRead = false
        session.apply(SessionInput.Stop)
    }

    private fun press(button: BrickButton) {
        state = state.copy(down = state.down + button)
        if (button == BrickButton.RUN && !state.running && state.changed) {
            val slot = slotOnBrick()
            if (!canStart(slot)) return
            beginAfresh(slot)
        }
        if (button == BrickButton.RUN) state = state.copy(untouched = false)
        session.apply(SessionInput.Press(button))
    }

    private fun release(button: BrickButton) {
        state = state.copy(down = state.down - button)
        session.apply(SessionInput.Release(button))
    }

    private fun canStart(slot: Int): Boolean {
        runWhenRead = !programs.isRead(slot)
        return programs.canStart(slot)
    }

    private fun slotOnBrick() = session.state.brick.selectedSlot.coerceAtMost(programs.count - 1)

    private fun beginAfresh(slot: Int) {
        session.close()
        session = newSession(slot)
        loaded = programs.written
        show()
    }

    private fun newSession(slot: Int) = Session(world, programs.loads(world, slot), physics, bench.language).also { sound.listenTo(it.sounds) }

    private fun show() {
        val now = session.state
        state = state.copy(world = world, session = now, changed = programs.written != loaded, awake = rest.isAwake(now))
    }
}
