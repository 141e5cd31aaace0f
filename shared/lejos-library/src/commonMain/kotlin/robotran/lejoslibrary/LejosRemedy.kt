package robotran.lejoslibrary

/** What a program does where a brick's class library lacks something. */
enum class LejosRemedy {
    /** Make the exception without a text: `new IllegalStateException()`. */
    EXCEPTION_WITHOUT_TEXT,

    /** Make the exception with a text: `new NoClassDefFoundError("text")`. */
    EXCEPTION_WITH_TEXT,

    /** Announce the exception with `throws`, or catch `Exception`: on a brick this one is checked. */
    CHECKED_EXCEPTION,

    /** Use `StringBuffer`. */
    STRING_BUFFER,

    /** Use `Integer.toString(number).toCharArray()`. */
    INTEGER_TO_STRING,

    /** Use `new StringBuffer(20).append(number).getChars()`. */
    APPEND_TO_STRING_BUFFER,

    /** Compute the depth: `stack.size() - stack.lastIndexOf(object)`. */
    LAST_INDEX_OF,

    /** Write `SensorConstants` in front of the constant, or let the program's class implement `SensorConstants`. */
    SENSOR_CONSTANTS,

    /** Send a packet of two bytes with `Serial.sendPacket`, and receive one with `Serial.readPacket`. */
    SERIAL_PACKETS,

    /** Use `Vector`: `addElement`, `elementAt`, `removeElementAt` and `isEmpty`. */
    VECTOR,

    /** Go through the elements in a loop from the last one to the first. */
    LOOP_FROM_THE_END,

    /** Use `LLC.sendBytes`. */
    SEND_BYTES,

    /** Leave it out; it has no effect anyway. */
    LEAVE_OUT,

    /** Import the class from `josx.platform.rcx.remotecontrol`, where leJOS 2.1 has it. */
    PACKAGE_OF_2_1,
}
