package robotran.tinyvm.natives

import robotran.tinyvm.link.LinkedMethod
import robotran.tinyvm.run.NativeMethod

/**
 * All native methods. Those of the class library are found by class, name and descriptor. A brick does not look at the
 * class; therefore a program may declare those of [nativesOfAnyClass] in classes of its own.
 */
internal object NativeMethods {
    private val ofLibrary: Map<String, NativeMethod> =
        objectMethods + threadMethods + systemMethods + memoryMethods + sensorMethods + infraredMethods

    /** The names of the class library's methods: internal class name, dot, method name and descriptor. */
    val names: Set<String> get() = ofLibrary.keys

    fun find(method: LinkedMethod): NativeMethod? = ofLibrary["${method.owner.name}.${method.signature}"]
        ?: nativesOfAnyClass[DeclaredNative(method.signature, method.isStatic)]
}
