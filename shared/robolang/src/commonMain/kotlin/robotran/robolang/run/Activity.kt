package robotran.robolang.run

import robotran.robolang.check.Symbol

/**
 * One thread of execution: the main program, the action of a behaviour, or the evaluation of a condition. Its stack
 * holds operands, the frames of routines, and the counters of loops between them. A value has 32 bits: an integer, the
 * bits of a float, 1 or 0 for true and false, or the index of a list in [InterpreterState].
 */
internal class Activity(val machine: InterpreterState, val name: String, start: Int, private var line: Int) {
    private val instructions = machine.code.instructions
    private val calls = ArrayList<Call>()
    private var stack = IntArray(SMALLEST_STACK)
    private var top = 0
    private var base = 0
    private var waits = false
    private var knownInside: KnownVariables? = null

    /** The index of the next instruction. */
    var next = start

    /** When it resumes, on the brick's clock; if in the past, it is not waiting. */
    var waitUntil = 0L
        private set

    val isWaiting: Boolean get() = waits && machine.robot.milliseconds < waitUntil

    val isOver: Boolean get() = !isWaiting && instructions[next] === Boundary.End

    /** The statement before which it stands; null if it is inside one. */
    val statement: Boundary.Statement? get() = instructions[next] as? Boundary.Statement

    /** The call depth. */
    val depth: Int get() = calls.size

    /** The current line; before a statement, that statement's line. */
    val sourceLine: Int get() = if (isWaiting) line else statement?.line ?: line

    /** The line of the statement being executed. */
    val currentLine: Int get() = line

    /** Whether it is inside a statement that can be resumed. */
    val isInsideStatement: Boolean get() = !isWaiting && instructions[next] !is Boundary

    /** The variables in scope; inside a routine, without those of the main program. */
    val known: List<Symbol>
        get() {
            val upcoming = statement
            return (if (upcoming == null || isWaiting) knownInside else upcoming.known)?.all.orEmpty()
        }

    /** The variables in scope at [frame] of its call stack; 0 is the innermost frame. */
    fun knownAt(frame: Int): List<Symbol> = if (frame == 0) known else caller(frame).known?.all.orEmpty()

    /** The routine that the one at [frame] has called; [frame] is not the innermost. */
    private fun caller(frame: Int): Call = calls[calls.size - frame]

    /** The call depth, including its own. */
    val frameCount: Int get() = calls.size + 1

    /** Begins the next statement. */
    fun begin(statement: Boundary.Statement) {
        line = statement.line
        knownInside = statement.known
        next++
    }

    /** Runs to the next statement, the end or a wait. */
    fun proceed() {
        waits = false
        while (!waits) {
            val instruction = instructions[next]
            if (instruction is Boundary) return
            next++
            instruction.execute(this)
        }
    }

    fun waitFor(milliseconds: Int) {
        waitUntil = machine.robot.milliseconds + milliseconds
        waits = true
    }

    /** Does the instruction that is being executed again in a millisecond. */
    fun lookAgain() {
        next--
        waitFor(RobotConstants.LOOKING_MILLISECONDS)
    }

    /** Ends a timed command early, as if its time were over. A pause that does not affect the robot continues. */
    fun cutShort() {
        val ending = instructions[next] as? CompletionAction ?: return
        if (!waits) return
        waits = false
        next++
        ending.cutShort(this)
    }

    fun push(value: Int) {
        if (top == stack.size) stack = stack.copyOf(stack.size * 2)
        stack[top++] = value
    }

    fun pushDecimal(value: Float) = push(value.toRawBits())

    fun pushTruth(value: Boolean) = push(if (value) 1 else 0)

    fun pop(): Int = stack[--top]

    fun popDecimal(): Float = Float.fromBits(pop())

    fun drop(count: Int) {
        top -= count
    }

    /** The value [below] the top of the stack. */
    fun peek(below: Int = 0): Int = stack[top - 1 - below]

    fun replace(value: Int, below: Int = 0) {
        stack[top - 1 - below] = value
    }

    /** Passes all values on its stack to [use]. */
    fun eachValue(use: (Int) -> Unit) {
        for (place in 0..<top) use(stack[place])
    }

    fun local(slot: Int): Int = stack[base + slot]

    /** The value of [slot] of the routine at [frame] of its call stack; 0 is the innermost frame. */
    fun local(slot: Int, frame: Int): Int = stack[(if (frame == 0) base else caller(frame).base) + slot]

    fun setLocal(slot: Int, value: Int) {
        stack[base + slot] = value
    }

    /** Calls [routine]; its arguments are on the stack. */
    fun call(routine: RoutineCode) {
        if (calls.size == RobotConstants.DEEPEST_CALLS) {
            fail(machine.messages.tooManyCalls(routine.name, RobotConstants.DEEPEST_CALLS))
        }
        calls += Call(routine, next, base, line, knownInside)
        base = top - routine.parameters
        repeat(routine.slots - routine.parameters) { push(0) }
        next = routine.entry
    }

    /** Returns from the routine: drops its frame and everything above it. */
    fun leave() {
        val call = calls.removeLast()
        top = base
        base = call.base
        next = call.returnTo
        line = call.line
        knownInside = call.known
    }

    /** Its call stack as names and lines, innermost first. */
    fun frames(): List<FrameView> {
        val names = listOf(name) + calls.map { it.routine.name }
        val lines = calls.map { it.line } + sourceLine
        return names.zip(lines, ::FrameView).asReversed()
    }

    private class Call(
        val routine: RoutineCode,
        val returnTo: Int,
        val base: Int,
        val line: Int,
        val known: KnownVariables?,
    )

    private companion object {
        const val SMALLEST_STACK = 32
    }
}

/** One level of an [Activity]. */
internal data class FrameView(val name: String, val line: Int)
