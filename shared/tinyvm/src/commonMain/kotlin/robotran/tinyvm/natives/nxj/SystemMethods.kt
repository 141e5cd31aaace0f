package robotran.tinyvm.natives.nxj

import robotran.tinyvm.config.Quirk
import robotran.tinyvm.config.QuirkHandling
import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.run.Heap
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VmThread
import robotran.tinyvm.run.action

private const val NANOSECONDS = 1_000_000L
private const val CLOCK_BITS = 0xFFFFFFFFL

/** `java.lang.System` and `Runtime`, and what of `lejos.nxt.VM` belongs to exceptions. */
internal val nxjSystemMethods: Map<String, NativeMethod> = mapOf(
    "java/lang/System.currentTimeMillis()J" to
        NativeMethod { machine, _, _ -> long(machine, machine.milliseconds and CLOCK_BITS) },
    "java/lang/System.nanoTime()J" to
        NativeMethod { machine, _, _ -> long(machine, (machine.milliseconds and CLOCK_BITS) * NANOSECONDS) },
    "java/lang/System.arraycopy(Ljava/lang/Object;ILjava/lang/Object;II)V" to action(::copyArray),
    "java/lang/System.gc()V" to action { machine, _, _ -> machine.collectGarbage() },
    "java/lang/System.getDataAddress(Ljava/lang/Object;)I" to
        NativeMethod { _, thread, first -> thread.stack[first] * Int.SIZE_BYTES },
    "java/lang/Runtime.freeMemory()J" to
        NativeMethod { machine, _, _ -> long(machine, machine.heap.freeBytes.toLong()) },
    "java/lang/Runtime.totalMemory()J" to
        NativeMethod { machine, _, _ -> long(machine, machine.heap.totalBytes.toLong()) },
    "lejos/nxt/VM.createStackTrace(Ljava/lang/Thread;Ljava/lang/Object;)[I" to
        NativeMethod { machine, thread, first ->
            val traced = thread.stack[first]
            if (traced == 0) {
                0
            } else {
                machine.stackTrace(machine.threadOf(traced), thread.stack[first + 1])
            }
        },
    "lejos/nxt/VM.firmwareExceptionHandler(Ljava/lang/Throwable;II)V" to action { machine, thread, first ->
        val thrown = thread.stack[first]
        if (thrown == 0) {
            nullPointer(machine, thread)
        } else {
            machine.onFailure(thread, thrown)
            machine.cutOff(thread)
        }
    },
)

private fun copyArray(machine: VirtualMachine, thread: VmThread, first: Int) {
    val source = thread.stack[first]
    val target = thread.stack[first + 2]
    if (source == 0 || target == 0) return machine.raise(thread, BuiltInException.NULL_POINTER)
    val sourceType = machine.heap.typeOf(source) as? ArrayType
    val targetType = machine.heap.typeOf(target) as? ArrayType
    val isSameKind = sourceType != null && targetType != null &&
        (sourceType === targetType || (sourceType.element != null && targetType.element != null))
    if (!isSameKind) return machine.raise(thread, BuiltInException.ARRAY_STORE)
    val from = thread.stack[first + 1]
    val to = thread.stack[first + 3]
    val count = thread.stack[first + 4]
    val isInside = from >= 0 && to >= 0 && count >= 0 && from.toLong() + count <= machine.heap.length(source) &&
        to.toLong() + count <= machine.heap.length(target)
    if (!isInside) return machine.raise(thread, BuiltInException.ARRAY_INDEX)
    val size = sourceType.elementWords
    val start = source + Heap.HEADER_WORDS + from * size
    val place = target + Heap.HEADER_WORDS + to * size
    val words = machine.heap.words
    machine.charge(count * size / machine.model.wordsInABytecode)
    val misfits = misfits(machine, start, count, sourceType, targetType)
    val isReported = machine.model.elements != QuirkHandling.APPLY
    val copied = if (isReported) misfits.firstOrNull() ?: count else count
    words.copyInto(words, place, start, start + copied * size)
    if (misfits.isEmpty()) return
    machine.addWarning(Quirk.UNCHECKED_ELEMENT)
    if (isReported) return machine.raise(thread, BuiltInException.ARRAY_STORE)
    misfits.forEach { words[place + it] = 0 }
}

/**
 * Which of [count] elements from the heap index [start] on, one after the other, [target] may not hold. As with a single
 * element, they become null on a brick.
 */
private fun misfits(
    machine: VirtualMachine,
    start: Int,
    count: Int,
    source: ArrayType?,
    target: ArrayType?,
): List<Int> {
    val wanted = target?.element ?: return emptyList()
    if (source?.element?.isA(wanted) == true) return emptyList()
    val heap = machine.heap
    return (0 until count).filter {
        heap.words[start + it] != 0 && !heap.typeOf(heap.words[start + it]).isA(wanted)
    }
}
