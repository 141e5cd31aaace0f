package robotran.tinyvm.link

import robotran.tinyvm.config.MachineModel

/** Exceptions that the virtual machine itself throws, by internal class name. Source: leJOS `exceptions.c`. */
internal enum class BuiltInException(val className: String) {
    ERROR("java/lang/Error"),
    NULL_POINTER("java/lang/NullPointerException"),
    ARITHMETIC("java/lang/ArithmeticException"),
    ARRAY_INDEX("java/lang/ArrayIndexOutOfBoundsException"),
    CLASS_CAST("java/lang/ClassCastException"),
    ILLEGAL_ARGUMENT("java/lang/IllegalArgumentException"),
    ILLEGAL_STATE("java/lang/IllegalStateException"),
    ILLEGAL_MONITOR_STATE("java/lang/IllegalMonitorStateException"),
    INTERRUPTED("java/lang/InterruptedException"),
    NO_SUCH_METHOD("java/lang/NoSuchMethodError"),
    OUT_OF_MEMORY("java/lang/OutOfMemoryError"),
    STACK_OVERFLOW("java/lang/StackOverflowError"),
    ARRAY_STORE("java/lang/ArrayStoreException"),
    NEGATIVE_ARRAY_SIZE("java/lang/NegativeArraySizeException"),
    ;

    companion object {
        private const val OF_RCX = 12

        /** Those of a machine, in the order in which it creates them: an RCX has the first twelve. */
        fun of(model: MachineModel): List<BuiltInException> = if (model.isExact) entries else entries.take(OF_RCX)
    }
}
