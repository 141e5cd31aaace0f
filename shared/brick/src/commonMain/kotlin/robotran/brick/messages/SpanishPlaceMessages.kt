package robotran.brick.messages

object SpanishPlaceMessages : PlaceMessages {
    override fun place(line: Int, file: String?) = if (file == null) "Línea $line" else "$file, línea $line"
}
