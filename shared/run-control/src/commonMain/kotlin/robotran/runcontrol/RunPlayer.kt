package robotran.runcontrol

import robotran.brick.program.BrickProgram
import robotran.brick.program.StepKind
import robotran.brick.sound.SoundTrack
import robotran.language.Language
import robotran.simulation.Breakpoint
import robotran.simulation.RecordedInput
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.SessionInput
import robotran.simulation.StopReason
import robotran.simulation.state.SessionState

/**
 * Plays a run at any [speed], pauses it, steps through it and seeks in it. [time] is the current position in the known
 * part of the run, which ends at [length]. To seek backwards, the player starts a new session and repeats the inputs up
 * to the target, which gives the same run to the last bit; meanwhile [state] is a recorded state of that time. An input
 * in the past starts a new branch and discards the old future. The player has no clock and no thread: the caller
 * reports each frame, see [frame]. When the task of the world is completed, which nothing can undo then, or its time is
 * up, the player pauses, even if the program would go on. Not thread-safe.
 *
 * @param recording the inputs from the start of the run, as in a project saved with its inputs.
 */
class RunPlayer(private var setup: RunSetup, recording: List<RecordedInput> = emptyList()) {
    private val recordedInputs = recording.toMutableList()
    private var record = RunRecord(setup.world)

    /** What to show while the run is recomputed in another language; null otherwise. */
    private var recomputation: Recomputation? = null
    private val pace = FramePace()
    private val smooth = SmoothMotion()
    private var cursor = SessionCursor(setup, watched = 0)
    private val checkpoints = SessionCheckpoints()
    private val waiting = mutableListOf<SessionInput>()
    private var isStepBegun = false

    /** Whether the task has just been completed or its time is just up, so that time stops. */
    private var pausesNow = false

    var playback: PlaybackState = PlaybackState.Playing()
        private set

    /** The speed of virtual time during playing and stepping. */
    var speed: RunSpeed = RunSpeed.REAL_TIME

    /** The lines at which to stop. */
    var breakpoints: Set<Breakpoint> = emptySet()

    /** The same for the programs of robots that are not [watched], by the index of the robot; none is empty. */
    var otherBreakpoints: Map<Int, Set<Breakpoint>> = emptyMap()

    /** Why the run stopped; null if it is running or the user paused it. */
    var stop: StopReason? = null
        private set

    /**
     * Called with the state every 10 ms of virtual time while the run plays or steps, also in its known part; null for
     * nobody, which costs nothing.
     */
    var onLook: ((SessionState) -> Unit)? = null

    /** Number of branches started in the past. */
    var branchCount = 0
        private set

    /** Index of the robot to debug; its log and sounds are available here. */
    var watched = 0
        set(number) {
            field = number
            (checkpoints.all + cursor).forEach { it.session.watched = number }
            recordState()
        }

    /** The session at [time], read-only; during seeking, a session at another time. */
    val session: Session get() = cursor.session

    /** The state at [time]; during seeking, a recorded state shortly before it. */
    val state: SessionState
        get() = (playback as? PlaybackState.Seeking)?.let { shown.at(recomputation?.time ?: it.target) }
            ?: session.state

    /** The state to draw: [state], in slow motion with positions interpolated between physics steps. */
    val drawn: SessionState get() = if (isSmooth) smooth.at(session.state, pace.fraction) else state

    /** The position in the run, in milliseconds. */
    val time: Long get() = recomputation?.time ?: (playback as? PlaybackState.Seeking)?.target ?: cursor.milliseconds

    /** The length of the known part of the run, in milliseconds. */
    val length: Long get() = maxOf(shown.end, cursor.milliseconds, recordedInputs.lastOrNull()?.milliseconds ?: 0)

    /** Progress of seeking, 0..1; 1 if not seeking. */
    val progress: Double
        get() = (playback as? PlaybackState.Seeking)?.let {
            if (it.target == 0L) 1.0 else cursor.milliseconds.toDouble() / it.target
        } ?: 1.0

    /** Whether the known run continues after [time]. */
    val isInPast: Boolean get() = time < length

    /** The goals at the end of the known run. */
    val outcome: RunOutcome get() = RunOutcome(shown.goals, shown.finished, shown.traceHash)

    /** All inputs of the run, including those after [time]. */
    val inputs: List<RecordedInput> get() = recordedInputs.toList()

    /** The known run, to be repeated elsewhere. */
    fun recorded(): RecordedRun = RecordedRun(setup, inputs, length)

    /** The program that [robot] got to run at once, if at [time] it runs or was the last one to run; otherwise null. */
    fun snippet(robot: Int): BrickProgram? {
        if (!state.robots[robot].brick.isSnippet) return null
        val now = time
        val input =
            recordedInputs.lastOrNull {
                it.milliseconds <= now && (it.input as? SessionInput.RunSnippet)?.robot == robot
            }
        return (input?.input as? SessionInput.RunSnippet)?.program
    }

