package robotran.ui.workshop

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.programs.ProgramReader
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
 * Run in the run bar begins afresh with the program that is shown: the robot is back at its start on a clean sheet, on a brick that is switched on.
 * The brick's own Run carries on from where the robot stands, as on a real one, unless a program has changed, which begins afresh too.
 *
 * @param programs the programs to begin with, one or more.
 * @param speaker plays the brick's tones; is closed with the workshop.
 */
class Workshop(
    private val world: World,
    private val physics: PhysicsEngine,
    programs: List<PupilProgram>,
    speaker: LoudSpeaker = NoLoudSpeaker,
) {
    private val shelf = ProgramShelf(programs.map { it.withPlainLineEnds() }, ProgramReader(PENBOT_CALIBRATION))
    private val readingLoop = ReadingLoop(shelf, ::showReading)
    private var loaded = shelf.programs
    private var loadedSlots = shelf.slots
    private val sound = SoundPlayer(speaker)
    private var session = newSession(slot = 0)
    private val frames = FrameClock()
    private val rest = RestWatch()
    private var runWhenRead = false

    /** What is to be seen now. Compose notices when it changes. */
    var state: WorkshopState by mutableStateOf(firstState())
        private set

    private val editing = ProgramEditing(shelf, { state }, { state = it })

    /** Something a person does. */
    fun handle(event: WorkshopEvent) {
        when (event) {
            is WorkshopEvent.OfPrograms -> changePrograms(event)
            WorkshopEvent.RunPressed -> run()
            WorkshopEvent.StopPressed -> stop()
            is WorkshopEvent.ButtonPressed -> press(event.button)
            is WorkshopEvent.ButtonReleased -> release(event.button)
            is WorkshopEvent.PaneChosen -> state = state.copy(pane = event.pane)
            is WorkshopEvent.SoundSwitched -> switchSound(event.on)
        }
        rest.disturb()
        show()
    }

    /** Compiles Java programs in the pauses of typing, for ever; to be called once, for as long as the workshop is on a screen. */
    suspend fun keepReading() = readingLoop.run()

    /** Reads all programs that were not read yet, and does what waited for it. */
    suspend fun readPrograms() = readingLoop.readAll()

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

    private fun changePrograms(event: WorkshopEvent.OfPrograms) {
        runWhenRead = false
        editing.handle(event)
        readingLoop.programsChanged()
    }

    private fun showReading(reading: ProgramReading) {
        state = state.copy(reading = reading)
        if (reading == ProgramReading.NO_COMPILER) runWhenRead = false
        if (reading == ProgramReading.DONE) {
            if (state.untouched) beginAfresh(state.session.brick.selectedSlot.coerceAtMost(shelf.programs.lastIndex))
            if (runWhenRead) run()
        }
        rest.disturb()
        show()
    }

    private fun run() {
        if (!canStart(state.shownProgram)) return
        beginAfresh(state.shownProgram)
        press(BrickButton.RUN)
        release(BrickButton.RUN)
        if (state.pane == Pane.PROGRAM) state = state.copy(pane = Pane.WORLD)
    }

    private fun stop() {
        runWhenRead = false
        session.apply(SessionInput.Stop)
    }

    private fun press(button: BrickButton) {
        state = state.copy(down = state.down + button)
        if (button == BrickButton.RUN && !state.running && state.changed) {
            val slot = state.session.brick.selectedSlot.coerceAtMost(shelf.programs.lastIndex)
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

    /** Whether the program in [slot] can run now; if it has mistakes, the first is pointed out, and if it was not read yet, it runs once it is. */
    private fun canStart(slot: Int): Boolean {
        runWhenRead = !shelf.isRead(slot)
        if (runWhenRead) readingLoop.hurry()
        val possible = shelf.canRun(slot)
        if (!possible && !runWhenRead) editing.pointOutMistakes(slot)
        return possible
    }

    private fun beginAfresh(slot: Int) {
        session.close()
        session = newSession(slot)
        loaded = shelf.programs
        loadedSlots = shelf.slots
        show()
    }

    private fun newSession(slot: Int) = Session(world, shelf.slots, physics, slot).also { sound.listenTo(it.sounds) }

    private fun switchSound(on: Boolean) {
        sound.muted = !on
        state = state.copy(soundOn = on)
    }

    private fun show() {
        val now = session.state
        state = state.copy(
            programs = shelf.programs,
            mistakes = shelf.mistakes(state.shownProgram),
            session = now,
            changed = shelf.programs != loaded || shelf.slots.map { it == null } != loadedSlots.map { it == null },
            awake = rest.isAwake(now),
        )
    }

    private fun firstState() = WorkshopState(
        programs = shelf.programs,
        shownProgram = 0,
        shownFile = 0,
        closedProgram = null,
        mistakes = shelf.mistakes(0),
        reading = if (shelf.hasUnread) ProgramReading.WAITING else ProgramReading.DONE,
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
