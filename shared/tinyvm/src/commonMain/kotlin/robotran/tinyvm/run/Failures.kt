package robotran.tinyvm.run

import robotran.rom.ProgramFailure
import robotran.rom.RomAddress
import robotran.rom.RomCall
import robotran.rom.RomCode
import robotran.tinyvm.RunMessages
import robotran.tinyvm.link.LinkedClass

/**
 * What happens when nobody catches an exception: its thread ends; if others keep the program going, the brick buzzes and shows the
 * numbers of the method and of the exception's class. Source: leJOS `main.c`, handle_uncaught_exception. A brick also waits for On-Off
 * then.
 */
internal class Failures(private val machine: Machine, private val messages: RunMessages) {
    /** The first exception that nobody caught. */
    var first: ProgramFailure? = null
        private set

    /** Takes note of [exception], which nobody in [thread] catches. */
    fun add(thread: VmThread, exception: Int) {
        val type = machine.heap.typeOf(exception) as LinkedClass
        val method = if (thread.depth > 0) thread.frame.method.signatureNumber else 0
        if (first == null) {
            val message = messages.uncaught(type.sourceName.substringAfterLast('.'), textOf(exception), method, type.number)
            first = ProgramFailure(message, machine.lineOf(thread), method, type.number, machine.fileOf(thread))
        }
        if (machine.scheduler.threads.any { it !== thread && !it.isDaemon }) show(method, type.number)
    }

    private fun show(method: Int, exceptionClass: Int) {
        call(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_QUEUED, BUZZ)
        call(RomAddress.SET_LCD_NUMBER, RomCode.LCD_UNSIGNED, method, RomCode.LCD_POINT_NONE)
        call(RomAddress.SET_LCD_NUMBER, RomCode.LCD_PROGRAM, exceptionClass % DIGITS, RomCode.LCD_POINT_NONE)
        call(RomAddress.SET_LCD_SEGMENT, RomCode.SEGMENT_SENSOR_1_VIEW)
        call(RomAddress.REFRESH_LCD)
    }

    private fun call(address: Int, vararg arguments: Int) = machine.rom.call(RomCall(address, arguments.toList()), 0)

    private fun textOf(exception: Int): String {
        val field = machine.program.throwableMessage ?: return ""
        val text = machine.heap.words[exception + Heap.HEADER_WORDS + field.slot]
        return if (text == 0) "" else machine.textOf(text)
    }

    private companion object {
        const val BUZZ = 4
        const val DIGITS = 10
    }
}
