package robotran.tinyvm.run

import robotran.brick.program.FailureCall
import robotran.brick.program.FailureCause
import robotran.brick.program.ProgramFailure
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.link.LinkedField
import robotran.tinyvm.link.SpecialNumbers
import robotran.tinyvm.messages.TinyVmRunMessages
import robotran.tinyvm.messages.nxt

/**
 * Records uncaught exceptions. An uncaught exception ends its thread, and the brick shows the numbers of the method and
 * of the exception class. Source: leJOS `main.c`, handle_uncaught_exception.
 */
internal class Failures(private val machine: VirtualMachine, private val messages: TinyVmRunMessages) {
    /** The exception that ended the last thread and with it the program. */
    var last: ProgramFailure? = null
        private set

    private var unseen: ProgramFailure? = null

    /** Records [exception], which [thread] does not catch, unless it is a `ThreadDeath`, which ends it silently. */
    fun add(thread: VmThread, exception: Int) {
        val type = machine.heap.typeOf(exception) as LinkedClass
        if (type.name == SpecialNumbers.THREAD_DEATH) return
        val name = type.sourceName.substringAfterLast('.')
        val failure = if (machine.model.isExact) {
            onNxt(
                thread,
                exception,
                type,
                name,
            )
        } else {
            onRcx(thread, exception, type, name)
        }
        if (machine.scheduler.threads.any { it !== thread && !it.isDaemon }) unseen = failure else last = failure
    }

    private fun onRcx(thread: VmThread, exception: Int, type: LinkedClass, name: String): ProgramFailure {
        val method = if (thread.depth > 0) machine.program.numberOf(thread.frame.method) else 0
        val number = machine.program.numberOf(type)
        val message = messages.uncaught(name, textOf(exception), method, number)
        return ProgramFailure(message, machine.lineOf(thread), method, number, machine.fileOf(thread))
    }

    private fun onNxt(thread: VmThread, exception: Int, type: LinkedClass, name: String): ProgramFailure {
        val at = thread.uncaughtAt ?: machine.placeOf(thread)
        val number = machine.program.numberOf(type)
        val text = textOf(exception)
        val message = messages.nxt.uncaught(name, text, number)
        return ProgramFailure(
            message,
            at.line,
            at.methodNumber,
            number,
            at.file,
            at.calls,
            text.ifEmpty { null },
            causesOf(exception),
        )
    }

    /** The exceptions that caused [exception], the nearest first; at most [MOST_CAUSES]. */
    private fun causesOf(exception: Int): List<FailureCause> =
        generateSequence(referenceIn(exception, machine.program.throwableCause).takeIf { it != 0 }) { cause ->
            referenceIn(cause, machine.program.throwableCause).takeIf { it != 0 }
        }.take(MOST_CAUSES).map { cause ->
            val type = machine.heap.typeOf(cause) as LinkedClass
            FailureCause(machine.program.numberOf(type), textOf(cause).ifEmpty { null }, callsOf(cause))
        }.toList()

    private fun callsOf(exception: Int): List<FailureCall> {
        val calls = referenceIn(exception, machine.program.throwableCalls)
        if (calls == 0) return emptyList()
        return List(machine.heap.length(calls)) {
            val call = machine.heap.words[calls + Heap.HEADER_WORDS + it]
            FailureCall(call ushr HALF_BITS, call and LOW_HALF)
        }
    }

    private fun referenceIn(exception: Int, field: LinkedField?): Int =
        if (field == null) 0 else machine.heap.words[exception + Heap.HEADER_WORDS + field.slot]

    /** Returns an exception that ended a thread and was not returned before, or null. */
    fun take(): ProgramFailure? = unseen.also { unseen = null }

    private fun textOf(exception: Int): String {
        val text = referenceIn(exception, machine.program.throwableMessage)
        return if (text == 0) "" else machine.textOf(text)
    }

    private companion object {
        /** More do not fit the memory of a brick. */
        const val MOST_CAUSES = 100
        const val HALF_BITS = 16
        const val LOW_HALF = 0xFFFF
    }
}
