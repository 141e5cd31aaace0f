package robotran.tinyvm.messages

import robotran.tinyvm.config.Quirk

/** What is said in Spanish while a program runs. */
internal object SpanishVmRunMessages : RunMessages {
    override fun uncaught(exception: String, text: String, methodNumber: Int, exceptionNumber: Int): String {
        val said = if (text.isEmpty()) exception else "$exception ($text)"
        return "Nadie ha atrapado esta excepción: $said. Un ladrillo zumba y muestra $methodNumber y $exceptionNumber."
    }

    override fun bites(quirk: Quirk) = when (quirk) {
        Quirk.DIVISOR_OF_16_BITS -> {
            "Un ladrillo solo divide entre números de -32768 a 32767. De un divisor mayor pierde el resto."
        }

        Quirk.INDEX_OF_16_BITS -> {
            "Un ladrillo solo mira 16 bits de un índice, así que uno grande acierta en otro elemento."
        }

        Quirk.SIGNED_CHARACTER -> {
            "En un ladrillo, un char mayor que 32767 se vuelve negativo."
        }

        Quirk.UNCHECKED_INTERFACE -> {
            "En un ladrillo, cualquier objeto vale por cualquier interfaz: esta comprobación o conversión no se ha " +
                "hecho de verdad."
        }

        Quirk.LONG_ARRAY -> {
            "En un ladrillo, un array tiene como mucho 511 elementos."
        }

        Quirk.HEAP_FULL -> {
            "La memoria del ladrillo está llena. Nunca devuelve memoria, así que haz los objetos, arrays y textos " +
                "una sola vez y " +
                "úsalos de nuevo."
        }

        Quirk.NOT_A_NUMBER -> {
            "Este número decimal no es ningún número, y un ladrillo lo toma por igual a todos los demás."
        }

        Quirk.JOIN_DOES_NOTHING -> {
            "En un ladrillo, join no espera. Pregunta con isAlive en un bucle."
        }
    }

    override fun sharesMemory(programBytes: Int, allBytes: Int) =
        "De sus $allBytes bytes, el propio programa ocupa unos $programBytes."

    override fun wouldBite(quirk: Quirk) = when (quirk) {
        Quirk.DIVISOR_OF_16_BITS -> {
            "Un ladrillo de verdad solo tomaría 16 bits de este divisor y le saldría otro resultado."
        }

        Quirk.INDEX_OF_16_BITS -> {
            "Un ladrillo de verdad solo tomaría 16 bits de este índice y podría acertar en otro elemento."
        }

        Quirk.SIGNED_CHARACTER -> {
            "En un ladrillo de verdad, este char se volvería negativo."
        }

        Quirk.UNCHECKED_INTERFACE -> {
            "Un ladrillo de verdad no notaría que el objeto no cumple esta interfaz."
        }

        Quirk.LONG_ARRAY -> {
            "Un ladrillo de verdad no tiene arrays de más de 511 elementos: lanzaría un OutOfMemoryError."
        }

        Quirk.HEAP_FULL -> {
            "La memoria de un ladrillo de verdad ya estaría llena: nunca devuelve memoria."
        }

        Quirk.NOT_A_NUMBER -> {
            "Un ladrillo de verdad lo tomaría por igual a todos los demás números."
        }

        Quirk.JOIN_DOES_NOTHING -> {
            "En un ladrillo de verdad, join no espera, así que aquí tampoco."
        }
    }
}
