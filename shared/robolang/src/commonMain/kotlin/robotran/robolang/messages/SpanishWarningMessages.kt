package robotran.robolang.messages

import robotran.language.quoted

/** What is told in Spanish about what is probably not meant so. */
internal object SpanishWarningMessages : WarningMessages {
    override fun unusedVariable(name: String) = "${quoted(name)} no se usa nunca."

    override fun neverReached(word: String) = "Esto no se hace nunca, por el ${quoted(word)} que hay antes."

    override fun busyLoop() =
        "Esto sigue para siempre sin moverse, sin esperar y sin mirar los sensores, y solo tiene ocupado al ladrillo."

    override fun fractionLost(division: String, result: Int) =
        "Al dividir números enteros sale un número entero: ${quoted(division)} es $result. Si quieres más, escribe " +
            "uno de ellos con punto."

    override fun divisorTooLarge(divisor: Int, kept: Int) =
        "El ladrillo solo divide entre números de -32768 a 32767. Toma $divisor por $kept."

    override fun listInLoop() =
        "Esto hace una lista nueva una y otra vez, y el ladrillo nunca recupera su memoria. Haz la lista una sola " +
            "vez, arriba del todo."

    override fun divisorTakenForZero(divisor: Int) =
        "El ladrillo solo divide entre números de -32768 a 32767. Toma $divisor por 0 y se para."

    override fun endlessRecursion(name: String) =
        "${quoted(name)} siempre se llama a sí mismo, así que no llega nunca a su final."
}
