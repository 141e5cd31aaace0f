package robotran.tinyvm.link

/**
 * The classes and signatures that have the same number in every program, because the virtual machine of leJOS refers to
 * them. A brick shows these numbers for an uncaught exception. Source: leJOS 2.1 and 3.0, `classes.db` and
 * `signatures.db`.
 */
object SpecialNumbers {
    /** The internal names of the special classes by number. All other classes follow. */
    val CLASSES: List<String> = listOf(
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
    ).map { "java/lang/$it" }

    /** The numbers of the special classes. */
    internal val CLASS_NUMBERS: Map<String, Int> = CLASSES.withIndex().associate { it.value to it.index }

    /** The class of an exception that ends its thread silently. */
    val THREAD_DEATH: String = CLASSES.last()

    /** The special signatures, names with descriptors, by number. All other signatures follow. */
    val SIGNATURES: List<String> = listOf(
        "main([Ljava/lang/String;)V",
        "run()V",
        "<init>()V",
        "<clinit>()V",
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
        "getMessage()Ljava/lang/String;",
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
        "test(Ljava/lang/String;Z)V",
        "testEQ(Ljava/lang/String;II)V",
        "floatToIntBits(F)I",
        "intBitsToFloat(I)F",
        "init()V",
        "write([BI)V",
        "read()I",
        "isSending()Z",
        "isSendError()Z",
        "getRegionAddress()I",
    )
}
