package robotran.build.site

/** A string, number, list or map as JSON that is safe inside a script element. */
internal fun json(value: Any): String = when (value) {
    is String -> quoted(value)
    is Number -> value.toString()
    is List<*> -> value.joinToString(",", "[", "]") { json(checkNotNull(it)) }
    is Map<*, *> -> value.entries.joinToString(",", "{", "}", transform = ::entry)
    else -> error("JSON of a ${value::class} is not needed")
}

private fun entry(entry: Map.Entry<*, *>): String =
    "${json(checkNotNull(entry.key))}:${json(checkNotNull(entry.value))}"

private fun quoted(text: String): String = text.map {
    when {
        it == '"' || it == '\\' -> "\\$it"
        it < ' ' || it == '<' -> "\\u%04x".format(it.code)
        else -> it.toString()
    }
}.joinToString("", "\"", "\"")
