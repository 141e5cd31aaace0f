package robotran.json.messages

internal object SpanishSyntax : JsonSyntaxMessages {
    override fun emptyFile() = "El archivo está vacío."

    override fun mustBeginWithBrace(line: Int) = "Línea $line: el archivo tiene que empezar con {."

    override fun textNotClosed(line: Int) = "La línea $line tiene un texto que no se cierra con comillas."

    override fun bracketsTooDeep(line: Int) = "La línea $line abre demasiados paréntesis unos dentro de otros."

    override fun missingComma(line: Int, before: String) = "Línea $line: falta una coma antes de $before."

    override fun missingCommaAtEnd(line: Int) = "Línea $line: falta una coma al final, antes de la entrada siguiente."

    override fun lastComma(line: Int) = "La línea $line tiene una coma después de la última entrada. Quítala."

    override fun extraComma(line: Int) = "La línea $line tiene una coma sin nada delante. Quítala."

    override fun comment(line: Int) = "La línea $line tiene un comentario, que JSON no conoce. Quítalo."

    override fun textNeedsQuotes(line: Int, text: String) = "Línea $line: un texto va entre comillas dobles: \"$text\"."

    override fun nameNeedsQuotes(line: Int, name: String) =
        "Línea $line: el nombre de un campo va entre comillas dobles: \"$name\"."

    override fun curlyQuotes(line: Int) =
        "La línea $line tiene las comillas de un procesador de textos. Escríbelas rectas: \"."

    override fun quoteInText(line: Int) = "La línea $line tiene comillas dentro de un texto. Escríbelas así: \\\"."

    override fun writeInstead(line: Int, written: String, right: String) =
        "Línea $line: escribe $right en lugar de $written."

    override fun decimalComma(line: Int, written: String, right: String) =
        "Línea $line: escribe $right con punto en lugar de $written."

    override fun noNumber(line: Int, written: String) = "Línea $line: $written no es un número."

    override fun missingColon(line: Int, name: String) = "Línea $line: faltan los dos puntos después de \"$name\"."

    override fun missingValue(line: Int, name: String) = "Línea $line: falta el valor después de \"$name\"."

    override fun tabInText(line: Int) =
        "La línea $line tiene un tabulador dentro de un texto. Escribe \\t o espacios en su lugar."

    override fun invisibleInText(line: Int) = "La línea $line tiene un signo invisible dentro de un texto. Quítalo."

    override fun noEscape(line: Int, written: String) =
        "Línea $line: $written no significa nada en un texto. Para la barra invertida misma escribe \\\\."

    override fun bracketNotClosed(line: Int, opening: String, closing: String) =
        "La línea $line abre $opening y ningún $closing lo cierra."

    override fun wrongBracket(line: Int, found: String, opening: String, openLine: Int, closing: String) =
        "Línea $line: el $opening de la línea $openLine se cierra con $closing, no con $found."

    override fun tooManyBrackets(line: Int, bracket: String) = "En la línea $line sobra $bracket."

    override fun goesOn(line: Int) = "Línea $line: después del último paréntesis del archivo no puede haber nada."

    override fun cannotStandThere(line: Int, sign: String) = "Línea $line: $sign no puede estar ahí."
}
