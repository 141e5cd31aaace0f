package robotran.javacompiler.messages

import robotran.language.quoted
import robotran.lejoslibrary.LejosRemedy

/**
 * The messages in German. They address the pupil as "du". Glossary: array - Array, braces - geschweifte Klammern,
 * brackets - Klammern, brick - Stein, class - Klasse, declare - anlegen, field - Feld, loop - Schleife, method -
 * Methode, text - Text, type - Typ, value - Wert.
 */
object GermanJavaMessages :
    JavaMessages,
    JavaSyntaxMessages by GermanJavaSyntaxMessages,
    JavaNameMessages by GermanJavaNameMessages,
    JavaSemanticMessages by GermanJavaSemanticMessages,
    JavaClassMessages by GermanJavaClassMessages,
    UnsupportedOnBrickMessages by GermanBrickMessages,
    LejosMessages by GermanLejosMessages

private object GermanJavaSyntaxMessages : JavaSyntaxMessages {
    override fun missingSemicolon() = "Ans Ende dieser Anweisung gehört ein \";\"."

    override fun missingBracket(bracket: String) =
        "Hier steht ein ${quoted(openingOf(bracket))} ohne sein ${quoted(bracket)}."

    override fun extraBracket(bracket: String) = "Dieses ${quoted(bracket)} ist eins zu viel, oder davor fehlt etwas."

    override fun expectedInstead(word: String, expected: String) =
        "Java erwartet hier ${quoted(expected)}, nicht ${quoted(word)}."

    override fun expectedAfter(word: String, expected: String) =
        "Java erwartet ${quoted(expected)} nach ${quoted(word)}."

    override fun notUnderstood(word: String) = "Java kann hier mit ${quoted(word)} nichts anfangen."

    override fun somethingMissing(word: String) = "Nach ${quoted(word)} fehlt etwas."

    override fun compilerSays(english: String) =
        "Hier ist etwas, das Java nicht erlaubt. Der Compiler sagt es auf Englisch: $english"

    override fun unclosedString() = "Diesem Text fehlt das Anführungszeichen am Ende."

    override fun closeString() =
        "Setz ein Anführungszeichen hinter seinen letzten Buchstaben. Ein Text kann nicht in der nächsten Zeile " +
            "weitergehen."

    override fun wrongCharacter() =
        "Zwischen einfachen Anführungszeichen steht genau ein Zeichen. Ein Text hat doppelte."

    override fun foreignWord(word: String, javaWord: String) = "Java sagt ${quoted(javaWord)} statt ${quoted(word)}."

    override fun noSuchWord(word: String) = "Java hat kein ${quoted(word)}. Lass es weg."

    override fun conditionInBrackets(word: String) =
        "Was nach ${quoted(word)} kommt, steht in Klammern, zum Beispiel: ${exampleOf(word)}"

    override fun semicolonsInFor() = "Zwischen den drei Teilen eines \"for\" steht \";\": for (int i = 0; i < 4; i++)"

    override fun elseWithoutIf() =
        "Zu diesem \"else\" gibt es kein \"if\". Such nach einem \";\" gleich hinter dem \"if\" oder nach einem " +
            "fehlenden \"{\" oder \"}\"."

    override fun outsideMethod() = "Diese Anweisung steht in einer Klasse, aber in keiner ihrer Methoden."

    override fun moveIntoMethod() = "Schieb sie zwischen die geschweiften Klammern einer Methode, zum Beispiel main."

    override fun outsideClass() = "Das steht in keiner Klasse, und in Java steht alles in einer."

    override fun beginWithClass(className: String) =
        "Beginn mit: public class $className { public static void main(String[] args) { und hör auf mit: } }"

    override fun callWithBrackets(name: String) =
        "Um die Methode ${quoted(name)} aufzurufen, setz Klammern dahinter: $name()"

    override fun noStatement() = "Hier wird etwas ausgerechnet, aber nichts damit gemacht."

    override fun setWithOneSign() =
        "Zwei Zeichen vergleichen. Um einer Variable einen Wert zu geben, schreib nur ein \"=\"."

    override fun reservedWord(word: String) =
        "${quoted(word)} ist ein eigenes Wort von Java, also kann nichts so heißen. Nimm einen anderen Namen."

