package robotran.workshop.run

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.CoroutineScope
import robotran.language.Language
import robotran.rcxrom.controls.BrickButton
import robotran.rcxrom.program.StepKind
import robotran.rcxrom.state.RunState
import robotran.runcontrol.IdleDetector
import robotran.runcontrol.PlaybackState
import robotran.runcontrol.RunPlayer
import robotran.runcontrol.RunSpeed
import robotran.simulation.Breakpoint
import robotran.simulation.RecordedInput
import robotran.simulation.RunReport
import robotran.simulation.SessionInput
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.report
import robotran.workshop.event.RunEvent
import robotran.workshop.platform.Platform
import robotran.workshop.programs.ProgramsStateHolder
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Notices
import robotran.workshop.service.Preferences
import robotran.workshop.service.ProjectEditor
import robotran.workshop.service.ScreenNavigator
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane
import robotran.workshop.state.ProgramReading
import robotran.workshop.state.RunPaneState
import robotran.world.World

/**
 * Keeps the run that is watched; not safe for use by several threads.
 *
 * Run in the run bar begins afresh with the program that is shown: the robot is back at its start on a clean sheet, on
 * a brick that is switched on, and Run is pressed on the bricks of all robots. The brick's own Run carries on from
 * where the robot stands, as on a real one, unless a program has changed, which begins afresh too.
 *
 * @param recording what was done to a run that the project came with; it can be played.
 */
