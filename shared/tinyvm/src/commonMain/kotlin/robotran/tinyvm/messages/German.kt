package robotran.tinyvm.messages

import robotran.tinyvm.config.Quirk

/**
 * The German messages. Each term has one translation: array - Array, brick - Stein, class - Klasse, field - Feld,
 * method - Methode, memory - Speicher, thread - Thread.
 */
object GermanTinyVmMessages :
    TinyVmMessages,
    ClassFileMessages by GermanClassFileMessages,
    LinkMessages by GermanLinkMessages,
    RunMessages by GermanVmRunMessages

private object GermanClassFileMessages : ClassFileMessages {
    override fun notAClassFile() = "Das ist keine Klassendatei: Übersetz das Programm noch einmal."

    override fun classFileTooLong(limit: Int) =
        "Diese Klassendatei ist länger als $limit Bytes. In einen Stein passt viel weniger."

    override fun classFileTooNew() =
        "Diese Klasse wurde für ein neueres Java übersetzt, als ein Stein versteht. Übersetz sie mit --release 8, " +
            "oder öffne hier ihren Quelltext."

    override fun classFileDamaged() = "Diese Klassendatei ist beschädigt: Übersetz das Programm noch einmal."
}

private object GermanLinkMessages : LinkMessages {
    override fun noMainMethod() =
        "Es gibt nichts zu starten: Schreib in eine Klasse eine Methode \"public static void main(String[] args)\"."

    override fun classMissing(name: String) = "Auf dem Stein gibt es keine Klasse $name."

    override fun fieldMissing(className: String, name: String) = when (className to name) {
        "java.lang.System" to "out" -> {
            "Der Stein hat kein System.out. Zeig Texte mit TextLCD.print und Zahlen mit LCD.showNumber."
        }

        else -> "Auf dem Stein hat $className kein \"$name\"."
    }

    override fun methodMissing(className: String, name: String) =
        "Auf dem Stein hat $className keine Methode \"$name\"."

    override fun duplicateClass(name: String) =
        "Es gibt zwei Klassen, die $name heißen. Gib einer davon einen anderen Namen."

    override fun cyclicInheritance(name: String) = "Die Klasse $name kann sich nicht selbst erweitern."

    override fun tooMany(counted: Counted, limit: Int) = "In einen Stein passen höchstens $limit ${nameOf(counted)}."

    override fun programTooLarge(bytes: Int, limit: Int) =
        "Dieses Programm braucht etwa $bytes Bytes vom Speicher des Steins, aber nur $limit passen hinein. " +
            "Nimm weniger Klassen von leJOS, oder schreib weniger."

    override fun nativeMethod(name: String) =
        "Der Stein hat keine eingebaute Methode \"$name\". Schreib sie in Java, ohne \"native\"."

    override fun unsupportedFeature(feature: UnsupportedFeature) = when (feature) {
        UnsupportedFeature.SWITCH -> "Der Stein kennt \"switch\" nicht. Nimm \"if\" und \"else if\"."

        UnsupportedFeature.LONG_ARITHMETIC -> {
            "Der Stein kann mit long-Zahlen nicht rechnen und sie nicht vergleichen. Mach vorher ein int daraus: " +
                "(int) time."
        }

        UnsupportedFeature.DECIMAL_REMAINDER -> "Der Stein kennt % nur für ganze Zahlen."
        UnsupportedFeature.FAR_JUMP -> "Diese Methode ist zu lang für den Stein. Verteil sie auf mehrere Methoden."
        UnsupportedFeature.MANY_LOCALS -> "Eine Methode kann auf dem Stein höchstens 255 Variablen haben."

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

        UnsupportedFeature.CLASS_LITERAL -> "Auf dem Stein sind Klassen keine Objekte: Es gibt kein \".class\"."
        UnsupportedFeature.INTERFACE_CODE -> "Auf dem Stein nennt ein Interface nur Methoden, es steht kein Code darin."

        UnsupportedFeature.NESTED_FINALLY -> {
            "Hier stehen zu viele \"finally\"-Blöcke ineinander. Verschieb ein paar in andere Methoden."
        }
    }

