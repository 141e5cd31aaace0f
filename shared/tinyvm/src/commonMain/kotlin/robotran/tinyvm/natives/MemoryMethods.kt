package robotran.tinyvm.natives

import robotran.rcxrom.call.RomCall
import robotran.tinyvm.config.TinyVmCosts
import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VmThread
import robotran.tinyvm.run.action
import robotran.tinyvm.run.rcx

private const val WORD = 0xFFFF
private const val MAX_ARGUMENTS = 4

/** `josx.platform.rcx.ROM`, `Memory` and `PersistentMemoryArea`. Source: leJOS `native.c`. */
internal val memoryMethods: Map<String, NativeMethod> = (0..MAX_ARGUMENTS).associate { arguments ->
    "josx/platform/rcx/ROM.call(S${"S".repeat(arguments)})V" to
        action { machine, thread, first -> callRom(machine, thread, first, arguments) }
} + mapOf(
    "josx/platform/rcx/Memory.readByte(I)B" to NativeMethod { machine, thread, first ->
        val address = thread.stack[first] and WORD
        val byte = machine.rcx.arrays.around(listOf(address)) { machine.rcx.rom.memory.readByte(address) }
        // A brick forgets the sign that a Java byte has.
        if (machine.model.hasQuirks) byte else byte.toByte().toInt()
    },
    "josx/platform/rcx/Memory.writeByte(IB)V" to action { machine, thread, first ->
        val address = thread.stack[first] and WORD
        val value = thread.stack[first + 1]
        machine.rcx.arrays.around(listOf(address)) { machine.rcx.rom.memory.writeByte(address, value) }
        machine.rcx.region.written(address)
    },
    "josx/platform/rcx/Memory.setBit(III)V" to action { machine, thread, first ->
        val address = thread.stack[first] and WORD
        val bit = 1 shl (thread.stack[first + 1] and 7)
        val isSet = thread.stack[first + 2] != 0
        machine.rcx.arrays.around(listOf(address)) {
            val byte = machine.rcx.rom.memory.readByte(address)
            machine.rcx.rom.memory.writeByte(address, if (isSet) byte or bit else byte and bit.inv())
        }
    },
    "josx/platform/rcx/Memory.getDataAddress(Ljava/lang/Object;)I" to NativeMethod { machine, thread, first ->
        val reference = thread.stack[first]
        if (reference == 0) machine.raise(thread, BuiltInException.NULL_POINTER)
        if (reference == 0) 0 else machine.rcx.arrays.addressOf(reference)
    },
    "josx/platform/rcx/PersistentMemoryArea.getRegionAddress()I" to
        NativeMethod { machine, _, _ -> machine.rcx.region.address() },
)

private fun callRom(machine: VirtualMachine, thread: VmThread, first: Int, arguments: Int) {
    val words = List(arguments) { thread.stack[first + 1 + it] and WORD }
    val line = machine.lineOf(thread)
    val file = machine.fileOf(thread)
    machine.charge(TinyVmCosts.ROM_ROUTINE)
    machine.rcx.arrays.around(words) { machine.rcx.rom.call(RomCall(thread.stack[first] and WORD, words), line, file) }
}
