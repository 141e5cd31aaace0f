package robotran.tinyvm.natives.nxj

import robotran.nxt.program.Nxt
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.tinyvm.config.NxtCosts
import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.run.Heap
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VmThread
import robotran.tinyvm.run.brick

/** A native method that makes the call [native] with its arguments, which are words, and returns the result. */
internal fun calls(native: NxtNative, cost: Int = NxtCosts.SETTING): NativeMethod =
    NativeMethod { machine, thread, first ->
        machine.charge(cost - NxtCosts.NATIVE_METHOD)
        val numbers = IntArray(native.parameters) { thread.stack[first + it] }
        machine.brick.call(thread, NxtCall(native, numbers))
    }

/** A native method that reads something from the brick; [read] gets the arguments, which are words. */
internal fun reads(read: (nxt: Nxt, arguments: (Int) -> Int) -> Int): NativeMethod =
    NativeMethod { machine, thread, first -> read(machine.brick.nxt) { thread.stack[first + it] } }

/**
 * The bytes [offset] until [offset] + [length] of the Java array [array]; null, after throwing, if there is no array or it
 * does not have them.
 */
internal fun bytesOf(machine: VirtualMachine, thread: VmThread, array: Int, offset: Int, length: Int): ByteArray? {
    if (!hasPart(machine, thread, array, offset, length)) return null
    val start = array + Heap.HEADER_WORDS + offset
    machine.charge(length / machine.model.wordsInABytecode)
    return ByteArray(length) { machine.heap.words[start + it].toByte() }
}

/** Puts the first [count] of [bytes] in the Java array [array] from [offset] on, which has room for them. */
internal fun putBytes(machine: VirtualMachine, array: Int, offset: Int, bytes: ByteArray, count: Int) {
    machine.charge(count / machine.model.wordsInABytecode)
    for (index in 0 until count) machine.heap.words[array + Heap.HEADER_WORDS + offset + index] = bytes[index].toInt()
}

/** Whether [array] has [length] elements from [offset] on; if not, throws. */
internal fun hasPart(machine: VirtualMachine, thread: VmThread, array: Int, offset: Int, length: Int): Boolean {
    if (array == 0) {
        machine.raise(thread, BuiltInException.NULL_POINTER)
        return false
    }
    val isInside = offset >= 0 && length >= 0 && offset.toLong() + length <= machine.heap.length(array)
    if (!isInside) machine.raise(thread, BuiltInException.ARRAY_INDEX)
    return isInside
}

/** The text at [index]; null, after throwing, if there is none. */
internal fun textAt(machine: VirtualMachine, thread: VmThread, index: Int): String? {
    val reference = thread.stack[index]
    if (reference == 0) machine.raise(thread, BuiltInException.NULL_POINTER)
    return if (reference == 0) null else machine.textOf(reference)
}
