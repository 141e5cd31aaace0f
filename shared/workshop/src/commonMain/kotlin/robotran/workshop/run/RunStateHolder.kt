package robotran.workshop.run

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.brick.controls.BrickButton
import robotran.brick.program.StepKind
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.nxt.storage.NxtFile
import robotran.runcontrol.IdleDetector
import robotran.runcontrol.PlaybackState
import robotran.runcontrol.RecordedRun
import robotran.runcontrol.RunPlayer
import robotran.runcontrol.RunSpeed
import robotran.simulation.Breakpoint
import robotran.simulation.RecordedInput
import robotran.simulation.RunReport
import robotran.simulation.SessionInput
import robotran.simulation.StopReason
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.report
import robotran.simulation.startInputs
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
import robotran.world.robot.draftError

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
    private var recording: List<RecordedInput> = emptyList(),
) {
    private val navigator = services.navigator
    private val notices = services.notices
    private val run = DebuggedRun(world, physics, programs, services.platform.speaker, services.preferences, notices)
    private val idleDetector = IdleDetector()
    private val drawer =
        DrawerStateHolder(services.platform, services.scope, notices, navigator, run.player.watchedBrick) {
            programs.shownProgram.name
        }
    private val stopLocation = StopLocation(programs)
    private var pendingStart: PendingStart? = null
    private var seenStop: StopReason? = null

    private val tries = AttemptRecorder(run)
    private val escape = LoneEscape()

    /** The programs that were started in the [recording], whichever are shown since. */
    private var recordedSlots = run.firstSlots

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
    internal val endedTry: EndedAttempt? get() = tries.ended()

    fun handle(event: RunEvent) {
        when (event) {
            RunEvent.RunPressed -> play()
            RunEvent.StopPressed -> stop()
            RunEvent.PausePressed -> togglePause()
            is RunEvent.StepPressed -> step(event.kind)
            is RunEvent.RunToLine -> runTo(event.line)
            RunEvent.StartedOver -> startOver()
            is RunEvent.SpeedChosen -> choose(event.speed)
            is RunEvent.Scrubbed -> player.seek(event.milliseconds)
            is RunEvent.ShortfallShown -> showShortfall(event.shortfall)
            is RunEvent.DebuggedRobotChosen -> choose(event.robot)
            RunEvent.RecordingPlayed -> playRecording()
            is RunEvent.RunSettingsChanged -> services.editor.changeProjectSettings(event.settings)
            is RunEvent.ButtonPressed -> press(event.button)
            is RunEvent.ButtonReleased -> release(event.button)
            is RunEvent.SessionTouched -> touch(event.input)
            is RunEvent.FrameChosen -> choose(event)
            is RunEvent.OfDrawer -> drawer.handle(event)
        }
        idleDetector.disturb()
        show()
    }

    /**
     * Runs [program] from where its robot stands, and shows the sheet. First ends the program that its robot runs. The
     * goals keep their progress until the run starts over.
     */
    internal fun runSnippet(program: Snippet) {
        val robot = run.world.robots.indexOfFirst { it.name == program.robot }
        if (robot < 0 || isRefused()) return
        pendingStart = null
        state = state.copy(untouched = false)
        tries.leave()
        player.apply(SessionInput.RunSnippet(program, robot))
        player.play()
        navigator.show(Pane.WORLD)
        idleDetector.disturb()
        show()
    }

    /** Called when a program has changed. */
    fun programsChanged() {
        pendingStart = null
        show()
    }

    /** Called when the programs were compiled, or compilation failed or began. */
    fun programsCompiled(compileStatus: CompileStatus) {
        if (compileStatus.isOver && compileStatus != CompileStatus.DONE) pendingStart = null
        if (compileStatus == CompileStatus.DONE) {
            if (state.untouched) startNewRun(run.slotOnBrick)
            pendingStart?.let { start(it.slot, it.what) }
        }
        show()
    }

    /**
     * Called before each frame. [nanoseconds] is monotonic time; virtual time follows it while [RunPaneState.awake].
     */
    fun frame(nanoseconds: Long) {
        if (!state.awake) return player.pauseClock()
        player.frame(nanoseconds)
        detectIdle()
        run.playNewSounds()
        show()
        if (!state.awake) player.pauseClock()
    }

    /** Called before each frame in which time stands still, because something covers the sheet. */
    fun standStill() {
        player.pauseClock()
        run.silence()
    }

    /** The known run, to be repeated elsewhere. */
    fun recorded(): RecordedRun = player.recorded()

    /** Advances virtual time by [milliseconds] at once, without sound. */
    fun advance(milliseconds: Int) {
        player.pass(milliseconds)
        detectIdle()
        run.skipSound()
        show()
    }

    /** Puts the robots into [world] with the current programs, and with [recording] for replay. */
    fun changeWorld(world: World, recording: List<RecordedInput> = emptyList()) {
        this.recording = recording
        startNewRun(programs.slotsBeginning(programs.slotToRun), world)
        recordedSlots = run.firstSlots
        state =
            state.copy(
                untouched = true,
                hasRecording = recording.isNotEmpty(),
                settings = services.current.project.settings,
            )
        idleDetector.disturb()
        show()
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

    /** Turns the brick's sound on or off. */
    fun setSound(on: Boolean) = run.setSound(on)

    /** Releases the session. No function may be called afterwards. */
    fun close() = run.close()

    /**
     * Presses Run on an empty sheet with the program in [slot], and then performs [what]. Waits until the program is
     * compiled.
     */
    private fun start(slot: Int, what: StartAction) {
        if (isRefused()) return
        pendingStart = if (programs.isCompiled(slot)) null else PendingStart(slot, what)
        if (!programs.canStart(slot)) return
        startNewRun(slot)
        tries.begin()
        state = state.copy(untouched = false)
        run.world.startInputs().forEach(player::apply)
        when (what) {
            StartAction.Play, StartAction.PlayFromBrick -> player.play()
            StartAction.StopBeforeFirstStatement -> stopBeforeFirstStatement()
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
        start(programs.slotToRun, StartAction.StopBeforeFirstStatement)
    }

    /** Java loads its classes before the first statement. Until then there is no line to show. */
    private fun stopBeforeFirstStatement() =
        if (player.session.isBeforeStatement) player.pause() else player.step(StepKind.INTO)

    private fun runTo(line: Breakpoint) =
        if (state.running) resume { player.play(line) } else start(programs.slotToRun, StartAction.PlayTo(line))

    private fun resume(how: () -> Unit) {
        drawer.willResume(player, isStep = false)
        how()
    }

    private fun startOver() {
        pendingStart = null
        startNewRun(run.slotOnBrick)
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

    private fun choose(speed: RunSpeed) {
        player.speed = speed
        state = state.copy(speed = speed)
    }

    private fun choose(robot: Int) {
        val chosen = run.world.robots.getOrNull(robot) ?: return
        programs.showRobot(chosen.name)
    }

    /** The brick, the status and the debugger are those of the robot whose program is shown. */
    private fun watchShownRobot() {
        val stopped = (player.stop as? StopReason.Breakpoint)?.takeIf { it !== seenStop }
        seenStop = player.stop
        if (stopped != null) choose(stopped.robot)
        val robot = run.world.robots.indexOfFirst { it.name == programs.shownRobot }
        if (robot < 0 || robot == player.watched) return
        run.watch(robot)
        drawer.startNewRun()
        state = state.copy(watched = robot)
    }

    /** Tells why, if a robot is impossible. */
    private fun isRefused(): Boolean {
        val draft = draftError(run.world) ?: return false
        pendingStart = null
        notices.show(Notice.RobotImpossible(draft))
        return true
    }

    private fun playRecording() {
        if (recording.isEmpty() || isRefused()) return
        startNewRun(recordedSlots, inputs = recording)
        state = state.copy(untouched = false)
        navigator.show(Pane.WORLD)
    }

    private fun press(button: BrickButton) {
        escape.pressed(button, isRunning = state.brick.run is RunState.Running)
        state = state.copy(down = state.down + button)
        val isStart = button == state.brick.kind.startButton
        if (isStart && state.brick.run !is RunState.Running && isRefused()) return
        if (isStart && state.brick.run !is RunState.Running && state.changed) {
            val slot = run.slotOnBrick
            pendingStart = if (programs.isCompiled(slot)) null else PendingStart(slot, StartAction.PlayFromBrick)
            if (!programs.canStart(slot)) return
            startNewRun(slot)
        }
        if (isStart) {
            state = state.copy(untouched = false)
            tries.goOn()
        }
        touch(SessionInput.Press(button, state.watched))
    }

    private fun release(button: BrickButton) {
        state = state.copy(down = state.down - button)
        touch(SessionInput.Release(button, state.watched))
        val isRunning = state.brick.run is RunState.Running
        if (escape.released(button, isRunning) && !readsButtons()) notices.show(Notice.EscapeAlone)
    }

    /** Whether the shown program may wait for ESCAPE itself; told by its text. */
    private fun readsButtons(): Boolean = programs.shownProgram.files.any { file ->
        BUTTON_WORDS.any { file.text.contains(it, ignoreCase = true) }
    }

    private fun touch(input: SessionInput) {
        player.apply(input)
        // A brick that is off, or waits for a button, cannot respond while time is paused.
        if (player.playback == PlaybackState.Paused && !state.running) player.play()
    }

    private fun firstState() = RunPaneState(
        run.world,
        player.state,
        drawer.state,
        hasRecording = recording.isNotEmpty(),
        settings = services.current.project.settings,
    )

    private fun startNewRun(slot: Int) = startNewRun(programs.slotsBeginning(slot))

    private fun startNewRun(
        firstSlots: List<Int>,
        world: World = run.world,
        inputs: List<RecordedInput> = emptyList(),
    ) {
        run.startNewRun(firstSlots, world, inputs)
        escape.forget()
        tries.leave()
        idleDetector.disturb()
        state = state.copy(watched = player.watched)
        drawer.startNewRun()
        show()
    }

    private fun show() {
        watchShownRobot()
        run.update()
        if (run.keepFiles()) services.publish(ProjectRoomEvent.Touched)
        val frame = drawer.chosenFrame(player)
        if (!run.isChanged) stopLocation.update(player, run.world.robots[player.watched].name, frame)
        drawer.update(player)
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
            outcome = player.outcome,
            drawer = drawer.state,
            frame = frame,
            snippetOf = run.world.robots.indices.map(run::snippet),
            awake = isAwake(),
        )
    }

    /** While seeking, the shown state may be slightly old, so there is nothing to detect. */
    private fun detectIdle() {
        if (player.playback !is PlaybackState.Seeking) idleDetector.passed(player.state)
    }

    private fun isAwake(): Boolean = when (player.playback) {
        PlaybackState.Paused -> drawer.isBusy
        is PlaybackState.Stepping, is PlaybackState.Seeking -> true
        is PlaybackState.Playing -> player.isInPast || idleDetector.isAwake(player.state)
    }
}
