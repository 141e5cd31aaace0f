package robotran.world

import robotran.rom.Brick
import robotran.rom.CallFrame
import robotran.rom.MemorySnapshot
import robotran.rom.MotorPort
import robotran.rom.ProgramRemark
import robotran.rom.RcxProgram
import robotran.rom.RomLog
import robotran.rom.SoundTrack
import robotran.rom.StepKind
import robotran.rom.ThreadView
import robotran.rom.VariableScope
import robotran.world.physics.PhysicsEngine

/**
 * A brick with its programs in a robot in a world, from switching it on. Time passes only in [advance], one tick of 1 ms after the other:
 * the brick's firmware, then its program, then the motors, and every fifth tick the physics. The same world, programs and inputs
 * at the same times give the same session, to the last bit, on every target. Not to be used from two threads at once.
 *
 * A program can be stopped before any statement, by [stepStatement] and [runUntilStop]. Several statements share a millisecond, so it may
 * be stopped in the middle of one, which then ends as soon as the session goes on or something is done to it. Stopping changes
 * nothing about the session but when its time passes.
 *
 * @param programs the brick's program slots, see [Brick].
 * @param firstSlot the program that Run starts as long as Prgm was not pressed, from 0.
 */
class Session(val world: World, programs: List<RcxProgram?>, physics: PhysicsEngine, firstSlot: Int = 0) {
    private val brick = Brick(programs, firstSlot = firstSlot)
    private val simulation = Simulation(world, physics)
    private val hash = TraceHash()
    private val recorded = mutableListOf<RecordedInput>()
    private var milliseconds = 0L
    private var hashedCalls = 0L
    private var latest: SessionState? = null
    private var closed = false

    /** Every ROM call of the program and the firmware. */
    val romLog: RomLog get() = brick.log

    /** What the brick's loudspeaker has played, at times of [SessionState.milliseconds]; to be listened to at any time, or never. */
    val sounds: SoundTrack get() = brick.sounds

    /** Everything that was done to the session so far, in order; with it [replay] makes the same session again. */
    val inputs: List<RecordedInput> get() = recorded.toList()

    /** The session as it is now. */
    val state: SessionState get() = latest ?: snapshot().also { latest = it }

    /** A hash of the robot's place in every tick and of every ROM call so far, as 16 hexadecimal digits. */
    val traceHash: String get() = hash.text

    /** The lines that [runUntilStop] and [stepStatement] stop before. */
    var breakpoints: Set<Breakpoint> = emptySet()

    /** What the running program is in the middle of, the innermost first; empty if none runs that can be looked into. */
    val callStack: List<CallFrame> get() = brick.debuggableRun?.callStack.orEmpty()

    /** The variables that the innermost of [callStack] knows, its own first. */
    val variables: List<VariableScope> get() = brick.debuggableRun?.variables.orEmpty()

    /** The threads of the running program, in the order of their start; empty if none runs that can be looked into. */
    val threads: List<ThreadView> get() = brick.debuggableRun?.threads.orEmpty()

    /** The variables that the place [frame] in the call stack of the thread with the number [thread] knows, see [threads]; 0 is the innermost. */
    fun variablesOf(thread: Int, frame: Int): List<VariableScope> = brick.debuggableRun?.variablesOf(thread, frame).orEmpty()

    /** What a pupil should know about the running program or, if none runs, about the last one. */
    val remarks: List<ProgramRemark> get() = brick.remarks

    /** Lets time pass, whatever the breakpoints. */
    fun advance(milliseconds: Int) {
        check(!closed) { "The session is closed." }
        repeat(milliseconds) { tick() }
    }

    /**
     * Lets the program make one step, and all the time pass that it takes, but [milliseconds] at most. The step is one of the thread that
     * is being executed; what others do meanwhile does not end it, unless its own thread cannot come to that any more.
     */
    fun stepStatement(kind: StepKind, milliseconds: Int = SimulationLimits.LONGEST_STEP_MILLISECONDS): StopReason =
        brick.debuggableRun?.let { advanceUntilStop(Stepping(it, breakpoints, kind, brick.isPaused), milliseconds) } ?: StopReason.Ended

    /** Lets [milliseconds] pass, or less if the program comes to a breakpoint or to its end before. With no program, all of them pass. */
    fun runUntilStop(milliseconds: Int): StopReason {
        val run = brick.debuggableRun
        if (run != null) return advanceUntilStop(Stepping(run, breakpoints), milliseconds)
        advance(milliseconds)
        return StopReason.TimeUp
    }

    /** Does something to the session from outside, between two ticks. */
    fun apply(input: SessionInput) {
        endPause()
        recorded += RecordedInput(milliseconds, input)
        latest = null
        when (input) {
            is SessionInput.Press -> brick.press(input.button)
            is SessionInput.Release -> brick.release(input.button)
            SessionInput.Stop -> brick.stopProgram()
        }
    }

    /** What the brick's memory holds now. */
    fun memory(): MemorySnapshot = brick.memory()

    /** Frees what the physics holds. The session can still be looked at, but not go on. */
    fun close() {
        if (!closed) simulation.close()
        closed = true
    }

    private fun advanceUntilStop(stepping: Stepping, milliseconds: Int): StopReason {
        check(!closed) { "The session is closed." }
        val run = brick.debuggableRun
        val end = this.milliseconds + milliseconds
        run?.watch = stepping.takeIf { it.canStop }
        while (this.milliseconds < end && stepping.reason == null && brick.debuggableRun === run) tick()
        run?.watch = null
        return stepping.reason ?: if (brick.debuggableRun === run) StopReason.TimeUp else StopReason.Ended
    }

    /** Ends a millisecond that the program was stopped in the middle of. */
    private fun endPause() {
        if (brick.isPaused) tick()
    }

    /** One millisecond, or what is left of one. */
    private fun tick() {
        latest = null
        brick.tick()
        if (brick.isPaused) return
        simulation.tick(brick.motor(MotorPort.A), brick.motor(MotorPort.B), brick.motor(MotorPort.C))
        milliseconds++
        simulation.addTo(hash)
        hashNewCalls()
    }

    private fun hashNewCalls() {
        while (hashedCalls < romLog.total) romLog[hashedCalls++]?.let(hash::add)
    }

    private fun snapshot() = SessionState(
        milliseconds = milliseconds,
        robots = listOf(RobotSnapshot(brick.state, simulation.robot, simulation.bumps, remarks, romLog.total.toInt())),
        blocks = emptyList(),
        lamps = emptyList(),
        ink = simulation.ink,
        goals = emptyList(),
    )

    companion object {
        /** A new session to which [inputs], in the order of their times, are done again, after [milliseconds]. */
        fun replay(
            world: World,
            programs: List<RcxProgram?>,
            physics: PhysicsEngine,
            inputs: List<RecordedInput>,
            milliseconds: Long,
            firstSlot: Int = 0,
        ): Session {
            val session = Session(world, programs, physics, firstSlot)
            inputs.filter { it.milliseconds <= milliseconds }.forEach { recorded ->
                session.advanceTo(recorded.milliseconds)
                session.apply(recorded.input)
            }
            session.advanceTo(milliseconds)
            return session
        }
    }

    private fun advanceTo(time: Long) {
        while (milliseconds < time) advance(1)
    }
}
