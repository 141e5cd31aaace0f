package robotran.tinyvm.link

/**
 * The classes that have the same number in every program for an NXT, because the virtual machine of leJOS NXJ refers to
 * them. The brick shows these numbers for an uncaught exception. Numbers between them belong to primitive types and arrays.
 */
internal object NxtNumbers {
    /** No class has a number from here on. */
    const val FIRST_ARRAY = 256

    /** By internal name. All other classes follow the last one. */
    val CLASSES: Map<String, Int> = mapOf(
        "Object" to 0,
        "Throwable" to 1,
        "Error" to 2,
        "OutOfMemoryError" to 3,
        "NoSuchMethodError" to 14,
        "StackOverflowError" to 15,
        "NullPointerException" to 16,
        "ClassCastException" to 26,
        "ArithmeticException" to 27,
        "ArrayIndexOutOfBoundsException" to 28,
        "IllegalArgumentException" to 29,
        "InterruptedException" to 30,
        "IllegalStateException" to 31,
        "IllegalMonitorStateException" to 32,
        "ThreadDeath" to 33,
        "ArrayStoreException" to 34,
        "NegativeArraySizeException" to 35,
    ).mapKeys { "java/lang/${it.key}" }
}
