package robotran.simulation

import robotran.language.Language
import robotran.rcxrom.Brick
import robotran.rcxrom.log.RomLog
import robotran.rcxrom.memory.MemorySnapshot
import robotran.rcxrom.program.CallFrame
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.RuntimeWarning
import robotran.rcxrom.program.StepKind
import robotran.rcxrom.program.ThreadView
import robotran.rcxrom.program.VariableScope
import robotran.rcxrom.sound.SoundTrack
import robotran.simulation.config.SimulationLimits
import robotran.simulation.explain.DeviationCause
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.state.SessionState
import robotran.world.World

/**
 * Robots with their bricks and programs in a world, from switching them on. Time passes only in [advance], one tick of
 * 1 ms after the other: each brick's firmware, then its program, in the order of the robots; then the motors, and every
 * fifth tick the physics. The same world, programs and inputs at the same times give the same session, to the last bit,
 * on every target. Not to be used from two threads at once.
 *
 * One robot can be looked into, see [watched]. Its program can be stopped before any statement, by [stepStatement] and
 * [runUntilStop]. Several statements share a millisecond, so it may be stopped in the middle of one, which then ends as
 * soon as the session goes on or something is done to it. Stopping changes nothing about the session but when its time
 * passes.
 *
 * @param loads what the robots are given, in the world's order; those without one get no program.
 * @param language what goals, bricks and [explain] are told in; nothing that happens depends on it.
 */
