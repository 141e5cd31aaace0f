package robotran.world.file

/** The places of all numbers, texts, truth values and nulls in the JSON [text], without the names of fields. */
internal fun valuesIn(text: String): List<IntRange> = VALUE_OR_NAME.findAll(text).map { it.range }
    .filter { text.getOrNull(it.last + 1) != ':' }.toList()

private val VALUE_OR_NAME = Regex("\"[^\"]*\"|-?[0-9.]+|true|false|null")
