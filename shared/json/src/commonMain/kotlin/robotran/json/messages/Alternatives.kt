package robotran.json.messages

import robotran.language.Language
import robotran.language.listed

/** Such as `"down" or "forward"` with [word] `or`. */
fun alternatives(words: Collection<String>, word: String): String = listed(words.map { "\"$it\"" }, word)

internal fun reason(sentence: JsonMessages.() -> String): (Language) -> String = { JsonMessages.of(it).sentence() }