    override fun codeInvalid() =
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

private object GermanVmRunMessages : RunMessages {
    override val nxt = GermanNxtRunMessages

    override fun uncaught(exception: String, text: String, methodNumber: Int, exceptionNumber: Int): String {
        val said = if (text.isEmpty()) exception else "$exception ($text)"
        val digit = exceptionNumber % 10
        val number = if (digit == exceptionNumber) "$digit" else "$digit, die letzte Ziffer von $exceptionNumber"
        return "Niemand hat diese Ausnahme gefangen: $said. Ein Stein brummt und zeigt $methodNumber und $number."
    }

    override fun quirkEffect(quirk: Quirk) = when (quirk) {
        Quirk.DIVISOR_OF_16_BITS -> {
            "Ein Stein teilt nur durch Zahlen von -32768 bis 32767. Von einem größeren Teiler lässt er den Rest weg."
        }

        Quirk.INDEX_OF_16_BITS -> {
            "Ein Stein schaut nur auf 16 Bits eines Index, also trifft ein großer ein anderes Element."
        }

        Quirk.SIGNED_CHARACTER -> "Auf einem Stein wird ein char über 32767 negativ."

        Quirk.UNCHECKED_INTERFACE -> {
            "Auf einem Stein geht jedes Objekt als jedes Interface durch: Hier wurde nicht wirklich geprüft oder " +
                "umgewandelt."
        }

        Quirk.LONG_ARRAY -> "Auf einem Stein hat ein Array höchstens 511 Elemente."

        Quirk.HEAP_FULL -> {
            "Der Speicher des Steins ist voll. Er gibt nie Speicher zurück, also mach Objekte, Arrays und Texte nur " +
                "einmal und " +
                "benutz sie wieder."
        }

        Quirk.NOT_A_NUMBER -> "Diese Kommazahl ist keine Zahl, und ein Stein hält sie für gleich mit allen anderen."
        Quirk.JOIN_DOES_NOTHING -> "Auf einem Stein wartet join nicht. Frag stattdessen in einer Schleife mit isAlive."

        Quirk.UNLOCKED_METHOD -> {
            "Ein Stein sperrt nichts bei einer synchronized-Methode, die private oder static ist oder mit super " +
                "aufgerufen wird: wait und notify scheitern darin, und andere Threads können hinein. Mach sie weder " +
                "private noch static."
        }

        Quirk.DEEP_ARRAY -> {
            "Ein Stein kann kein Array mit drei oder mehr Dimensionen auf einmal anlegen: Er wirft einen " +
                "OutOfMemoryError. Leg die inneren Arrays in einer Schleife an."
        }

        Quirk.DEEP_CALLS -> {
            "Ein Stein hat Platz für etwa 210 Aufrufe ineinander, und für weniger, wenn sie viele Variablen haben " +
                "oder sein Speicher voll ist."
        }

        Quirk.LATE_INITIALIZER -> {
            "Ein Stein bereitet die statischen Felder einer Klasse erst vor, wenn sie selbst zum ersten Mal benutzt " +
                "wird. Die der Oberklasse sind hier also noch nicht bereit."
        }

        Quirk.EARLY_HANDLER -> {
            "Auf einem Stein kümmert sich ein try auch um das, was in der Anweisung direkt davor schiefgeht. Schreib " +
                "eine andere Anweisung dazwischen, zum Beispiel int next = 0;"
        }

        Quirk.NEGATIVE_TIME -> "Ein Stein macht bei einer Zeit unter 0 keine Pause und wirft keine Ausnahme."

        Quirk.NEGATIVE_LONG -> {
            "Ein Stein hält ein negatives long für eine große positive Zahl, wenn daraus eine Kommazahl wird. Mach " +
                "zuerst ein int daraus: (int) time."
        }

        Quirk.UNCHECKED_ELEMENT -> {
            "Ein Stein prüft nicht, was du in ein Array schreibst. Dieses Objekt gehört zu einer anderen Klasse, und " +
                "damit geht es nicht gut weiter: Hier wird stattdessen null gespeichert."
        }

        Quirk.LOST_EXCEPTION -> {
            "Nach einer gescheiterten Umwandlung oder einem gescheiterten neuen Array gibt ein Stein catch die " +
                "Ausnahme nicht: Die Variable ist null oder behält, was sie vorher hatte. Benutz sie dort nicht."
        }
    }

