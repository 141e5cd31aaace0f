package robotran.json.messages

internal object SpanishJsonMessages : JsonMessages {
    override fun refused(line: Int, path: String, reason: String) =
        "Línea $line: ${path.ifEmpty { "el archivo" }} $reason."

    override fun at(line: Int, path: String, sentence: String) =
        "Línea $line: ${path.ifEmpty { "el archivo" }}: $sentence"

    override fun fileTooLong(limit: Int) = "El archivo es demasiado largo: tiene más de $limit letras y signos."

    override fun notUtf8() = "El archivo no es un texto en UTF-8; un editor puede guardarlo así."

    override fun notReadable(line: Int) = "La línea $line no se puede leer: ahí falta algo, o algo no está en su sitio."

    override fun textNotClosed(line: Int) = "La línea $line tiene un texto que no se cierra con comillas."

    override fun bracketsTooDeep(line: Int) = "La línea $line abre demasiados paréntesis unos dentro de otros."

    override fun missing() = "falta"

    override fun mustBeObject() = "tiene que ser un objeto entre llaves"

    override fun mustBeList() = "tiene que ser una lista entre corchetes"

    override fun tooManyEntries(count: Int, limit: Int) = "tiene $count entradas, pero solo puede haber $limit"

    override fun tooFewEntries(count: Int, min: Int) =
        "tiene ${if (count == 1) "1 entrada" else "$count entradas"}, pero tiene que haber al menos $min"

    override fun mustBeText() = "tiene que ser un texto entre comillas"

    override fun mustNotBeEmpty() = "no puede estar vacío"

    override fun tooManyCharacters(limit: Int) = "no puede tener más de $limit letras y signos"

    override fun mustBeOneOrdinaryLine() = "tiene que ser una sola línea de letras y signos corrientes"

    override fun mustBeOrdinary() = "solo puede tener letras y signos corrientes"

    override fun mustBeNumber() = "tiene que ser un número"

    override fun mustBeFrom(min: String, max: String) = "tiene que estar entre $min y $max"

    override fun mustBeWholeFrom(min: Long, max: Long) = "tiene que ser un número entero de $min a $max"

    override fun mustBeTrueOrFalse() = "tiene que ser true o false"

    override fun mustBeKnownWord() = "tiene que ser un número, un texto entre comillas, true, false o null"

    override fun mustBeOneOf(words: Collection<String>) = "tiene que ser ${alternatives(words, "o")}"
}
