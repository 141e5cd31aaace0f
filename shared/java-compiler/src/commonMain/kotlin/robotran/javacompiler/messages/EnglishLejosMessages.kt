package robotran.javacompiler.messages

import robotran.language.quoted
import robotran.lejoslibrary.LejosRemedy

internal object EnglishLejosMessages : LejosMessages {
    override fun missingInLejos(remedy: LejosRemedy, owner: String, member: String) = when (remedy) {
        LejosRemedy.EXCEPTION_WITHOUT_TEXT -> "On a real brick, leJOS makes every $owner without a text."
        LejosRemedy.EXCEPTION_WITH_TEXT -> "On a real brick, leJOS makes every $owner with a text."
        LejosRemedy.CHECKED_EXCEPTION -> checkedInLejos(owner)
        LejosRemedy.STRING_BUFFER -> "leJOS on a real brick has no $owner."
        LejosRemedy.INTEGER_TO_STRING -> "$owner.$member of leJOS takes no whole number."
        LejosRemedy.APPEND_TO_STRING_BUFFER -> "$owner.$member of leJOS takes no decimal number."
        LejosRemedy.LAST_INDEX_OF -> "A $owner of leJOS has no ${quoted(member)}."
        LejosRemedy.SENSOR_CONSTANTS -> "$owner of leJOS has no $member."
        LejosRemedy.SERIAL_PACKETS, LejosRemedy.VECTOR -> "leJOS 2.1 has no $owner. It came with leJOS 3.0."
        LejosRemedy.LOOP_FROM_THE_END -> "A $owner of leJOS 2.1 has no ${quoted(member)}. It came with leJOS 3.0."
        LejosRemedy.SEND_BYTES, LejosRemedy.LEAVE_OUT -> "A $owner of leJOS has no ${quoted(member)}."
        LejosRemedy.PACKAGE_OF_2_1 -> "leJOS 2.1 has $owner in another package."
    }

    override fun insteadInLejos(remedy: LejosRemedy, owner: String, member: String) = when (remedy) {
        LejosRemedy.EXCEPTION_WITHOUT_TEXT -> "Write \"new $owner()\", or take Exception, which can have a text."
        LejosRemedy.EXCEPTION_WITH_TEXT -> "Write new $owner(\"text\")."
        LejosRemedy.SEND_BYTES -> "Write LLC.sendBytes, which also waits until all is sent."
        LejosRemedy.CHECKED_EXCEPTION -> catchException()
        LejosRemedy.STRING_BUFFER -> "StringBuffer can do the same."
        LejosRemedy.INTEGER_TO_STRING -> "Write Integer.toString(number).toCharArray()."
        LejosRemedy.APPEND_TO_STRING_BUFFER -> "Write new StringBuffer(20).append(number).getChars()."
        LejosRemedy.LAST_INDEX_OF -> "Calculate it: stack.size() - stack.lastIndexOf(object)."
        LejosRemedy.SENSOR_CONSTANTS -> "Write SensorConstants.$member."

        LejosRemedy.SERIAL_PACKETS -> {
            "Send a packet of two bytes with Serial.sendPacket, and receive it with Serial.readPacket."
        }

        LejosRemedy.VECTOR -> "There, use a Vector with addElement, elementAt, removeElementAt and isEmpty."
        LejosRemedy.LOOP_FROM_THE_END -> "There, go through the elements from the last one to the first."
        LejosRemedy.LEAVE_OUT -> "Leave it out: it does nothing."
        LejosRemedy.PACKAGE_OF_2_1 -> "There, import it from josx.platform.rcx.remotecontrol."
    }

    override fun builderOfCompiler() =
        "A newer compiler takes it for every \"+\" of texts. \"javac -source 1.3 -target 1.1\" of a JDK up to 8 does " +
            "not, and Robotran compiles Java sources itself."

    override fun checkedInLejos(name: String) = "On a real brick, every $name must be announced with \"throws\"."

    override fun catchException() = "Catch Exception instead."

    override fun unlockedMethod(name: String, modifier: String) =
        "A brick does not lock for a method that is ${quoted(modifier)}, so ${quoted(name)} is not synchronized there."

    override fun monitorCallFails(method: String) =
        "Unless the lock is held already, ${quoted(method)} in it ends with an IllegalMonitorStateException."

    override fun lockWithoutPrivate() = "Leave \"private\" out, or put what is in it into synchronized (this) { ... }."

    override fun lockAnObject() =
        "Give the class \"static final Object LOCK = new Object();\" and put what is in the method into " +
            "synchronized (LOCK) { ... }."

    override fun unlockedSuperCall(name: String) =
        "A brick does not lock for a call with \"super\", so ${quoted(name)} is not synchronized here."

    override fun lockThis() = "Put the call into synchronized (this) { ... }."

    override fun textAndNumber() =
        "On a real brick, a number may not fit behind a text: leJOS makes no room for it, and an exception ends the " +
            "program."

    override fun makeRoomForNumber() = "Show the number with LCD.showNumber, or make a text of it: " +
        "new StringBuffer(20).append(\"x\").append(Integer.toString(7)).toString()."

    override fun largeStep() =
        "With \"+=\" and \"-=\", leJOS adds at most 127 to a variable of a method, or takes at most 128 from it."

    override fun insteadOfStep(sum: String) = "Write \"$sum\"."
}
