package robotran.workshop.run

import robotran.brick.controls.BrickButton
import robotran.brick.state.BrickState
import robotran.brick.state.RunState
import robotran.runcontrol.PlaybackState
import robotran.simulation.SessionInput
import robotran.workshop.service.Notices
import robotran.workshop.service.ProgramsToRun
import robotran.workshop.state.Notice

/** What the user's fingers do to the robots: they press the buttons of the watched one's brick, and touch its sensors. */
internal class BrickTouch(
    private val run: DebuggedRun,
    private val programs: ProgramsToRun,
    private val starter: RunStarter,
    private val notices: Notices,
) {
    /** The buttons of the brick that are held; the brick may not have read them yet. */
    var down: Set<BrickButton> = emptySet()
        private set

    private val brick: BrickState get() = run.player.state.robots[run.player.watched].brick
    private val isRunning: Boolean get() = brick.run is RunState.Running

    fun press(button: BrickButton) {
        run.escape.pressed(button, isRunning)
        down = down + button
        if (button == brick.kind.startButton) {
            if (!isRunning && !mayStart()) return
            starter.isUntouched = false
            starter.tries.goOn()
        }
        touch(SessionInput.Press(button, run.player.watched))
    }

    /** Whether the brick's own Run may be pressed; starts over for that if a program has changed. */
    private fun mayStart(): Boolean {
        if (!run.isChanged) return !starter.isRefused()
        val slot = run.slotOnBrick
        return starter.isReady(slot, StartAction.PlayFromBrick).also { if (it) starter.startNewRun(slot) }
    }

    fun release(button: BrickButton) {
        down = down - button
        val wasRunning = isRunning
        touch(SessionInput.Release(button, run.player.watched))
        if (run.escape.released(button, wasRunning) && !readsButtons()) notices.show(Notice.EscapeAlone)
    }

    fun touch(input: SessionInput) {
        val player = run.player
        val isResting = player.state.robots.none { it.brick.run is RunState.Running }
        player.apply(input)
        // A brick that is off, or waits for a button, cannot respond while time is paused.
        if (player.playback == PlaybackState.Paused && isResting) player.play()
    }

    /** Whether the shown program may wait for ESCAPE itself; told by its text. */
    private fun readsButtons(): Boolean = programs.shownProgram.files.any { file ->
        BUTTON_WORDS.any { file.text.contains(it, ignoreCase = true) }
    }

    private companion object {
        /** What a program that reads the buttons of an NXT contains, in Robolang and in Java. */
        val BUTTON_WORDS = listOf("button", "escape")
    }
}
