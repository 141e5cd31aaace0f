package robotran.tinyvm.natives

import robotran.tinyvm.run.NativeMethod

/** All native methods by class, a dot, name and descriptor. */
internal object NativeMethods {
    private val all: Map<String, NativeMethod> =
        objectMethods + threadMethods + systemMethods + memoryMethods + sensorMethods

    val names: Set<String> get() = all.keys

    fun find(name: String): NativeMethod? = all[name]
}
