package robotran.robolang.run

import robotran.robolang.check.Symbol

/**
 * One thread of execution: the main program, the action of a behaviour, or a condition being looked at. All it is in
 * the middle of lies on its own stack: operands, the frames of routines, and the counters of loops between them. A
 * value is 32 bits: a whole number, the bits of a decimal one, 1 or 0 for true and false, or the number of a list among
 * the [InterpreterState]'s.
 */
internal class Activity(val machine: InterpreterState, val name: String, start: Int, private var line: Int) {
    private val instructions = machine.code.instructions
    private val calls = ArrayList<Call>()
    private var stack = IntArray(SMALLEST_STACK)
    private var top = 0
    private var base = 0
    private var waits = false
    private var knownInside: KnownVariables? = null

    /** The instruction to be executed next. */
    var next = start

    /** Until when it does nothing, on the brick's clock; over if that is past. */
    var waitUntil = 0L
        private set

    val isWaiting: Boolean get() = waits && machine.rom.milliseconds < waitUntil

    val isOver: Boolean get() = !isWaiting && instructions[next] === Boundary.End

    /** The statement about to be executed, null in the middle of one. */
    val statement: Boundary.Statement? get() = instructions[next] as? Boundary.Statement

    /** How many routines it is inside of. */
    val depth: Int get() = calls.size

    /** The line it is at or, before a statement, about to be at. */
    val sourceLine: Int get() = if (isWaiting) line else statement?.line ?: line

    /** The line of the statement it is in the middle of. */
    val currentLine: Int get() = line

    /** Whether it is in the middle of a statement that can go on. */
    val isInsideStatement: Boolean get() = !isWaiting && instructions[next] !is Boundary

    /** The variables that it knows at the place where it is, those of the main program left aside inside a routine. */
    val known: List<Symbol>
        get() {
            val upcoming = statement
            return (if (upcoming == null || isWaiting) knownInside else upcoming.known)?.all.orEmpty()
        }

    /** The variables that are known at [frame] in its own call stack, 0 for the innermost. */
    fun knownAt(frame: Int): List<Symbol> = if (frame == 0) known else caller(frame).known?.all.orEmpty()

    /** What the routine at [frame], which is not the innermost, has called. */
    private fun caller(frame: Int): Call = calls[calls.size - frame]

    /** How many routines it is inside of, itself included. */
    val frameCount: Int get() = calls.size + 1

    /** Begins the statement it stands before. */
    fun begin(statement: Boundary.Statement) {
        line = statement.line
        knownInside = statement.known
        next++
    }

    /** Goes on to the next statement, to the end or to a wait. */
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
        waitUntil = machine.rom.milliseconds + milliseconds
        waits = true
    }

    /** Ends at once a command that lasts, as its time would. A pause that does nothing to the robot goes on. */
    fun cutShort() {
        val ending = instructions[next] as? CompletionAction ?: return
        if (!waits) return
        waits = false
        next++
        ending.execute(this)
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

    /** The value [below] the topmost one. */
    fun peek(below: Int = 0): Int = stack[top - 1 - below]

    fun replace(value: Int, below: Int = 0) {
        stack[top - 1 - below] = value
    }

    fun local(slot: Int): Int = stack[base + slot]

    /** What is in [slot] of the routine at [frame] in its own call stack, 0 for the innermost. */
    fun local(slot: Int, frame: Int): Int = stack[(if (frame == 0) base else caller(frame).base) + slot]

    fun setLocal(slot: Int, value: Int) {
        stack[base + slot] = value
    }

    /** Enters [routine], whose arguments are on the stack. */
    fun call(routine: RoutineCode) {
        if (calls.size ==
            RobotConstants.DEEPEST_CALLS
        ) {
            fail(machine.messages.tooManyCalls(routine.name, RobotConstants.DEEPEST_CALLS))
        }
        calls += Call(routine, next, base, line, knownInside)
        base = top - routine.parameters
        repeat(routine.slots - routine.parameters) { push(0) }
        next = routine.entry
    }

    /** Leaves the routine, its frame and all that is above it. */
    fun leave() {
        val call = calls.removeLast()
        top = base
        base = call.base
        next = call.returnTo
        line = call.line
        knownInside = call.known
    }

    /** What it is in the middle of as names and lines, the innermost first. */
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