    override fun nameBeginsWithLetter() = "Ein Name beginnt mit einem Buchstaben, nicht mit einer Ziffer."

    override fun typeOfParameter() =
        "In den Klammern einer Methode steht vor jedem Namen sein Typ, zum Beispiel: (int speed)"

    override fun lengthOfArray() = "Ein Array bekommt seine Länge dort, wo es gemacht wird: int[] values = new int[3];"

    override fun arrayOfValues() = "Schreib vor die geschweiften Klammern, was gemacht wird: new int[] {1, 2, 3}"

    override fun tryAlone() = "Dieses \"try\" hat kein \"catch\"."

    override fun addCatch() = "Schreib hinter sein \"}\": catch (InterruptedException e) { }"

    override fun sourceTooLong(limit: String) =
        "Ein Programm kann höchstens $limit Zeichen und 100 Dateien haben. Von diesem wurde nichts gelesen."

    override fun nestedTooDeeply() =
        "Hier steht zu viel ineinander. Nimm für einen Teil eine Methode oder eine Variable."

    override fun compilerFailed() =
        "Der Compiler ist mit diesem Programm nicht fertig geworden. Nimm deine letzte Änderung weg und versuch es " +
            "noch einmal."
}

private object GermanJavaNameMessages : JavaNameMessages {
    override fun unknownClass(name: String) = "Es gibt keine Klasse ${quoted(name)}."

    override fun unknownVariable(name: String) = "Es gibt keine Variable ${quoted(name)}."

    override fun unknownMethod(name: String, owner: String) = "${quoted(owner)} hat keine Methode ${quoted(name)}."

    override fun unknownMethodHere(name: String, owner: String) =
        "${quoted(owner)} hat keine Methode ${quoted(name)}, und es steht keine Klasse davor."

    override fun unknownField(name: String, owner: String?) =
        if (owner == null) "Hier gibt es kein ${quoted(name)}." else "${quoted(owner)} hat kein ${quoted(name)}."

    override fun unknownImport(name: String) = "Der Stein hat kein ${quoted(name)}."

    override fun didYouMean(suggestion: String) = "Meinst du ${quoted(suggestion)}?"

    override fun wrongCase(suggestion: String) =
        "Schreib ${quoted(suggestion)}: Java unterscheidet kleine und große Buchstaben."

    override fun importIt(line: String) = "Schreib ${quoted(line)} ganz nach oben."

    override fun declareIt(name: String) = "Leg sie vorher an, zum Beispiel mit \"int $name = 0;\"."

    override fun writeMethod(name: String) = "Schreib die Methode: static void $name() { }"

    override fun isPrivate(name: String, owner: String) =
        "${quoted(name)} ist privat: Nur ${quoted(owner)} selbst darf es benutzen."

    override fun usePublic() =
        "Nimm dort, wo es angelegt wird, \"private\" weg, oder nimm eine Methode, die seine Klasse dafür hat."

    override fun lengthOfArrayValue() = "Die Länge eines Arrays hat keine Klammern: values.length"

    override fun lengthOfTextOrArray() =
        "Die Länge eines Textes hat Klammern, word.length(), und die eines Arrays hat keine, values.length."

    override fun noArray(type: String) =
        "Nur ein Array hat \"[...]\" hinter sich, und das hier ist ein ${quoted(type)}."

    override fun charAt() = "Ein Buchstabe eines Textes ist word.charAt(0), wobei der erste die Nummer 0 hat."

    override fun noMembers(type: String) =
        "Das ist vom Typ ${quoted(type)}, ein einzelner Wert, und hat keine Methoden."
}

private object GermanJavaSemanticMessages : JavaSemanticMessages {
    override fun doesNotFit(given: String, needed: String) =
        "Das ist vom Typ ${quoted(given)}, aber hier wird ${quoted(needed)} gebraucht."

    override fun castNumber(type: String) =
        "Schreib \"($type)\" davor und setz es in Klammern, wenn ein Teil verloren gehen darf."

    override fun castObject(type: String) = "Schreib \"($type)\" davor, wenn du weißt, dass es eins ist."

    override fun writeFloat(number: String) = "Schreib \"${number}f\"."

    override fun compareWithTwoSigns() =
        "Zum Vergleichen schreib \"==\". Ein einzelnes \"=\" gibt einer Variable einen Wert."

