package robotran.lejoslibrary

/**
 * What the firmware of leJOS 2.1 and 3.0 knows of the classes of a program. Source: leJOS `classes.db`, `signatures.db`,
 * `native.c` and `classes.h`.
 */
internal object FirmwareTables {
    /** The classes of `java.lang` with fixed numbers, from 0. */
    val SPECIAL_CLASSES: List<String> = listOf(
        "Object",
        "Thread",
        "String",
        "Throwable",
        "Error",
        "OutOfMemoryError",
        "NoSuchMethodError",
        "StackOverflowError",
        "NullPointerException",
        "ClassCastException",
        "ArithmeticException",
        "ArrayIndexOutOfBoundsException",
        "IllegalArgumentException",
        "InterruptedException",
        "IllegalStateException",
        "IllegalMonitorStateException",
        "ThreadDeath",
    )

    /** The native methods, by name and descriptor; the firmware does not look at their classes. */
    val NATIVE_METHODS: Set<String> = setOf(
        "notify()V",
        "notifyAll()V",
        "wait()V",
        "wait(J)V",
        "start()V",
        "yield()V",
        "sleep(J)V",
        "currentThread()Ljava/lang/Thread;",
        "getPriority()I",
        "setPriority(I)V",
        "interrupt()V",
        "interrupted()Z",
        "isInterrupted()Z",
        "setDaemon(Z)V",
        "isDaemon()Z",
        "join()V",
        "join(J)V",
        "currentTimeMillis()J",
        "exit(I)V",
        "freeMemory()J",
        "totalMemory()J",
        "call(S)V",
        "call(SS)V",
        "call(SSS)V",
        "call(SSSS)V",
        "call(SSSSS)V",
        "readByte(I)B",
        "writeByte(IB)V",
        "setBit(III)V",
        "getDataAddress(Ljava/lang/Object;)I",
        "resetSerial()V",
        "readSensorValue(II)I",
        "setSensorValue(III)V",
        "setPoller()V",
        "setThrottle(I)V",
        "floatToIntBits(F)I",
        "intBitsToFloat(I)F",
        "init()V",
        "write([BI)V",
        "read()I",
        "isSending()Z",
        "isSendError()Z",
        "getRegionAddress()I",
    )

    /**
     * The native methods that take `this` in place of their first argument if they are not static, because the firmware
     * reads the arguments from the beginning.
     */
    val ARGUMENTS_FROM_THE_BEGINNING: Set<String> = NATIVE_METHODS.filter { signature ->
        val name = signature.substringBefore('(')
        signature.substringAfter('(').first() != ')' && name !in METHODS_OF_OBJECTS
    }.toSet()

    /** The descriptors of the first fields of a thread: 27 bytes. */
    val THREAD_FIELDS: List<String> = listOf("Ljava/lang/Thread;") + List(4) { "I" } + List(7) { "B" }

    /** The place of the thread's state among them: 0 new, 1 dead, 2 and more alive. */
    const val THREAD_STATE = 8

    private val METHODS_OF_OBJECTS: Set<String> get() = setOf("wait", "setPriority", "setDaemon", "join")
}
