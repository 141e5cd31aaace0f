package robotran.javacompiler.messages

import robotran.language.quoted
import robotran.lejoslibrary.LejosRemedy

internal object SpanishLejosMessages : LejosMessages {
    override fun missingInLejos(remedy: LejosRemedy, owner: String, member: String) = when (remedy) {
        LejosRemedy.EXCEPTION_WITHOUT_TEXT -> "En un ladrillo real, leJOS crea cada $owner sin texto."
        LejosRemedy.EXCEPTION_WITH_TEXT -> "En un ladrillo real, leJOS crea cada $owner con un texto."
        LejosRemedy.CHECKED_EXCEPTION -> checkedInLejos(owner)
        LejosRemedy.STRING_BUFFER -> "leJOS en un ladrillo real no tiene $owner."
        LejosRemedy.INTEGER_TO_STRING -> "$owner.$member de leJOS no toma números enteros."
        LejosRemedy.APPEND_TO_STRING_BUFFER -> "$owner.$member de leJOS no toma números decimales."
        LejosRemedy.LAST_INDEX_OF -> "Un $owner de leJOS no tiene ${quoted(member)}."
        LejosRemedy.SENSOR_CONSTANTS -> "$owner de leJOS no tiene $member."
        LejosRemedy.SERIAL_PACKETS, LejosRemedy.VECTOR -> "leJOS 2.1 no tiene $owner. Llegó con leJOS 3.0."
        LejosRemedy.LOOP_FROM_THE_END -> "Un $owner de leJOS 2.1 no tiene ${quoted(member)}. Llegó con leJOS 3.0."
        LejosRemedy.SEND_BYTES, LejosRemedy.LEAVE_OUT -> "Un $owner de leJOS no tiene ${quoted(member)}."
        LejosRemedy.PACKAGE_OF_2_1 -> "leJOS 2.1 tiene $owner en otro paquete."
    }

    override fun insteadInLejos(remedy: LejosRemedy, owner: String, member: String) = when (remedy) {
        LejosRemedy.EXCEPTION_WITHOUT_TEXT -> "Escribe \"new $owner()\", o usa Exception, que puede tener un texto."
        LejosRemedy.EXCEPTION_WITH_TEXT -> "Escribe new $owner(\"text\")."
        LejosRemedy.SEND_BYTES -> "Escribe LLC.sendBytes, que también espera hasta que todo se ha enviado."
        LejosRemedy.CHECKED_EXCEPTION -> catchException()
        LejosRemedy.STRING_BUFFER -> "StringBuffer puede hacer lo mismo."
        LejosRemedy.INTEGER_TO_STRING -> "Escribe Integer.toString(numero).toCharArray()."
        LejosRemedy.APPEND_TO_STRING_BUFFER -> "Escribe new StringBuffer(20).append(numero).getChars()."
        LejosRemedy.LAST_INDEX_OF -> "Calcúlalo: stack.size() - stack.lastIndexOf(object)."
        LejosRemedy.SENSOR_CONSTANTS -> "Escribe SensorConstants.$member."

        LejosRemedy.SERIAL_PACKETS -> {
            "Envía un paquete de dos bytes con Serial.sendPacket y recíbelo con Serial.readPacket."
        }

        LejosRemedy.VECTOR -> "Allí, usa un Vector con addElement, elementAt, removeElementAt e isEmpty."
        LejosRemedy.LOOP_FROM_THE_END -> "Allí, recorre los elementos desde el último hasta el primero."
        LejosRemedy.LEAVE_OUT -> "Quítalo: no hace nada."
        LejosRemedy.PACKAGE_OF_2_1 -> "Allí, impórtalo de josx.platform.rcx.remotecontrol."
    }

    override fun builderOfCompiler() =
        "Un compilador más nuevo lo usa en cada \"+\" de textos. \"javac -source 1.3 -target 1.1\" de un JDK hasta " +
            "el 8 no, y Robotran compila él mismo los archivos de Java."

    override fun checkedInLejos(name: String) = "En un ladrillo real, cada $name se tiene que anunciar con \"throws\"."

    override fun catchException() = "Captura Exception en su lugar."

    override fun unlockedMethod(name: String, modifier: String) =
        "Un ladrillo no bloquea nada para un método con ${quoted(modifier)}, así que allí ${quoted(name)} no es " +
            "synchronized."

    override fun monitorCallFails(method: String) =
        "Si no está ya bloqueado, ${quoted(method)} acaba allí con una IllegalMonitorStateException."

    override fun lockWithoutPrivate() = "Quita \"private\", o pon todo lo que contiene en synchronized (this) { ... }."

    override fun lockAnObject() =
        "Da a la clase \"static final Object LOCK = new Object();\" y pon todo lo del método en " +
            "synchronized (LOCK) { ... }."

    override fun unlockedSuperCall(name: String) =
        "Un ladrillo no bloquea nada para una llamada con \"super\", así que aquí ${quoted(name)} no es synchronized."

    override fun lockThis() = "Pon la llamada en synchronized (this) { ... }."

    override fun textAndNumber() =
        "En un ladrillo real, puede que un número no quepa detrás de un texto: leJOS no le hace sitio, y una " +
            "excepción acaba el programa."

    override fun makeRoomForNumber() = "Muestra el número con LCD.showNumber, o conviértelo en texto: " +
        "new StringBuffer(20).append(\"x\").append(Integer.toString(7)).toString()."

    override fun largeStep() =
        "Con \"+=\" y \"-=\", leJOS suma como mucho 127 a una variable de un método, o le resta como mucho 128."

    override fun insteadOfStep(sum: String) = "Escribe \"$sum\"."
}
