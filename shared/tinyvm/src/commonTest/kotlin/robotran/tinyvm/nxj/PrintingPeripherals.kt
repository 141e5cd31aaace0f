package robotran.tinyvm.nxj

import robotran.tinyvm.ClassAssembler
import robotran.tinyvm.link.LinkedMethod
import robotran.tinyvm.natives.nxj.NxjNatives
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.Peripherals
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.action
import robotran.tinyvm.short

/** A brick that has nothing but a clock, and keeps what is printed. */
internal class PrintingPeripherals : Peripherals {
    private val text = StringBuilder()

    /** The printed lines; what stands behind the last line feed is one, too. */
    val lines: List<String> get() = text.toString().removeSuffix("\n").ifEmpty { null }?.lines().orEmpty()

    override var milliseconds = 0L

    override val wakesAt: Long? = null

    /** What takes the place of classes of the library. */
    val classes: Map<String, ByteArray> get() = replaced

    override fun attach(machine: VirtualMachine) = Unit

    override fun poll() = Unit

    override fun roots(mark: (Int) -> Unit) = Unit

    override fun forget(isGone: (Int) -> Boolean) = Unit

    override fun delaysEnd() = false

    fun find(method: LinkedMethod): NativeMethod? =
        when ("${method.owner.name}.${method.name}") {
            "$STREAM.write" -> write
            "java/lang/Shutdown.halt" -> halt
            else -> NxjNatives.find(method)
        }

    private val halt = action { machine, _, _ -> machine.isExited = true }

    private val write = action { _, thread, first -> text.append((thread.stack[first + 1] and 0xFF).toChar()) }

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