    /** All events of the known run, including those after [time]; the same list until that changes. */
    val marks: List<TimelineMark> get() = shown.timeline

    /** The known run in states at equal intervals, a bounded number of them. */
    val history: List<SessionState> get() = shown.history

    /** The sounds of the [watched] robot's brick up to the time of [session]. */
    val sounds: SoundTrack get() = session.sounds

    /** The ROM calls of the [watched] robot up to [state]. */
    val romCalls: RomCalls get() = RomCalls(front.session.callLog, state.robots[watched].romCalls.toLong())

    /** The chart of [lane] for the [watched] robot, over the whole known run. */
    fun chart(lane: ChartLane): ChartLine = ChartLine(shown.chart, watched, lane)

    /** The ROM call counts of the [watched] robot, over the whole known run. */
    val callLine: CallCountLine get() = CallCountLine(shown.calls, watched)

    /** Call before drawing each frame, with the [nanoseconds] of a monotonic clock. */
    fun frame(nanoseconds: Long) {
        if (playback == PlaybackState.Paused) return pace.pauseClock()
        pass(pace.millisecondsTo(nanoseconds, if (playback is PlaybackState.Seeking) RunSpeed.FASTEST else speed))
    }

    /** Call when nothing is visible for a while: no time passes until the frame after the next. */
    fun pauseClock() = pace.pauseClock()

    /** Advances by [milliseconds], or less if the run stops earlier; does nothing while paused. */
    fun pass(milliseconds: Int) {
        when (val now = playback) {
            PlaybackState.Paused -> Unit
            is PlaybackState.Playing -> play(now, milliseconds)
            is PlaybackState.Stepping -> step(now, milliseconds)
            is PlaybackState.Seeking -> seekOn(now, milliseconds)
        }
    }

    /** Plays the run, up to line [until] unless null. */
    fun play(until: Breakpoint? = null) = move(PlaybackState.Playing(until))

    fun pause() {
        pausesNow = false
        move(PlaybackState.Paused)
    }

    /**
     * Steps the program, at [speed]; without a program, pauses.
     *
     * @param thread the number of the thread that steps; null for the current one.
     */
    fun step(kind: StepKind, thread: Int? = null) {
        isStepBegun = false
        move(PlaybackState.Stepping(kind, thread))
    }

    /** Seeks to [time], clamped to 0..[length], and pauses there. */
    fun seek(time: Long) {
        val target = time.coerceIn(0, length)
        stop = null
        waiting.clear()
        recomputation?.let {
            recomputation = it.copy(time = target)
            playback = PlaybackState.Seeking(shown.end, PlaybackState.Paused)
            return
        }
        chooseCursor(target)
        playback = PlaybackState.Seeking(target, PlaybackState.Paused)
        seekOn(PlaybackState.Seeking(target, PlaybackState.Paused), 0)
    }

    /** Completes seeking at once, however long that takes. */
    fun finishSeeking() {
        while (playback is PlaybackState.Seeking) pass(SEEK_CHUNK_MILLISECONDS)
    }

    /**
     * Switches the texts of the run to [language], including past ones: recomputes the run in the background, shows the
     * known part meanwhile, and continues at the current time.
     *
     * @param loads the same programs, with texts in that language.
     */
    fun setLanguage(language: Language, loads: List<RobotProgramSet> = setup.loads) {
        if (language == setup.language) return
        setup = setup.telling(language, loads)
        val then = (playback as? PlaybackState.Seeking)?.then ?: playback
        recomputation = Recomputation(shown, time)
        record = RunRecord(setup.world)
        checkpoints.closeAll()
        cursor.close()
        cursor = SessionCursor(setup, watched)
        // The state before any input.
        recordState()
        applyDueInputs()
        playback = PlaybackState.Seeking(length, then)
        seekOn(PlaybackState.Seeking(length, then), 0)
    }

    /** Applies an external input; during seeking, once the target is reached. */
    fun apply(input: SessionInput) {
        if (playback is PlaybackState.Seeking) {
            waiting += input
            return
        }
        if (isInPast || cursor.applied < recordedInputs.size) startBranch()
        session.apply(input)
        recordedInputs += session.inputs.last()
        cursor.applied = recordedInputs.size
        recordState()
        smooth.jump()
    }

    /** Releases the physics. The player must not be used afterwards. */
    fun close() {
        checkpoints.close()
        cursor.close()
    }

    init {
        applyDueInputs()
    }

    /** The record to show. */
    private val shown: RunRecord get() = recomputation?.record ?: record

    private val isSmooth: Boolean
        get() = speed.isSlow && (playback is PlaybackState.Playing || playback is PlaybackState.Stepping)

