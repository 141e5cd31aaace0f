package robotran.ui.workshop

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.robolang.Diagnostic
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.readRobolang
import robotran.rom.BrickButton
import robotran.ui.sound.LoudSpeaker
import robotran.ui.sound.NoLoudSpeaker
import robotran.ui.sound.SoundPlayer
import robotran.world.RunReport
import robotran.world.Session
import robotran.world.SessionInput
import robotran.world.World
import robotran.world.physics.PhysicsEngine
import robotran.world.report

/**
 * What happens behind the screen: takes [WorkshopEvent]s, lets virtual time pass, and shows the result as one [WorkshopState].
 * Owns the running session; not safe for use by several threads.
 *
 * Run in the run bar begins afresh: the robot is back at its start on a clean sheet, on a brick that is switched on. The brick's own Run
 * carries on from where the robot stands, as on a real one, unless the program has changed, which begins afresh too.
 *
 * @param program the program to begin with.
 * @param speaker plays the brick's tones; is closed with the workshop.
 */
class Workshop(
    private val world: World,
    private val physics: PhysicsEngine,
    program: ProgramFile,
    speaker: LoudSpeaker = NoLoudSpeaker,
) {
    private val programName = program.name
    private var loadedText = program.text.withPlainLineEnds()
    private var reading = read(loadedText)
    private val sound = SoundPlayer(speaker)
    private var session = newSession()
    private val frames = FrameClock()
    private val rest = RestWatch()

    /** What is to be seen now. Compose notices when it changes. */
    var state: WorkshopState by mutableStateOf(firstState(loadedText))
        private set

    /** Something a person does. */
    fun handle(event: WorkshopEvent) {
        when (event) {
            is WorkshopEvent.ProgramEdited -> edit(event.text)
            is WorkshopEvent.FixApplied -> applyFix(event.mistake)
            WorkshopEvent.RunPressed -> run()
            WorkshopEvent.StopPressed -> session.apply(SessionInput.Stop)
            is WorkshopEvent.ButtonPressed -> press(event.button)
            is WorkshopEvent.ButtonReleased -> release(event.button)
            is WorkshopEvent.PaneChosen -> state = state.copy(pane = event.pane)
            is WorkshopEvent.SoundSwitched -> switchSound(event.on)
        }
        rest.disturb()
        show()
    }

    /** A picture is about to be drawn, at [nanoseconds] of a clock that only goes forwards: virtual time follows it while [WorkshopState.awake]. */
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

    private fun pass(milliseconds: Int) {
        session.advance(milliseconds)
        rest.passed(milliseconds, session.state)
        show()
    }

    /** What came of the run up to now. */
    fun report(): RunReport = session.report()

    /** Gives back what the session holds. Nothing may be called afterwards. */
    fun close() {
        sound.close()
        session.close()
    }

    private fun edit(written: String) {
        val text = written.withPlainLineEnds()
        if (text == state.programText) return
        reading = read(text)
        state = state.copy(programText = text, mistakes = mistakes(), mistakePointedOut = false)
    }

    private fun applyFix(mistake: Diagnostic) {
        mistake.fix?.let { edit(state.programText.mendedBy(it)) }
    }

    private fun run() {
        if (!canStart()) return
        beginAfresh()
        press(BrickButton.RUN)
        release(BrickButton.RUN)
        if (state.pane == Pane.PROGRAM) state = state.copy(pane = Pane.WORLD)
    }

    private fun press(button: BrickButton) {
        state = state.copy(down = state.down + button)
        if (button == BrickButton.RUN && !state.running && state.changed) {
            if (!canStart()) return
            beginAfresh()
        }
        if (button == BrickButton.RUN) state = state.copy(untouched = false)
        session.apply(SessionInput.Press(button))
    }

    private fun release(button: BrickButton) {
        state = state.copy(down = state.down - button)
        session.apply(SessionInput.Release(button))
    }

    /** Whether the text can run; if not, its first mistake is pointed out. */
    private fun canStart(): Boolean {
        val possible = reading is RobolangResult.Ready && state.programText.isNotBlank()
        if (!possible) state = state.copy(mistakePointedOut = true, pane = Pane.PROGRAM)
        return possible
    }

    private fun beginAfresh() {
        session.close()
        session = newSession()
        loadedText = state.programText
        show()
    }

    private fun newSession() = Session(world, listOfNotNull(program()), physics).also { sound.listenTo(it.sounds) }

    private fun switchSound(on: Boolean) {
        sound.muted = !on
        state = state.copy(soundOn = on)
    }

    private fun program(): RobolangProgram? = (reading as? RobolangResult.Ready)?.program

    private fun mistakes(): List<Diagnostic> = (reading as? RobolangResult.Mistaken)?.diagnostics.orEmpty()

    private fun read(text: String): RobolangResult = readRobolang(programName, text, PENBOT_CALIBRATION)

    private fun show() {
        val now = session.state
        state = state.copy(session = now, changed = state.programText != loadedText, awake = rest.isAwake(now))
    }

    private fun firstState(text: String) = WorkshopState(
        programName = programName,
        programText = text,
        mistakes = mistakes(),
        changed = false,
        mistakePointedOut = false,
        world = world,
        session = session.state,
        down = emptySet(),
        pane = Pane.WORLD,
        untouched = true,
        awake = true,
        soundOn = true,
    )
}