class Session(
    val world: World,
    loads: List<RobotLoad>,
    physics: PhysicsEngine,
    val language: Language = Language.ENGLISH,
) {
    /**
     * A session in which only the first robot is given programs: [programs] are its brick's slots, Run starts that in
     * [firstSlot].
     */
    constructor(world: World, programs: List<RcxProgram?>, physics: PhysicsEngine, firstSlot: Int = 0) :
        this(world, listOf(RobotLoad(programs, firstSlot)), physics)

    private val running = SessionEngine(world, loads, physics, language)
    private val brick: Brick get() = running.robots[watched].brick
    private val recorded = mutableListOf<RecordedInput>()
    private var closed = false
    private var step: Stepping? = null

    /**
     * The number of the robot whose program can be stopped and looked into, and whose ROM calls and sounds these are.
     */
    var watched = 0
        set(number) {
            require(number in world.robots.indices) { "There is no robot $number." }
            endPause()
            field = number
        }

    /** Every ROM call of the program and the firmware of the robot that is [watched]. */
    val romLog: RomLog get() = brick.log

    /**
     * What the loudspeaker of its brick has played, at times of [SessionState.milliseconds]; to be listened to at any
     * time, or never.
     */
    val sounds: SoundTrack get() = brick.sounds

    /** Everything that was done to the session so far, in order; with it [replay] makes the same session again. */
    val inputs: List<RecordedInput> get() = recorded.toList()

    /** Virtual time since the session began; the same as in [state], but cheaper. */
    val milliseconds: Long get() = running.milliseconds

    /** Whether a program runs that can be looked into; the same as whether there are [threads], but cheaper. */
    val isDebuggable: Boolean get() = brick.debuggableRun != null

    /** Whether the program was stopped in the middle of a millisecond. */
    val isPaused: Boolean get() = brick.isPaused

    /** Whether the program that runs stands before one of its statements, so that the line about to run is known. */
    val isBeforeStatement: Boolean get() = brick.debuggableRun?.isBeforeStatement == true

    /** The session as it is now. */
    val state: SessionState get() = running.state

    /**
     * A hash of where all robots and blocks are after every step of the physics and of every ROM call so far, as 16
     * hexadecimal digits.
     */
    val traceHash: String get() = running.traceHash

    /** The lines that [runUntilStop] and [stepStatement] stop before. */
    var breakpoints: Set<Breakpoint> = emptySet()

    /**
     * What the running program is in the middle of, the innermost first; empty if none runs that can be looked into.
     */
    val callStack: List<CallFrame> get() = brick.debuggableRun?.callStack.orEmpty()

    /** The variables that the innermost of [callStack] knows, its own first. */
    val variables: List<VariableScope> get() = brick.debuggableRun?.variables.orEmpty()

    /** The threads of the running program, in the order of their start; empty if none runs that can be looked into. */
    val threads: List<ThreadView> get() = brick.debuggableRun?.threads.orEmpty()

    /**
     * The variables that the place [frame] in the call stack of the thread with the number [thread] knows, see
     * [threads]; 0 is the innermost.
     */
    fun variablesOf(thread: Int, frame: Int): List<VariableScope> =
        brick.debuggableRun?.variablesOf(thread, frame).orEmpty()

    /** What a pupil should know about the running program or, if none runs, about the last one. */
    val remarks: List<RuntimeWarning> get() = brick.remarks

    /** Lets time pass, whatever the breakpoints. */
    fun advance(milliseconds: Int) {
        check(!closed) { "The session is closed." }
        repeat(milliseconds) { running.tick() }
    }

    /**
     * Lets the program make one step, and all the time pass that it takes, but [milliseconds] at most. The step is one
     * of the thread that is being executed; what others do meanwhile does not end it, unless its own thread cannot come
     * to that any more.
     */
    fun stepStatement(kind: StepKind, milliseconds: Int = SimulationLimits.LONGEST_STEP_MILLISECONDS): StopReason {
        step = brick.debuggableRun?.let { Stepping(it, breakpoints, kind, brick.isPaused) }
        return continueStep(milliseconds)
    }

    /**
     * Goes on with the step that was begun last, whose time was up, for [milliseconds] at most; one that is over is not
     * begun again.
     */
    fun continueStep(milliseconds: Int): StopReason =
        step?.let { advanceUntilStop(it, milliseconds) } ?: StopReason.Ended

    /**
     * Lets [milliseconds] pass, or less if the program comes to a breakpoint or to its end before. With no program, all
     * of them pass.
     */
    fun runUntilStop(milliseconds: Int): StopReason {
        val run = brick.debuggableRun
        if (run != null) return advanceUntilStop(Stepping(run, breakpoints), milliseconds)
        advance(milliseconds)
        return StopReason.TimeUp
    }

    /**
     * Does something to the session from outside, between two ticks. Lengths, angles and amounts count in thousandths.
     */
    fun apply(input: SessionInput) {
        endPause()
        val exact = input.inThousandths()
        recorded += RecordedInput(running.milliseconds, exact)
        running.apply(exact)
    }

    /**
     * What has made the robots stray so far and their sensors err, robot by robot; what did next to nothing is left
     * out.
     */
    fun explain(): List<DeviationCause> = running.explain()

    /** What the brick's memory holds now. */
    fun memory(): MemorySnapshot = brick.memory()

    /**
     * The run is over, nothing more is to come that counts for the world's goals: those are decided now and for good.
     * Time may go on to pass.
     */
    fun finish() = running.finish()

    /** Frees what the physics holds. The session can still be looked at, but not go on. */
    fun close() {
        if (!closed) running.close()
        closed = true
    }

    private fun advanceUntilStop(stepping: Stepping, milliseconds: Int): StopReason {
        check(!closed) { "The session is closed." }
        val run = stepping.run
        val end = running.milliseconds + milliseconds
        run.watch = stepping.takeIf { it.canStop }
        while (running.milliseconds < end && stepping.reason == null && brick.debuggableRun === run) running.tick()
        run.watch = null
        return stepping.reason ?: if (brick.debuggableRun === run) StopReason.TimeUp else StopReason.Ended
    }

    /** Ends a millisecond that the program was stopped in the middle of. */
    private fun endPause() {
        if (brick.isPaused) running.tick()
    }

    companion object {
        /** A new session to which [inputs], in the order of their times, are done again, after [milliseconds]. */
        fun replay(
            world: World,
            loads: List<RobotLoad>,
            physics: PhysicsEngine,
            inputs: List<RecordedInput>,
            milliseconds: Long,
            language: Language = Language.ENGLISH,
        ): Session {
            val session = Session(world, loads, physics, language)
            inputs.filter { it.milliseconds <= milliseconds }.forEach { recorded ->
                session.advanceTo(recorded.milliseconds)
                session.apply(recorded.input)
            }
            session.advanceTo(milliseconds)
            return session
        }
    }

    private fun advanceTo(time: Long) {
        while (running.milliseconds < time) advance(1)
    }
}
