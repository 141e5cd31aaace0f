package robotran.tinyvm.natives.nxj

import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.link.HeapType
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.natives.objectMethods
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VmThread
import robotran.tinyvm.run.wordOf

private const val OBJECT = "java/lang/Object"
private const val CLASS = "java/lang/Class"

/** `java.lang.Object`, `Class`, `Float` and `Double`. */
internal val languageMethods: Map<String, NativeMethod> = mapOf(
    "$OBJECT.getClass()Ljava/lang/Class;" to NativeMethod { machine, thread, first ->
        made(machine, thread, machine.classObject(machine.heap.typeOf(thread.stack[first])))
    },
    "$OBJECT.cloneObject(Ljava/lang/Object;)Ljava/lang/Object;" to NativeMethod { machine, thread, first ->
        val original = thread.stack[first]
        if (original == 0) nullPointer(machine, thread) else made(machine, thread, machine.copyOf(original))
    },
    "$CLASS.desiredAssertionStatus()Z" to NativeMethod { _, _, _ -> 0 },
    "$CLASS.getSuperclass()Ljava/lang/Class;" to NativeMethod { machine, thread, first ->
        val above = when (val type = classAt(machine, thread, first)) {
            is LinkedClass -> if (type.isInterface) null else type.superclass
            is ArrayType -> machine.program.throwable.superclass
            null -> null
        }
        if (above == null) 0 else made(machine, thread, machine.classObject(above))
    },
    "$CLASS.isInstance(Ljava/lang/Object;)Z" to NativeMethod { machine, thread, first ->
        val reference = thread.stack[first + 1]
        val type = classAt(machine, thread, first)
        wordOf(reference != 0 && type != null && machine.heap.typeOf(reference).isA(type))
    },
    "$CLASS.isAssignableFrom(Ljava/lang/Class;)Z" to NativeMethod { machine, thread, first ->
        if (thread.stack[first + 1] == 0) {
            nullPointer(machine, thread)
        } else {
            val type = classAt(machine, thread, first)
            wordOf(type != null && classAt(machine, thread, first + 1)?.isA(type) == true)
        }
    },
    "$CLASS.isInterface()Z" to NativeMethod { machine, thread, first ->
        wordOf((classAt(machine, thread, first) as? LinkedClass)?.isInterface == true)
    },
    "$CLASS.isArray()Z" to NativeMethod { machine, thread, first ->
        wordOf(classAt(machine, thread, first) is ArrayType)
    },
    // The classes of plain values have no type of the machine.
    "$CLASS.isPrimitive()Z" to NativeMethod { machine, thread, first ->
        wordOf(classAt(machine, thread, first) == null)
    },
    "$CLASS.elementClass()Ljava/lang/Class;" to NativeMethod { machine, thread, first ->
        val element = (classAt(machine, thread, first) as? ArrayType)?.element
        if (element == null) 0 else made(machine, thread, machine.classObject(element))
    },
    "$CLASS.elementSign()C" to NativeMethod { machine, thread, first ->
        (classAt(machine, thread, first) as? ArrayType)?.elementDescriptor?.first()?.code ?: 0
    },
    "$CLASS.interfaceAt(I)Ljava/lang/Class;" to NativeMethod { machine, thread, first ->
        val all = (classAt(machine, thread, first) as? LinkedClass)?.interfaces.orEmpty()
        val found = all.getOrNull(thread.stack[first + 1])
        if (found == null) 0 else made(machine, thread, machine.classObject(found))
    },
    "java/lang/Float.floatToRawIntBits(F)I" to NativeMethod { _, thread, first -> thread.stack[first] },
    "java/lang/Float.intBitsToFloat(I)F" to NativeMethod { _, thread, first -> thread.stack[first] },
    "java/lang/Double.doubleToRawLongBits(D)J" to
        NativeMethod { machine, thread, first -> bothWords(machine, thread, first) },
    "java/lang/Double.longBitsToDouble(J)D" to
        NativeMethod { machine, thread, first -> bothWords(machine, thread, first) },
) + listOf("notify()V", "notifyAll()V").associate { "$OBJECT.$it" to objectMethods.getValue("$OBJECT.$it") }

private fun classAt(machine: VirtualMachine, thread: VmThread, index: Int): HeapType? =
    machine.typeOfClassObject(thread.stack[index])

private fun bothWords(machine: VirtualMachine, thread: VmThread, first: Int): Int {
    machine.highWord = thread.stack[first + 1]
    return thread.stack[first]
}

/** Throws a `NullPointerException`; returns 0. */
internal fun nullPointer(machine: VirtualMachine, thread: VmThread): Int {
    machine.raise(thread, BuiltInException.NULL_POINTER)
    return 0
}

/** Returns [reference], an object just made; throws an `OutOfMemoryError` if it is 0. */
internal fun made(machine: VirtualMachine, thread: VmThread, reference: Int): Int {
    if (reference == 0) machine.raise(thread, BuiltInException.OUT_OF_MEMORY)
    return reference
}

/** Returns the result [value] of a native method. */
internal fun long(machine: VirtualMachine, value: Long): Int {
    machine.highWord = (value shr Int.SIZE_BITS).toInt()
    return value.toInt()
}
