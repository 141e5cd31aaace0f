package robotran.runcontrol

import robotran.language.Language
import robotran.rcxrom.program.StepKind
import robotran.rcxrom.sound.SoundTrack
import robotran.simulation.Breakpoint
import robotran.simulation.RecordedInput
import robotran.simulation.RobotLoad
import robotran.simulation.Session
import robotran.simulation.SessionInput
import robotran.simulation.StopReason
import robotran.simulation.state.SessionState

/**
 * A run that is watched: played at any [speed], stopped, stepped through, and gone through back and forth. It is at one
 * [time] of what is known of it, up to [length]. Going back begins a new session and does to it what was done before,
 * as far as the time wanted, which gives the same run to the last bit; while that is being computed, [state] is what
 * was kept of that time. Whatever is done to the run in the past begins a new future, and the old one is gone. It has
 * no clock and no thread: whoever draws the frames tells it of each, see [frame]. Not to be used from two threads at
 * once.
 *
 * @param recording what is done to the run from its beginning, as in a project that was saved with its inputs.
 */
class RunPlayer(private var setup: RunSetup, recording: List<RecordedInput> = emptyList()) {
    private val whole = recording.toMutableList()
    private var record = RunRecord(setup.world)

    /** What is shown of the run while it is made once more in another language; null if it is not. */
    private var retelling: Retelling? = null
    private val pace = FramePace()
    private val smooth = SmoothMotion()
    private var take = SessionCursor(setup, watched = 0)
    private val parked = SessionCheckpoints()
    private val waiting = mutableListOf<SessionInput>()
    private var isStepBegun = false

    /** What it is doing. */
    var playback: PlaybackState = PlaybackState.Playing()
        private set

    /** How fast virtual time passes while it plays or steps. */
    var speed: RunSpeed = RunSpeed.REAL_TIME

    /** The lines to stop before. */
    var breakpoints: Set<Breakpoint> = emptySet()

    /** Why it stands still; null if it does not, or because somebody wanted it to. */
    var stop: StopReason? = null
        private set

    /** How often a new future has begun in the past. */
    var branchCount = 0
        private set

    /**
     * The robot whose program is stopped and looked into, and whose ROM calls and sounds these are; its number in the
     * world.
     */
    var watched = 0
        set(number) {
            field = number
            (parked.all + take).forEach { it.session.watched = number }
            see()
        }

    /** The session at [time], to be looked into but not changed; while it seeks, one that is somewhere else. */
    val session: Session get() = take.session

    /** The run at [time]; while it seeks, at a moment shortly before it. */
    val state: SessionState
        get() = (playback as? PlaybackState.Seeking)?.let { shown.at(retelling?.time ?: it.target) } ?: session.state

    /** The run as it is best drawn: [state], but in slow motion with what moves between the steps of the physics. */
    val drawn: SessionState get() = if (isSmooth) smooth.at(session.state, pace.fraction) else state

    /** Where in the run it is, in milliseconds. */
    val time: Long get() = retelling?.time ?: (playback as? PlaybackState.Seeking)?.target ?: take.milliseconds

    /** How much of the run is known, in milliseconds. */
    val length: Long get() = maxOf(shown.end, take.milliseconds, whole.lastOrNull()?.milliseconds ?: 0)

    /** How far the way to another time has been gone, 0..1; 1 if it is not on one. */
    val progress: Double
        get() = (playback as? PlaybackState.Seeking)?.let {
            if (it.target ==
                0L
            ) {
                1.0
            } else {
                take.milliseconds.toDouble() / it.target
            }
        }
            ?: 1.0

    /** Whether the run had gone on from here before. */
    val isInPast: Boolean get() = time < length

    /** Everything that is done to the run, also after [time]. */
    val inputs: List<RecordedInput> get() = whole.toList()

    /** What has happened in the run so far, also after [time]; the same list as long as that does not change. */
    val marks: List<TimelineMark> get() = shown.timeline

    /** What the brick of the robot that is [watched] has played up to where [session] is. */
    val sounds: SoundTrack get() = session.sounds

