package robotran.simulation

import robotran.brick.Brick
import robotran.brick.log.CallLog
import robotran.brick.program.BrickProgram
import robotran.brick.program.CallFrame
import robotran.brick.program.RuntimeWarning
import robotran.brick.program.StepKind
import robotran.brick.program.ThreadView
import robotran.brick.program.VariableScope
import robotran.brick.sound.SoundTrack
import robotran.language.Language
import robotran.rcxrom.memory.MemorySnapshot
import robotran.rcxrom.state.RcxFirmwareState
import robotran.simulation.config.SimulationLimits
import robotran.simulation.explain.DeviationCause
import robotran.simulation.physics.PhysicsEngine
import robotran.simulation.state.SessionState
import robotran.world.World

/**
 * Robots with their bricks and programs in a world, from power-on. Time passes only in [advance], in ticks of 1 ms:
 * first each brick's firmware and program, in the order of the robots, then the motors, and every fifth tick the
 * physics. The same world, programs and inputs at the same times give the same session, bit for bit, on every target.
 * Not thread-safe.
 *
 * One robot can be debugged, see [watched]. [stepStatement] and [runUntilStop] can stop its program before any
 * statement, and those of others at [otherBreakpoints]. Several statements share a millisecond, so the program may stop
 * in the middle of one; that millisecond ends when the session continues or receives an input. Stops do not affect the
 * results of the session.
 *
 * @param loads the configurations of the robots, in the world's order; robots without one get no program.
 * @param language the language of goals, bricks and [explain]; it does not affect the simulation.
 */
class Session(val world: World, loads: List<RobotProgramSet>, physics: PhysicsEngine, val language: Language) {
    /**
     * A session in which only the first robot has programs: [programs] are its brick's slots, Run starts the one in
     * [firstSlot].
     */
    constructor(
        world: World,
        programs: List<BrickProgram?>,
        physics: PhysicsEngine,
        language: Language,
        firstSlot: Int = 0,
    ) : this(world, listOf(RobotProgramSet(programs, firstSlot)), physics, language)

    private val running = SessionEngine(world, loads, physics, language)
    private val brick: Brick get() = running.robots[watched].brick
    private val recorded = mutableListOf<RecordedInput>()
    private var closed = false
    private var step: Stepping? = null

    /** Index of the robot to debug; its log and sounds are available here. */
    var watched = 0
        set(number) {
            require(number in world.robots.indices) { "There is no robot $number." }
            field = number
        }

    /** All calls by the program and the firmware of the [watched] robot. */
    val callLog: CallLog get() = brick.log

    /** The sounds of the [watched] robot's brick, at times of [SessionState.milliseconds]. */
    val sounds: SoundTrack get() = brick.sounds

    /** All inputs of the session so far, in order; [replay] repeats the session from them. */
    val inputs: List<RecordedInput> get() = recorded.toList()

    /** Virtual time since the session began; the same as in [state], but cheaper. */
    val milliseconds: Long get() = running.milliseconds

    /** Whether all programs run that could stop at a breakpoint. */
    val areBreakpointsReady: Boolean
        get() = (breakpoints.isEmpty() || brick.debuggableRun != null) &&
            otherBreakpoints.keys.all { running.robots[it].brick.debuggableRun != null }

    /** Whether a program is paused in the middle of a millisecond. */
    val isPaused: Boolean get() = running.robots.any { it.brick.isPaused }

    /** Whether the running program is at the start of a statement, so that the next line is known. */
    val isBeforeStatement: Boolean get() = brick.debuggableRun?.isBeforeStatement == true

    /** The current state of the session. */
    val state: SessionState get() = running.state

    /**
     * A hash of all robot and block poses after every physics step and of every logged call so far, as 16 hexadecimal
     * digits.
     */
    val traceHash: String get() = running.traceHash

    /** The lines at which [runUntilStop] and [stepStatement] stop. */
    var breakpoints: Set<Breakpoint> = emptySet()

    /** The same for the programs of robots that are not [watched], by the index of the robot; none is empty. */
    var otherBreakpoints: Map<Int, Set<Breakpoint>> = emptyMap()

    /** The active calls of the running program, innermost first; empty if no debuggable program is running. */
    val callStack: List<CallFrame> get() = brick.debuggableRun?.callStack.orEmpty()

    /** The variables visible in the innermost frame of [callStack], its own first. */
    val variables: List<VariableScope> get() = brick.debuggableRun?.variables.orEmpty()