class RunStateHolder(
    world: World,
    physics: PhysicsEngine,
    private val programs: ProgramsStateHolder,
    private val current: CurrentProject,
    private val editor: ProjectEditor,
    private val navigator: ScreenNavigator,
    platform: Platform,
    scope: CoroutineScope,
    preferences: Preferences,
    notices: Notices,
    private var recording: List<RecordedInput> = emptyList(),
) {
    private val run = WatchedRun(world, physics, programs, platform.speaker, preferences, notices)
    private val rest = IdleDetector()
    private val drawer = DrawerUpdater()
    private val export = RomLogExport(platform, scope, notices)
    private val stoppedPlace = StoppedPlace(programs)
    private var pendingStart: PendingStart? = null

    private val player: RunPlayer get() = run.player

    var state: RunPaneState by mutableStateOf(firstState())
        private set

    /**
     * The program of each robot of the world that Run started, or would start, in this run, as long as Prgm was not
     * pressed.
     */
    val startedPrograms: List<Int> get() = run.firstSlots

    /** What was done to the run, also after the time that is looked at. */
    val inputs: List<RecordedInput> get() = player.inputs

    fun handle(event: RunEvent) {
        when (event) {
            RunEvent.RunPressed -> play()
            RunEvent.StopPressed -> stop()
            RunEvent.PausePressed -> pauseOrGoOn()
            is RunEvent.StepPressed -> step(event.kind)
            is RunEvent.RunToLine -> runTo(event.line)
            RunEvent.StartedOver -> startOver()
            is RunEvent.SpeedChosen -> choose(event.speed)
            is RunEvent.Scrubbed -> player.seek(event.milliseconds)
            is RunEvent.RobotWatched -> watch(event.robot)
            RunEvent.RecordingPlayed -> playRecording()
            is RunEvent.RunSettingsChanged -> editor.changeProjectSettings(event.settings)
            is RunEvent.ButtonPressed -> press(event.button)
            is RunEvent.ButtonReleased -> release(event.button)
            is RunEvent.SessionTouched -> touch(event.input)
            is RunEvent.DrawerChosen -> openDrawer(event.tab)
            is RunEvent.DrawerBesideChosen -> state = state.copy(drawer = state.drawer.choosingBeside(event.tab))
            is RunEvent.FrameChosen -> drawer.choose(event.thread, event.frame)
            is RunEvent.LogFiltered -> drawer.filter(event.filter)
            RunEvent.LogCopied -> export.copy(state.drawer.log)
            RunEvent.LogSaved -> export.save(state.drawer.log, programs.state.program.name)
            is RunEvent.LaneSwitched -> state = state.copy(drawer = state.drawer.switching(event.lane))
        }
        rest.disturb()
        show()
    }

    /** Something about the programs was changed. */
    fun programsChanged() {
        pendingStart = null
        show()
    }

    /** The programs were read as far as [reading] says. */
    fun programsRead(reading: ProgramReading) {
        if (reading.isOver && reading != ProgramReading.DONE) pendingStart = null
        if (reading == ProgramReading.DONE) {
            if (state.untouched) beginAfresh(run.slotOnBrick)
            pendingStart?.let { start(it.slot, it.what) }
        }
        show()
    }

    /**
     * A picture is about to be drawn, at [nanoseconds] of a clock that only goes forwards: virtual time follows it
     * while [RunPaneState.awake].
     */
    fun frame(nanoseconds: Long) {
        if (!state.awake) return player.rest()
        player.frame(nanoseconds)
        lookForRest()
        run.hearWhatIsNew()
        show()
        if (!state.awake) player.rest()
    }

    /** Lets [milliseconds] of virtual time pass at once, too quickly to be heard. */
    fun advance(milliseconds: Int) {
        player.pass(milliseconds)
        lookForRest()
        run.skipSound()
        show()
    }

    /** Puts the robots into [world], with the programs as they are, and with [recording], which can be played there. */
    fun changeWorld(world: World, recording: List<RecordedInput> = emptyList()) {
        this.recording = recording
        beginAfresh(programs.slotsBeginning(programs.slotToRun), world)
        state = state.copy(untouched = true, hasRecording = recording.isNotEmpty(), settings = current.project.settings)
        rest.disturb()
        show()
    }

    /** Tells the run in [language], also what has happened in it so far. */
    fun speak(language: Language) {
        run.speak(language)
        show()
    }

    /** What came of the run up to now. */
    fun report(): RunReport = player.session.report()

    /** Whether the brick's tones are to be heard. */
    fun hear(on: Boolean) = run.hear(on)

    /** Gives back what the session holds. Nothing may be called afterwards. */
    fun close() = run.close()

    /**
     * Presses Run on a clean sheet, with the program in [slot], and then does [what] is wanted of it; if it was not
     * compiled yet, once it is.
     */
    private fun start(slot: Int, what: StartAction) {
        pendingStart = if (programs.isRead(slot)) null else PendingStart(slot, what)
        if (!programs.canStart(slot)) return
        beginAfresh(slot)
        state = state.copy(untouched = false)
        for (robot in run.world.robots.indices) {
            player.apply(SessionInput.Press(BrickButton.RUN, robot))
            player.apply(SessionInput.Release(BrickButton.RUN, robot))
        }
        when (what) {
            StartAction.Play, StartAction.PlayFromBrick -> player.play()
            StartAction.StopBeforeFirstStatement -> standBeforeFirstStatement()
            is StartAction.PlayTo -> player.play(what.line)
        }
        if (what == StartAction.Play) navigator.show(Pane.WORLD)
    }

    private fun play() = start(programs.slotToRun, StartAction.Play)

    private fun stop() {
        pendingStart = null
        if (player.isInPast) {
            player.pause()
        } else {
            player.apply(SessionInput.Stop)
            player.play()
        }
    }

    private fun pauseOrGoOn() {
        if (player.playback == PlaybackState.Paused || state.isSeeking) {
            goOn { player.play() }
        } else {
            player.pause()
            run.silence()
        }
    }

    private fun step(kind: StepKind) = if (state.running) {
        goOn {
            player.step(kind)
        }
    } else {
        start(programs.slotToRun, StartAction.StopBeforeFirstStatement)
    }

    /** Java loads its classes before it comes to a statement; meanwhile there is no line that could be shown. */
    private fun standBeforeFirstStatement() =
        if (player.session.isBeforeStatement) player.pause() else player.step(StepKind.INTO)

    private fun runTo(line: Breakpoint) =
        if (state.running) goOn { player.play(line) } else start(programs.slotToRun, StartAction.PlayTo(line))

    private fun goOn(how: () -> Unit) {
        drawer.variables.goesOn(player.session)
        drawer.goesOn()
        how()
    }

    private fun startOver() {
        pendingStart = null
        beginAfresh(run.slotOnBrick)
    }

    private fun choose(speed: RunSpeed) {
        player.speed = speed
        state = state.copy(speed = speed)
    }

    private fun watch(robot: Int) {
        if (robot !in run.world.robots.indices) return
        run.watch(robot)
        drawer.beginAfresh()
        state = state.copy(watched = robot)
    }

    private fun playRecording() {
        if (recording.isEmpty()) return
        val robots = current.project.robots.associateBy { it.name }
        beginAfresh(run.world.robots.map { robots[it.name]?.firstProgram ?: 0 }, inputs = recording)
        state = state.copy(untouched = false)
        navigator.show(Pane.WORLD)
    }

    private fun press(button: BrickButton) {
        state = state.copy(down = state.down + button)
        if (button == BrickButton.RUN && state.brick.run !is RunState.Running && state.changed) {
            val slot = run.slotOnBrick
            pendingStart = if (programs.isRead(slot)) null else PendingStart(slot, StartAction.PlayFromBrick)
            if (!programs.canStart(slot)) return
            beginAfresh(slot)
        }
        if (button == BrickButton.RUN) state = state.copy(untouched = false)
        touch(SessionInput.Press(button, state.watched))
    }

    private fun release(button: BrickButton) {
        state = state.copy(down = state.down - button)
        touch(SessionInput.Release(button, state.watched))
    }

    private fun touch(input: SessionInput) {
        player.apply(input)
        // A brick that is switched off, or waits for a button, would not answer while time stands still.
        if (player.playback == PlaybackState.Paused && !state.running) player.play()
    }

    private fun openDrawer(tab: DrawerTab?) {
        state = state.copy(drawer = state.drawer.choosing(tab))
        if (tab != null) navigator.show(Pane.WORLD)
    }

    private fun firstState() = RunPaneState(
        run.world,
        player.state,
        hasRecording = recording.isNotEmpty(),
        settings = current.project.settings,
    )

    private fun beginAfresh(slot: Int) = beginAfresh(programs.slotsBeginning(slot))

    private fun beginAfresh(
        firstSlots: List<Int>,
        world: World = run.world,
        inputs: List<RecordedInput> = emptyList(),
    ) {
        run.beginAfresh(firstSlots, world, inputs)
        rest.disturb()
        state = state.copy(watched = player.watched)
        drawer.beginAfresh()
        show()
    }

    private fun show() {
        run.look()
        if (!run.isChanged) stoppedPlace.look(player, run.world.robots[player.watched].name)
        state = state.copy(
            world = run.world,
            session = player.state,
            drawn = player.drawn,
            changed = run.isChanged,
            playback = player.playback,
            time = player.time,
            length = player.length,
            marks = player.marks,
            calls = player.callLine,
            drawer = drawer.fill(state.drawer, player),
            awake = isAwake(),
        )
    }

    /** On the way to another time nothing is to be learnt: what is shown meanwhile may be of shortly before. */
    private fun lookForRest() {
        if (player.playback !is PlaybackState.Seeking) rest.passed(player.state)
    }

    private fun isAwake(): Boolean = when (player.playback) {
        PlaybackState.Paused -> DrawerTab.LOG in state.drawer.open && drawer.isBusy
        is PlaybackState.Stepping, is PlaybackState.Seeking -> true
        is PlaybackState.Playing -> player.isInPast || rest.isAwake(player.state)
    }
}

/** What is wanted of a program that is started. */
private sealed interface StartAction {
    /** It runs, and the sheet comes into sight. */
    data object Play : StartAction

    /** It runs, as Run on the brick was pressed, which is in sight. */
    data object PlayFromBrick : StartAction

    /** It stops before its first line. */
    data object StopBeforeFirstStatement : StartAction

    /** It runs until it stands before [line]. */
    data class PlayTo(val line: Breakpoint) : StartAction
}

/** The program in [slot] starts as soon as it is compiled. */
private class PendingStart(val slot: Int, val what: StartAction)