    override fun programMemoryUse(programBytes: Int, allBytes: Int) =
        "Von seinen $allBytes Bytes braucht das Programm selbst etwa $programBytes."

    override fun quirkWarning(quirk: Quirk) = when (quirk) {
        Quirk.DIVISOR_OF_16_BITS -> {
            "Ein echter Stein würde von diesem Teiler nur 16 Bits nehmen und etwas anderes herausbekommen."
        }

        Quirk.INDEX_OF_16_BITS -> {
            "Ein echter Stein würde von diesem Index nur 16 Bits nehmen und könnte ein anderes Element treffen."
        }

        Quirk.SIGNED_CHARACTER -> "Auf einem echten Stein würde dieses char negativ."

        Quirk.UNCHECKED_INTERFACE -> {
            "Ein echter Stein würde nicht merken, dass das Objekt dieses Interface nicht erfüllt."
        }

        Quirk.LONG_ARRAY -> {
            "Ein echter Stein hat keine Arrays mit mehr als 511 Elementen: Er würde einen OutOfMemoryError werfen."
        }

        Quirk.HEAP_FULL -> "Der Speicher eines echten Steins wäre jetzt voll: Er gibt nie Speicher zurück."
        Quirk.NOT_A_NUMBER -> "Ein echter Stein würde das für gleich mit allen anderen Zahlen halten."
        Quirk.JOIN_DOES_NOTHING -> "Auf einem echten Stein wartet join nicht, also hier auch nicht."

        Quirk.UNLOCKED_METHOD -> {
            "Ein echter Stein würde hier nichts sperren: Er übergeht \"synchronized\" bei einer Methode, die " +
                "private oder static ist oder mit super aufgerufen wird."
        }

        Quirk.DEEP_ARRAY -> {
            "Ein echter Stein kann kein Array mit drei oder mehr Dimensionen auf einmal anlegen: Er würde einen " +
                "OutOfMemoryError werfen."
        }

        Quirk.DEEP_CALLS -> {
            "Ein echter Stein hat Platz für etwa 210 Aufrufe ineinander, mit vielen Variablen für weniger: Er würde " +
                "einen StackOverflowError werfen."
        }

        Quirk.LATE_INITIALIZER -> {
            "Ein echter Stein hätte die statischen Felder der Oberklasse hier noch nicht vorbereitet: Das tut er " +
                "erst, wenn sie selbst zum ersten Mal benutzt wird."
        }

        Quirk.EARLY_HANDLER -> {
            "Auf einem echten Stein würde sich das try nach dieser Anweisung auch darum kümmern. Schreib eine andere " +
                "Anweisung dazwischen, zum Beispiel int next = 0;"
        }

        Quirk.NEGATIVE_TIME -> "Ein echter Stein würde hier keine Pause machen und keine Ausnahme werfen."
        Quirk.NEGATIVE_LONG -> "Ein echter Stein würde dieses negative long für eine große positive Zahl halten."

        Quirk.UNCHECKED_ELEMENT -> {
            "Ein echter Stein würde nicht merken, dass dieses Objekt zu einer anderen Klasse gehört als die Elemente " +
                "des Arrays."
        }

        Quirk.LOST_EXCEPTION -> {
            "Ein echter Stein würde catch diese Ausnahme nicht geben: Die Variable wäre null oder behielte, was sie " +
                "vorher hatte."
        }
    }
}