    override fun compareWithZero() =
        "Eine Bedingung ist wahr oder falsch. Vergleich die Zahl mit etwas, zum Beispiel: count > 0"

    override fun makeText() = "Integer.toString(...) um eine ganze Zahl macht sie zu einem Text."

    override fun givesNothing() =
        "Diese Methode ist \"void\", also gibt sie nichts zurück, was man hier benutzen könnte."

    override fun notInitialized(name: String) =
        "${quoted(name)} hat vielleicht noch keinen Wert. Gib ihm dort einen, wo es angelegt wird."

    override fun declaredTwice(name: String) =
        "${quoted(name)} ist schon angelegt. Nimm einen anderen Namen, oder lass den Typ weg, um nur den Wert zu " +
            "ändern."

    override fun returnsNothing() =
        "Diese Methode ist \"void\", also gibt sie nichts zurück. Schreib \"return;\" oder ändere ihren Typ."

    override fun mustReturn() = "Diese Methode muss auf jedem Weg einen Wert zurückgeben."

    override fun returnValue() =
        "Schreib \"return\" und den Wert, auch für den Fall, dass kein \"if\" zutrifft. Gibt es keinen, mach sie " +
            "\"void\"."

    override fun neverReached() = "Hierher kommt das Programm nie. Das liegt an dem, was davor steht."

    override fun unhandledException(name: String) =
        "Hier kann ${quoted(name)} passieren, und nichts kümmert sich darum."

    override fun handleIt(name: String) =
        "Schreib \"throws $name\" hinter die Klammern der Methode, wie in \"main(String[] args) throws $name\", oder " +
            "setz es in " +
            "try { ... } catch ($name e) { }, wie eine Methode \"run\" es muss."

    override fun neverThrown(name: String) =
        "Nichts in dem \"try\" kann zu ${quoted(name)} führen, oder ein \"catch\" davor hat es schon gefangen."

    override fun removeCatch() = "Nimm dieses \"catch\" weg."

    override fun wrongArguments(method: String, needed: String, given: String) =
        "${quoted(method)} nimmt ${inBrackets(needed)}, nicht ${inBrackets(given)}."

    override fun staticNeeded(name: String) =
        "${quoted(name)} gehört zu einem Objekt, und in einer \"static\"-Methode gibt es keins."

    override fun makeItStatic() = "Schreib \"static\" davor, wo es angelegt wird."

    override fun objectNeeded(name: String, owner: String) =
        "${quoted(name)} braucht ein Objekt von ${quoted(owner)}, nicht die Klasse."

    override fun neverChanges(name: String) = "${quoted(name)} ist \"final\", also bekommt es nur einmal einen Wert."

    override fun numberTooLarge(number: String) =
        "$number ist zu groß. Ein \"int\" geht von -2147483648 bis 2147483647."

    override fun noEffect() = "Das ändert nichts."

    override fun emptyStatement() =
        "Dieses \";\" ist alles, was hier getan wird. Nimm es weg, wenn danach ein Block kommt."

    override fun wrongOperator(operator: String, types: String) = "${quoted(operator)} geht nicht mit ${quoted(types)}."

    private fun inBrackets(types: String) = if (types.isEmpty()) "keine Werte" else "($types)"
}

private object GermanJavaClassMessages : JavaClassMessages {
    override fun wrongFileName(className: String) =
        "Eine öffentliche Klasse steht in einer Datei mit ihrem Namen. Nenn die Datei ${quoted("$className.java")}, " +
            "oder die Klasse wie die Datei."

    override fun missingReturnType() = "Diese Methode sagt nicht, von welchem Typ das ist, was sie zurückgibt."

    override fun writeVoid() = "Schreib \"void\" vor ihren Namen, wenn sie nichts zurückgibt."

    override fun cannotInstantiate(name: String) =
        "Java kann kein ${quoted(name)} mit \"new\" machen, weil ein Teil davon noch nicht geschrieben ist."

    override fun extendThread() =
        "Schreib eine Klasse mit \"extends Thread\" und einer Methode \"public void run()\", und mach davon ein " +
            "Objekt. " +
            "Auf dem Stein nimmt Thread kein Runnable."

