package robotran.tinyvm.natives

import robotran.tinyvm.link.BuiltInException
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VmThread
import robotran.tinyvm.run.action
import robotran.tinyvm.run.rcx

/** How a program declares a native method: its name and descriptor, and whether it is static. */
internal data class DeclaredNative(val signature: String, val isStatic: Boolean)

/** The native methods of the class library that take no object, so that they work in any class if they are static. */
private val staticOfLibrary: List<String> = listOf(
    "java/lang/Thread.yield()V",
    "java/lang/Thread.sleep(J)V",
    "java/lang/Thread.currentThread()Ljava/lang/Thread;",
    "java/lang/Thread.interrupted()Z",
    "java/lang/System.exit(I)V",
    "java/lang/System.currentTimeMillis()J",
    "java/lang/Float.floatToIntBits(F)I",
    "java/lang/Float.intBitsToFloat(I)F",
    "josx/platform/rcx/ROM.call(S)V",
    "josx/platform/rcx/ROM.call(SS)V",
    "josx/platform/rcx/ROM.call(SSS)V",
    "josx/platform/rcx/ROM.call(SSSS)V",
    "josx/platform/rcx/ROM.call(SSSSS)V",
    "josx/platform/rcx/Memory.readByte(I)B",
    "josx/platform/rcx/Memory.writeByte(IB)V",
    "josx/platform/rcx/Memory.setBit(III)V",
    "josx/platform/rcx/Memory.getDataAddress(Ljava/lang/Object;)I",
    "josx/platform/rcx/Sensor.readSensorValue(II)I",
    "josx/platform/rcx/Sensor.setSensorValue(III)V",
    "josx/platform/rcx/Serial.resetSerial()V",
    "josx/platform/rcx/Throttle.setThrottle(I)V",
    "josx/platform/rcx/PersistentMemoryArea.getRegionAddress()I",
    "josx/rcxcomm/LLC.init()V",
    "josx/rcxcomm/LLC.write([BI)V",
    "josx/rcxcomm/LLC.read()I",
    "josx/rcxcomm/LLC.isSending()Z",
    "josx/rcxcomm/LLC.isSendError()Z",
)

/** The native methods of the class library that do not look at their object. */
private val objectIgnored: List<String> = listOf(
    "java/lang/Runtime.freeMemory()J",
    "java/lang/Runtime.totalMemory()J",
)

/**
 * The native methods that a program may declare in a class of its own. Those that act on a thread or on the monitor of
 * their object are not among them.
 */
internal val nativesOfAnyClass: Map<DeclaredNative, NativeMethod> = buildMap {
    val library = threadMethods + systemMethods + memoryMethods + sensorMethods + infraredMethods

    fun add(name: String, isStatic: Boolean) =
        put(DeclaredNative(name.substringAfter('.'), isStatic), library.getValue(name))
    for (name in staticOfLibrary) add(name, isStatic = true)
    for (name in objectIgnored) {
        add(name, isStatic = true)
        add(name, isStatic = false)
    }
    add("josx/platform/rcx/Poll.setPoller()V", isStatic = false)
    put(
        DeclaredNative("setThrottle(I)V", isStatic = false),
        action { machine, thread, first -> machine.rcx.poller.setThrottle(thread.stack[first] and BYTE) },
    )
    put(
        DeclaredNative("test(Ljava/lang/String;Z)V", isStatic = true),
        action { machine, thread, first -> throwErrorUnless(thread.stack[first + 1] != 0, machine, thread) },
    )
    put(
        DeclaredNative("testEQ(Ljava/lang/String;II)V", isStatic = true),
        action { machine, thread, first ->
            throwErrorUnless(thread.stack[first + 1] == thread.stack[first + 2], machine, thread)
        },
    )
}

/** Throws an `Error`, as the native methods of leJOS's `Assertion` do. */
private fun throwErrorUnless(isTrue: Boolean, machine: VirtualMachine, thread: VmThread) {
    if (!isTrue) machine.raise(thread, BuiltInException.ERROR)
}

private const val BYTE = 0xFF
