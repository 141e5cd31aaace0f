package robotran.json.messages

internal object SpanishJsonMessages :
    JsonMessages,
    JsonSyntaxMessages by SpanishSyntax {
    override fun refused(line: Int, path: String, reason: String) =
        "Línea $line: ${path.ifEmpty { "el archivo" }} $reason."

    override fun at(line: Int, path: String, sentence: String) =
        "Línea $line: ${path.ifEmpty { "el archivo" }}: $sentence"

    override fun fileTooLong(limit: Int) = "El archivo es demasiado largo: tiene más de $limit letras y signos."

    override fun inLine(line: Int, sentence: String) = "Línea $line: $sentence"

    override fun notText() = "El archivo no es un texto."

    override fun otherEncoding(encoding: String) = "El archivo está en $encoding, no en UTF-8."

    override fun misspelt(known: String) = "no se conoce y no hace nada; quizá quieres decir \"$known\""

    override fun twice() = "está dos veces; solo cuenta el último"

    override fun missingBut(written: String) = "falta; quizá \"$written\" debería serlo"

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

    override fun mustBeOneOf(words: Collection<String>) = "tiene que ser ${alternatives(words, "o")}"
}