    /** The ROM calls of the robot that is [watched], up to [state]. */
    val romCalls: RomCalls get() = RomCalls(front.session.romLog, state.robots[watched].romCalls.toLong())

    /** The chart of [lane] for the robot that is [watched], over the whole run that is known. */
    fun chart(lane: ChartLane): ChartLine = ChartLine(shown.chart, watched, lane)

    /** When the robot that is [watched] makes its ROM calls, over the whole run that is known. */
    val callLine: RomCallLine get() = RomCallLine(shown.calls, watched)

    /** A picture is about to be drawn, at [nanoseconds] of a clock that only goes forwards. */
    fun frame(nanoseconds: Long) {
        if (playback == PlaybackState.Paused) return pace.rest()
        pass(pace.millisecondsTo(nanoseconds, if (playback is PlaybackState.Seeking) RunSpeed.FASTEST else speed))
    }

    /** Nothing is to be seen for a while: no time passes until the frame after the next. */
    fun rest() = pace.rest()

    /** Lets [milliseconds] pass, or less if it stops before; nothing if it stands still. */
    fun pass(milliseconds: Int) {
        when (val now = playback) {
            PlaybackState.Paused -> Unit
            is PlaybackState.Playing -> play(now, milliseconds)
            is PlaybackState.Stepping -> step(now, milliseconds)
            is PlaybackState.Seeking -> seekOn(now, milliseconds)
        }
    }

    /** Time passes, up to [until] if a line is given. */
    fun play(until: Breakpoint? = null) = move(PlaybackState.Playing(until))

    /** Time stands still. */
    fun pause() = move(PlaybackState.Paused)

    /** The program makes one step, at [speed]; with no program, time stands still. */
    fun step(kind: StepKind) {
        isStepBegun = false
        move(PlaybackState.Stepping(kind))
    }

    /** Goes to another [time], 0..[length], and stands still there; what is beyond counts as the nearest. */
    fun seek(time: Long) {
        val target = time.coerceIn(0, length)
        stop = null
        waiting.clear()
        retelling?.let {
            retelling = it.copy(time = target)
            playback = PlaybackState.Seeking(shown.end, PlaybackState.Paused)
            return
        }
        chooseTake(target)
        playback = PlaybackState.Seeking(target, PlaybackState.Paused)
        seekOn(PlaybackState.Seeking(target, PlaybackState.Paused), 0)
    }

    /** Comes to the end of a way to another time at once, however long that takes. */
    fun arriveNow() {
        while (playback is PlaybackState.Seeking) pass(ARRIVING_MILLISECONDS)
    }

    /**
     * Tells the run in [language] from now on, also what has happened in it so far: it is made once more in the
     * background, while what was known of it stays to be seen, and goes on where it was.
     *
     * @param loads what the robots were given, telling in that language.
     */
    fun speak(language: Language, loads: List<RobotLoad> = setup.loads) {
        if (language == setup.language) return
        setup = setup.telling(language, loads)
        val then = (playback as? PlaybackState.Seeking)?.then ?: playback
        retelling = Retelling(shown, time)
        record = RunRecord(setup.world)
        parked.closeAll()
        take.close()
        take = SessionCursor(setup, watched)
        // As it was before anything was done to it.
        see()
        arrive()
        playback = PlaybackState.Seeking(length, then)
        seekOn(PlaybackState.Seeking(length, then), 0)
    }

    /** Does something to the run from outside; on the way to another time, once it is reached. */
    fun apply(input: SessionInput) {
        if (playback is PlaybackState.Seeking) {
            waiting += input
            return
        }
        if (isInPast || take.applied < whole.size) beginNewFuture()
        session.apply(input)
        whole += session.inputs.last()
        take.applied = whole.size
        see()
        smooth.jump()
    }

    /** Frees what the physics holds. Nothing may be called afterwards. */
    fun close() {
        parked.close()
        take.close()
    }

    init {
        arrive()
    }

    /** What is shown of the run as a whole. */
    private val shown: RunRecord get() = retelling?.record ?: record

    private val isSmooth: Boolean
        get() = speed.isSlow && (playback is PlaybackState.Playing || playback is PlaybackState.Stepping)

