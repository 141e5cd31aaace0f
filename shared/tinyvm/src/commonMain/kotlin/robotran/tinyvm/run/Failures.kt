package robotran.tinyvm.run

import robotran.brick.program.ProgramFailure
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.link.SpecialNumbers
import robotran.tinyvm.messages.RunMessages

/**
 * Records uncaught exceptions. An uncaught exception ends its thread, and the brick shows the numbers of the method and
 * of the exception class. Source: leJOS `main.c`, handle_uncaught_exception.
 */
internal class Failures(private val machine: VirtualMachine, private val messages: RunMessages) {
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
        )
    }

    /** Returns an exception that ended a thread and was not returned before, or null. */
    fun take(): ProgramFailure? = unseen.also { unseen = null }

    private fun textOf(exception: Int): String {
        val field = machine.program.throwableMessage ?: return ""
        val text = machine.heap.words[exception + Heap.HEADER_WORDS + field.slot]
        return if (text == 0) "" else machine.textOf(text)
    }
}
