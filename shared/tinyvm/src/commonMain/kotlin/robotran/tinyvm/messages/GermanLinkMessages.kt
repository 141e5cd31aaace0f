package robotran.tinyvm.messages

/** What is said in German of a class that cannot be put on the brick. */
internal object GermanLinkMessages : LinkMessages {
    override fun noMainMethod() =
        "Es gibt nichts zu starten: Schreib in eine Klasse eine Methode \"public static void main(String[] args)\"."

    override fun classMissing(name: String) = "Auf dem Stein gibt es keine Klasse $name."

    override fun fieldMissing(className: String, name: String) = when (className to name) {
        "java.lang.System" to "out" -> {
            "Der Stein hat kein System.out. Zeig Texte mit TextLCD.print und Zahlen mit LCD.showNumber."
        }

        else -> {
            "Auf dem Stein hat $className kein \"$name\"."
        }
    }

    override fun methodMissing(className: String, name: String) =
        "Auf dem Stein hat $className keine Methode \"$name\"."

    override fun classTwice(name: String) =
        "Es gibt zwei Klassen, die $name heißen. Gib einer davon einen anderen Namen."

    override fun classLoop(name: String) = "Die Klasse $name kann sich nicht selbst erweitern."

    override fun tooMany(counted: Counted, limit: Int) = "In einen Stein passen höchstens $limit ${nameOf(counted)}."

    override fun programTooLarge(bytes: Int, limit: Int) =
        "Dieses Programm braucht etwa $bytes Bytes vom Speicher des Steins, aber nur $limit passen hinein. " +
            "Nimm weniger Klassen von leJOS, oder schreib weniger."

    override fun nativeMethod(name: String) =
        "Der Stein hat keine eingebaute Methode \"$name\". Schreib sie in Java, ohne \"native\"."

    override fun lacks(feature: UnsupportedFeature) = when (feature) {
        UnsupportedFeature.SWITCH -> {
            "Der Stein kennt \"switch\" nicht. Nimm \"if\" und \"else if\"."
        }

        UnsupportedFeature.LONG_ARITHMETIC -> {
            "Der Stein kann mit long-Zahlen nicht rechnen und sie nicht vergleichen. Mach vorher ein int daraus: " +
                "(int) time."
        }

        UnsupportedFeature.DECIMAL_REMAINDER -> {
            "Der Stein kennt % nur für ganze Zahlen."
        }

        UnsupportedFeature.FAR_JUMP -> {
            "Diese Methode ist zu lang für den Stein. Verteil sie auf mehrere Methoden."
        }

        UnsupportedFeature.MANY_LOCALS -> {
            "Eine Methode kann auf dem Stein höchstens 255 Variablen haben."
        }

        UnsupportedFeature.MANY_CONSTANTS -> {
            "Diese Klasse hat zu viele verschiedene Texte und große Zahlen für den Stein. Verschieb ein paar in eine " +
                "andere Klasse."
        }

        UnsupportedFeature.INVOKE_DYNAMIC -> {
            "Der Stein kennt keine Lambdas und keine neueren Arten, Texte zu verbinden. Übersetz für ein älteres " +
                "Java, oder schreib eine Klasse."
        }

        UnsupportedFeature.ARRAY_TEST -> {
            "Der Stein kann Arrays nicht prüfen und nicht umwandeln. Behalt das Array in einer Variable seines " +
                "eigenen Typs."
        }

        UnsupportedFeature.CLASS_LITERAL -> {
            "Auf dem Stein sind Klassen keine Objekte: Es gibt kein \".class\"."
        }

        UnsupportedFeature.INTERFACE_CODE -> {
            "Auf dem Stein nennt ein Interface nur Methoden, es steht kein Code darin."
        }

        UnsupportedFeature.NESTED_FINALLY -> {
            "Hier stehen zu viele \"finally\"-Blöcke ineinander. Verschieb ein paar in andere Methoden."
        }
    }

    override fun codeUnsound() =
        "Diese Klassendatei ist beschädigt, ihr Code ergibt keinen Sinn: Übersetz das Programm noch einmal."

    private fun nameOf(counted: Counted) = when (counted) {
        Counted.CLASSES -> "Klassen in einem Programm, die von leJOS mitgezählt"
        Counted.ARRAY_TYPES -> "Arten von Arrays in einem Programm"
        Counted.FIELDS -> "Felder in einer Klasse"
        Counted.METHODS -> "Methoden in einer Klasse"
        Counted.LOCALS -> "Variablen in einer Methode"
        Counted.OPERANDS -> "Werte in einer Rechnung"
        Counted.PARAMETERS -> "Parameter einer Methode, wobei \"this\" mitzählt und long und double doppelt zählen"
        Counted.HANDLERS -> "\"catch\" und \"finally\" in einer Methode"
        Counted.CODE_BYTES -> "Bytes Code in einer Methode"
        Counted.TEXT_CHARACTERS -> "Zeichen in einem Text"
        Counted.ANCESTORS -> "Klassen und Interfaces über einer Klasse"
    }
}
