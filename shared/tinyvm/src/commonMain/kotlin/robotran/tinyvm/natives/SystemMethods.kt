package robotran.tinyvm.natives

import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.action

/** `java.lang.System`, `Runtime` and `Float`. Source: leJOS `native.c`. */
internal val systemMethods: Map<String, NativeMethod> = mapOf(
    "java/lang/System.exit(I)V" to action { machine, _, _ -> machine.isExited = true },
    "java/lang/System.currentTimeMillis()J" to NativeMethod { machine, _, _ -> machine.milliseconds.toInt() },
    "java/lang/Runtime.freeMemory()J" to NativeMethod { machine, _, _ -> machine.heap.freeBytes },
    "java/lang/Runtime.totalMemory()J" to NativeMethod { machine, _, _ -> machine.heap.totalBytes },
    "java/lang/Float.floatToIntBits(F)I" to
        NativeMethod { _, thread, first -> Float.fromBits(thread.stack[first]).toBits() },
    "java/lang/Float.intBitsToFloat(I)F" to NativeMethod { _, thread, first -> thread.stack[first] },
)