    override fun extendIt(name: String) =
        "Schreib eine Klasse, die ein $name ist und alle seine Methoden hat, und mach davon ein Objekt."

    override fun mustHaveMethod(className: String, method: String, owner: String) =
        "${quoted(className)} ist ein ${quoted(owner)}, also muss es die Methode ${quoted(method)} haben."

    override fun writePublicMethod(method: String) =
        "Schreib sie mit \"public\" davor, zum Beispiel: public void $method { }"

    override fun mustBePublic(method: String) = "Vor ${quoted(method)} muss \"public\" stehen."

    override fun noMain() = "Der Stein weiß nicht, wo er anfangen soll: Keine Klasse hat eine Methode \"main\"."

    override fun wrongMain() =
        "Der Stein weiß nicht, wo er anfangen soll, denn diese Methode ist nicht so angelegt, wie \"main\" es sein " +
            "muss."

    override fun writeMain() = "Schreib sie so: public static void main(String[] args) { }"
}

private object GermanBrickMessages : UnsupportedOnBrickMessages {
    override fun newerJava(what: NewerJava) = "Das Java des Steins ist älter. Es hat ${name(what)}."

    override fun insteadOf(what: NewerJava) = when (what) {
        NewerJava.GENERICS -> {
            "Lass das \"<...>\" weg. Wenn du etwas herausholst, schreib seinen Typ davor: (String) list.elementAt(0)."
        }

        NewerJava.FOR_EACH -> {
            "Zähl stattdessen: for (int i = 0; i < values.length; i++)."
        }

        NewerJava.VARARGS -> {
            "Nimm ein Array, zum Beispiel int[]."
        }

        NewerJava.ANNOTATION -> {
            "Lass sie weg."
        }

        NewerJava.ENUM -> {
            "Nimm Zahlen mit Namen: static final int RED = 0, GREEN = 1;"
        }

        NewerJava.STATIC_IMPORT -> {
            "Importier die Klasse und schreib ihren Namen vor die Methode."
        }

        NewerJava.INTERFACE_METHOD_BODY -> {
            "Schreib die Methode in eine Klasse."
        }

        NewerJava.LAMBDA -> {
            "Schreib dafür eine Klasse, zum Beispiel new Thread() { public void run() { ... } }."
        }

        NewerJava.MULTI_CATCH -> {
            "Schreib für jede ein \"catch\"."
        }

        NewerJava.TRY_WITH_RESOURCES -> {
            "Schreib die Anweisung vor das \"try\"."
        }

        NewerJava.SWITCH_EXPRESSION -> {
            "Nimm \"if\" und \"else\"."
        }

        NewerJava.AUTOBOXING -> {
            "Nimm \"int\", oder \"new Integer(...)\", um eine Zahl in einen Vector zu legen."
        }

        NewerJava.ASSERT -> {
            "Nimm \"if\"."
        }

        NewerJava.VAR -> {
            "Schreib den Typ, zum Beispiel \"int\"."
        }

        NewerJava.TEXT_BLOCK -> {
            "Schreib den Text zwischen zwei Anführungszeichen, in eine Zeile."
        }

        NewerJava.NUMBER_STYLE -> {
            "Schreib die Zahl nur mit Ziffern."
        }
    }

    private fun name(what: NewerJava) = when (what) {
        NewerJava.GENERICS -> "keine Typen in \"<...>\""
        NewerJava.FOR_EACH -> "kein \"for\" mit Doppelpunkt"
        NewerJava.VARARGS -> "kein \"...\" in einer Methode"
        NewerJava.ANNOTATION -> "keine Anmerkungen mit \"@\""
        NewerJava.ENUM -> "kein \"enum\""
        NewerJava.STATIC_IMPORT -> "kein \"import static\""
        NewerJava.INTERFACE_METHOD_BODY -> "keine ausgeschriebenen Methoden in einem Interface"
        NewerJava.LAMBDA -> "kein \"->\" und kein \"::\""
        NewerJava.MULTI_CATCH -> "kein \"|\" in einem \"catch\""
        NewerJava.TRY_WITH_RESOURCES -> "keine Klammern hinter \"try\""
        NewerJava.SWITCH_EXPRESSION -> "kein \"switch\" mit einem Wert"
        NewerJava.AUTOBOXING -> "keinen Weg von einer Zahl zu einem Objekt, der von selbst geht"
        NewerJava.ASSERT -> "kein \"assert\""
        NewerJava.VAR -> "kein \"var\""
        NewerJava.TEXT_BLOCK -> "keine Texte zwischen drei Anführungszeichen"
        NewerJava.NUMBER_STYLE -> "kein \"_\" in Zahlen und keine Zahlen, die mit \"0b\" beginnen"
    }

