package robotran.tinyvm.messages

/** Messages during a run on an NXT. */
interface NxtRunMessages {
    /** An uncaught exception; [text] is its message, empty if it has none. The brick shows [exceptionNumber]. */
    fun uncaught(exception: String, text: String, exceptionNumber: Int): String

    /** The memory is full, so a program gets an `OutOfMemoryError`. */
    fun memoryFull(): String

    /** Objects that are still needed take more than nine tenths of the memory. */
    fun memoryNearlyFull(): String
}

internal object EnglishNxtRunMessages : NxtRunMessages {
    override fun uncaught(exception: String, text: String, exceptionNumber: Int): String {
        val said = if (text.isEmpty()) exception else "$exception ($text)"
        return "Nobody caught the $said. The NXT stops and shows \"Exception: $exceptionNumber\"."
    }

    override fun memoryFull() =
        "The NXT's memory is full: all objects that the program still uses take too much room. Make arrays and lists " +
            "shorter, or forget what you no longer need."

    override fun memoryNearlyFull() =
        "The NXT's memory is nearly full: the objects that the program still uses take more than nine tenths of it."
}

internal object GermanNxtRunMessages : NxtRunMessages {
    override fun uncaught(exception: String, text: String, exceptionNumber: Int): String {
        val said = if (text.isEmpty()) exception else "$exception ($text)"
        return "Niemand hat diese Ausnahme gefangen: $said. Der NXT hält an und zeigt „Exception: $exceptionNumber“."
    }

    override fun memoryFull() =
        "Der Speicher des NXT ist voll: Alle Objekte, die das Programm noch benutzt, brauchen zu viel Platz. Mach " +
            "Arrays und Listen kürzer oder vergiss, was du nicht mehr brauchst."

    override fun memoryNearlyFull() =
        "Der Speicher des NXT ist fast voll: Die Objekte, die das Programm noch benutzt, brauchen mehr als neun " +
            "Zehntel davon."
}

internal object SpanishNxtRunMessages : NxtRunMessages {
    override fun uncaught(exception: String, text: String, exceptionNumber: Int): String {
        val said = if (text.isEmpty()) exception else "$exception ($text)"
        return "Nadie capturó la excepción $said. El NXT se detiene y muestra \"Exception: $exceptionNumber\"."
    }

    override fun memoryFull() =
        "La memoria del NXT está llena: todos los objetos que el programa aún usa ocupan demasiado. Haz más cortos " +
            "los arrays y las listas, u olvida lo que ya no necesitas."

    override fun memoryNearlyFull() =
        "La memoria del NXT está casi llena: los objetos que el programa aún usa ocupan más de nueve décimas partes."
}
