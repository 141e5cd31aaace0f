package robotran.tinyvm.nxj

import robotran.tinyvm.ClassAssembler
import robotran.tinyvm.link.LinkedMethod
import robotran.tinyvm.natives.nxj.NxjNatives
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.action
import robotran.tinyvm.short

/** Takes the place of the display for `System.out`, and keeps the printed lines by the program line that ended them. */
internal class PrintedLines {
    private val text = StringBuilder()
    private val lines = HashMap<Int, MutableList<String>>()

    val byLine: Map<Int, List<String>> get() = lines

    /** What takes the place of classes of the library. */
    val replacedClasses: Map<String, ByteArray> get() = replaced

    fun find(method: LinkedMethod): NativeMethod? =
        if (method.owner.name == STREAM && method.name == "write") write else NxjNatives.find(method)

    private val write = action { machine, thread, first ->
        val character = (thread.stack[first + 1] and 0xFF).toChar()
        if (character == '\n') {
            lines.getOrPut(machine.lineOf(thread)) { ArrayList() } += text.toString()
            text.clear()
        } else {
            text.append(character)
        }
    }

    private companion object {
        const val STREAM = "lejos/nxt/LCDOutputStream"

        val replaced: Map<String, ByteArray> by lazy {
            val stream = ClassAssembler(STREAM, "java/io/OutputStream")
            val above = stream.method("java/io/OutputStream", "<init>", "()V")
            stream.addMethod("<init>", "()V", 1, listOf(0x2A, 0xB7) + short(above) + 0xB1)
            stream.addMethod("write", "(I)V", 0x101, null)
            mapOf(STREAM to stream.assemble())
        }
    }
}
