package robotran.lejoslibrary

import robotran.tinyvm.config.LejosVersion

/**
 * All differences between the class library and those of leJOS 2.1 and 3.0. A program in which nothing of this list
 * occurs compiles with leJOS; the list does not cover what the virtual machines do differently.
 */
object LejosDifferences {
    /** Exceptions that only have a constructor without a text in leJOS. */
    private val withoutText = listOf(
        "java/lang/ArithmeticException",
        "java/lang/ArrayIndexOutOfBoundsException",
        "java/lang/ClassCastException",
        "java/lang/ClassNotFoundException",
        "java/lang/Error",
        "java/lang/IllegalArgumentException",
        "java/lang/IllegalMonitorStateException",
        "java/lang/IllegalStateException",
        "java/lang/InterruptedException",
        "java/lang/NoSuchMethodError",
        "java/lang/NullPointerException",
        "java/lang/OutOfMemoryError",
        "java/lang/RuntimeException",
        "java/lang/StackOverflowError",
        "java/lang/ThreadDeath",
        "java/util/EmptyQueueException",
        "java/util/EmptyStackException",
        "josx/robotics/StopException",
    ).map { LejosDifference(it, "<init>(Ljava/lang/String;)V", null, LejosRemedy.EXCEPTION_WITHOUT_TEXT) }

    /** leJOS's `Sensor` does not implement `SensorConstants`. */
    private val constantsOfSensor = listOf(
        "SENSOR_TYPE_RAW",
        "SENSOR_TYPE_TOUCH",
        "SENSOR_TYPE_TEMP",
        "SENSOR_TYPE_LIGHT",
        "SENSOR_TYPE_ROT",
        "SENSOR_MODE_RAW",
        "SENSOR_MODE_BOOL",
        "SENSOR_MODE_EDGE",
        "SENSOR_MODE_PULSE",
        "SENSOR_MODE_PCT",
        "SENSOR_MODE_DEGC",
        "SENSOR_MODE_DEGF",
        "SENSOR_MODE_ANGLE",
        "RAW_VALUE",
        "CANONICAL_VALUE",
        "BOOLEAN_VALUE",
    ).map { LejosDifference("josx/platform/rcx/Sensor", "$it:I", null, LejosRemedy.SENSOR_CONSTANTS) }

    private val others = listOf(
        LejosDifference("java/lang/NoClassDefFoundError", "<init>()V", null, LejosRemedy.EXCEPTION_WITH_TEXT),
        LejosDifference("java/lang/ArithmeticException", "", null, LejosRemedy.CHECKED_EXCEPTION),
        LejosDifference("java/lang/StringBuilder", "", null, LejosRemedy.STRING_BUFFER),
        LejosDifference("java/lang/StringUtils", "getCharacters(I)[C", null, LejosRemedy.INTEGER_TO_STRING),
        LejosDifference("java/lang/StringUtils", "getCharacters(F)[C", null, LejosRemedy.APPEND_TO_STRING_BUFFER),
        LejosDifference("java/util/Stack", "search(Ljava/lang/Object;)I", null, LejosRemedy.LAST_INDEX_OF),
        LejosDifference("josx/rcxcomm/LLC", "write([BI)V", null, LejosRemedy.SEND_BYTES),
        LejosDifference("java/net/Socket", "close()V", null, LejosRemedy.LEAVE_OUT),
    )

    private val newIn30 = listOf("EmptyQueueException", "EmptyStackException", "Queue", "Stack").map {
        LejosDifference("java/util/$it", "", LejosVersion.V3_0, LejosRemedy.VECTOR)
    } + listOf("lastIndexOf(Ljava/lang/Object;)I", "lastIndexOf(Ljava/lang/Object;I)I").map {
        LejosDifference("java/util/Vector", it, LejosVersion.V3_0, LejosRemedy.LOOP_FROM_THE_END)
    } + LejosDifference("josx/platform/rcx/Message", "", LejosVersion.V3_0, LejosRemedy.SERIAL_PACKETS)

    private val movedIn30 = listOf("RemoteControlAdapter", "RemoteControlListener", "RemoteControlSensor").map {
        LejosDifference("josx/rcxcomm/remotecontrol/$it", "", LejosVersion.V3_0, LejosRemedy.PACKAGE_OF_2_1)
    }

    /** All of them, each once. */
    val all: List<LejosDifference> = withoutText + constantsOfSensor + others + newIn30 + movedIn30
}
