package robotran.tinyvm.natives

import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.run.Heap
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VmThread
import robotran.tinyvm.run.action
import robotran.tinyvm.run.rcx
import robotran.tinyvm.run.wordOf

private const val BYTE = 0xFF

/** `josx.rcxcomm.LLC`. Source: leJOS `native.c`, `llc.c`. */
internal val infraredMethods: Map<String, NativeMethod> = mapOf(
    "josx/rcxcomm/LLC.init()V" to action { machine, _, _ -> machine.rcx.rom.infraredLine.begin() },
    "josx/rcxcomm/LLC.write([BI)V" to action { machine, thread, first ->
        write(machine, thread, thread.stack[first], thread.stack[first + 1])
    },
    "josx/rcxcomm/LLC.read()I" to NativeMethod { machine, _, _ -> machine.rcx.rom.infraredLine.read() },
    "josx/rcxcomm/LLC.isSending()Z" to NativeMethod { machine, _, _ -> wordOf(machine.rcx.rom.infraredLine.isSending) },
    "josx/rcxcomm/LLC.isSendError()Z" to
        NativeMethod { machine, _, _ -> wordOf(machine.rcx.rom.infraredLine.hasCollided) },
)

/** Sends the first [length] bytes of [array]. A brick would send what is behind the array if it has fewer. */
private fun write(machine: VirtualMachine, thread: VmThread, array: Int, length: Int) {
    if (array == 0) return machine.raise(thread, BuiltInException.NULL_POINTER)
    val words = machine.heap.words
    val count = length.coerceIn(0, machine.heap.length(array))
    machine.rcx.rom.infraredLine.write(List(count) { words[array + Heap.HEADER_WORDS + it] and BYTE })
}