    /** The threads of the running program in start order; empty if no debuggable program is running. */
    val threads: List<ThreadView> get() = brick.debuggableRun?.threads.orEmpty()

    /**
     * The variables visible in frame [frame] of the call stack of the thread with the number [thread], see [threads];
     * frame 0 is the innermost.
     */
    fun variablesOf(thread: Int, frame: Int): List<VariableScope> =
        brick.debuggableRun?.variablesOf(thread, frame).orEmpty()

    /** Warnings for the pupil about the running program or, if none runs, about the last one. */
    val warnings: List<RuntimeWarning> get() = running.robots[watched].warnings

    /** Advances time and ignores breakpoints. */
    fun advance(milliseconds: Int) {
        check(!closed) { "The session is closed." }
        repeat(milliseconds) { running.tick() }
    }

    /**
     * Steps the program and advances time until the step ends, at most [milliseconds]. The step belongs to one thread;
     * other threads do not end it, unless that thread can no longer reach its end.
     *
     * @param thread the number of the thread that steps, even if it waits; null for the current one.
     */
    fun stepStatement(
        kind: StepKind,
        milliseconds: Int = SimulationLimits.MAX_STEP_MILLISECONDS,
        thread: Int? = null,
    ): StopReason {
        step = brick.debuggableRun?.let { Stepping(watched, it, breakpoints, kind, brick.isPaused, thread) }
        return continueStep(milliseconds)
    }

    /**
     * Continues the last step if its time ran out, for at most [milliseconds]. Does not repeat a step that has ended.
     */
    fun continueStep(milliseconds: Int): StopReason =
        step?.let { advanceUntilStop(it, milliseconds) } ?: StopReason.Ended

    /**
     * Advances time by [milliseconds], or less if the program reaches a breakpoint or ends earlier. Without a program,
     * all of the time passes.
     */
    fun runUntilStop(milliseconds: Int): StopReason {
        val stepping = brick.debuggableRun?.let { Stepping(watched, it, breakpoints) }
        return advanceUntilStop(stepping, milliseconds)
    }

    /** Applies an external input between two ticks. Lengths, angles and amounts are rounded to thousandths. */
    fun apply(input: SessionInput) {
        endPause()
        val exact = input.inThousandths()
        recorded += RecordedInput(running.milliseconds, exact)
        running.apply(exact)
    }

    /**
     * The causes why the robots have deviated and their sensors erred so far, robot by robot; negligible causes are
     * left out.
     */
    fun explain(): List<DeviationCause> = running.explain()

    /** A copy of the current memory of the [watched] robot's brick; null if it has none to look at. */
    fun memory(): MemorySnapshot? = running.robots[watched].ports.memory()

    /** What the firmware of the [watched] robot's brick knows now; null if it tells nothing, such as leJOS's. */
    fun firmwareState(): RcxFirmwareState? = running.robots[watched].ports.firmwareState

    /**
     * Ends the run for the world's goals: the remaining goals are decided now, finally. Time may continue to advance.
     */
    fun finish() = running.finish()

    /** Releases the physics. The session can still be read, but not advanced. */
    fun close() {
        if (!closed) running.close()
        closed = true
    }

    /** @param own of the [watched] robot's program; null if none runs. */
    private fun advanceUntilStop(own: Stepping?, milliseconds: Int): StopReason {
        check(!closed) { "The session is closed." }
        val others = otherBreakpoints.mapNotNull { (robot, lines) ->
            running.robots[robot].brick.debuggableRun?.let { Stepping(robot, it, lines) }
        }
        val all = listOfNotNull(own?.takeIf { it.canStop }) + others
        val isOver = { own != null && brick.debuggableRun !== own.run }
        val end = running.milliseconds + milliseconds
        for (each in all) each.run.watch = each
        while (running.milliseconds < end && all.none { it.reason != null } && !isOver()) running.tick()
        for (each in all) each.run.watch = null
        return all.firstNotNullOfOrNull { it.reason } ?: if (isOver()) StopReason.Ended else StopReason.TimeUp
    }

    /** Completes a millisecond in which a program is paused. */
    private fun endPause() {
        if (isPaused) running.tick()
    }

    companion object {
        /** Starts a new session, repeats [inputs], which are ordered by time, and advances it to [milliseconds]. */
        fun replay(
            world: World,
            loads: List<RobotProgramSet>,
            physics: PhysicsEngine,
            inputs: List<RecordedInput>,
            milliseconds: Long,
            language: Language,
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
