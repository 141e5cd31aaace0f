package robotran.javacompiler.messages

import robotran.language.quoted

internal object GermanJavaSemanticMessages : JavaSemanticMessages {
    override fun doesNotFit(given: String, needed: String) =
        "Das ist vom Typ ${quoted(given)}, aber hier wird ${quoted(needed)} gebraucht."

    override fun castNumber(type: String) =
        "Schreib \"($type)\" davor und setz es in Klammern, wenn ein Teil verloren gehen darf."

    override fun notWhole(number: String, type: String) =
        "$number hat einen Punkt, und in ${quoted(type)} passen nur ganze Zahlen."

    override fun writeWhole(number: String) = "Schreib eine ganze Zahl, zum Beispiel $number."

    override fun writeWholeOrDeclare(number: String, declaration: String) =
        "Schreib eine ganze Zahl, zum Beispiel $number. Für Zahlen mit Punkt leg die Variable so an: $declaration"

    override fun tooLargeFor(number: String, type: String) = "$number passt nicht in ${quoted(type)}."

    override fun declareAsInt() = "Leg die Variable als \"int\" an."

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

    override fun wrongArguments(method: String, needed: String, given: String) = when {
        given.isEmpty() -> "${quoted(method)} braucht etwas in den Klammern, also: $method($needed)"
        needed.isEmpty() -> "${quoted(method)} hat nichts in den Klammern: $method()"
        else -> "${quoted(method)} nimmt ($needed), nicht ($given)."
    }

    override fun staticNeeded(name: String) =
        "${quoted(name)} gehört zu einem Objekt, und in einer \"static\"-Methode gibt es keins."

    override fun makeItStatic() = "Schreib \"static\" davor, wo es angelegt wird."

    override fun objectNeeded(name: String, owner: String) =
        "${quoted(name)} braucht ein Objekt von ${quoted(owner)}, nicht die Klasse."

    override fun neverChanges(name: String) = "${quoted(name)} ist \"final\", also bekommt es nur einmal einen Wert."

    override fun numberTooLarge(number: String) =
        "$number ist zu groß. Ein \"int\" geht von -2147483648 bis 2147483647."

    override fun noLeadingZero(number: String) = "Eine ganze Zahl beginnt in Java nicht mit 0. Schreib $number."

    override fun countsMilliseconds() = "Gezählt werden ganze Millisekunden: Eine halbe Sekunde ist 500."

    override fun sleepInstead() = "Um zu warten, schreib Thread.sleep(500), das ist eine halbe Sekunde."

    override fun callOnObject(name: String) = "Schreib davor, für welches Objekt, zum Beispiel: lock.$name()"

    override fun callOnNew(className: String, name: String) =
        "Mach zuerst ein Objekt, und ruf sie damit auf: new $className().$name()"

    override fun announcesMore(exception: String, method: String) =
        "Diese Methode ersetzt ${quoted(method)}, und die kündigt keine $exception an. Also darf sie es auch nicht."

    override fun catchInside(exception: String) =
        "Nimm dieses \"throws\" weg, und setz das, was dazu führen kann, in try { ... } catch ($exception e) { }."

    override fun noEffect() = "Das ändert nichts."

    override fun emptyStatement() =
        "Dieses \";\" ist alles, was hier getan wird. Nimm es weg, wenn danach ein Block kommt."

    override fun wrongOperator(operator: String, types: String) = "${quoted(operator)} geht nicht mit ${quoted(types)}."
}
