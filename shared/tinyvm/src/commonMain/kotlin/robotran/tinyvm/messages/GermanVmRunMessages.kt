package robotran.tinyvm.messages

import robotran.tinyvm.config.Quirk

/** What is said in German while a program runs. */
internal object GermanVmRunMessages : RunMessages {
    override fun uncaught(exception: String, text: String, methodNumber: Int, exceptionNumber: Int): String {
        val said = if (text.isEmpty()) exception else "$exception ($text)"
        return "Niemand hat diese Ausnahme gefangen: $said. Ein Stein brummt und zeigt $methodNumber und " +
            "$exceptionNumber."
    }

    override fun bites(quirk: Quirk) = when (quirk) {
        Quirk.DIVISOR_OF_16_BITS -> {
            "Ein Stein teilt nur durch Zahlen von -32768 bis 32767. Von einem größeren Teiler lässt er den Rest weg."
        }

        Quirk.INDEX_OF_16_BITS -> {
            "Ein Stein schaut nur auf 16 Bits eines Index, also trifft ein großer ein anderes Element."
        }

        Quirk.SIGNED_CHARACTER -> {
            "Auf einem Stein wird ein char über 32767 negativ."
        }

        Quirk.UNCHECKED_INTERFACE -> {
            "Auf einem Stein geht jedes Objekt als jedes Interface durch: Hier wurde nicht wirklich geprüft oder " +
                "umgewandelt."
        }

        Quirk.LONG_ARRAY -> {
            "Auf einem Stein hat ein Array höchstens 511 Elemente."
        }

        Quirk.HEAP_FULL -> {
            "Der Speicher des Steins ist voll. Er gibt nie Speicher zurück, also mach Objekte, Arrays und Texte nur " +
                "einmal und " +
                "benutz sie wieder."
        }

        Quirk.NOT_A_NUMBER -> {
            "Diese Kommazahl ist keine Zahl, und ein Stein hält sie für gleich mit allen anderen."
        }

        Quirk.JOIN_DOES_NOTHING -> {
            "Auf einem Stein wartet join nicht. Frag stattdessen in einer Schleife mit isAlive."
        }
    }

    override fun sharesMemory(programBytes: Int, allBytes: Int) =
        "Von seinen $allBytes Bytes braucht das Programm selbst etwa $programBytes."

    override fun wouldBite(quirk: Quirk) = when (quirk) {
        Quirk.DIVISOR_OF_16_BITS -> {
            "Ein echter Stein würde von diesem Teiler nur 16 Bits nehmen und etwas anderes herausbekommen."
        }

        Quirk.INDEX_OF_16_BITS -> {
            "Ein echter Stein würde von diesem Index nur 16 Bits nehmen und könnte ein anderes Element treffen."
        }

        Quirk.SIGNED_CHARACTER -> {
            "Auf einem echten Stein würde dieses char negativ."
        }

        Quirk.UNCHECKED_INTERFACE -> {
            "Ein echter Stein würde nicht merken, dass das Objekt dieses Interface nicht erfüllt."
        }

        Quirk.LONG_ARRAY -> {
            "Ein echter Stein hat keine Arrays mit mehr als 511 Elementen: Er würde einen OutOfMemoryError werfen."
        }

        Quirk.HEAP_FULL -> {
            "Der Speicher eines echten Steins wäre jetzt voll: Er gibt nie Speicher zurück."
        }

        Quirk.NOT_A_NUMBER -> {
            "Ein echter Stein würde das für gleich mit allen anderen Zahlen halten."
        }

        Quirk.JOIN_DOES_NOTHING -> {
            "Auf einem echten Stein wartet join nicht, also hier auch nicht."
        }
    }
}