    override fun absent(what: UnsupportedOnBrick) = when (what) {
        UnsupportedOnBrick.PRINTING -> {
            "Der Stein zeigt Zahlen mit LCD.showNumber(7) und bis zu fünf Buchstaben mit TextLCD.print(\"hello\")."
        }

        UnsupportedOnBrick.KEYBOARD -> {
            "Der Stein hat keine Tastatur. Frag seine Tasten, zum Beispiel Button.VIEW.isPressed()."
        }

        UnsupportedOnBrick.COLLECTIONS -> {
            "Nimm ein Array, zum Beispiel int[], oder einen Vector aus java.util."
        }

        UnsupportedOnBrick.VECTOR_METHODS -> {
            "Der Vector eines Steins hat addElement(), elementAt(), setElementAt(), removeElementAt() und size()."
        }

        UnsupportedOnBrick.HASHTABLE_METHODS -> {
            "Eine Hashtable hat auf dem Stein put() und get(), und get() gibt null für das, was nicht darin ist."
        }

        UnsupportedOnBrick.RUNNABLE -> {
            "Schreib stattdessen \"extends Thread\", mit einer Methode \"public void run()\"."
        }

        UnsupportedOnBrick.FORMATTING -> {
            "Der Stein kann Texte nicht formatieren. Zeig eine Zahl mit LCD.showNumber(7)."
        }

        UnsupportedOnBrick.TEXT_METHODS -> {
            "Ein Text hat auf dem Stein length(), charAt(), toCharArray() und equals(), und nicht viel mehr."
        }

        UnsupportedOnBrick.PARSING -> {
            "Der Stein kann keine Zahlen aus Texten lesen."
        }

        UnsupportedOnBrick.WRAPPERS -> {
            "Nimm boolean, char, int oder float selbst."
        }

        UnsupportedOnBrick.WRITING_NUMBERS -> {
            "Integer.toString(number) macht aus einer ganzen Zahl einen Text. LCD.showNumber(number) zeigt sie ohne."
        }

        UnsupportedOnBrick.SYSTEM_METHODS -> {
            "System.currentTimeMillis() ist die Zeit, und Speicher kommt nie zurück."
        }

        UnsupportedOnBrick.ARRAY_COPYING -> {
            "Kopier in einem \"for\" ein Element nach dem anderen."
        }

        UnsupportedOnBrick.WAITING -> {
            "Thread.sleep(1000) wartet eine Sekunde."
        }

        UnsupportedOnBrick.FILES -> {
            "Der Stein hat keine Dateien."
        }

        UnsupportedOnBrick.WINDOWS -> {
            "Der Stein hat keine Fenster. Er zeigt Zahlen und kurze Texte mit LCD und TextLCD."
        }

        UnsupportedOnBrick.OTHER_BRICKS -> {
            "Das ist für neuere Steine. Die Klassen von diesem stehen in josx.platform.rcx."
        }
    }

    override fun noSwitch() = "Das Java des Steins hat kein \"switch\"."

    override fun useIf() = "Nimm \"if\" und \"else if\"."

    override fun noLongArithmetic() = "Der Stein kann mit \"long\" nicht rechnen."

    override fun useInt() = "Mach vorher ein \"int\" daraus, zum Beispiel (int) System.currentTimeMillis()."

    override fun noFloatRemainder() = "Der Stein hat kein \"%\" für \"float\" und \"double\"."

    override fun useIntRemainder() = "Nimm \"int\", oder zieh so oft ab, wodurch du teilst, wie es ganz hineinpasst."

    override fun noArrayTypeTest() = "Der Stein kann beim Laufen nicht herausfinden, ob etwas ein Array ist."

    override fun useArrayItself() = "Gib der Variable von Anfang an den Typ des Arrays, zum Beispiel int[]."

    override fun noClassLiteral() = "Der Stein hat kein \".class\"."

