package robotran.workshop.run

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.brick.program.StepKind
import robotran.language.Language
import robotran.narration.RunStory
import robotran.narration.storyOf
import robotran.nxt.storage.NxtFile
import robotran.projects.ProjectSettings
import robotran.runcontrol.PlaybackState
import robotran.runcontrol.RecordedRun
import robotran.runcontrol.RunPlayer
import robotran.simulation.Breakpoint
import robotran.simulation.RecordedInput
import robotran.simulation.RunReport
import robotran.simulation.SessionInput
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.report
import robotran.simulation.state.GoalShortfall
import robotran.workshop.event.RunEvent
import robotran.workshop.service.ProgramsToRun
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.Services
import robotran.workshop.state.CompileStatus
import robotran.workshop.state.EndedAttempt
import robotran.workshop.state.Notice
import robotran.workshop.state.Pane
import robotran.workshop.state.RunPaneState
import robotran.workshop.state.Snippet
import robotran.world.World

/**
 * Holds the current run. Not thread-safe.
 *
 * Run in the run bar starts over with the current program: it returns the robot to its start on an empty sheet,
 * switches the brick on, and presses Run on the bricks of all robots. The brick's own Run continues from the robot's
 * position, like a real brick, unless a program has changed; then it starts over, too.
 *
 * @param recording the recorded inputs of the project, which can be replayed.
 */