    /** The session that has advanced furthest. */
    private val front: SessionCursor get() = checkpoints.furthest?.takeIf { it.milliseconds > cursor.milliseconds }
        ?: cursor

    private fun move(next: PlaybackState) {
        stop = null
        val now = playback
        if (now == PlaybackState.Paused) pace.pauseClock()
        playback = if (now is PlaybackState.Seeking) now.copy(then = next) else next
        smooth.jump()
    }

    private fun play(now: PlaybackState.Playing, milliseconds: Int) =
        advance(milliseconds) { part -> cursor.run(part, breakpoints + listOfNotNull(now.until), otherBreakpoints) }

    private fun step(now: PlaybackState.Stepping, milliseconds: Int) {
        advance(milliseconds) { part ->
            cursor.step(now, isStepBegun, part, breakpoints, otherBreakpoints).also { isStepBegun = true }
        }
    }

    private fun seekOn(now: PlaybackState.Seeking, milliseconds: Int) {
        advance(minOf(milliseconds.toLong(), now.target - cursor.milliseconds).toInt()) { part -> cursor.run(part) }
        if (cursor.milliseconds < now.target) return
        recomputation?.let {
            recomputation = null
            chooseCursor(it.time)
            playback = now.copy(target = it.time)
            return seekOn(now.copy(target = it.time), 0)
        }
        playback = now.then
        pace.pauseClock()
        val pending = waiting.toList()
        waiting.clear()
        pending.forEach(::apply)
    }

    /**
     * Advances by [milliseconds] in parts, each by [run] and without scheduled events inside, until one returns a
     * reason to stop.
     */
    private fun advance(milliseconds: Int, run: (Int) -> StopReason?) {
        val end = cursor.milliseconds + milliseconds
        applyDueInputs()
        while (cursor.milliseconds < end) {
            val reason = run((minOf(end, nextEvent()) - cursor.milliseconds).toInt())
            recordState()
            if (onLook != null) look()
            if (reason != null) return stopAt(reason)
            applyDueInputs()
            if (pausesNow) return pause()
        }
    }

    private fun stopAt(reason: StopReason) {
        applyDueInputs()
        playback = PlaybackState.Paused
        stop = reason
    }

    /** The time of the next observation or scheduled input. */
    private fun nextEvent(): Long {
        val now = cursor.milliseconds
        val observation = if (now < record.end && onLook == null) {
            record.end
        } else {
            now - now % RunRecord.LOOK_MILLISECONDS + RunRecord.LOOK_MILLISECONDS
        }
        val input = recordedInputs.getOrNull(cursor.applied)?.milliseconds ?: Long.MAX_VALUE
        val finish = record.finished?.takeIf { it > now } ?: Long.MAX_VALUE
        val step = if (isSmooth) smooth.nextStep(now) else Long.MAX_VALUE
        return minOf(minOf(observation, input), minOf(finish, step)).coerceAtLeast(now + 1)
    }

    private fun look() {
        val isDue = cursor.milliseconds % RunRecord.LOOK_MILLISECONDS == 0L && playback !is PlaybackState.Seeking
        if (isDue) onLook?.invoke(session.state)
    }

    /** Records the current state of the run. */
    private fun recordState() {
        val wasFinished = record.finished
        record.record(cursor.milliseconds) { session.state }
        if (isSmooth) smooth.record(session.state)
        if (record.finished != wasFinished) {
            cursor.applyDueInputs(recordedInputs, record.finished)
            record.observeGoals(session.state)
            record.traceHash = session.traceHash
            pausesNow = record.isCutShort && playback !is PlaybackState.Seeking
        }
    }

    /** Handles the events scheduled for now. */
    private fun applyDueInputs() {
        if (!session.isPaused) cursor.applyDueInputs(recordedInputs, record.finished)
        recordState()
    }

    /** Continues from the session closest to [target]. */
    private fun chooseCursor(target: Long) {
        val isBest = cursor.canReach(target)
        val next =
            checkpoints.take(target, after = if (isBest) cursor.milliseconds else -1)
                ?: if (isBest) return else SessionCursor(setup, watched)
        // A session that was only seeking is of no use later.
        if (playback is PlaybackState.Seeking && front !== cursor) cursor.close() else checkpoints.park(cursor)
        cursor = next
    }

    private fun startBranch() {
        while (recordedInputs.size > cursor.applied) recordedInputs.removeLast()
        checkpoints.closeAfter(cursor)
        record.cutAt(session.state)
        branchCount++
    }

    /** A run that is being recomputed: its [record] so far, and the [time] to return to. */
    private data class Recomputation(val record: RunRecord, val time: Long)

    private companion object {
        const val SEEK_CHUNK_MILLISECONDS = 1_000
    }
}
