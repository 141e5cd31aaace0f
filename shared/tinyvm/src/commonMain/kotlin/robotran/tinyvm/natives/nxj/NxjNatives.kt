package robotran.tinyvm.natives.nxj

import robotran.tinyvm.link.LinkedMethod
import robotran.tinyvm.run.NativeMethod

/** The native methods of the class library of leJOS NXJ, by class, name and descriptor. */
internal object NxjNatives {
    private val all: Map<String, NativeMethod> = languageMethods + nxjThreadMethods + nxjSystemMethods +
        motorMethods + nxtSensorMethods + displayMethods + brickMethods + radioMethods + flashMethods

    /** The names of the methods: internal class name, dot, method name and descriptor. */
    val names: Set<String> get() = all.keys

    fun find(method: LinkedMethod): NativeMethod? = all["${method.owner.name}.${method.signature}"]
}