    /** The take that has come furthest. */
    private val front: SessionCursor get() = parked.furthest?.takeIf { it.milliseconds > take.milliseconds } ?: take

    private fun move(next: PlaybackState) {
        stop = null
        val now = playback
        if (now == PlaybackState.Paused) pace.rest()
        playback = if (now is PlaybackState.Seeking) now.copy(then = next) else next
        smooth.jump()
    }

    private fun play(now: PlaybackState.Playing, milliseconds: Int) =
        go(milliseconds) { part -> take.run(part, breakpoints + listOfNotNull(now.until)) }

    private fun step(now: PlaybackState.Stepping, milliseconds: Int) {
        go(milliseconds) { part -> take.step(now.kind, isStepBegun, part, breakpoints).also { isStepBegun = true } }
    }

    private fun seekOn(now: PlaybackState.Seeking, milliseconds: Int) {
        go(minOf(milliseconds.toLong(), now.target - take.milliseconds).toInt()) { part -> take.run(part, emptySet()) }
        if (take.milliseconds < now.target) return
        retelling?.let {
            retelling = null
            chooseTake(it.time)
            playback = now.copy(target = it.time)
            return seekOn(now.copy(target = it.time), 0)
        }
        playback = now.then
        pace.rest()
        val come = waiting.toList()
        waiting.clear()
        come.forEach(::apply)
    }

    /**
     * Lets [milliseconds] pass in parts, each by [run], with nothing due within any of them, until one has a reason to
     * stop.
     */
    private fun go(milliseconds: Int, run: (Int) -> StopReason?) {
        val end = take.milliseconds + milliseconds
        arrive()
        while (take.milliseconds < end) {
            val reason = run((minOf(end, nextEvent()) - take.milliseconds).toInt())
            see()
            if (reason != null) return stand(reason)
            arrive()
        }
    }

    private fun stand(reason: StopReason) {
        arrive()
        playback = PlaybackState.Paused
        stop = reason
    }

    /** When it has to be looked or something has to be done next, after now. */
    private fun nextEvent(): Long {
        val now = take.milliseconds
        val look = if (now <
            record.end
        ) {
            record.end
        } else {
            now - now % RunRecord.LOOK_MILLISECONDS + RunRecord.LOOK_MILLISECONDS
        }
        val input = whole.getOrNull(take.applied)?.milliseconds ?: Long.MAX_VALUE
        val finish = record.finished?.takeIf { it > now } ?: Long.MAX_VALUE
        val step = if (isSmooth) smooth.nextStep(now) else Long.MAX_VALUE
        return minOf(minOf(look, input), minOf(finish, step)).coerceAtLeast(now + 1)
    }

    /** Sees what has become of the run. */
    private fun see() {
        val wasFinished = record.finished
        record.look(take.milliseconds) { session.state }
        if (isSmooth) smooth.look(session.state)
        if (record.finished != wasFinished) {
            take.doWhatIsDue(whole, record.finished)
            record.lookAgain(session.state)
        }
    }

    /** Does what is due now. */
    private fun arrive() {
        if (!session.isPaused) take.doWhatIsDue(whole, record.finished)
        see()
    }

    /** Goes on from the session that is nearest to [target]. */
    private fun chooseTake(target: Long) {
        val isBest = take.leadsTo(target)
        val next =
            parked.take(target, after = if (isBest) take.milliseconds else -1)
                ?: if (isBest) return else SessionCursor(setup, watched)
        // One that was only on its way somewhere is of no use to come back to.
        if (playback is PlaybackState.Seeking && front !== take) take.close() else parked.park(take)
        take = next
    }

    private fun beginNewFuture() {
        while (whole.size > take.applied) whole.removeLast()
        parked.closeAfter(take)
        record.cutAt(session.state)
        branchCount++
    }

    /** A run of which [record] is known, and which was at [time] when it began to be made once more. */
    private data class Retelling(val record: RunRecord, val time: Long)

    private companion object {
        const val ARRIVING_MILLISECONDS = 1_000
    }
}
