package robotran.tinyvm.natives

import robotran.tinyvm.run.NativeMethod

/** All native methods. A key is the internal class name, a dot, the method name and the descriptor. */
internal object NativeMethods {
    private val all: Map<String, NativeMethod> =
        objectMethods + threadMethods + systemMethods + memoryMethods + sensorMethods

    val names: Set<String> get() = all.keys

    fun find(name: String): NativeMethod? = all[name]
}
