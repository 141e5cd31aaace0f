package robotran.tinyvm.natives.nxj

import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.storage.FlashMemory
import robotran.tinyvm.run.Heap
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VmThread
import robotran.tinyvm.run.brick

/** `lejos.nxt.Flash`: pages of the memory that keeps files. */
internal val flashMethods: Map<String, NativeMethod> = mapOf(
    "lejos/nxt/Flash.flashReadPage([BI)I" to NativeMethod(::readPage),
    "lejos/nxt/Flash.flashWritePage([BI)I" to NativeMethod(::writePage),
)

private fun readPage(machine: VirtualMachine, thread: VmThread, first: Int): Int {
    val array = thread.stack[first]
    if (array == 0) return nullPointer(machine, thread)
    val page = ByteArray(FlashMemory.PAGE_BYTES)
    val isThere = machine.heap.length(array) >= page.size && machine.brick.nxt.readPage(thread.stack[first + 1], page)
    if (!isThere) return -1
    machine.charge(page.size / machine.model.wordsInABytecode)
    for (index in page.indices) machine.heap.words[array + Heap.HEADER_WORDS + index] = page[index].toInt()
    return 0
}

private fun writePage(machine: VirtualMachine, thread: VmThread, first: Int): Int {
    val array = thread.stack[first]
    if (array == 0) return nullPointer(machine, thread)
    if (machine.heap.length(array) < FlashMemory.PAGE_BYTES) return -1
    val page = ByteArray(FlashMemory.PAGE_BYTES) { machine.heap.words[array + Heap.HEADER_WORDS + it].toByte() }
    machine.charge(page.size / machine.model.wordsInABytecode)
    return machine.brick.call(
        thread,
        NxtCall(NxtNative.FLASH_WRITE_PAGE, intArrayOf(thread.stack[first + 1]), bytes = page),
    )
}