    override fun useInstanceof() = "Um herauszufinden, was etwas ist, nimm \"instanceof\"."

    override fun textJoinedInLoop() =
        "Das macht immer wieder einen neuen Text, und der Stein bekommt den Speicher nie zurück."

    override fun makeTextOnce() = "Mach ihn einmal, vor der Schleife, oder zeig Zahlen mit LCD.showNumber."

    override fun divisorTooLarge(divisor: String, kept: String) =
        "Der Stein teilt nur durch Zahlen von -32768 bis 32767. Er nimmt $kept statt $divisor."

    override fun arrayTooLong(length: String, limit: String) =
        "Ein Array hat auf dem Stein höchstens $limit Elemente, nicht $length."
}

private object GermanLejosMessages : LejosMessages {
    override fun missingInLejos(remedy: LejosRemedy, owner: String, member: String) = when (remedy) {
        LejosRemedy.EXCEPTION_WITHOUT_TEXT -> "Auf einem echten Stein macht leJOS jede $owner ohne Text."
        LejosRemedy.CHECKED_EXCEPTION -> checkedInLejos(owner)
        LejosRemedy.STRING_BUFFER -> "leJOS hat auf einem echten Stein keinen $owner."
        LejosRemedy.INTEGER_TO_STRING -> "$owner.$member von leJOS nimmt keine ganze Zahl."
        LejosRemedy.APPEND_TO_STRING_BUFFER -> "$owner.$member von leJOS nimmt keine Kommazahl."
        LejosRemedy.LAST_INDEX_OF -> "Ein $owner von leJOS hat kein ${quoted(member)}."
        LejosRemedy.SENSOR_CONSTANTS -> "$owner von leJOS hat kein $member."
        LejosRemedy.SERIAL_PACKETS, LejosRemedy.VECTOR -> "leJOS 2.1 hat kein $owner. Das kam mit leJOS 3.0."
        LejosRemedy.LOOP_FROM_THE_END -> "Ein $owner von leJOS 2.1 hat kein ${quoted(member)}. Das kam mit leJOS 3.0."
        LejosRemedy.LEAVE_OUT -> "Ein $owner von leJOS hat kein ${quoted(member)}."
        LejosRemedy.PACKAGE_OF_2_1 -> "leJOS 2.1 hat $owner in einem anderen Paket."
    }

    override fun insteadInLejos(remedy: LejosRemedy, owner: String, member: String) = when (remedy) {
        LejosRemedy.EXCEPTION_WITHOUT_TEXT -> {
            "Schreib \"new $owner()\", oder nimm Exception oder RuntimeException, die einen Text haben können."
        }

        LejosRemedy.CHECKED_EXCEPTION -> {
            catchException()
        }

        LejosRemedy.STRING_BUFFER -> {
            "StringBuffer kann dasselbe."
        }

        LejosRemedy.INTEGER_TO_STRING -> {
            "Schreib Integer.toString(zahl).toCharArray()."
        }

        LejosRemedy.APPEND_TO_STRING_BUFFER -> {
            "Schreib new StringBuffer(20).append(zahl).getChars()."
        }

        LejosRemedy.LAST_INDEX_OF -> {
            "Rechne es aus: stack.size() - stack.lastIndexOf(object)."
        }

        LejosRemedy.SENSOR_CONSTANTS -> {
            "Schreib SensorConstants.$member."
        }

        LejosRemedy.SERIAL_PACKETS -> {
            "Sende mit Serial.sendPacket ein Paket von zwei Bytes und empfange es mit Serial.readPacket."
        }

        LejosRemedy.VECTOR -> {
            "Nimm dort einen Vector mit addElement, elementAt, removeElementAt und isEmpty."
        }

        LejosRemedy.LOOP_FROM_THE_END -> {
            "Geh dort die Elemente vom letzten zum ersten durch."
        }

        LejosRemedy.LEAVE_OUT -> {
            "Lass es weg: Es tut nichts."
        }

        LejosRemedy.PACKAGE_OF_2_1 -> {
            "Importiere es dort aus josx.platform.rcx.remotecontrol."
        }
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

    override fun makeRoomForNumber() =
        "Zeig die Zahl mit LCD.showNumber, oder mach Platz: new StringBuffer(20).append(\"x\").append(7).toString()."
}
