package robotran.javacompiler.messages

internal object GermanBrickMessages : UnsupportedOnBrickMessages {
    override fun newerJava(what: NewerJava) = "Das Java des Steins ist älter. Es hat ${name(what)}."

    override fun insteadOf(what: NewerJava) = when (what) {
        NewerJava.GENERICS -> {
            "Lass das \"<...>\" weg. Wenn du etwas herausholst, schreib seinen Typ davor: (String) list.elementAt(0)."
        }

        NewerJava.FOR_EACH -> "Zähl stattdessen: for (int i = 0; i < values.length; i++)."
        NewerJava.VARARGS -> "Nimm ein Array, zum Beispiel int[]."
        NewerJava.ANNOTATION -> "Lass sie weg."
        NewerJava.ENUM -> "Nimm Zahlen mit Namen: static final int RED = 0, GREEN = 1;"
        NewerJava.STATIC_IMPORT -> "Importier die Klasse und schreib ihren Namen vor die Methode."
        NewerJava.INTERFACE_METHOD_BODY -> "Schreib die Methode in eine Klasse."
        NewerJava.LAMBDA -> "Schreib dafür eine Klasse, zum Beispiel new Thread() { public void run() { ... } }."
        NewerJava.MULTI_CATCH -> "Schreib für jede ein \"catch\"."
        NewerJava.TRY_WITH_RESOURCES -> "Schreib die Anweisung vor das \"try\"."
        NewerJava.SWITCH_EXPRESSION -> "Nimm \"if\" und \"else\"."
        NewerJava.AUTOBOXING -> "Nimm \"int\", oder \"new Integer(...)\", um eine Zahl in einen Vector zu legen."
        NewerJava.DIAMOND -> "Schreib die Typen hinein, zum Beispiel new ArrayList<String>()."
        NewerJava.TEXT_IN_SWITCH -> "Nimm \"if\" und \"equals\": if (wort.equals(\"los\"))."
        NewerJava.ASSERT -> "Nimm \"if\"."
        NewerJava.VAR -> "Schreib den Typ, zum Beispiel \"int\"."
        NewerJava.TEXT_BLOCK -> "Schreib den Text zwischen zwei Anführungszeichen, in eine Zeile."
        NewerJava.NUMBER_STYLE -> "Schreib die Zahl nur mit Ziffern."
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
        NewerJava.DIAMOND -> "kein leeres \"<>\""
        NewerJava.TEXT_IN_SWITCH -> "kein \"switch\" mit einem Text"
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

        UnsupportedOnBrick.COLLECTIONS -> "Nimm ein Array, zum Beispiel int[], oder einen Vector aus java.util."

        UnsupportedOnBrick.VECTOR_METHODS -> {
            "Der Vector eines Steins hat addElement(), elementAt(), setElementAt(), removeElementAt() und size()."
        }

        UnsupportedOnBrick.HASHTABLE_METHODS -> {
            "Eine Hashtable hat auf dem Stein put() und get(), und get() gibt null für das, was nicht darin ist."
        }

        UnsupportedOnBrick.RUNNABLE -> {
            "Schreib stattdessen \"extends Thread\", mit einer Methode \"public void run()\"."
        }

        UnsupportedOnBrick.FORMATTING -> "Der Stein kann Texte nicht formatieren. Zeig eine Zahl mit LCD.showNumber(7)."

        UnsupportedOnBrick.TEXT_METHODS -> {
            "Ein Text hat auf dem Stein length(), charAt(), toCharArray() und equals(), und nicht viel mehr."
        }

        UnsupportedOnBrick.PARSING -> "Der Stein kann keine Zahlen aus Texten lesen."
        UnsupportedOnBrick.WRAPPERS -> "Nimm boolean, char, int oder float selbst."

        UnsupportedOnBrick.WRITING_NUMBERS -> {
            "Integer.toString(number) macht aus einer ganzen Zahl einen Text. LCD.showNumber(number) zeigt sie ohne."
        }

        UnsupportedOnBrick.SYSTEM_METHODS -> "System.currentTimeMillis() ist die Zeit, und Speicher kommt nie zurück."
        UnsupportedOnBrick.ARRAY_COPYING -> "Kopier in einem \"for\" ein Element nach dem anderen."
        UnsupportedOnBrick.WAITING -> "Thread.sleep(1000) wartet eine Sekunde."
        UnsupportedOnBrick.FILES -> "Der Stein hat keine Dateien."

        UnsupportedOnBrick.WINDOWS -> {
            "Der Stein hat keine Fenster. Er zeigt Zahlen und kurze Texte mit LCD und TextLCD."
        }

        UnsupportedOnBrick.MOTOR_DIRECTIONS -> {
            "Ein Motor hat forward(), backward() und stop(), zum Beispiel Motor.A.forward();"
        }

        UnsupportedOnBrick.MOTOR_TIME -> {
            "Ein Motor eines RCX zählt keine Grad. Lass ihn eine Zeit lang laufen: forward(), Thread.sleep(500), stop()"
        }

        UnsupportedOnBrick.MOTOR_POWER -> "Ein Motor hat setPower(), von 0 bis 7."

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
