package robotran.brick.messages

object GermanPlaceMessages : PlaceMessages {
    override fun place(line: Int, file: String?) = if (file == null) "Zeile $line" else "$file, Zeile $line"
}
