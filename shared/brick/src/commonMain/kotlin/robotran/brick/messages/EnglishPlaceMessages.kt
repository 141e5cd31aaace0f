package robotran.brick.messages

object EnglishPlaceMessages : PlaceMessages {
    override fun place(line: Int, file: String?) = if (file == null) "Line $line" else "$file, line $line"
}