class RunStateHolder(
    world: World,
    physics: PhysicsEngine,
    private val programs: ProgramsToRun,
    private val services: Services,
    recording: List<RecordedInput> = emptyList(),
) {
    private val navigator = services.navigator
    private val notices = services.notices
    private val run = DebuggedRun(world, physics, programs, services.platform.speaker, services.preferences, notices)
    private val drawer =
        DrawerStateHolder(services.platform, services.scope, notices, navigator, run.player.watchedBrick) {
            programs.shownProgram.name
        }
    private val stopLocation = StopLocation(run, programs, drawer)
    private val starter = RunStarter(run, programs, drawer, services, recording)
    private val touch = BrickTouch(run, programs, starter, notices)

    private val player: RunPlayer get() = run.player

    var state: RunPaneState by mutableStateOf(firstState())
        private set

    /**
     * For each robot in the world, the slot of the program that Run started, or would start, in this run, unless Prgm
     * was pressed.
     */
    val startedPrograms: List<Int> get() = run.firstSlots

    /** The files with which the robots began the run, by their names. */
    val filesAtStart: Map<String, List<NxtFile>> get() = run.filesAtStart

    /** The inputs of the run, including those after the current time. */
    val inputs: List<RecordedInput> get() = player.inputs

    /** The run that Run has started, once it is over; null for any other run. */
    internal val endedTry: EndedAttempt? get() = starter.tries.ended()

    fun handle(event: RunEvent) {
        when (event) {
            RunEvent.RunPressed -> starter.start(programs.slotToRun, StartAction.Play)
            RunEvent.StopPressed -> stop()
            RunEvent.PausePressed -> togglePause()
            is RunEvent.StepPressed -> step(event.kind)
            is RunEvent.RunToLine -> runTo(event.line)
            RunEvent.StartedOver -> starter.startOver()
            is RunEvent.SpeedChosen -> player.speed = event.speed
            is RunEvent.Scrubbed -> scrub(event.milliseconds)
            RunEvent.HearingSwitched -> switchHearing()
            is RunEvent.SampleRequested -> run.play(event.sample)
            is RunEvent.ShortfallShown -> showShortfall(event.shortfall)
            RunEvent.StoryRequested -> navigator.show(Pane.WORLD)
            is RunEvent.DebuggedRobotChosen -> stopLocation.choose(event.robot)
            RunEvent.RecordingPlayed -> starter.playRecording()
            is RunEvent.RunSettingsChanged -> services.editor.changeProjectSettings(event.settings)
            is RunEvent.ButtonPressed -> touch.press(event.button)
            is RunEvent.ButtonReleased -> touch.release(event.button)
            is RunEvent.SessionTouched -> touch.touch(event.input)
            is RunEvent.FrameChosen -> choose(event)
            is RunEvent.OfDrawer -> drawer.handle(event)
        }
        run.idleDetector.disturb()
        show()
    }

    /**
     * Runs [program] from where its robot stands, and shows the sheet. First ends the program that its robot runs. The
     * goals keep their progress until the run starts over.
     */
    internal fun runSnippet(program: Snippet) {
        val robot = run.world.robots.indexOfFirst { it.name == program.robot }
        if (robot < 0 || starter.isRefused()) return
        starter.cancel()
        starter.isUntouched = false
        starter.tries.leave()
        player.apply(SessionInput.RunSnippet(program, robot))
        player.play()
        navigator.show(Pane.WORLD)
        run.idleDetector.disturb()
        show()
    }

    /** Called when a program has changed. */
    fun programsChanged() {
        starter.cancel()
        show()
    }

    /** Called when the programs were compiled, or compilation failed or began. */
    fun programsCompiled(compileStatus: CompileStatus) {
        starter.programsCompiled(compileStatus)
        show()
    }

    /**
     * Called before each frame. [nanoseconds] is monotonic time; virtual time follows it while [RunPaneState.awake].
     */
    fun frame(nanoseconds: Long) {
        if (!state.awake) return player.pauseClock()
        player.frame(nanoseconds)
        run.detectIdle()
        run.playNewSounds()
        show()
        if (!state.awake) player.pauseClock()
    }

    /** Called before each frame in which time stands still, because something covers the sheet. */
    fun standStill() {
        player.pauseClock()
        run.silence()
    }

    /** What happened in the known run. */
    fun story(): RunStory = storyOf(run.world, player.history, player.outcome.goals)

    /** The known run, to be repeated elsewhere. */
    fun recorded(): RecordedRun = player.recorded()

    /** Advances virtual time by [milliseconds] at once, without sound. */
    fun advance(milliseconds: Int) {
        player.pass(milliseconds)
        run.detectIdle()
        run.skipSound()
        show()
    }

    /** Puts the robots into [world] with the current programs, and with [recording] for replay. */
    fun changeWorld(world: World, recording: List<RecordedInput> = emptyList()) {
        starter.changeWorld(world, recording)
        show(services.current.project.settings)
    }

    /** Shows the run's messages in [language], including earlier ones. */
    fun setLanguage(language: Language) {
        run.setLanguage(language)
        show()
    }

    /** The result of the run so far. */
    fun report(): RunReport = player.session.report()

    /** Plays a short tune for a solved task. */
    fun celebrate() = run.playTune()

    /** Turns all sound [on] or off, and whether the run [isHeard]. */
    fun setSound(on: Boolean, isHeard: Boolean) = run.setSound(on, isHeard)

    /** Releases the session. No function may be called afterwards. */
    fun close() = run.close()

    private fun stop() {
        starter.cancel()
        if (player.isInPast) {
            player.pause()
        } else {
            player.apply(SessionInput.Stop)
            player.play()
        }
    }

    private fun togglePause() {
        if (player.playback == PlaybackState.Paused || state.isSeeking) {
            resume { player.play() }
        } else {
            player.pause()
            run.silence()
        }
    }

    private fun step(kind: StepKind) = if (state.running) {
        drawer.willResume(player, isStep = true)
        player.step(kind, drawer.chosenThread)
    } else {
        starter.start(programs.slotToRun, StartAction.StopBeforeFirstStatement)
    }

    private fun runTo(line: Breakpoint) = if (state.running) {
        resume { player.play(line) }
    } else {
        starter.start(programs.slotToRun, StartAction.PlayTo(line))
    }

    private fun resume(how: () -> Unit) {
        drawer.willResume(player, isStep = false)
        how()
    }

    private fun scrub(milliseconds: Long) {
        player.seek(milliseconds)
        run.playMoment()
    }

    private fun switchHearing() = with(services.preferences) {
        val on = !settings.hearsRun
        change(settings.copy(hearsRun = on))
        if (!on) run.silence()
        notices.show(Notice.RunHeard(on, isMuted = on && !settings.soundOn))
    }

    private fun showShortfall(shortfall: GoalShortfall) {
        run.silence()
        shortfall.moment?.let { player.seek(it.milliseconds) }
        navigator.show(Pane.WORLD)
    }

    private fun choose(frame: RunEvent.FrameChosen) {
        drawer.handle(frame)
        stopLocation.frameChosen()
    }

    private fun firstState() = RunPaneState(
        run.world,
        player.state,
        drawer.state,
        hasRecording = starter.recording.isNotEmpty(),
        settings = services.current.project.settings,
    )

    private fun show(settings: ProjectSettings = state.settings) {
        stopLocation.watchShownRobot()
        run.update()
        if (run.keepFiles()) services.publish(ProjectRoomEvent.Touched)
        val frame = drawer.chosenFrame(player)
        stopLocation.showFile(frame)
        drawer.update(player)
        state = state.copy(
            world = run.world,
            session = player.state,
            drawn = player.drawn,
            changed = run.isChanged,
            down = touch.down,
            untouched = starter.isUntouched,
            playback = player.playback,
            speed = player.speed,
            time = player.time,
            length = player.length,
            marks = player.marks,
            calls = player.callLine,
            watched = player.watched,
            hasRecording = starter.recording.isNotEmpty(),
            settings = settings,
            outcome = player.outcome,
            drawer = drawer.state,
            frame = frame,
            snippetOf = run.world.robots.indices.map(run::snippet),
            awake = isAwake(),
        )
    }

    private fun isAwake(): Boolean = when (player.playback) {
        PlaybackState.Paused -> drawer.isBusy
        is PlaybackState.Stepping, is PlaybackState.Seeking -> true
        is PlaybackState.Playing -> player.isInPast || run.idleDetector.isAwake(player.state)
    }
}
