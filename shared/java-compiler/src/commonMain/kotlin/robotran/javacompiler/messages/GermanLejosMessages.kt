package robotran.javacompiler.messages

import robotran.language.quoted
import robotran.lejoslibrary.LejosRemedy

internal object GermanLejosMessages : LejosMessages {
    override fun missingInLejos(remedy: LejosRemedy, owner: String, member: String) = when (remedy) {
        LejosRemedy.EXCEPTION_WITHOUT_TEXT -> "Auf einem echten Stein macht leJOS jede $owner ohne Text."
        LejosRemedy.EXCEPTION_WITH_TEXT -> "Auf einem echten Stein macht leJOS jeden $owner mit einem Text."
        LejosRemedy.CHECKED_EXCEPTION -> checkedInLejos(owner)
        LejosRemedy.STRING_BUFFER -> "leJOS hat auf einem echten Stein keinen $owner."
        LejosRemedy.INTEGER_TO_STRING -> "$owner.$member von leJOS nimmt keine ganze Zahl."
        LejosRemedy.APPEND_TO_STRING_BUFFER -> "$owner.$member von leJOS nimmt keine Kommazahl."
        LejosRemedy.LAST_INDEX_OF -> "Ein $owner von leJOS hat kein ${quoted(member)}."
        LejosRemedy.SENSOR_CONSTANTS -> "$owner von leJOS hat kein $member."
        LejosRemedy.SERIAL_PACKETS, LejosRemedy.VECTOR -> "leJOS 2.1 hat kein $owner. Das kam mit leJOS 3.0."
        LejosRemedy.LOOP_FROM_THE_END -> "Ein $owner von leJOS 2.1 hat kein ${quoted(member)}. Das kam mit leJOS 3.0."
        LejosRemedy.SEND_BYTES, LejosRemedy.LEAVE_OUT -> "Ein $owner von leJOS hat kein ${quoted(member)}."
        LejosRemedy.PACKAGE_OF_2_1 -> "leJOS 2.1 hat $owner in einem anderen Paket."
    }

    override fun insteadInLejos(remedy: LejosRemedy, owner: String, member: String) = when (remedy) {
        LejosRemedy.EXCEPTION_WITHOUT_TEXT -> {
            "Schreib \"new $owner()\", oder nimm Exception, die einen Text haben kann."
        }

        LejosRemedy.EXCEPTION_WITH_TEXT -> "Schreib new $owner(\"text\")."
        LejosRemedy.SEND_BYTES -> "Schreib LLC.sendBytes, das auch wartet, bis alles gesendet ist."
        LejosRemedy.CHECKED_EXCEPTION -> catchException()
        LejosRemedy.STRING_BUFFER -> "StringBuffer kann dasselbe."
        LejosRemedy.INTEGER_TO_STRING -> "Schreib Integer.toString(zahl).toCharArray()."
        LejosRemedy.APPEND_TO_STRING_BUFFER -> "Schreib new StringBuffer(20).append(zahl).getChars()."
        LejosRemedy.LAST_INDEX_OF -> "Rechne es aus: stack.size() - stack.lastIndexOf(object)."
        LejosRemedy.SENSOR_CONSTANTS -> "Schreib SensorConstants.$member."

        LejosRemedy.SERIAL_PACKETS -> {
            "Sende mit Serial.sendPacket ein Paket von zwei Bytes und empfange es mit Serial.readPacket."
        }

        LejosRemedy.VECTOR -> "Nimm dort einen Vector mit addElement, elementAt, removeElementAt und isEmpty."
        LejosRemedy.LOOP_FROM_THE_END -> "Geh dort die Elemente vom letzten zum ersten durch."
        LejosRemedy.LEAVE_OUT -> "Lass es weg: Es tut nichts."
        LejosRemedy.PACKAGE_OF_2_1 -> "Importiere es dort aus josx.platform.rcx.remotecontrol."
    }

    override fun builderOfCompiler() =
        "Ein neuerer Compiler nimmt ihn für jedes \"+\" von Texten. \"javac -source 1.3 -target 1.1\" aus einem JDK " +
            "bis 8 tut das nicht, und Robotran übersetzt Java-Dateien selbst."

    override fun checkedInLejos(name: String) =
        "Auf einem echten Stein muss jede $name mit \"throws\" angekündigt werden."

    override fun catchException() = "Fang stattdessen Exception."

    override fun unlockedMethod(name: String, modifier: String) =
        "Für eine Methode mit ${quoted(modifier)} sperrt ein Stein nichts, also ist ${quoted(name)} dort nicht " +
            "synchronized."

    override fun monitorCallFails(method: String) =
        "Wenn nicht schon gesperrt ist, endet ${quoted(method)} darin mit einer IllegalMonitorStateException."

    override fun lockWithoutPrivate() = "Lass \"private\" weg, oder setz alles darin in synchronized (this) { ... }."

    override fun lockAnObject() =
        "Gib der Klasse \"static final Object LOCK = new Object();\" und setz alles in der Methode in " +
            "synchronized (LOCK) { ... }."

    override fun unlockedSuperCall(name: String) =
        "Für einen Aufruf mit \"super\" sperrt ein Stein nichts, also ist ${quoted(name)} hier nicht synchronized."

    override fun lockThis() = "Setz den Aufruf in synchronized (this) { ... }."

    override fun textAndNumber() =
        "Auf einem echten Stein passt eine Zahl vielleicht nicht hinter einen Text: leJOS macht ihr keinen Platz, " +
            "und eine Ausnahme beendet das Programm."

    override fun makeRoomForNumber() = "Zeig die Zahl mit LCD.showNumber, oder mach einen Text daraus: " +
        "new StringBuffer(20).append(\"x\").append(Integer.toString(7)).toString()."

    override fun largeStep() =
        "Mit \"+=\" und \"-=\" zählt leJOS höchstens 127 zu einer Variablen einer Methode dazu oder höchstens 128 davon ab."

    override fun insteadOfStep(sum: String) = "Schreib \"$sum\"."
}
